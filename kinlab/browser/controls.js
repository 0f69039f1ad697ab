// A slider with a field for its number: the same in a notebook and in a page.

import { make, tidy } from "./dom.js";
import { read } from "./numbers.js";
import { KEYS, clip, snap, stepped } from "./steps.js";

/** @import { Joints, Knob } from "./types.js" */

/**
 * Nobody but the element itself hears of its keys; a notebook has uses for them, too.
 * @param {HTMLElement} node
 * @param {(event: KeyboardEvent) => void} act
 */
function ownKeys(node, act) {
  node.setAttribute("data-lm-suppress-shortcuts", "true");
  node.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    act(event);
    if (event.key !== "Tab") event.stopPropagation();
  });
}

/** The row of one knob: its name, a slider, a field for its number, and its unit. */
class Row {
  value = NaN;

  shown = "";                                       // in the field, unless something is typed there

  reason = "";                                      // why what was typed cannot be read

  gone = false;

  /**
   * @param {Controls} all
   * @param {Knob} knob
   */
  constructor(all, knob) {
    this.all = all;
    this.knob = knob;
    this.label = make("span");
    this.range = make("input", { type: "range", step: "any" });
    this.field = make("input", { type: "text", class: "kl-field", inputmode: "decimal",
      autocomplete: "off", spellcheck: "false", maxlength: 200 });
    this.unit = make("span", { class: "kl-unit" });
    this.node = make("div", { class: "kl-knob" }, this.label, this.range, this.field, this.unit);
    this.listen();
  }

  /** Limits and step in the slider's unit. */
  get units() {
    const { low, high, scale, step } = this.knob;
    return { low: low / scale, high: high / scale, step };
  }

  /**
   * Stand for this knob from now on, the joint of this number; what is held or half typed stays.
   * @param {Knob} knob
   * @param {number} joint
   */
  take(knob, joint) {
    this.knob = knob;
    this.node.setAttribute("data-joint", String(joint));
    this.label.className = knob.quantity ? `kl-of-${knob.quantity}` : "";
    const { label, title, unit } = knob, name = title ? `${label}, ${title}` : label;
    const { low, high } = this.units;
    this.label.textContent = label;
    this.unit.textContent = unit;
    this.range.min = String(tidy(low));
    this.range.max = String(tidy(high));
    for (const node of [this.label, this.range, this.field]) node.title = title || label;
    this.range.setAttribute("aria-label", name);
    this.field.setAttribute("aria-label", `${name}, number${unit ? ` in ${unit}` : ""}`);
    this.value = NaN;                               // to be shown anew
  }

  listen() {
    const { range, field } = this;
    range.addEventListener("input", () => this.took(snap(range.valueAsNumber, this.units)));
    range.addEventListener("pointerdown", () => this.all.joints?.gripped?.add(this.knob.name));
    for (const end of ["pointerup", "pointercancel"]) {
      range.addEventListener(end, () => this.all.joints?.gripped?.delete(this.knob.name));
    }
    ownKeys(range, (event) => {
      if (!(event.key in KEYS)) return;
      this.took(stepped(this.value, KEYS[event.key], event.shiftKey, this.units));
      event.preventDefault();
    });
    field.addEventListener("focus", () => field.select());
    field.addEventListener("change", () => this.commit());
    ownKeys(field, ({ key }) => {
      if (key === "Enter") this.commit();
      if (key === "Escape") this.restore();
    });
  }

  /** @param {number} value in the slider's unit, from a hand */
  took(value) { this.all.write(this.knob, value); }

  /** @param {number} next the value to show, in the slider's unit */
  show(next) {
    if (next === this.value) return;
    const { digits, suffix } = this.knob, { range, field } = this;
    this.value = next;
    if (range.valueAsNumber !== next) range.value = String(next);
    range.setAttribute("aria-valuetext", next.toFixed(digits) + suffix);
    const typing = field.value !== this.shown && field.matches(":focus");
    if (!typing) this.restore();
  }

  restore() {
    this.field.value = this.shown = this.value.toFixed(this.knob.digits);
    if (this.reason) this.wrong("");
  }

  /** @param {string} reason */
  wrong(reason) {
    this.reason = reason && `${this.knob.label}: ${reason}`;
    this.field.setAttribute("aria-invalid", String(Boolean(reason)));
    this.field.title = reason || this.knob.title || this.knob.label;
    this.all.remark();
  }

  /** Read what was typed; a field that is taken out of the page is not one that was left. */
  commit() {
    const { field, units } = this, { unit } = this.knob;
    if (this.gone) return;
    if (field.value === this.shown || !field.value.trim()) return this.restore();
    const typed = read(field.value, { angle: unit === "°", unit });
    if (typed.reason != null) return this.wrong(typed.reason);
    this.shown = field.value;
    this.took(clip(typed.value, units.low, units.high));
    this.restore();
  }
}

/**
 * The rows of all knobs. They stay in the page while one scene follows another, so that a slider
 * is not taken out of a hand, nor a number out of the keyboard.
 */
export class Controls {
  node = make("div", { class: "kl-joints", role: "group", "aria-label": "Sliders" });

  /** @type {Map<string, Row>} */
  rows = new Map();

  /** @type {Knob[]} */
  knobs = [];

  /** @type {Joints | null} */
  joints = null;

  remark = () => {};                                // called when a reason has come or gone

  /**
   * Show these knobs, and follow these joints.
   * @param {Knob[]} knobs
   * @param {Joints} joints
   * @param {() => void} remark
   */
  take(knobs, joints, remark) {
    Object.assign(this, { knobs, joints, remark });
    const before = this.rows;
    this.rows = new Map(knobs.map((knob) =>
      [knob.name, before.get(knob.name) ?? new Row(this, knob)]));
    for (const [name, row] of before) {
      if (this.rows.has(name)) continue;
      row.gone = true;
      row.node.remove();
    }
    knobs.forEach((knob, i) => {
      const row = this.row(knob), there = this.node.children[i];
      row.take(knob, i + 1);
      if (there !== row.node) this.node.insertBefore(row.node, there ?? null);
    });
    this.update();
  }

  /** @param {Knob} knob */
  row(knob) { return /** @type {Row} */ (this.rows.get(knob.name)); }

  update() {
    this.joints?.read().forEach((value, i) => {
      this.row(this.knobs[i]).show(value / this.knobs[i].scale);
    });
  }

  /**
   * @param {Knob} knob
   * @param {number} value in the slider's unit
   */
  write(knob, value) {
    const i = this.knobs.indexOf(knob);
    this.joints?.write(this.joints.read().map((old, k) => k === i ? value * knob.scale : old));
  }

  /** Why some fields cannot be read. */
  reasons() { return [...this.rows.values()].map((row) => row.reason).filter(Boolean).join("; "); }
}
