// Ties a live view to a widget: its joints are the widget's traits, in degrees or lengths. Only
// what every host of anywidget has is asked for; what JupyterLab has besides is used where it is.

import { make, write } from "./dom.js";
import { Listeners } from "./listeners.js";
import { mount } from "./mount.js";
import { followTerms } from "./terms.js";

/** @import { Pointing } from "./pointing.js" */
/** @import { Joints, Knob, Live, Model } from "./types.js" */

const TELL = 100;                                   // ms between two messages to Python

/**
 * The joints of a widget's model, whoever sets them.
 *
 * A hand sets the model at once, for widgets that the browser has tied to it, and Python hears of
 * it at most every TELL ms, and always of the last value. Until it has heard, and while the hand
 * holds the slider, what comes from elsewhere for that joint does not move it.
 * @param {Model} model
 * @param {Knob[]} knobs
 * @param {() => boolean} listening whether Python still does
 * @param {Set<string>} gripped names of the joints that a hand holds
 * @returns {Joints & { leave(): void }}
 */
export function modelJoints(model, knobs, listening, gripped = new Set()) {
  const names = knobs.map(({ name }) => name);
  const listeners = new Listeners();
  /** @type {Set<string>} */
  const untold = new Set();
  /** @type {number[]} */
  let held = names.map((name) => model.get(name));
  let timer = 0, asked = false;
  let q = held.map((value, i) => value * knobs[i].scale);

  const tell = () => {
    timer = 0;
    if (!untold.size) return;
    untold.clear();
    if (listening()) model.save_changes();
    timer = setTimeout(tell, TELL);
  };
  const take = () => {
    asked = false;
    const next = held.slice();
    names.forEach((name, i) => {
      const value = model.get(name);
      if (value === held[i]) return;
      if (!untold.has(name) && !gripped.has(name)) { next[i] = value; return; }
      model.set(name, held[i]);
      untold.add(name);
    });
    if (!timer) tell();
    if (next.every((value, i) => value === held[i])) return;
    q = q.map((value, i) => next[i] === held[i] ? value : next[i] * knobs[i].scale);
    held = next;
    listeners.tell();
  };
  // Whoever sets several joints sets them one by one: look when all are there.
  const heard = () => {
    if (!asked) queueMicrotask(take);
    asked = true;
  };
  names.forEach((name) => model.on(`change:${name}`, heard));

  return {
    gripped,
    read: () => q,
    write(wanted) {
      const next = wanted.map((value, i) =>         // 60 degrees are 60, not 59.99999999999999
        value === q[i] ? held[i] : Number((value / knobs[i].scale).toPrecision(13)));
      const moved = names.filter((_, i) => next[i] !== held[i]);
      [q, held] = [wanted, next];
      names.forEach((name, i) => { if (moved.includes(name)) model.set(name, next[i]); });
      moved.forEach((name) => untold.add(name));
      if (model.get("note")) model.set("note", "");   // it told of where the joints were
      if (!timer) tell();
      listeners.tell();
    },
    listen: (listener) => listeners.add(listener),
    leave() {
      names.forEach((name) => model.off(`change:${name}`, heard));
      clearTimeout(timer);
      tell();
      clearTimeout(timer);
    },
  };
}

const GONE = ["restarting", "autorestarting", "terminating", "dead"];
const DEAF = "Python no longer listens to this view. The picture still moves; run the cell again " +
             "to connect them.";
const APART = "No connection to Python now. The picture still moves; Python will hear of it later.";

/**
 * Say in the view when Python does not listen; JupyterLab's kernel tells, other hosts' may not.
 * @param {Model} model
 */
function watchPython(model) {
  const line = make("div", { class: "kl-silence", role: "status" });
  const kernel = model.widget_manager?.kernel;
  const layout = model.get("layout");               // a model beside this one, open as long as it
  let gone = false;
  const look = () => {
    gone ||= kernel?.isDisposed || GONE.includes(kernel?.status) || layout?.comm_live === false;
    const apart = (kernel?.connectionStatus ?? "connected") !== "connected";
    write(line, gone ? DEAF : apart ? APART : "");
  };
  const signals = ["statusChanged", "connectionStatusChanged", "disposed"]
    .flatMap((name) => kernel?.[name] ?? []);
  signals.forEach((signal) => signal.connect(look));
  layout?.on?.("comm_live_update", look);
  look();
  return {
    line,
    listening: () => !gone,
    leave() {
      signals.forEach((signal) => signal.disconnect(look));
      layout?.off?.("comm_live_update", look);
    },
  };
}

/**
 * Show a model's view in an element.
 * @param {Model} model
 * @param {HTMLElement} el
 * @param {Pointing} [pointing] what stands beside the view and points at it shares this
 * @param {typeof mount} [put] puts the view there
 * @returns {() => void} ends it
 */
export function showView(model, el, pointing, put = mount) {
  const python = watchPython(model), place = make("div");
  /** @type {Set<string>} */
  const gripped = new Set();
  /** @type {Live | undefined} */
  let live;
  /** @type {ReturnType<typeof modelJoints> | undefined} */
  let joints;
  const remark = () => live?.note(model.get("note"));
  const show = () => {
    const before = live?.leave();
    joints?.leave();
    const scene = model.get("scene");
    joints = modelJoints(model, scene.knobs, python.listening, gripped);
    live = put(place, scene, joints, model.get("formula"), before, pointing);
    place.append(python.line);
    joints.listen(remark);
    remark();
  };
  el.append(place);
  show();
  model.on("change:note", remark);
  model.on("change:scene", show);
  const unfollow = followTerms(place, () => live);
  return () => {
    unfollow();
    model.off("change:note", remark);
    model.off("change:scene", show);
    live?.dismount();
    joints?.leave();
    python.leave();
  };
}
