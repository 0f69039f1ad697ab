// A chart of its own beside the picture: curves over counted steps, drawn as far as a knob has
// gone. Laid out as in kinlab/drawing/chart.py.

import { make } from "./dom.js";
import { clip } from "./steps.js";
import { chartWords, drawn, polyline, put, px } from "./svg.js";

/** @import { ChartScene, Paint, Plot, Track } from "./types.js" */

const CHART_LEFT = 48, CHART_RIGHT = 16, CHART_TOP = 34, CHART_BOTTOM = 42;   // px round the curves
const NUMBER_WIDE = 34, NUMBER_HIGH = 24;          // px that a number wants on an axis
const MARKERS_APART = 7;                            // px
const LEGEND_LINE = 26, LEGEND_GAP = 14, LEGEND_LETTER = 7;   // px: a piece of a curve, a letter
const LOWEST_DECADE = -300;                         // of what is smaller still, and of zero

/**
 * The value as a power of ten.
 * @param {number} value
 */
const decade = (value) => value > 0 ? Math.log10(value) : LOWEST_DECADE;

/**
 * The smallest of 1, 2, 5, 10, 20, ... that is no less than `least`.
 * @param {number} least
 */
function niceStep(least) {
  const tens = 10 ** Math.max(0, Math.floor(Math.log10(least)));
  return tens * ([1, 2, 5].find((step) => step * tens >= least) ?? 10);
}

/** @type {(power: number) => string} */
const powerOfTen = (power) =>
  `10${[...String(power)].map((digit) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[Number(digit)] ?? "⁻").join("")}`;

/**
 * A curve, gone as far as `place`, with a marker on some steps. What comes is not shown: which
 * of two curves falls faster is for the student to find out.
 * @param {number[][]} points
 * @param {number} place
 * @param {number} every
 * @returns {Track}
 */
function curveTrack(points, place, every) {
  const at = clip(place, 0, points.length - 1), k = Math.floor(at), gone = points.slice(0, k + 1);
  if (at > k) gone.push(points[k].map((e, i) => e + (at - k) * (points[k + 1][i] - e)));
  return { gone, markers: points.slice(0, k + 1).filter((_, j) => j % every === 0) };
}

/**
 * The curves' names beside pieces of them, side by side up to the right end: where each begins.
 * @param {ChartScene["curves"]} curves
 * @param {number} right
 */
function legendPlaces(curves, right) {
  const wide = curves.map(({ name }) => LEGEND_LINE + 6 + LEGEND_LETTER * name.length);
  const all = wide.reduce((sum, w) => sum + w + LEGEND_GAP, -LEGEND_GAP);
  let x = right - all;
  return curves.map(({ name }, k) => {
    const entry = /** @type {[number, string]} */ ([x, name]);
    x += wide[k] + LEGEND_GAP;
    return entry;
  });
}

/**
 * A chart laid out on a picture of `size` px, at the knobs' values q.
 * @param {ChartScene} chart
 * @param {number[]} size
 * @param {number[]} q
 * @returns {Plot}
 */
export function plotted({ curves, knob, last, low, high }, [width, height], q) {
  const [left, top, right, bottom] = [CHART_LEFT, CHART_TOP, width - CHART_RIGHT,
                                      height - CHART_BOTTOM];
  const wide = (right - left) / last, deep = (bottom - top) / (high - low);
  /** @type {Plot["across"]} */
  const across = [];
  for (let j = 0, by = niceStep(NUMBER_WIDE / wide); j <= last; j += by) {
    across.push([left + j * wide, String(j)]);
  }
  /** @type {Plot["up"]} */
  const up = [];
  for (let k = high, by = Math.ceil(NUMBER_HIGH / deep); k >= low; k -= by) {
    up.push([top + (high - k) * deep, powerOfTen(k)]);
  }
  const tracks = curves.map(({ values }) => curveTrack(values.map((value, j) =>
    [left + j * wide, bottom - (Math.max(decade(value), low) - low) * deep]),
  q[knob], Math.ceil(MARKERS_APART / wide)));
  return { box: [left, top, right, bottom], across, up, tracks,
           legend: legendPlaces(curves, right) };
}

/**
 * Outlines of markers, r px to each side of their place.
 * @type {Record<string, (place: number[], r: number) => string>}
 */
const MARKERS = {
  dot: ([x, y], r) =>
    `M${px(x - r)} ${px(y)}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0Z`,
  square: ([x, y], r) => `M${px(x - r)} ${px(y - r)}h${2 * r}v${2 * r}h${-2 * r}Z`,
};

const STEP_MARK = 2.4, NOW_MARK = 4.6;              // px: markers of the steps, and of this one

/**
 * The lines and words that stay where they are: grid, numbers, titles, and who is who.
 * @param {ChartScene} chart
 * @param {Plot} plot
 */
function chartFrame(chart, { box: [left, top, right, bottom], across, up, legend }) {
  const grid = up.map(([y]) => `M${px(left)} ${px(y)}H${px(right)}`);
  const ticks = across.map(([x]) => `M${px(x)} ${px(bottom)}v4`);
  return [
    drawn("path", { d: [...grid, ...ticks].join(""), "data-part": "grid" }),
    ...up.map(([y, text]) => chartWords(text, left - 7, y, "end")),
    ...across.map(([x, text]) => chartWords(text, x, bottom + 13, "middle")),
    chartWords(chart.up, 4, top - 22),
    chartWords(chart.across, (left + right) / 2, bottom + 31, "middle"),
    ...legend.map(([x, name]) => chartWords(name, x + LEGEND_LINE + 6, top - 22)),
  ];
}

export class Chart {
  /** @type {number[]} */
  size = [0, 0];

  /** @type {number[] | null} */
  q = null;

  /**
   * @param {ChartScene} chart
   * @param {Record<string, Paint>} paints
   */
  constructor(chart, paints) {
    this.chart = chart;
    this.frame = drawn("g", { "data-part": "axes" });
    this.curves = chart.curves.map(({ name, style, marker }) => {
      const line = { ...paints[style], fill: "none", words: "" }, { stroke } = paints[style];
      const paths = { gone: drawn("path", { ...line, "data-part": "gone" }),
                      sample: drawn("path", { ...line, "data-part": "sample" }),
                      markers: drawn("path", { stroke, fill: stroke, "data-part": "markers" }) };
      const group = drawn("g", { class: `kl-${style}`, "data-curve": name },
                          ...Object.values(paths));
      return { ...paths, group, marked: MARKERS[marker] };
    });
    this.svg = drawn("svg", { role: "img", "aria-label": `Chart: ${chart.up} at each ` +
                              `${chart.across}` }, this.frame,
                     ...this.curves.map(({ group }) => group));
    this.node = make("div", { class: "kl-chart" }, this.svg);
    this.watch = new ResizeObserver(() => this.resize());
    this.watch.observe(this.node);
  }

  /** Lay it out anew where the page has given it another size. */
  resize() {
    const { clientWidth: width, clientHeight: height } = this.node;
    if (!width || width === this.size[0] && height === this.size[1]) return;
    this.size = [width, height];
    put(this.svg, "viewBox", `0 0 ${width} ${height}`);
    this.frame.replaceChildren();
    if (this.q) this.draw(this.q);
  }

  /**
   * Draw the curves as far as the knobs' values say.
   * @param {number[]} q
   */
  draw(q) {
    this.q = q;
    if (!this.size[0]) return;
    const plot = plotted(this.chart, this.size, q), beside = plot.box[1] - 22;
    if (!this.frame.firstChild) this.frame.replaceChildren(...chartFrame(this.chart, plot));
    this.curves.forEach(({ gone, sample, markers, marked }, k) => {
      const { gone: way, ...points } = plot.tracks[k], x = plot.legend[k][0];
      put(gone, "d", polyline(way));
      put(sample, "d", polyline([[x, beside], [x + LEGEND_LINE, beside]]));
      put(markers, "d", marked([x + LEGEND_LINE / 2, beside], STEP_MARK) +
        points.markers.map((place) => marked(place, STEP_MARK)).join("") +
        marked(way[way.length - 1], NOW_MARK));
    });
  }

  /** Let go of the page. */
  leave() { this.watch.disconnect(); }
}
