// The picture, drawn from the scene alone: the frames of frames.js, projected as in
// kinlab/drawing/figure.py, become paths, and nearer groups are put over farther ones.

import { lens } from "./camera.js";
import { frames, inRoom } from "./frames.js";
import { hull } from "./solids.js";
import { dot, minus } from "./vectors.js";

/** @import { Camera, Frame, Item, Lens, Paint, Scene, Shape, Triple } from "./types.js" */
/** @typedef {Required<Item> & { group: SVGGElement, node: SVGElement }} Drawn */

/** @type {(point: number[]) => string} */
const corner = ([x, y]) => `${x.toFixed(2)} ${y.toFixed(2)}`;

/** @type {(points: number[][]) => string} */
const polyline = (points) => `M ${points.map(corner).join(" L ")}`;

/** @param {number[][]} points */
function face(points) {
  const area = points.reduce((sum, [x, y], k) => {
    const [u, v] = points[(k + 1) % points.length];
    return sum + x * v - u * y;
  }, 0);
  return area < 0 ? `${polyline(points)} Z` : "";   // y points down
}

/** @param {number[][]} points */
function arrow([tail, tip]) {
  const [dx, dy] = [tip[0] - tail[0], tip[1] - tail[1]], length = Math.hypot(dx, dy);
  const [ux, uy] = length > 1e-9 ? [dx / length, dy / length] : [0, 0];
  const head = Math.min(9, 0.5 * length), side = 0.36 * head;
  const neck = [tip[0] - head * ux, tip[1] - head * uy];
  const wing = (/** @type {1 | -1} */ s) => [neck[0] - s * side * uy, neck[1] + s * side * ux];
  return polyline([tail, neck, wing(1), tip, wing(-1), neck, tail]);
}

/**
 * How the points of a shape become a path.
 * @type {Record<string, (points: number[][]) => string>}
 */
export const PATHS = { line: polyline, trace: polyline, face, arrow,
                       hull: (points) => `${polyline(hull(points))} Z` };

const TRACE_LENGTH = 4000;
const PAPER = { azimuth: -90, elevation: 90, zoom: 1 };   // x to the right, y up

const SVG = "http://www.w3.org/2000/svg";

/**
 * An element of an SVG picture.
 * @template {keyof SVGElementTagNameMap} Tag
 * @param {Tag} tag
 * @param {Record<string, unknown>} attributes
 * @param {(Node | string)[]} children
 */
function drawn(tag, attributes, ...children) {
  const node = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, String(value));
  node.append(...children);
  return node;
}

const OPEN = ["line", "trace"];                     // shapes that are never filled

/**
 * An item with its group, painted and still without its place.
 * @param {Item} item
 * @param {Paint} paint
 * @returns {Drawn}
 */
function shown(item, paint) {
  const { gid, shape, style, text = "" } = item;
  const node = shape === "text" ? drawn("text", { fill: paint.words ?? paint.fill ?? "" }, text)
    : drawn("path", { ...paint, fill: OPEN.includes(shape) ? "none" : paint.fill ?? "none" });
  const group = drawn("g", { id: gid, class: `kl-${style} kl-shape-${shape}` }, node);
  return { body: -1, layer: "", text, lift: 0, paper: false, size: [], part: "", frame: "",
           joint: null, link: null, ...item, group, node };
}

export class Picture {
  /**
   * Where the tip has been, for the trace.
   * @type {Triple[]}
   */
  path = [];

  /**
   * The frames as they were drawn last.
   * @type {Frame[]}
   */
  at = [];

  /** @type {Camera} */
  camera = PAPER;

  /**
   * What the camera made of the room last.
   * @type {Lens | undefined}
   */
  lens;

  order = "";

  /** @param {Scene} scene */
  constructor(scene) {
    this.scene = scene;
    this.items = scene.items.map((item) => shown(item, scene.paints[item.style]));
    this.bodies = this.items.filter((item) => item.body >= 0);
    this.svg = drawn("svg", { viewBox: `0 0 ${scene.size.join(" ")}`, role: "img" },
                     ...this.items.map((item) => item.group));
    this.reset(scene.preset);
  }

  /**
   * Look from one of the scene's presets.
   * @param {string} preset
   */
  reset(preset) {
    const [azimuth, elevation] = this.scene.presets[preset];
    this.camera = { azimuth, elevation, zoom: 1 };
  }

  /**
   * @param {string} layer
   * @param {boolean} visible
   */
  show(layer, visible) {
    if (layer === "trace") this.path = [];
    for (const { group } of this.items.filter((item) => item.layer === layer)) {
      group.style.display = visible ? "" : "none";
    }
  }

  /**
   * Draw the scene at the knobs' values; gives the frames there.
   * @param {number[]} q
   */
  draw(q) {
    const { motions, focus, tip, center } = this.scene, at = this.at = frames(motions, q);
    const middle = focus == null ? center : at[focus][3];
    const framed = { ...this.scene, fit: null }, { size } = framed;
    const looking = this.lens = lens(framed, this.camera, size, [], [], middle);
    const onPaper = lens(framed, PAPER, size, [], [], middle);
    /** @type {Map<number, number[]>} */
    const depths = new Map();
    this.follow(at[tip][3]);
    for (const item of this.items) {
      const room = item.shape === "trace" ? this.path
        : item.points.map(([k, ...local]) => inRoom(at[k], local));
      const { see, near: ahead } = item.paper ? onPaper : looking;
      const points = room.map((p) => [...see(p).slice(0, 2), dot(minus(p, middle), ahead)]);
      this.set(item, points);
      if (item.body >= 0) {
        const near = item.lift + points.reduce((sum, p) => sum + p[2], 0) / points.length;
        depths.set(item.body, [...(depths.get(item.body) ?? []), near]);
      }
    }
    this.stack(depths);
    return at;
  }

  /**
   * @param {Drawn} item
   * @param {number[][]} points
   */
  set({ shape, node }, points) {
    if (shape !== "text") return node.setAttribute("d", PATHS[shape](points));
    const [x, y] = points[0];
    node.setAttribute("x", x.toFixed(2));
    node.setAttribute("y", (y + 4).toFixed(2));    // half the height of the letters
  }

  /** @param {Triple} tip */
  follow(tip) {
    const last = this.path.at(-1);
    if (last && Math.hypot(...tip.map((v, k) => v - last[k])) * this.scene.scale < 0.2) return;
    this.path.push(tip);
    if (this.path.length > TRACE_LENGTH) this.path.shift();
  }

  /**
   * Lay nearer bodies over farther ones.
   * @param {Map<number, number[]>} depths
   */
  stack(depths) {
    const mean = new Map([...depths].map(([body, near]) =>
      [body, near.reduce((sum, d) => sum + d, 0) / near.length]));
    const far = (/** @type {Drawn} */ item) => mean.get(item.body) ?? 0;
    const sorted = [...this.bodies].sort((a, b) => far(a) - far(b));
    const order = sorted.map((item) => item.body).join();
    if (order === this.order) return;
    this.order = order;
    this.svg.append(...sorted.map((item) => item.group));
  }
}
