// One live arm in one element. `mount` knows nothing of Jupyter: it takes the SVG, the scene
// (kinlab/drawing/scene.py) and the joints to read, write and listen to. host_jupyter.js ties it to
// ipywidgets' sliders, host_page.js to those of a plain page.
// @ts-nocheck

import { follower } from "./chase.js";
import { make, toolbar } from "./dom.js";
import { seenFrom } from "./frames.js";
import { missed, poseTable, readingLines } from "./panels.js";
import { Picture } from "./picture.js";
import { Mover } from "./player.js";
import { grasp, orbit } from "./pointer.js";

const MOVE = 700, TOUR = 900;                       // ms from pose to pose

/**
 * Show a live arm.
 * @param element where to put it
 * @param svg the picture as matplotlib drew it, SVG text
 * @param scene plain data from kinlab's Scene and view (see kinlab/views/live.py)
 * @param joints { read() -> q, write(q), listen(callback) -> stop }, in radians and lengths
 * @param before what dismount() returned, to go on looking at another arm in the same way
 * @returns { note(text), freeze(), dismount() }
 */
export function mount(element, svg, scene, joints, before = null) {
  const box = make("div", { class: "kl-picture", tabindex: "0", role: "application",
    "aria-label": `${scene.name}: picture of the arm. Arrow keys turn the view, ` +
                  "plus and minus zoom, 0 resets." });
  box.innerHTML = svg;
  const picture = new Picture(box.querySelector("svg"), scene);
  picture.svg.setAttribute("role", "img");
  picture.svg.removeAttribute("width");
  picture.svg.removeAttribute("height");
  const pose = scene.pose && poseTable(scene.pose);
  const lines = readingLines(scene);
  const progress = make("div", { class: "kl-number" });
  if (scene.target) lines.node.append(progress);
  const remark = make("div", { class: "kl-remark", role: "status" });

  let preset = scene.preset, pending = 0, described = 0, note = "", solved = null;
  const remarks = () => {
    const q = joints.read();
    const text = note || scene.joints.flatMap(({ label, suffix, scale, low, high }, i) => {
      const slack = 1e-6 * (high - low);
      if (q[i] > low + slack && q[i] < high - slack) return [];
      return `${label} is at its limit, ${Number((q[i] / scale).toFixed(3))}${suffix}`;
    }).join("; ");
    if (remark.textContent !== text) remark.textContent = text;
  };
  const describe = () => {
    const state = [pose, lines].map((panel) => panel?.text()).filter(Boolean).join("; ");
    picture.svg.setAttribute("aria-label", `${scene.name}, ${state}`);
  };
  const draw = () => {
    pending = 0;
    const q = joints.read(), all = picture.draw(q);
    pose?.update(seenFrom(all[scene.tip], all[scene.pose.base ?? 0]));
    lines.update(all, q);
    if (chase) progress.textContent = missed(scene, all, solved);
    remarks();
    clearTimeout(described);
    described = setTimeout(describe, 400);          // a screen reader need not hear every step
  };
  const redraw = () => { pending ||= requestAnimationFrame(draw); };
  const look = (name) => { preset = name; picture.reset(name); redraw(); };

  const chase = scene.target && follower(scene, joints, (found) => { solved = found; });
  const drive = chase?.drive ?? joints;
  let play = null;
  const mover = new Mover(() => {
    play?.replaceChildren("▶ Play");
    play?.setAttribute("aria-pressed", "false");
  });
  const whole = () => element.closest(".kl-view") ?? element;
  const switches = scene.layers.map(({ layer, label, title, on }) => [label, title, (button) => {
    const pressed = button.getAttribute("aria-pressed") !== "true";
    button.setAttribute("aria-pressed", pressed);
    picture.show(layer, pressed);
    redraw();
  }, layer, on]);
  const presets = Object.keys(scene.presets);
  const playing = ["▶ Play", "Move smoothly from pose to pose", () => {
    if (mover.request) return mover.stop();
    mover.start(chase?.lead ?? joints, scene.poses, TOUR, true);
    play.replaceChildren("Pause");
    play.setAttribute("aria-pressed", "true");
  }];
  const bar = toolbar([
    ["Move", ["Home", "Move to where it began", () => mover.start(drive, [scene.home], MOVE)],
      ...(scene.poses.length
        ? [["Zero", "Set every joint to zero", () => mover.start(drive, [scene.zero], MOVE)],
           playing]
        : [])],
    ["View", ...(presets.length > 1 ? presets : []).map((name) =>
      [name[0].toUpperCase() + name.slice(1), `View: ${name}`, () => look(name)])],
    ["Show", ...switches],
    ["Screen", ...(document.fullscreenEnabled ? [["Full screen", "Fill the screen, with large type",
      () => document.fullscreenElement ? document.exitFullscreen() : whole().requestFullscreen(),
    ]] : [])],
  ].filter((group) => group.length > 1));
  play = scene.poses.length ? bar.querySelectorAll("button")[2] : null;
  const buttons = [...bar.querySelectorAll('[aria-label="Show"] button')];
  switches.forEach(([, , , layer, on], k) => {
    const pressed = before?.shown[layer] ?? on;
    buttons[k].setAttribute("aria-pressed", pressed);
    picture.show(layer, pressed);
  });

  element.classList.add("kl-live");
  element.append(bar, box, ...(pose ? [pose.node] : []), lines.node, remark);
  const release = orbit(box, picture, redraw, () => look(preset), chase && grasp(picture, chase));
  const silence = joints.listen(() => {
    if (mover.request && !mover.writing) mover.stop();   // a hand on a slider takes over
    note = "";
    if (!mover.writing) chase?.changed();
    redraw();
  });
  look(preset);
  if (before?.began === scene.preset) {
    preset = before.preset;
    picture.camera = before.camera;
  }
  draw();
  const freeze = () => {
    mover.stop();
    silence();
    cancelAnimationFrame(pending);
    pending = 0;
  };
  return {
    note(text) { note = text; remarks(); },
    freeze,
    dismount() {
      freeze();
      release();
      clearTimeout(described);
      element.replaceChildren();
      const shown = Object.fromEntries(switches.map(([, , , layer], k) =>
        [layer, buttons[k].getAttribute("aria-pressed") === "true"]));
      return { began: scene.preset, preset, camera: picture.camera, shown };
    },
  };
}
