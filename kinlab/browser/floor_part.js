// The floor in an SVG picture: what floor.js says stands on it.

import { FADE, drop, giveWay, ground, saidOnce, shadow } from "./floor.js";
import { Pool, display, drawn, letter, polygon, polyline, put, px } from "./svg.js";

/** @import { Body } from "./order.js" */
/** @import { Ground, RulerNumber, Words as FloorWords } from "./floor.js" */
/** @import { Box, Label, Placed } from "./labels.js" */
/** @import { Floor, Frame, Lens, Shape, Triple } from "./types.js" */
/** @typedef {{ body: Body, group: SVGGElement }} Dropped */
/** @typedef {{ shape: Shape, ends: Triple[], size: number[] }} Shading */

let floors = 0;                                     // each gradient of the page has its own name

/** @type {(part: string, ...nodes: SVGElement[]) => SVGGElement} */
const named = (part, ...nodes) =>
  drawn("g", { class: `kl-${part}`, "data-part": part, "data-frame": "0" }, ...nodes);

export class FloorPart {
  on = true;

  /**
   * Coordinates of feet and heights, which make room as all words do.
   * @type {Label[]}
   */
  labels = [];

  /** @type {FloorWords[]} */
  coordinates = [];

  /** @type {RulerNumber[]} */
  numbers = [];

  /** @param {Floor} floor */
  constructor(floor) {
    this.floor = floor;
    const id = `kl-floor-${floors += 1}`, path = () => drawn("path");
    this.fades = ["grid", "x", "y", "pane"].map((ink) => fade(`${id}-${ink}`, ink));
    this.pane = drawn("path", { fill: `url(#${id}-pane)`, "data-part": "pane" });
    this.grid = drawn("path", { stroke: `url(#${id}-grid)` });
    this.rulers = ["x", "y"].map((ink) => drawn("path",
      { stroke: `url(#${id}-${ink})`, "stroke-width": 1.4 }));
    this.shade = [drawn("path", { class: "kl-penumbra" }), drawn("path", { class: "kl-umbra" })];
    const marks = named("foot");
    this.guides = new Pool(marks, () => drawn("path", { class: "kl-guide" }));
    this.feet = new Pool(marks, path);
    this.lines = floor.drops.map(() => named("dropline", drawn("path")));
    this.numerals = new Pool(named("numbers"), () => drawn("text"));
    this.texts = new Pool(named("coordinates"), () => drawn("text"));
    this.group = named("floor", drawn("defs", {}, ...this.fades), this.pane,
      named("ground", this.grid, ...this.rulers), named("shadow", ...this.shade), marks,
      this.numerals.group);
    this.words = this.texts.group;
  }

  /** @param {boolean} on */
  show(on) {
    this.on = on;
    for (const node of [this.group, this.words, ...this.lines]) display(node, on);
    if (!on) this.settle();
  }

  /**
   * Lines from frames to their feet, to be drawn among the solids.
   * @param {Frame[]} at
   * @returns {Dropped[]}
   */
  dropped(at) {
    if (!this.on) return [];
    return this.floor.drops.map((k, i) => {
      const [x, y, z] = at[k][3], { height } = this.floor;
      return { group: this.lines[i],
               body: { p: [x, y, z - 0.02 * (z - height)], q: [x, y, height], r: 0 } };
    });
  }

  /**
   * @param {Lens} lens
   * @param {Frame[]} at
   * @param {Shading[]} solids
   * @param {boolean} sunk whether something lies beyond the floor
   * @param {number[]} size
   */
  draw(lens, at, solids, sunk, size) {
    if (!this.on) return;
    const { floor } = this, seen = ground(floor, lens, size);
    this.drawGround(seen, sunk);
    const outlines = shadow(floor, lens, solids).map(polygon).join("");
    for (const node of this.shade) put(node, "d", outlines);
    this.drawDrops(lens, at, size);
    this.numbers = seen.numbers;
  }

  /** @param {Ground} seen @param {boolean} sunk */
  drawGround({ grid, rulers, rim, fade: { center: [x, y], radius, squeeze } }, sunk) {
    put(this.grid, "d", grid.map(polyline).join(""));
    rulers.forEach((line, k) => put(this.rulers[k], "d", polyline(line)));
    put(this.pane, "d", sunk ? polygon(rim) : "");
    for (const node of this.fades) {
      put(node, "gradientTransform", `translate(${px(x)} ${px(y)}) scale(1 ${squeeze.toFixed(2)})`);
      put(node, "r", px(radius));
    }
  }

  /** @param {Lens} lens @param {Frame[]} at @param {number[]} size */
  drawDrops(lens, at, size) {
    const drops = this.floor.drops.map((k) => drop(this.floor, lens, size, at[k][3]));
    drops.forEach(({ line }, k) =>
      put(/** @type {Element} */ (this.lines[k].firstElementChild), "d", polyline(line)));
    this.guides.show(drops.flatMap(({ guides }) => guides), (node, line) =>
      put(node, "d", polyline(line)));
    this.feet.show(drops, (node, { foot }) => put(node, "d", polygon(foot)));
    const states = this.labels.map(({ state }) => state);
    this.coordinates = saidOnce(drops);
    this.labels = this.coordinates.map(({ place, w, h }, k) =>
      ({ anchor: place, from: null, w, h, state: states[k] }));
  }

  /** @param {(Placed | null)[]} places of the labels */
  writeCoordinates(places) {
    places.forEach((spot, k) => { this.labels[k].state = spot?.state; });
    const shown = this.coordinates.flatMap((words, k) => {
      const spot = places[k];
      return spot ? [{ ...words, place: [spot.x, spot.y] }] : [];
    });
    this.texts.show(shown, writeAt);
  }

  /** Let the labels find their places anew. */
  settle() { this.labels = []; }

  /**
   * Show the numbers on the rulers that no other words cover.
   * @param {Box[]} words
   */
  giveWay(words) {
    this.numerals.show(giveWay(this.numbers, words), (node, one) => {
      writeAt(node, one);
      put(node, "class", `kl-number-${one.axis}`);
      put(node, "opacity", one.opacity.toFixed(2));
    });
  }
}

/** @type {(node: Element, words: FloorWords) => void} */
function writeAt(node, { text, place: [x, y] }) {
  letter(node, text);
  put(node, "x", px(x));
  put(node, "y", px(y));
}

/**
 * A gradient that lets an ink fade away from the middle of the floor.
 * @param {string} id
 * @param {string} ink
 */
function fade(id, ink) {
  return drawn("radialGradient", { id, cx: 0, cy: 0, gradientUnits: "userSpaceOnUse" },
    ...FADE.map(([offset, strong]) => drawn("stop", { offset, class: `kl-fade-${ink}`,
      "stop-opacity": ink === "pane" ? 0.7 * strong : strong })));
}
