// One live view in one element. It knows nothing of Jupyter: it takes a scene
// (kinlab/drawing/scene.py) and the joints to read, write and listen to. widget.js ties it to a
// widget's traits, host_page.js to the address of a plain page.

import { Bar } from "./bar.js";
import { Chart } from "./chart.js";
import { Controls } from "./controls.js";
import { make, number, write } from "./dom.js";
import { follower } from "./following.js";
import { fitFormula } from "./formula.js";
import { inRoom, seenFrom } from "./frames.js";
import { Grasp } from "./grasp.js";
import { Highlight } from "./highlight.js";
import { seenFlat } from "./holds.js";
import { missed, poseTable, readingLines } from "./panels.js";
import { Picture } from "./picture.js";
import { Plan } from "./plan.js";
import { Mover, wantsCalm } from "./player.js";
import { orbit } from "./pointer.js";
import { Pointing } from "./pointing.js";
import { letAllScroll } from "./scrolls.js";
import { Walk, stages } from "./stages.js";
import { Film, TimedCharts, placesOf } from "./timed.js";
import { minus } from "./vectors.js";

/** @import { Source } from "./pointing.js" */
/** @import { Frame, Joints, Knob, Lens, Live, Looks, Scene, Solved } from "./types.js" */
/** @import { Spot, TargetScene } from "./types.js" */

const MOVE = 700, TOUR = 900;                       // ms from pose to pose
const CALM_STEPS = 200;                             // of names to their places, in one picture
const USUAL_LETTERS = 16;                           // px: a browser's usual ones
const HEARD = 400;                                  // ms: a screen reader need not hear every step

/**
 * What to say of joints that stand at a limit. The ends of a range that a hand sets, a last stage,
 * a lock and how far a joint has swept its range are no limits.
 * @param {Knob[]} knobs
 * @param {number[]} q
 */
function limits(knobs, q) {
  return knobs.flatMap((knob, i) => {
    const { label, suffix, scale, low, high, whole, pair, unit, digits } = knob;
    if (whole || pair || unit === "%" || knob.quantity === "time" || low === high) return [];
    const slack = 1e-6 * (high - low);
    if (q[i] > low + slack && q[i] < high - slack) return [];
    const at = number(q[i] / scale, Math.max(3, digits)).replace(/\.?0+$/, "");
    return `${label} is at its limit, ${at}${suffix}`;
  }).join("; ");
}

/**
 * What to say of a picture that was made smaller for an arm that reaches far.
 * @param {Lens | null} lens
 */
const drawnAt = (lens) =>
  lens && lens.shrunk < 0.975 ? `drawn at ${Math.round(100 * lens.shrunk)} %` : "";

/**
 * The camera that looks along a direction of the room, so that it points at the viewer; upright
 * directions are seen as from the top.
 * @param {number[]} direction
 * @returns {[azimuth: number, elevation: number]}
 */
export function lookAlong([x, y, z]) {
  const flat = Math.hypot(x, y), degrees = 180 / Math.PI;
  const upright = flat < 1e-9 * Math.abs(z);
  return [upright ? -90 : Math.atan2(y, x) * degrees, Math.atan2(z, flat) * degrees];
}

class View {
  said = "";

  /** @type {Solved | null} */
  solved = null;

  pending = 0;

  settling = 0;

  heard = 0;

  /** @type {(() => void)[]} */
  ends = [];                                        // of what the view follows

  /**
   * @param {HTMLElement} element
   * @param {Scene} scene
   * @param {Joints} joints
   * @param {string} formula
   * @param {Looks | null} before how another scene was looked at in this place
   * @param {Pointing} pointing
   */
  constructor(element, scene, joints, formula, before, pointing) {
    this.element = element;
    this.controls = before?.controls ?? new Controls();
    this.plan = before?.plan ?? new Plan(this.controls.node);
    this.scene = scene;
    this.joints = joints;
    this.preset = scene.preset;
    this.picture = new Picture(scene);
    this.shrunk = make("div", { class: "kl-shrunk", "aria-hidden": "true" });
    this.box = make("div", { class: "kl-picture", tabindex: "0", role: "application",
      "style": `--kl-aspect: ${scene.size.join(" / ")}` }, this.picture.svg, this.shrunk);
    this.hands = new Grasp(this.box, this.picture, joints, () => this.redraw());
    const turns = seenFlat(scene) ? "Plus" : "Arrow keys turn the view, plus";
    this.box.setAttribute("aria-label",
      `${scene.name}: picture. ${turns} and minus zoom, 0 resets.${this.hands.help()}`);
    this.pose = scene.pose && poseTable(scene.pose);
    this.lines = readingLines(scene);
    this.chart = scene.chart && new Chart(scene.chart, scene.paints);
    this.timed = scene.timed && new TimedCharts(scene.timed, scene.paints, joints, pointing);
    this.error = make("div", { class: "kl-number" });
    this.remark = make("div", { class: "kl-remark" });
    this.spoken = make("div", { class: "kl-spoken", role: "status" });
    this.formula = make("div", { class: "kl-math", role: "group", "aria-label": "Formula" });
    this.formula.innerHTML = formula;               // MathML that kinlab has made
    this.chase = scene.target && follower(/** @type {TargetScene} */ (scene), joints,
                                          (found) => { this.solved = found; });
    this.highlight = new Highlight(this, pointing);
    this.mover = new (scene.timed ? Film : Mover)(() => this.playing(false));
    this.walk = new Walk(scene);
    this.bar = new Bar(scene, this.acts(), this.walk.has);
  }

  /**
   * Put the parts into the page, looked at as another view was before.
   * @param {Looks | null} before
   */
  show(before) {
    const { element, box, picture, pose, lines, plan, scene } = this;
    if (this.chase) lines.node.append(this.error);
    if (this.chart) lines.node.prepend(this.chart.node);
    element.classList.add("kl-view");
    element.classList.toggle("kl-wide", scene.wide);
    if (!before) element.append(plan.node);
    write(plan.title, scene.name);
    plan.put("stage", box, this.timed?.said, this.bar.node, this.spoken);
    plan.put("side", this.timed?.node, pose?.node, lines.node, this.remark);
    const staged = this.formula.querySelector("[data-stages]");
    if (this.formula.innerHTML) plan.put(staged ? "side" : "below", this.formula);
    this.controls.take(scene.knobs, this.joints, () => this.note(this.said));
    for (const { layer, on } of scene.layers) this.switch(layer, before?.shown[layer] ?? on);
    this.look(before?.began === scene.preset ? before.preset : scene.preset);
    if (before?.began === scene.preset) picture.camera = before.camera;
    this.ends.push(
      ...this.formula.innerHTML
        ? [fitFormula(this.formula, !staged && scene.pose?.columns || [])] : [],
      orbit(box, picture, () => this.redraw(), () => this.look(this.preset), this.hands),
      this.joints.listen(() => this.moved()),
      this.highlight.begin(),
      () => this.chart?.leave(),
      () => this.timed?.leave(),
      () => this.sizes.disconnect());
    letAllScroll(plan.node, ".kl-math");
    this.draw();
    this.describe();
    this.sizes.observe(box);
  }

  /** The picture is drawn anew for each size of its box, before that is painted. */
  sizes = new ResizeObserver(() => {
    const { clientWidth, clientHeight } = this.box;
    if (!clientWidth || !clientHeight) return;      // taken out, or in a page that is not shown
    const { fontSize } = getComputedStyle(document.documentElement);
    this.picture.resize(clientWidth, clientHeight, parseFloat(fontSize) / USUAL_LETTERS);
    this.draw();
  });

  // ---- the buttons ----

  /** @returns {import("./bar.js").Acts} */
  acts() {
    const { mover, picture } = this;
    const anew = (/** @type {() => void} */ change) => {
      change();
      this.redraw();
    };
    return {
      go: (q) => this.go(q),
      play: () => this.play(),
      step: (by) => {                                // on from where the last one leads
        const from = mover.request ? mover.goal : this.joints.read();
        mover.start(this.led, [this.walk.next(from, by)], MOVE);
      },
      stage: (k) => {
        const way = this.walk.to(this.joints.read(), k);
        if (way.length) mover.start(this.led, way, MOVE);
      },
      look: (preset) => this.look(preset),
      along: (frame, direction) => this.along(frame, direction),
      show: (layer, on) => this.switch(layer, on),
      showFrame: (frame, on) => anew(() => picture.showFrame(frame, on)),
      clear: () => this.clear(),
      perspective: (on) => anew(() => { picture.camera.perspective = on; }),
      fill: () => this.fill(),
    };
  }

  /**
   * Go to a pose; what is null in it stays.
   * @param {(number | null)[]} q
   */
  go(q) {
    const drive = this.chase?.drive ?? this.joints, now = drive.read();
    this.mover.start(drive, [q.map((value, i) => value ?? now[i])], MOVE);
  }

  /** Begin the trace anew. */
  clear() {
    this.picture.clear();
    this.redraw();
  }

  /** What Play and steps move: where there is a target, that leads. */
  get led() { return this.chase?.lead ?? this.joints; }

  /**
   * @param {string} layer
   * @param {boolean} on
   */
  switch(layer, on) {
    this.bar.press(layer, on);
    this.picture.show(layer, on);
    this.redraw();
  }

  /** @param {string} preset */
  look(preset) {
    this.preset = preset;
    this.picture.reset(preset);
    this.redraw();
  }

  /**
   * Look along an axis, which then points at the viewer.
   * @param {number} frame
   * @param {number[]} direction in that frame
   */
  along(frame, direction) {
    const at = this.picture.at[frame];
    const [azimuth, elevation] = lookAlong(minus(inRoom(at, direction), at[3]));
    this.picture.camera = { ...this.picture.camera, azimuth, elevation };
    this.redraw();
  }

  play() {
    const { mover, scene: { timed } } = this;
    if (mover.request) return mover.stop();
    if (timed && mover instanceof Film) mover.run(this.joints, timed.times[timed.times.length - 1]);
    else mover.start(this.led, stages(this.scene, this.joints.read()), TOUR, true);
    this.playing(true);
  }

  /** @param {boolean} on */
  playing(on) { this.bar?.playing(on); }

  fill() {
    if (document.fullscreenElement) document.exitFullscreen();
    else this.element.requestFullscreen();
  }

  // ---- what follows the joints ----

  moved() {
    if (this.mover.request && !this.mover.writing) this.mover.stop();   // a hand takes over
    this.said = "";
    if (!this.mover.writing) this.chase?.changed();
    this.controls.update();
    this.redraw();
  }

  redraw() { this.pending ||= requestAnimationFrame(() => this.draw()); }

  draw() {
    this.pending = 0;
    const { scene, lines } = this, q = this.joints.read(), all = this.picture.draw(q);
    const at = scene.timed ? placesOf(scene, q) : q;
    const changed = [...this.pose?.update(this.posed(all)) ?? [], ...lines.update(all, at)];
    this.highlight.follow(changed, q);
    this.chart?.draw(q);
    this.timed?.draw(q);
    this.stand(this.walk.stage(q));
    if (this.chase) write(this.error, missed(/** @type {TargetScene} */ (scene), all, this.solved));
    write(this.shrunk, drawnAt(this.picture.lens));
    this.hands.drawn();
    if (this.picture.steady.moving) this.redraw();  // back to its frame, after a drag
    this.note(this.said);
    this.settle();
  }

  /** @param {number} stage of those that have buttons, or parts of the formula */
  stand(stage) {
    this.bar.stand(stage);
    for (const part of this.formula.querySelectorAll("[data-stages]")) {
      const of = part.getAttribute("data-stages")?.split(" ");
      part.toggleAttribute("hidden", !of?.includes(String(stage)));
    }
  }

  /**
   * Let the names in the picture go on to their places, when nothing else moves any more. Who
   * prefers less motion sees them there at once.
   */
  settle() {
    cancelAnimationFrame(this.settling);
    if (!this.picture.restless) return;
    this.settling = requestAnimationFrame(() => {
      const steps = this.pending ? 0 : wantsCalm() ? CALM_STEPS : 1;
      for (let k = 0; k < steps && this.picture.restless; k++) this.picture.placeWords();
      this.settle();
    });
  }

  /** @param {string} text */
  note(text) {
    this.said = text;
    const wrong = this.controls.reasons();
    write(this.remark, wrong || text || limits(this.scene.knobs, this.joints.read()));
    this.remark.classList.toggle("kl-warns", Boolean(wrong));
    this.tellLater();
  }

  /** @param {Frame[]} all */
  posed(all) { return seenFrom(all[this.scene.tip], all[this.scene.pose?.base ?? 0]); }

  /**
   * @param {Spot | null} spot
   * @param {Source} [source]
   */
  point(spot, source) { this.highlight.pointing.point(spot, source); }

  /** Tell assistive technology of the picture once it rests: nobody can listen to a drag. */
  tellLater() {
    clearTimeout(this.heard);
    this.heard = setTimeout(() => this.tell(), HEARD);
  }

  /** What there is to see, in words. */
  describe() {
    const panels = [this.timed, this.pose, this.lines];
    const state = panels.map((panel) => panel?.text()).filter(Boolean).join("; ");
    this.picture.svg.setAttribute("aria-label", `${this.scene.name}, ${state}`);
    return { held: this.hands.describe(), state };
  }

  /** Say what a hand in this view, or a word of the text, has changed; and remarks in any case. */
  tell() {
    const { held, state } = this.describe(), { pointing, caption } = this.highlight;
    const own = this.element.querySelector("input:focus, .kl-hold:focus");   // says its own value
    const shown = own ? "" : caption.textContent;
    const here = pointing.spots.word || this.element.matches(":focus-within");
    write(this.spoken, [here && (held || [shown, state].filter(Boolean).join("; ")),
                        this.remark.textContent].filter(Boolean).join(". "));
  }

  /** Make room for another scene: all but the controls goes. How the view was looked at. */
  leave() {
    this.mover.stop();
    this.ends.forEach((end) => end());
    cancelAnimationFrame(this.pending);
    cancelAnimationFrame(this.settling);
    clearTimeout(this.heard);
    this.plan.clear();
    return { began: this.scene.preset, preset: this.preset, camera: this.picture.camera,
             shown: this.bar.shown(), controls: this.controls, plan: this.plan };
  }

  /** Take everything out of the page again. */
  dismount() {
    this.leave();
    this.element.replaceChildren();
  }
}

/**
 * Show a live view.
 * @param {HTMLElement} element where to put it
 * @param {Scene} scene
 * @param {Joints} joints in radians and lengths
 * @param {string} formula MathML to stand below, or ""
 * @param {Looks | null} before what leave() returned, to look at another arm in the same way
 * @param {Pointing} pointing shared with what stands beside the view and points at it
 * @returns {Live}
 */
export function mount(element, scene, joints, formula = "", before = null,
                      pointing = new Pointing()) {
  const view = new View(element, scene, joints, formula, before, pointing);
  view.show(before);
  return view;
}
