// A cloud of dots in the room, cut open by a plane; the nearer, the stronger. As in
// kinlab/drawing/cloud.py.

import { Part } from "./parts.js";
import { clip } from "./steps.js";
import { drawn, put } from "./svg.js";
import { dot, minus } from "./vectors.js";

/** @import { Frame, Lens, Paint, Triple } from "./types.js" */
/** @import { Whole } from "./parts.js" */

const SLICE = "slice";                              // the layer that cuts it open while it is on
const FIRST_LETTER = 0x100;                         // for the lowest place along an axis
const FADES = [0.3, 0.45, 0.65, 0.9];               // of layers of dots, from far to near

/**
 * The dots in layers from far to near. Those on the negative side of a plane are cut away.
 * @param {Triple[]} dots
 * @param {Frame | null} plane its x and z axes span it
 * @param {Lens} lens
 * @param {Triple} middle of the cloud
 * @param {number} radius of it
 */
export function cloudLayers(dots, plane, lens, middle, radius) {
  /** @type {Triple[][]} */
  const layers = FADES.map(() => []), slack = 1e-9 * radius;
  for (const place of dots) {
    if (plane && dot(minus(place, plane[3]), plane[1]) < -slack) continue;
    const near = dot(minus(place, middle), lens.near) / radius;
    layers[clip(Math.floor((near + 1) / 2 * FADES.length), 0, FADES.length - 1)].push(place);
  }
  return layers;
}

/**
 * The dots that letters stand for: three each, for the places along the axes of a lattice.
 * @param {Triple} corner
 * @param {string} letters
 * @param {number} step
 * @returns {Triple[]}
 */
export function unpacked(corner, letters, step) {
  const dots = [];
  for (let k = 0; k < letters.length; k += 3) {
    dots.push(corner.map((e, i) => e + step * (letters.charCodeAt(k + i) - FIRST_LETTER)));
  }
  return dots;
}

/** @type {(value: number) => number} */
const half = (value) => Math.round(2 * value) / 2;  // px: dots need no more, and half the letters

/** A cloud of dots, which a plane may cut open. */
export class Cloud extends Part {
  isCut = true;

  /**
   * @param {Whole} item
   * @param {Paint} paint
   */
  constructor(item, paint) {
    super(item);
    const [[, ...corner]] = item.points;
    this.dots = unpacked(corner, item.text, item.size[1]);
    this.paths = FADES.map((fade) => drawn("path", { ...paint, fill: "none", opacity: fade }));
    this.group.append(...this.paths);
  }

  /**
   * @param {string} layer
   * @param {boolean} on
   */
  cutBy(layer, on) {
    if (layer === SLICE) this.isCut = on;
  }

  /**
   * @param {Frame[]} all
   * @param {Lens} lens
   * @param {Triple} middle
   * @param {number} radius
   */
  draw(all, lens, middle, radius) {
    const plane = this.isCut ? all[this.item.size[0]] : null;
    cloudLayers(this.dots, plane, lens, middle, radius).forEach((layer, k) => {
      put(this.paths[k], "d", layer.map((place) => {
        const [x, y] = lens.see(place);
        return `M${half(x)} ${half(y)}h0`;
      }).join(""));
    });
  }
}
