// One live view in one element. It knows nothing of Jupyter: it takes a scene
// (kinlab/drawing/scene.py) and the joints to read, write and listen to. widget.js ties it to a
// widget's traits, host_page.js to the address of a plain page.

import { follower } from "./chase.js";
import { Controls } from "./controls.js";
import { make, toolbar, write } from "./dom.js";
import { seenFrom } from "./frames.js";
import { missed, poseTable, readingLines } from "./panels.js";
import { Picture } from "./picture.js";
import { Mover } from "./player.js";
import { grasp, orbit } from "./pointer.js";

/** @import { Button } from "./dom.js" */
/** @import { Joints, Knob, Live, Looks, Scene, Solved, TargetScene } from "./types.js" */

const MOVE = 700, TOUR = 900;                       // ms from pose to pose
const HEARD = 400;                                  // ms: a screen reader need not hear every step

/**
 * What to say of joints that stand at a limit.
 * @param {Knob[]} knobs
 * @param {number[]} q
 */
function limits(knobs, q) {
  return knobs.flatMap(({ label, suffix, scale, low, high }, i) => {
    const slack = 1e-6 * (high - low);
    if (q[i] > low + slack && q[i] < high - slack) return [];
    return `${label} is at its limit, ${Number((q[i] / scale).toFixed(3))}${suffix}`;
  }).join("; ");
}

/** @type {(name: string) => string} */
const capital = (name) => name[0].toUpperCase() + name.slice(1);

class View {
  said = "";

  /** @type {Solved | null} */
  solved = null;

  pending = 0;

  settling = 0;

  heard = 0;

  silence = () => {};

  release = () => {};

  /**
   * @param {HTMLElement} element
   * @param {Scene} scene
   * @param {Joints} joints
   * @param {string} formula
   * @param {Controls} controls
   */
  constructor(element, scene, joints, formula, controls) {
    this.element = element;
    this.controls = controls;
    this.scene = scene;
    this.joints = joints;
    this.preset = scene.preset;
    this.picture = new Picture(scene);
    this.box = make("div", { class: "kl-picture", tabindex: "0", role: "application",
      "data-lm-suppress-shortcuts": "true",
      "aria-label": `${scene.name}: picture of the arm. Arrow keys turn the view, ` +
                    "plus and minus zoom, 0 resets." }, this.picture.svg);
    this.pose = scene.pose && poseTable(scene.pose);
    this.lines = readingLines(scene);
    this.error = make("div", { class: "kl-number" });
    this.remark = make("div", { class: "kl-remark", role: "status" });
    this.formula = make("div", { class: "kl-math", role: "group", "aria-label": "Formula" });
    this.formula.innerHTML = formula;               // MathML that kinlab has made
    this.chase = scene.target && follower(/** @type {TargetScene} */ (scene), joints,
                                          (found) => { this.solved = found; });
    this.mover = new Mover(() => this.playing(false));
    this.bar = toolbar(this.groups());
  }

  /**
   * Put the parts into the page, looked at as another view was before.
   * @param {Looks | null} before
   */
  show(before) {
    const { element, box, picture, pose, lines, scene } = this;
    if (this.chase) lines.node.append(this.error);
    element.classList.add("kl-view");
    element.classList.toggle("kl-wide", scene.wide);
    if (!before) element.append(this.controls.node);
    this.controls.node.before(this.bar, box);
    this.controls.node.after(...(pose ? [pose.node] : []), lines.node, this.remark,
                             ...(this.formula.innerHTML ? [this.formula] : []));
    this.controls.take(scene.knobs, this.joints, () => this.note(this.said));
    for (const { layer, on } of scene.layers) this.switch(layer, before?.shown[layer] ?? on);
    this.look(before?.began === scene.preset ? before.preset : scene.preset);
    if (before?.began === scene.preset) picture.camera = before.camera;
    this.release = orbit(box, picture, () => this.redraw(), () => this.look(this.preset),
                         this.chase && grasp(picture, this.chase));
    this.silence = this.joints.listen(() => this.moved());
    this.draw();
  }

  // ---- the toolbar ----

  /** Groups of buttons that this scene has a use for. */
  groups() {
    const { scene, mover } = this, drive = this.chase?.drive ?? this.joints;
    const go = (/** @type {number[]} */ to) => () => mover.start(drive, [to], MOVE);
    /** @type {Button[]} */
    const poses = scene.poses.length
      ? [["Zero", "Set every joint to zero", go(scene.zero)],
         ["▶ Play", "Move smoothly from pose to pose", () => this.play(), { "data-part": "play" }]]
      : [];
    /** @type {Button[]} */
    const sides = Object.keys(scene.presets).map((name) =>
      [capital(name), `View: ${name}`, () => this.look(name)]);
    /** @type {Button[]} */
    const layers = scene.layers.map(({ layer, label, title }) =>
      [label, title, () => this.switch(layer, !this.shown()[layer]), { "data-layer": layer }]);
    /** @type {Button[]} */
    const screen = document.fullscreenEnabled
      ? [["Full screen", "Fill the screen, with large type", () => this.fill()]] : [];
    /** @type {[label: string, ...buttons: Button[]][]} */
    const groups = [["Move", ["Home", "Move to where it began", go(scene.home)], ...poses],
                    ["View", ...(sides.length > 1 ? sides : [])], ["Show", ...layers],
                    ["Screen", ...screen]];
    return groups.filter((group) => group.length > 1);
  }

  /** Which layers are switched on. */
  shown() {
    return Object.fromEntries([...this.bar.querySelectorAll("[data-layer]")].map((button) =>
      [button.getAttribute("data-layer"), button.getAttribute("aria-pressed") === "true"]));
  }

  /**
   * @param {string} layer
   * @param {boolean} on
   */
  switch(layer, on) {
    this.bar.querySelector(`[data-layer="${layer}"]`)?.setAttribute("aria-pressed", String(on));
    this.picture.show(layer, on);
    this.redraw();
  }

  /** @param {string} preset */
  look(preset) {
    this.preset = preset;
    this.picture.reset(preset);
    this.redraw();
  }

  play() {
    if (this.mover.request) return this.mover.stop();
    this.mover.start(this.chase?.lead ?? this.joints, this.scene.poses, TOUR, true);
    this.playing(true);
  }

  /** @param {boolean} on */
  playing(on) {
    const button = this.bar?.querySelector('[data-part="play"]');
    button?.replaceChildren(on ? "Pause" : "▶ Play");
    button?.setAttribute("aria-pressed", String(on));
  }

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
    const { scene, pose, lines } = this, q = this.joints.read(), all = this.picture.draw(q);
    pose?.update(seenFrom(all[scene.tip], all[scene.pose?.base ?? 0]));
    lines.update(all, q);
    if (this.chase) write(this.error, missed(/** @type {TargetScene} */ (scene), all, this.solved));
    this.note(this.said);
    this.settle();
    clearTimeout(this.heard);
    this.heard = setTimeout(() => this.describe(), HEARD);
  }

  /** Let the names in the picture go on to their places, when nothing else moves any more. */
  settle() {
    cancelAnimationFrame(this.settling);
    if (!this.picture.restless) return;
    this.settling = requestAnimationFrame(() => {
      if (!this.pending) this.picture.placeWords();
      this.settle();
    });
  }

  /** @param {string} text */
  note(text) {
    this.said = text;
    const wrong = this.controls.reasons();
    write(this.remark, wrong || text || limits(this.scene.knobs, this.joints.read()));
    this.remark.classList.toggle("kl-warns", Boolean(wrong));
  }

  describe() {
    const state = [this.pose, this.lines].map((panel) => panel?.text()).filter(Boolean).join("; ");
    this.picture.svg.setAttribute("aria-label", `${this.scene.name}, ${state}`);
  }

  /** Make room for another scene: all but the controls goes. How the view was looked at. */
  leave() {
    this.mover.stop();
    this.silence();
    this.release();
    cancelAnimationFrame(this.pending);
    cancelAnimationFrame(this.settling);
    clearTimeout(this.heard);
    for (const part of [...this.element.children]) {
      if (part !== this.controls.node) part.remove();
    }
    return { began: this.scene.preset, preset: this.preset, camera: this.picture.camera,
             shown: this.shown(), controls: this.controls };
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
 * @returns {Live}
 */
export function mount(element, scene, joints, formula = "", before = null) {
  const view = new View(element, scene, joints, formula, before?.controls ?? new Controls());
  view.show(before);
  return view;
}
