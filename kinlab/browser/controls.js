// A slider with a field for its number: the same in a notebook and in a page.

import { make, tidy } from "./dom.js";
import { read } from "./numbers.js";
import { KEYS, clip, replaced, snap, stepped, stopsOf } from "./steps.js";

/** @import { Joints, Knob } from "./types.js" */

const HANDLE = 22;                                  // px, as in live.css

/**
 * Nobody but the element itself hears of its keys; a notebook has uses for them, too.
 * @param {HTMLElement} node
 * @param {(event: KeyboardEvent) => void} act
 */
function ownKeys(node, act) {
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

  /** As far as it may go now: of two handles on a track neither passes the other. */
  get reach() {
    const { low, high, step } = stopsOf(this.knob), all = this.all.ends(this.knob);
    const at = all.indexOf(this), before = all[at - 1]?.value, after = all[at + 1]?.value;
    return { low: Math.max(low, before ?? low), high: Math.min(high, after ?? high), step };
  }

  /**
   * Stand for this knob from now on, the joint of this number; what is held or half typed stays.
   * @param {Knob} knob
   * @param {number} joint
   */
  take(knob, joint) {
    this.knob = knob;
    if (knob.quantity !== "time") this.node.setAttribute("data-joint", String(joint));
    this.node.setAttribute("data-quantity", knob.quantity);
    this.label.className = knob.quantity ? `kl-of-${knob.quantity}` : "";
    const { label, title, unit } = knob, name = title ? `${label}, ${title}` : label;
    const { low, high } = this.all.track(knob);
    this.label.textContent = label;
    this.unit.textContent = unit;
    this.range.min = String(tidy(low));
    this.range.max = String(tidy(high));
    const { low: least, high: most } = knob, locked = least === most;
    for (const node of [this.label, this.range, this.field]) {
      node.title = `${title || label}${locked ? ", locked" : ""}`;
    }
    this.range.disabled = this.field.disabled = locked;
    this.range.setAttribute("aria-label", name);
    this.field.setAttribute("aria-label", `${name}, number${unit && " in "}${unit}`);
    this.value = NaN;                               // to be shown anew
  }

  listen() {
    const { range, field } = this;
    range.addEventListener("input", () => {
      this.took(snap(range.valueAsNumber, this.reach));
      if (this.knob.pair) range.value = String(this.value);   // it stops where the other one is
    });
    range.addEventListener("pointerdown", () => this.all.joints?.gripped?.add(this.knob.name));
    for (const end of ["pointerup", "pointercancel"]) {
      range.addEventListener(end, () => this.all.joints?.gripped?.delete(this.knob.name));
    }
    ownKeys(range, (event) => {
      if (!(event.key in KEYS)) return;
      this.took(stepped(this.value, KEYS[event.key], event.shiftKey, this.reach));
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
    const { low, high } = this.all.track(this.knob);
    range.style.setProperty("--at", String((next - low) / (high - low || 1)));
    range.setAttribute("aria-valuetext", next.toFixed(digits) + suffix);
    const typing = field.value !== this.shown && field.matches(":focus");
    if (!typing) this.restore();
  }

  restore() {
    const text = this.value.toFixed(this.knob.digits);
    this.field.value = this.shown = Number(text) === 0 ? text.replace("-", "") : text;
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
    const { field, reach } = this, { unit } = this.knob;
    if (this.gone) return;
    if (field.value === this.shown || !field.value.trim()) return this.restore();
    const typed = read(field.value, { angle: unit === "°", unit });
    if (typed.reason != null) return this.wrong(typed.reason);
    this.shown = field.value;
    this.took(clip(typed.value, reach.low, reach.high));
    this.restore();
  }
}

/**
 * A track with two handles: two rows laid over each other. A press on the track brings the nearer
 * handle there.
 * @param {string} name
 * @param {string} quantity what kind of number it is, for its colour
 * @param {(share: number) => void} press hears how far along the track
 */
function trackOf(name, quantity, press) {
  const node = make("div", { class: "kl-pair", role: "group", "aria-label": name });
  const line = make("span", { class: "kl-track" });
  line.addEventListener("pointerdown", ({ clientX }) => {
    const { left, width } = line.getBoundingClientRect();
    press(clip((clientX - left - HANDLE / 2) / (width - HANDLE), 0, 1));
  });
  node.append(make("span", quantity ? { class: `kl-of-${quantity}` } : {}, name), line);
  return node;
}

/**
 * The rows of all knobs. They stay in the page while one scene follows another, so that a slider
 * is not taken out of a hand, nor a number out of the keyboard.
 */
export class Controls {
  node = make("div", { class: "kl-joints", role: "group", "aria-label": "Sliders" });

  /** @type {Map<string, Row>} */
  rows = new Map();

  /** @type {Map<string, HTMLElement>} */
  tracks = new Map();

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
    knobs.forEach((knob, i) => this.row(knob).take(knob, i + 1));
    const places = [...new Set(knobs.map((knob) => this.place(knob)))];
    places.forEach((node, i) => {
      const there = this.node.children[i];
      if (there !== node) this.node.insertBefore(node, there ?? null);
    });
    for (const left of [...this.node.children].slice(places.length)) left.remove();
    this.update();
  }

  /**
   * What stands in the page for a knob: its row, or the track that holds it and another.
   * @param {Knob} knob
   */
  place(knob) {
    const { node } = this.row(knob), { pair, quantity } = knob;
    if (!pair) return node;
    const track = this.tracks.get(pair) ??
      trackOf(pair, quantity, (share) => this.press(knob, share));
    this.tracks.set(pair, track);
    if (node.parentElement !== track) track.append(node);
    return track;
  }

  /**
   * The rows on a knob's track, the lower end first.
   * @param {Knob} knob
   */
  ends(knob) {
    const all = knob.pair ? this.knobs.filter(({ pair }) => pair === knob.pair) : [knob];
    return all.map((one) => this.row(one));
  }

  /**
   * Where the track of a knob begins and ends, in the slider's unit.
   * @param {Knob} knob
   */
  track(knob) {
    const all = this.ends(knob).map((row) => stopsOf(row.knob));
    return { low: Math.min(...all.map(({ low }) => low)),
             high: Math.max(...all.map(({ high }) => high)) };
  }

  /**
   * Bring the nearer handle to a place on the track.
   * @param {Knob} knob one of its knobs
   * @param {number} share
   */
  press(knob, share) {
    const { low, high } = this.track(knob), value = low + share * (high - low);
    const far = (/** @type {Row} */ row) => Math.abs(row.value - value) +
      Math.abs(clip(value, row.reach.low, row.reach.high) - value);   // and whether it gets there
    const nearest = this.ends(knob).reduce((a, b) => far(b) < far(a) ? b : a);
    nearest.took(snap(value, nearest.reach));
  }

  /** @param {Knob} knob */
  row(knob) { return /** @type {Row} */ (this.rows.get(knob.name)); }

  update() {
    this.joints?.read().forEach((value, i) => {
      this.row(this.knobs[i]).show(value / this.knobs[i].scale);
    });
    for (const [pair, node] of this.tracks) {
      const knob = this.knobs.find((one) => one.pair === pair);
      if (!knob) continue;
      const { low, high } = this.track(knob), rows = this.ends(knob);
      const shares = rows.map(({ value }) => (value - low) / (high - low));
      shares.forEach((share, k) => node.style.setProperty(`--end-${k}`, String(share)));
      rows[0].range.style.zIndex = shares[0] > 0.5 ? "2" : "";   // on top is the one that can go
    }
  }

  /**
   * @param {Knob} knob
   * @param {number} value in the slider's unit
   */
  write(knob, value) {
    const i = this.knobs.indexOf(knob);
    this.joints?.write(replaced(this.joints.read(), i, value * knob.scale));
  }

  /** Why some fields cannot be read. */
  reasons() { return [...this.rows.values()].map((row) => row.reason).filter(Boolean).join("; "); }
}
