// Ties the live picture (mount.js) to Jupyter: its joints are ipywidgets' sliders, in degrees or
// lengths.
// @ts-nocheck

import { mount } from "./mount.js";
import { make } from "./dom.js";
import { KEYS, snap, stepped } from "./steps.js";

const TELL = 100;                                   // ms between two messages to Python

/**
 * Make a slider tell Python its value at most every TELL ms, and always the last one.
 *
 * ipywidgets keeps what a slider has to say until its last message is answered; meanwhile it
 * takes no echo of an older value, which would move the slider back. Here each message has one
 * answer more, which comes after TELL ms.
 */
function spare(slider) {
  const send = slider.send_sync_message.bind(slider);
  slider.send_sync_message = (...message) => {
    const id = send(...message);
    slider._pending_msgs += 1;
    setTimeout(() => {
      if (slider.comm_live) slider._handle_status({ content: { execution_state: "idle" } });
    }, TELL);
    return id;
  };
}

const GONE = ["restarting", "autorestarting", "terminating", "dead"];
const DEAF = "Python no longer listens to this view. The picture still moves; run the cell again " +
             "to connect them.";
const APART = "No connection to Python now. The picture still moves; Python will hear of it later.";

/** Say in the view when Python does not listen; JupyterLab's kernel tells, other hosts' may not. */
function watchPython(el, sliders) {
  const line = make("div", { class: "kl-silence", role: "status" });
  const [first] = sliders, kernel = first?.widget_manager.kernel;
  const look = () => {
    if (kernel?.isDisposed || GONE.includes(kernel?.status)) {   // what comes next knows no view
      for (const slider of sliders) if (slider.comm_live) slider.comm_live = false;
    }
    const apart = (kernel?.connectionStatus ?? "connected") !== "connected";
    const text = !first || first.comm_live && !apart ? "" : first.comm_live ? APART : DEAF;
    if (line.textContent !== text) line.textContent = text;
  };
  const signals = ["statusChanged", "connectionStatusChanged", "disposed"]
    .flatMap((name) => kernel?.[name] ?? []);
  signals.forEach((signal) => signal.connect(look));
  first?.on("comm_live_update", look);
  el.append(line);
  look();
  return () => {
    signals.forEach((signal) => signal.disconnect(look));
    first?.off("comm_live_update", look);
  };
}

/**
 * A slider that stops at whole steps under the hand but takes any value from elsewhere.
 *
 * With a step of its own, ipywidgets' slider rounds every value that it is given, those from
 * Python too, and tells Python the rounded one. So it has none, and the steps are made here.
 */
class Joint {
  constructor(slider) {
    Object.assign(this, { slider, settled: slider.get("value") });
    spare(slider);
    slider.on("change:value", (_, value, options) => this.settle(options));
    // The slider's own view writes back what it was given, rounded: that is no change.
    const set = slider.set.bind(slider);
    slider.set = (key, value, options) =>
      set(key, options?.updated_view && this.echoes(value) ? this.settled : value, options);
  }

  /** The one joint of a slider, however often it is shown: two would round for each other. */
  static of(slider, data) {
    if (!Joint.known.has(slider)) Joint.known.set(slider, new Joint(slider));
    const { step, scale } = data;                   // another arm's, where the arm has changed
    return Object.assign(Joint.known.get(slider), { step, scale });
  }

  static known = new WeakMap();

  get value() { return this.slider.get("value"); }

  get low() { return this.slider.get("min"); }

  get high() { return this.slider.get("max"); }

  echoes(value) { return Math.abs(value - this.settled) <= 1e-6 * this.step; }

  /** Keep values from elsewhere exact, and round those that a hand on the slider makes. */
  settle(options = {}) {
    this.settled = options.updated_view ? snap(this.value, this) : this.value;
    if (this.value !== this.settled) this.slider.set("value", this.settled);
  }

  press(steps, fine) {
    this.slider.set("value", stepped(this.value, steps, fine, this));
    this.slider.save_changes();
  }
}

const STATE = "application/vnd.jupyter.widget-state+json";
const VIEW = "application/vnd.jupyter.widget-view+json";
const keeping = new WeakSet();

/**
 * Save with a notebook what its widgets hold: opened again, and not run, its views still move.
 *
 * JupyterLab's own setting for this forgets the views of a notebook that is opened and not run.
 */
function keepWidgets(manager) {
  const { context } = manager;                      // a notebook of JupyterLab, or nothing
  if (!context?.model.setMetadata || keeping.has(manager)) return;
  keeping.add(manager);
  context.saveState.connect((_, phase) => {
    if (phase !== "started") return;
    const all = { ...context.model.getMetadata("widgets")?.[STATE]?.state,
                  ...manager.get_state_sync({ drop_defaults: true }).state };
    const state = {}, keep = (id) => {
      if (!all[id] || state[id]) return;
      state[id] = all[id];
      for (const [, inner] of JSON.stringify(all[id]).matchAll(/"IPY_MODEL_(.*?)"/g)) keep(inner);
    };
    const outputs = context.model.toJSON().cells.flatMap((cell) => cell.outputs ?? []);
    outputs.forEach((output) => keep(output.data?.[VIEW]?.model_id));
    context.model.setMetadata("widgets",
      { [STATE]: { version_major: 2, version_minor: 0, state } });
  });
}

async function sliderJoints(model, scene) {
  const joints = await Promise.all(model.get("sliders").map(async (reference, i) => {
    const id = reference.slice("IPY_MODEL_".length);
    return Joint.of(await model.widget_manager.get_model(id), scene.joints[i]);
  }));
  const values = () => joints.map((joint) => joint.value * joint.scale);
  let q = values();
  return {
    joints,
    read: () => q,
    write(wanted) {
      joints.forEach(({ slider, scale }, i) => {
        slider.set("value", wanted[i] / scale);
        slider.save_changes();                      // else Python's echo of an older value wins
      });
    },
    listen(callback) {
      const take = () => {
        if (model.get("hold")) return;              // Python is still setting the other joints
        q = values();
        callback();
      };
      joints.forEach(({ slider }) => slider.on("change:value", take));
      model.on("change:hold", take);
      return () => {
        joints.forEach(({ slider }) => slider.off("change:value", take));
        model.off("change:hold", take);
      };
    },
  };
}

/** Arrow keys on a slider: a step; with Shift a tenth; Page keys ten; Home, End the limits. */
function sliderKeys(panel, joints) {
  const handle = (event) => {
    if (event.target.getAttribute("role") !== "slider" || !(event.key in KEYS)) return;
    const sliders = [...panel.querySelectorAll("[role=slider]")];
    joints()[sliders.indexOf(event.target)].press(KEYS[event.key], event.shiftKey);
    event.preventDefault();
    event.stopPropagation();
  };
  panel.addEventListener("keydown", handle, { capture: true });
  return () => panel.removeEventListener("keydown", handle, { capture: true });
}

async function render({ model, el }) {
  let joints, live, latest = 0, unwatch = () => {};
  const show = async () => {
    const turn = ++latest;
    live?.freeze();                                 // until the sliders of another arm are there
    const found = await sliderJoints(model, model.get("scene"));
    if (turn !== latest) return;
    joints = found.joints;
    unwatch();
    live = mount(el, model.get("svg"), model.get("scene"), found, live?.dismount());
    unwatch = watchPython(el, joints.map(({ slider }) => slider));
    remark();
  };
  const remark = () => live.note(model.get("note"));
  await show();
  model.on("change:note", remark);
  model.on("change:scene", show);
  keepWidgets(model.widget_manager);
  let release = () => {};
  const attach = requestAnimationFrame(() => {      // the view stands in the page by then
    const panel = el.closest(".kl-view")?.querySelector(".kl-joints");
    if (panel) release = sliderKeys(panel, () => joints);
  });
  return () => {
    latest = 0;
    cancelAnimationFrame(attach);
    release();
    unwatch();
    model.off("change:note", remark);
    model.off("change:scene", show);
    live.dismount();
  };
}

export default { render };
