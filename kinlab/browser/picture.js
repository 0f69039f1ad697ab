// The picture, drawn from the scene alone, as kinlab/drawing/figure.py draws it: the frames of
// frames.js, seen through the lens of camera.js. One unit of the SVG is one pixel of the page, or
// more on a large screen.

import { lens } from "./camera.js";
import { Cloud } from "./cloud.js";
import { FloorPart } from "./floor_part.js";
import { frames, roomPoint } from "./frames.js";
import { place } from "./labels.js";
import { backToFront } from "./order.js";
import { Axis, Solid, Stroke, Words, longTip, whole } from "./parts.js";
import { moversOf } from "./pointing.js";
import { Steady } from "./steady.js";
import { clip } from "./steps.js";
import { arrange, drawn } from "./svg.js";
import { placesOf } from "./timed.js";
import { norm, minus } from "./vectors.js";

/** @import { Camera, Frame, Item, Lens, Scene, Triple } from "./types.js" */
/** @import { Whole } from "./parts.js" */
/** @typedef {{ joints?: Set<number>, frames?: Set<string>, links?: Set<number> }} Pointed */

const TRACE_LENGTH = 4000, TRACE_STEP = 0.2;        // points; px
const SAME_DEPTH = 1e-6;                            // px: strokes that differ less keep their order
const ORDINARY = 620, MAGNIFIED = 1.6;                // px: a picture's side; times larger words
const LABEL_STEPS = 3;                              // towards its place, in each picture
const UNFRAMED = ["axes", "ghost", "trace"];        // layers that may leave the picture
const SOLID_SHAPES = ["tube", "ball", "box"], WORD_SHAPES = ["text", "name"];
const FRAME_PARTS = ["frame", "label"];

/** @type {(point: Triple) => [Triple, number]} */
const bare = (point) => [point, 0];                 // without a body round it

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
  camera = { azimuth: 0, elevation: 0, zoom: 1 };

  /** @type {Lens | null} */
  lens = null;

  /**
   * Layers and frames that are switched off.
   * @type {Set<string>}
   */
  off = new Set();
  steady = new Steady();

  /**
   * The joints that move what does not say what it is; found when somebody points.
   * @type {Map<string, number[]> | undefined}
   */
  movers;

  restless = false;                                 // whether labels are still on their way

  /** @param {Scene} scene */
  constructor(scene) {
    this.scene = scene;
    this.size = [...scene.size];
    const items = scene.items.map(whole), { paints } = scene;
    /** @type {(shapes: string[]) => Whole[]} */
    const of = (shapes) => items.filter(({ shape }) => shapes.includes(shape));
    this.solids = of(SOLID_SHAPES).map((i) => new Solid(i, paints[i.style], paints.amber ?? {}));
    this.axes = of(["axis"]).map((item) => new Axis(item));
    this.words = of(WORD_SHAPES).map((item) => new Words(item, paints[item.style]));
    this.clouds = of(["cloud"]).map((item) => new Cloud(item, paints[item.style]));
    const others = [...SOLID_SHAPES, ...WORD_SHAPES, "axis", "cloud"];
    this.strokes = items.filter(({ shape }) => !others.includes(shape))
     .map((item) => new Stroke(item, paints[item.style]));
    this.floor = scene.floor ? new FloorPart(scene.floor) : null;
    this.parts = [...this.solids, ...this.axes, ...this.strokes, ...this.words, ...this.clouds];
    this.heeding = this.parts.filter(({ item }) => item.when);
    this.layers = this.layOut();
    this.svg = drawn("svg", { role: "img" }, ...Object.values(this.layers));
    this.move(scene.home);
    this.home = { balls: this.extents(), axes: this.axes.map(({ room }) => room) };
    this.reset(scene.preset);
    this.resize(scene.size[0], scene.size[1]);
  }

  /** Groups of the picture from the farthest to the nearest. */
  layOut() {
    const { floor, axes, strokes, words, clouds } = this;
    const names = ["sunk", "floor", "under", "solids", "hints", "over", "words"];
    const layers = Object.fromEntries(names.map((name) =>
      [name, drawn("g", { class: `kl-layer-${name}` })]));
    layers.floor.append(...floor ? [floor.group] : []);
    layers.under.append(...clouds.map(({ group }) => group),
      ...strokes.filter(({ item }) => item.body < 0).map((part) => part.group));
    layers.hints.append(...axes.map(({ hint }) => hint));
    layers.words.append(...words.map(({ group }) => group), ...floor ? [floor.words] : []);
    return layers;
  }

  /**
   * Look from one of the scene's presets.
   * @param {string} preset
   */
  reset(preset) {
    const [azimuth, elevation] = this.scene.presets[preset];
    this.camera = { azimuth, elevation, zoom: 1, perspective: this.camera.perspective };
  }

  /**
   * Fill a box of this size (px). In a large one, for a lecture, words and lines are larger, too,
   * and where the reader wants larger letters.
   * @param {number} width
   * @param {number} height
   * @param {number} letters how many times as large as usual
   */
  resize(width, height, letters = 1) {
    const wanted = Math.max(Math.min(width, height) / ORDINARY, letters);
    const larger = clip(wanted, 1, MAGNIFIED);
    this.size = [width / larger, height / larger];
    this.svg.setAttribute("viewBox", `0 0 ${this.size.join(" ")}`);
    for (const words of this.words) words.state = null;
    this.floor?.settle();
  }

  /**
   * @param {string} layer
   * @param {boolean} visible
   */
  show(layer, visible) {
    if (layer === "trace") this.clear();
    if (layer === "floor") this.floor?.show(visible);
    this.turn(`layer ${layer}`, visible);
    for (const cloud of this.clouds) cloud.cutBy(layer, visible);
  }

  /**
   * One frame's axes and their names; their layers may hide them as well.
   * @param {string} name
   * @param {boolean} visible
   */
  showFrame(name, visible) { this.turn(`frame ${name}`, visible); }

  /**
   * @param {string} what
   * @param {boolean} on
   */
  turn(what, on) {
    this.off[on ? "delete" : "add"](what);
    const hidden = (/** @type {Whole} */ { part, layer, frame }) =>
      this.off.has(`layer ${layer}`) ||
      (FRAME_PARTS.includes(part) && this.off.has(`frame ${frame}`));
    for (const part of this.parts) part.show(!hidden(part.item));
  }

  /** Begin the trace anew. */
  clear() { this.path = []; }

  /**
   * Light these joints, frames and links and let all the rest step back; null lights everything.
   * @param {Pointed | null} pointed
   */
  light(pointed) {
    if (pointed && !this.scene.timed) this.movers ??= moversOf(this.scene);
    const isLit = (/** @type {Whole} */ item) => !pointed || isMeant(item, pointed) ||
      (this.movers?.get(item.gid)?.some((joint) => pointed.joints?.has(joint)) ?? false);
    for (const solid of this.solids) {
      const meant = isLit(solid.item);
      solid.light(meant, Boolean(pointed) && meant && solid.item.style === "steel");
    }
    for (const part of [...this.axes, ...this.strokes, ...this.words]) {
      part.light(isLit(part.item));
    }
  }

  /**
   * Bring all parts to where they are in the room at the knobs' values.
   * @param {number[]} q
   */
  move(q) {
    const { knobs, motions } = this.scene, at = this.scene.timed ? placesOf(this.scene, q) : q;
    const all = this.at = frames(motions, at);
    for (const part of this.parts) part.move({ motions, all, q: at, knobs });
    for (const part of this.heeding) part.heed(at);
  }

  /**
   * Balls that have to be seen: the ends of solids, what is drawn beside the arm, feet, and points
   * that the scene names.
   * @returns {[Triple, number][]}
   */
  extents() {
    const { at, scene: { floor, fit } } = this;
    const bodies = this.solids.filter(({ paint }) => !paint.faded)
      .flatMap((solid) => solid.balls());
    const beside = this.strokes.filter(({ item }) => !UNFRAMED.includes(item.layer))
      .flatMap(({ room }) => room);
    const feet = (floor?.drops ?? []).flatMap((k) => {
      const [x, y] = at[k][3];
      return [at[k][3], [x, y, floor?.height ?? 0]];
    });
    const named = (fit?.points ?? []).map((point) => roomPoint(at, point));
    return [...bodies, ...[...beside, ...feet, ...named].map(bare)];
  }

  /**
   * The lens through which nothing leaves the picture. How far arrows reach depends on its scale:
   * a first lens tells that well enough.
   * @param {Triple} middle
   */
  framed(middle) {
    const { scene, camera, size, home } = this;
    if (!scene.fit) return lens(scene, camera, size, [], [], middle);
    const now = this.extents(), first = lens(scene, camera, size, now, home.balls, middle);
    const tips = (/** @type {Triple[][]} */ rooms) => rooms.map((room, k) =>
      bare(longTip(room, this.axes[k].item.size, first.scale / camera.zoom, size)));
    return lens(scene, camera, size, [...now, ...tips(this.axes.map(({ room }) => room))],
                [...home.balls, ...tips(home.axes)], middle);
  }

  /**
   * Draw the scene at the knobs' values; gives the frames there.
   * @param {number[]} q
   */
  draw(q) {
    this.move(q);
    const { scene, size, at } = this, { focus, center } = scene;
    const middle = focus == null ? center : at[focus][3];
    const seen = this.lens = this.steady.through(this.framed(middle));
    this.follow(at[scene.tip][3]);
    for (const stroke of this.strokes) {
      if (stroke.item.shape === "trace") stroke.room = this.path;
      stroke.draw(seen);
    }
    for (const cloud of this.clouds) cloud.draw(at, seen, center, scene.radius);
    const { shading, sunk } = this.drawBodies(seen);
    this.floor?.draw(seen, at, shading, sunk, size);
    this.stackStrokes();
    this.placeWords();
    return at;
  }

  /**
   * Draw solids, axes and drop lines and lay the nearer ones over the farther ones.
   * @param {Lens} seen
   */
  drawBodies(seen) {
    const { at, size, scene: { floor }, layers } = this;
    const pieces = this.solids.filter(({ on }) => on)
      .flatMap((solid) => solid.locate(at, this.floor?.on ? floor?.height : undefined));
    for (const piece of pieces) piece.draw(seen);
    const axes = this.axes.filter(({ on }) => on)
      .map((axis) => ({ body: axis.locate(seen, size), group: axis.group, axis }));
    for (const { axis } of axes) axis.draw(seen);
    const drops = this.floor?.dropped(at) ?? [];
    const all = [...pieces, ...axes, ...drops];
    const ordered = backToFront(all.map(({ body }) => body), seen).map((k) => all[k]);
    const sunk = ordered.filter(({ body: { p, q } }) => this.isBeyondFloor(p, q, seen));
    arrange(layers.sunk, sunk.map(({ group }) => group));
    arrange(layers.solids, ordered.filter((one) => !sunk.includes(one)).map(({ group }) => group));
    const shading = pieces.filter(({ shown }) => shown)
      .map(({ solid, ends, size: wide }) => ({ shape: solid.item.shape, ends, size: wide }));
    return { shading, sunk: sunk.length > 0 };
  }

  /**
   * Whether a segment lies on the other side of the floor than the viewer.
   * @param {Triple} p
   * @param {Triple} q
   * @param {Lens} seen
   */
  isBeyondFloor(p, q, seen) {
    const { floor, fit } = this.scene;
    if (!floor || !this.floor?.on) return false;
    const above = (p[2] + q[2]) / 2 - floor.height, touch = 0.05 * (fit?.thick ?? 0);
    return seen.near[2] >= 0 ? above < -touch : above > touch;
  }

  /** Lay nearer strokes over farther ones. */
  stackStrokes() {
    /** @type {Map<number, number[]>} */
    const depths = new Map();
    const over = this.strokes.filter(({ item }) => item.body >= 0);
    for (const { item, near } of over) {
      depths.set(item.body, [...(depths.get(item.body) ?? []), near]);
    }
    const exact = (this.lens?.scale ?? 0) / SAME_DEPTH;
    const mean = new Map([...depths].map(([body, near]) =>
      [body, Math.floor(exact * near.reduce((sum, d) => sum + d, 0) / near.length + 0.5)]));
    const far = (/** @type {Stroke} */ { item }) => mean.get(item.body) ?? 0;
    arrange(this.layers.over, over.sort((a, b) => far(a) - far(b)).map(({ group }) => group));
  }

  /** Bring the words nearer to where they want to stand. */
  placeWords() {
    const { size, lens: seen, floor } = this;
    if (!seen) return;
    const shown = this.words.filter(({ on }) => on);
    const labels = [...shown.map((words) => words.locate(seen, size)), ...floor?.labels ?? []];
    const strokes = [...this.axes, ...this.strokes].filter(({ on }) => on)
      .flatMap(({ stroke }) => stroke ?? []);
    const solids = this.solids.filter(({ on }) => on).flatMap((solid) => solid.bars(seen));
    const { places, restless } = place(labels, strokes, solids, [], size, LABEL_STEPS);
    shown.forEach((words, k) => words.draw(places[k]));
    floor?.writeCoordinates(places.slice(shown.length));
    floor?.giveWay(places.flatMap((spot, k) =>
      spot ? [[spot.x, spot.y, labels[k].w, labels[k].h]] : []));
    this.restless = restless;
  }

  /** @param {Triple} tip */
  follow(tip) {
    const last = this.path.at(-1);
    if (last && norm(minus(tip, last)) * (this.lens?.scale ?? 0) < TRACE_STEP) return;
    this.path.push(tip);
    if (this.path.length > TRACE_LENGTH) this.path.shift();
  }
}

/**
 * Whether an item is a picture of something that is pointed at.
 * @param {Whole} item
 * @param {Pointed} pointed
 */
function isMeant({ joint, frame, link, part }, { joints, frames: named, links }) {
  if (joint != null && joints?.has(joint)) return true;
  if (frame) return named?.has(frame) ?? false;
  return part !== "axis" && joint == null && link != null && (links?.has(link) ?? false);
}
