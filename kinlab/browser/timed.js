// Curves over time beside a picture, with the limits that they should keep: the joints of a path,
// their rates, and how fast the tip goes. Laid out as in kinlab/drawing/timed.py.

import { button, make, number, write } from "./dom.js";
import { between } from "./frames.js";
import { Mover, wantsCalm } from "./player.js";
import { rove } from "./roving.js";
import { clip } from "./steps.js";
import { chartWords, drawn, polyline, put, px } from "./svg.js";

/** @import { Pointing } from "./pointing.js" */
/** @import { Drive, Joints, Paint, Panel, PanelPlot, Pointed, Timed } from "./types.js" */

const PANEL_LEFT = 54, PANEL_RIGHT = 12, PANEL_TOP = 26, PANEL_BOTTOM = 22;   // px round curves
const TICK_WIDE = 44, TICK_HIGH = 26;              // px that a number wants on an axis
const SAMPLE_WIDE = 30, SAMPLE_HIGH = 10;           // px: of a piece of a curve
const NOW_DOT = 3.6, LEAST_BAND = 1.5;              // px
const SIGN_WIDE = 34, SIGN_HIGH = 15, SIGN_DOWN = 9;   // px of a band's sign, and to the first row
// Px of the letters of a page, and how many times as large they are in a lecture at most.
const PLAIN_LETTERS = 16, MOST_ENLARGED = 1.5;
const CALM_STOPS = 8;                               // of a motion, for who prefers less of it
const ROUND_STEPS = [1, 2, 5];

/**
 * The number of the sample at a time, or between which two it is: `place` in
 * kinlab/drawing/timed.py.
 * @param {number[]} times
 * @param {number} time
 */
export function placeIn(times, time) {
  const last = times.length - 1;
  if (time >= times[last]) return last;
  let low = 0, high = last;                         // times[low] <= time < times[high]
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle] <= time) low = middle; else high = middle;
  }
  return low + Math.max(0, (time - times[low]) / (times[high] - times[low]));
}

/**
 * The knobs' values as motions and items take them: of a time the number of its sample.
 * @param {{ timed?: Pick<Timed, "times"> | null }} scene
 * @param {number[]} q
 */
export const placesOf = ({ timed }, q) =>
  timed ? [placeIn(timed.times, q[0]), ...q.slice(1)] : q;

/**
 * Round numbers from low to high, at least so far apart, and how they are written.
 * @param {number} low
 * @param {number} high
 * @param {number} least
 * @returns {[value: number, text: string][]}
 */
function roundNumbers(low, high, least) {
  const tens = Math.floor(Math.log10(least));
  const all = [tens, tens + 1].flatMap((e) => ROUND_STEPS.map((k) => ({ e, step: k * 10 ** e })));
  const { e, step } = all.find((one) => one.step >= least * (1 - 1e-9)) ?? all[all.length - 1];
  const first = Math.ceil(low / step - 1e-9), last = Math.floor(high / step + 1e-9);
  return Array.from({ length: last - first + 1 }, (_, k) =>
    [(first + k) * step, ticked((first + k) * step, e)]);
}

/**
 * A number on an axis; with an e if it is long.
 * @param {number} value
 * @param {number} tens
 */
function ticked(value, tens) {
  const fine = tens < -4;
  return value && (fine || Math.abs(value) > 99999)
    ? (+value.toPrecision(6)).toExponential().replace("+", "").replace(/-/g, "\u2212")
    : number(value, fine ? 0 : Math.max(0, -tens));
}

/**
 * Where the signs of bands stand: in the middle of each, within the panel, and in a row where no
 * other sign is.
 * @param {PanelPlot["bands"]} bands
 * @param {number} left
 * @param {number} top
 * @param {number} right
 */
function signsOf(bands, left, top, right) {
  /** @type {PanelPlot["signs"]} */
  const taken = [];
  for (const [from, to] of bands) {
    const x = clip((from + to) / 2, left + SIGN_WIDE / 2, right - SIGN_WIDE / 2);
    let y = top + SIGN_DOWN;
    while (taken.some(([u, v]) => v === y && Math.abs(x - u) < SIGN_WIDE)) y += SIGN_HIGH;
    taken.push([x, y]);
  }
  return taken;
}

/**
 * A panel laid out on a picture of `size` px, at a time.
 * @param {Panel} panel
 * @param {number[]} times
 * @param {number[]} size
 * @param {number} time
 * @returns {PanelPlot}
 */
export function laidOut({ low, high, courses, bounds, bands }, times, [width, height], time) {
  const [left, top, right, bottom] = [PANEL_LEFT, PANEL_TOP, width - PANEL_RIGHT,
                                      height - PANEL_BOTTOM];
  const last = times[times.length - 1];
  const wide = (right - left) / last, deep = (bottom - top) / (high - low);
  const along = (/** @type {number} */ t) => left + t * wide;
  const down = (/** @type {number} */ value) => bottom - (value - low) * deep;
  const whole = courses.map(({ values }) => values.map((v, k) => [along(times[k]), down(v)]));
  const at = placeIn(times, time), k = Math.floor(at);
  const gone = whole.map((points) => [...points.slice(0, k + 1),
    ...at > k ? [points[k].map((e, i) => e + (at - k) * (points[k + 1][i] - e))] : []]);
  /** @type {PanelPlot["bands"]} */
  const spans = bands.map(({ start, end }) => [along(start), along(end)]);
  return { box: [left, top, right, bottom],
           across: roundNumbers(0, last, TICK_WIDE / wide).map(([t, text]) =>
             [along(t), t ? text : `${text} s`]),
           up: roundNumbers(low, high, TICK_HIGH / deep).map(([v, text]) => [down(v), text]),
           zero: low <= 0 && high >= 0 ? down(0) : null, whole, gone,
           bounds: bounds.map(({ level }) => down(level)),
           bands: spans, signs: signsOf(spans, left, top, right),
           now: along(clip(time, 0, last)) };
}

/**
 * What marks a band: a sign, and whose it is.
 * @param {Panel} panel
 * @param {number} k
 */
const signOf = ({ bands, courses }, k) =>
  `! ${courses.find(({ joint }) => joint === bands[k].joint)?.name ?? ""}`;

/** @type {(style: string) => string} */
const classOf = (style) => `kl-${style.replace("-", " kl-")}`;

/** @type {(paint: Paint) => Record<string, unknown>} */
const lineOf = (paint) => ({ ...paint, fill: "none", words: "" });

/** One panel: its frame, which stays, and its curves, which go on. */
class PanelChart {
  size = [0, 0];

  /**
   * @param {Panel} panel
   * @param {Timed} timed
   * @param {Record<string, Paint>} paints
   */
  constructor(panel, { times }, paints) {
    this.panel = panel;
    this.times = times;
    this.frame = drawn("g", { "data-part": "axes" });
    this.now = drawn("path", { "data-part": "now" });
    this.bands = panel.bands.map(({ joint }) =>
      drawn("path", { "data-part": "band", "data-of": joint }));
    this.signs = panel.bands.map(({ joint }) =>
      drawn("g", { "data-part": "sign", "data-of": joint }));
    this.bounds = panel.bounds.map(({ style, joint }) =>
      drawn("g", { class: classOf(style), "data-of": joint },
            drawn("path", { ...lineOf(paints[style]), "data-part": "bound" })));
    this.courses = panel.courses.map(({ name, style, joint }) => {
      const line = lineOf(paints[style]), { stroke } = paints[style];
      const [whole, gone] = ["whole", "gone"].map((part) =>
        drawn("path", { ...line, "data-part": part }));
      const dot = drawn("circle", { r: NOW_DOT, fill: stroke, "data-part": "dot" });
      const group = drawn("g", { class: classOf(style), "data-course": name, "data-of": joint },
                          whole, gone, dot);
      return { group, whole, gone, dot };
    });
    this.svg = drawn("svg", { role: "img", "aria-label": `Chart over time: ${panel.title}` },
                     ...this.bands, this.frame, ...this.bounds, this.now,
                     ...this.courses.map(({ group }) => group), ...this.signs);
    this.node = make("div", { class: "kl-chart kl-over-time" }, this.svg);
  }

  /** @returns {boolean} whether the page has given it another size */
  resize() {
    const { clientWidth: width, clientHeight: height } = this.node;
    const letters = parseFloat(getComputedStyle(this.node).fontSize) / PLAIN_LETTERS;
    const larger = clip(letters, 1, MOST_ENLARGED), size = [width / larger, height / larger];
    if (!width || size.every((side, k) => side === this.size[k])) return false;
    this.size = size;
    put(this.svg, "viewBox", `0 0 ${size.join(" ")}`);
    this.frame.replaceChildren();
    return true;
  }

  /** @param {number} time */
  draw(time) {
    if (!this.size[0]) return;
    const plot = laidOut(this.panel, this.times, this.size, time), [, top, , bottom] = plot.box;
    if (!this.frame.firstChild) this.still(plot);
    put(this.now, "d", `M${px(plot.now)} ${px(top)}V${px(bottom)}`);
    this.courses.forEach(({ gone, dot }, k) => {
      put(gone, "d", polyline(plot.gone[k]));
      const [x, y] = plot.gone[k][plot.gone[k].length - 1];
      put(dot, "cx", px(x));
      put(dot, "cy", px(y));
    });
  }

  /**
   * What stays where it is until the size is another one.
   * @param {PanelPlot} plot
   */
  still({ box: [left, top, right, bottom], across, up, zero, whole, bounds, bands, signs }) {
    const grid = up.map(([y]) => `M${px(left)} ${px(y)}H${px(right)}`);
    const ticks = across.map(([x]) => `M${px(x)} ${px(bottom)}v4`);
    this.frame.replaceChildren(
      drawn("path", { d: [...grid, ...ticks].join(""), "data-part": "grid" }),
      drawn("path", { d: zero == null ? "" : `M${px(left)} ${px(zero)}H${px(right)}`,
                      "data-part": "zero" }),
      ...up.map(([y, text]) => chartWords(text, left - 7, y, "end")),
      ...across.map(([x, text]) => chartWords(text, x, bottom + 12, "middle")),
      chartWords(this.panel.title, 4, top - 15));
    this.courses.forEach((course, k) => put(course.whole, "d", polyline(whole[k])));
    this.bounds.forEach((bound, k) => put(bound.firstElementChild ?? bound, "d",
      `M${px(left)} ${px(bounds[k])}H${px(right)}`));
    this.bands.forEach((band, k) => {
      const [from, to] = bands[k], wide = Math.max(LEAST_BAND, to - from);
      put(band, "d", `M${px(from)} ${px(top)}h${px(wide)}V${px(bottom)}h${px(-wide)}Z`);
      this.signs[k].replaceChildren(
        chartWords(signOf(this.panel, k), ...signs[k], "middle"));
    });
  }

  /**
   * The time under a pointer.
   * @param {number} clientX
   */
  timeAt(clientX) {
    const { left, width } = this.svg.getBoundingClientRect();
    const share = ((clientX - left) * this.size[0] / width - PANEL_LEFT) /
      (this.size[0] - PANEL_LEFT - PANEL_RIGHT);
    return clip(share, 0, 1) * this.times[this.times.length - 1];
  }
}

/** All panels with the names of their curves, by which a joint is singled out. */
export class TimedCharts {
  /** @type {number | null} */
  alone = null;                                     // the joint whose name is pressed

  time = 0;

  /**
   * @param {Timed} timed
   * @param {Record<string, Paint>} paints
   * @param {Joints} joints
   * @param {Pointing} pointing
   */
  constructor(timed, paints, joints, pointing) {
    this.timed = timed;
    this.joints = joints;
    this.pointing = pointing;
    this.panels = timed.panels.map((panel) => new PanelChart(panel, timed, paints));
    const named = timed.panels.filter((_, k) => timed.panels.findIndex(({ courses }) =>
      courses[0].name === timed.panels[k].courses[0].name) === k);
    this.names = named.flatMap(({ courses }) => courses).map((course) =>
      this.name(course, paints[course.style]));
    const switches = this.layers().map((layer) => this.switch(layer));
    this.legend = make("div", { class: "kl-toolbar kl-names", role: "toolbar",
                                "aria-label": "Curves" },
                       ...this.names.map(({ node }) => node), ...switches);
    rove(this.legend);
    this.said = make("div", { class: "kl-broken", role: "list",
                              "aria-label": "Limits that are broken" },
                     ...timed.remarks.map(({ text, joint }) =>
                       make("div", { role: "listitem", "data-joint": joint }, text)));
    this.node = make("div", { class: "kl-timed" }, this.legend,
                     ...this.panels.map(({ node }) => node));
    this.panels.forEach((panel) => this.scrub(panel));
    this.watch = new ResizeObserver(() => this.resize());
    this.panels.forEach(({ node }) => this.watch.observe(node));
  }

  layers() { return [...new Set(this.timed.panels.flatMap(({ layer }) => layer || []))]; }

  /**
   * The name of a curve with a piece of it and its value now: a button, if it is a joint's.
   * @param {Panel["courses"][number]} course
   * @param {Paint} paint
   */
  name(course, paint) {
    const { name, style, joint } = course, value = make("span", { class: "kl-number" });
    const y = SAMPLE_HIGH / 2;
    const sample = drawn("svg", { class: classOf(style), width: SAMPLE_WIDE, height: SAMPLE_HIGH,
      "aria-hidden": "true" },
      drawn("path", { ...lineOf(paint), d: `M1 ${y}H${SAMPLE_WIDE - 1}` }));
    const node = joint == null ? make("span", { class: "kl-button kl-name" })
      : button("", `Show ${name} alone`, () => this.single(joint),
               { "data-joint": joint, "aria-pressed": "false", class: "kl-button kl-name" });
    node.append(sample, `${name} `, value);
    return { node, course, value };
  }

  /**
   * A button that shows the panels of a layer.
   * @param {string} layer
   */
  switch(layer) {
    const of = this.panels.filter(({ panel }) => panel.layer === layer);
    const show = (/** @type {boolean} */ on) =>
      of.forEach(({ node }) => node.toggleAttribute("hidden", !on));
    show(false);
    return button(layer[0].toUpperCase() + layer.slice(1), `Show the ${layer} too`, (node) => {
      const on = node.getAttribute("aria-pressed") !== "true";
      node.setAttribute("aria-pressed", String(on));
      show(on);
    }, { "aria-pressed": "false" });
  }

  /**
   * Single out a joint, or none any more.
   * @param {number} joint
   */
  single(joint) {
    this.alone = this.alone === joint ? null : joint;
    this.pointing.point(this.alone == null ? null : { joints: [joint] }, "tap");
    for (const { node, course } of this.names) {
      if (course.joint != null) {
        node.setAttribute("aria-pressed", String(course.joint === this.alone));
      }
    }
  }

  /**
   * Let a hand drag the time in a panel.
   * @param {PanelChart} panel
   */
  scrub(panel) {
    const { node } = panel;
    const take = (/** @type {PointerEvent} */ { clientX }) =>
      this.joints.write([panel.timeAt(clientX)]);
    node.addEventListener("pointerdown", (event) => {
      if (event.button) return;
      node.setPointerCapture(event.pointerId);
      take(event);
    });
    node.addEventListener("pointermove", (event) => {
      if (node.hasPointerCapture(event.pointerId)) take(event);
    });
  }

  resize() {
    if (this.panels.map((panel) => panel.resize()).some(Boolean)) this.draw([this.time]);
  }

  /** @param {number[]} q */
  draw([time]) {
    this.time = time;
    const at = placeIn(this.timed.times, time);
    for (const panel of this.panels) panel.draw(time);
    for (const { course, value } of this.names) {
      write(value, valueNow(course, at));
    }
  }

  /**
   * Let all curves step back but those of the joints that are pointed at.
   * @param {Pointed | null} now
   */
  light(now) {
    const on = now != null && now.joints.size > 0;
    for (const { svg } of this.panels) {
      for (const part of svg.querySelectorAll("[data-of]")) {
        const joint = Number(part.getAttribute("data-of"));
        part.classList.toggle("kl-away", on && !now.joints.has(joint));
      }
    }
  }

  /** What there is to see, in words. */
  text() {
    const values = this.names.map(({ course, value }) => `${course.name} ${value.textContent}`);
    return [`time ${number(this.time, 2)} s`, ...values].join(", ");
  }

  /** Let go of the page. */
  leave() { this.watch.disconnect(); }
}

/** Plays a motion in time. */
export class Film extends Mover {
  /**
   * Let the first knob run on to its end, as the time does: a second takes a second. Who prefers
   * less motion sees stops on the way, each for as long as the way to the next one takes.
   * @param {Drive} joints
   * @param {number} end of the time (s)
   */
  run(joints, end) {
    this.stop();
    const stop = wantsCalm() ? end / CALM_STOPS : 0, [now] = joints.read();
    let since = /** @type {number | null} */ (null);
    const from = now < end ? now : 0;
    this.goal = [end];
    const step = (/** @type {number} */ at) => {
      since ??= at;
      const time = Math.min(end, from + (at - since) / 1000);
      const shown = stop && time < end ? Math.floor(time / stop + 1e-9) * stop : time;
      this.write(joints, [Math.max(shown, from)]);
      if (time === end) return this.stop();
      this.request = requestAnimationFrame(step);
    };
    this.request = requestAnimationFrame(step);
  }
}

/**
 * The value of a course at a place among its samples, with three digits or so.
 * @param {Panel["courses"][number]} course
 * @param {number} at
 */
function valueNow({ values, unit }, at) {
  const most = Math.max(...values.map(Math.abs));
  const digits = clip(2 - Math.floor(Math.log10(most || 1)), 0, 4);
  return `${number(between(values, at), digits)}${unit === "°" ? "" : " "}${unit}`;
}
