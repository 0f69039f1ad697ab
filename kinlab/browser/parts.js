// What a scene's items become in an SVG picture: solids, axes of frames, strokes and words.

import { onPicture } from "./camera.js";
import { cornersOf, isThere } from "./curves.js";
import { valued, write } from "./dom.js";
import { roomPoint } from "./frames.js";
import { textSize } from "./labels.js";
import { OFFSETS, dimmed, faces, hull, pale, shades } from "./solids.js";
import { display, drawn, polygon, polyline, put, px, reveal } from "./svg.js";
import { clip } from "./steps.js";
import { dot, minus, norm, partway, plus, times, unit } from "./vectors.js";

/** @import { Face, Frame, Item, Lens, Paint, Triple } from "./types.js" */
/** @import { Now } from "./curves.js" */
/** @import { Label, LabelState, Placed } from "./labels.js" */
/** @import { Body } from "./order.js" */
/** @typedef {Required<Item>} Whole */

const USUAL = { body: -1, layer: "", text: "", lift: 0, size: [], part: "", frame: "",
                joint: null, link: null, when: null };

/** @type {(item: Item) => Whole} */
export const whole = (item) => /** @type {Whole} */ ({ ...USUAL, ...item });

/** The drawn group of an item, which says what it is a picture of. */
export class Part {
  layerOn = true;

  there = true;                                     // whether its knob lets it be seen

  lit = true;                                       // whether something else is pointed at

  /** @param {Whole} item */
  constructor(item) {
    const { gid, style, shape, part, frame, joint, link } = item;
    this.item = item;
    this.group = drawn("g", { id: gid, class: `kl-${style.replace("-", " kl-")} kl-shape-${shape}`,
      "data-frame": frame, "data-part": part || shape, "data-joint": joint, "data-link": link });
  }

  get on() { return this.layerOn && this.there; }

  /** @param {boolean} on */
  show(on) {
    this.layerOn = on;
    display(this.group, this.on);
  }

  /** @param {number[]} q */
  heed(q) {
    const there = isThere(this.item, q);
    if (there === this.there) return;
    this.there = there;
    this.show(this.layerOn);
  }

  /** @param {boolean} lit */
  light(lit) {
    this.lit = lit;
    this.group.classList.toggle("kl-dim", !lit);
  }

  /**
   * Where its points are in the room.
   * @type {Triple[]}
   */
  room = [];

  /** @param {Now} now */
  move({ all }) { this.room = this.item.points.map((point) => roomPoint(all, point)); }
}

// ---- solids ----

let lights = 0;                                     // each gradient of the page has its own name

/** A body with a surface that light falls on; one that dips through the floor is drawn as two. */
export class Solid extends Part {
  pointed = false;

  /** @type {Piece[]} */
  pieces = [];

  /**
   * @param {Whole} item
   * @param {Paint} paint
   * @param {Paint} amber how it is painted while it is pointed at
   */
  constructor(item, paint, amber) {
    super(item);
    this.paint = paint;
    const ramp = shades(paint.ramp ?? []), hub = paint.hub ? shades(paint.hub) : ramp;
    const plain = [ramp, hub].map((colours) => paint.faded ? colours.map(pale) : colours);
    this.ramps = { plain, pointed: [shades(amber.ramp ?? []), hub],
                   dim: [ramp.map(dimmed), hub.map(dimmed)] };
    this.pieces = [new Piece(this, this.group)];
  }

  /** @param {boolean} lit @param {boolean} pointed */
  light(lit, pointed = false) {
    super.light(lit);
    this.pointed = pointed;
  }

  /** @param {boolean} on */
  show(on) {
    super.show(on);
    for (const { group } of this.pieces) display(group, this.on);
  }

  get ramp() { return this.ramps[!this.lit ? "dim" : this.pointed ? "pointed" : "plain"]; }

  /**
   * The pieces in which it is drawn at these frames.
   * @param {Frame[]} at
   * @param {number | undefined} height of the floor
   */
  locate(at, height) {
    const { room: ends, item: { shape, size, points } } = this;
    const halves = shape === "tube" ? cut(ends, size, height) : [{ ends, size }];
    halves.forEach((half, k) => this.piece(k).locate(half.ends, half.size, at[points[0][0]]));
    this.pieces.slice(halves.length).forEach((piece) => piece.hide());
    return this.pieces.slice(0, halves.length);
  }

  /**
   * Balls about its ends, which have to be seen.
   * @returns {[Triple, number][]}
   */
  balls() {
    const [p, q, u] = this.room, { shape, size: [r, s = r] } = this.item;
    if (shape === "box") return [p, q].map((end) => [end, norm(minus(u, p))]);
    return shape === "ball" ? [[p, r]] : [[p, r], [q, s]];
  }

  /**
   * What words keep off: its segment and its radius on the picture.
   * @param {Lens} lens
   */
  bars(lens) {
    return this.pieces.filter(({ shown }) => shown).map(({ body: { p, q, r } }) => {
      const [a, b] = [p, q].map(lens.see);
      return { a: a.slice(0, 2), b: b.slice(0, 2), radius: r * lens.scale * Math.max(a[2], b[2]) };
    });
  }

  /** @param {number} k */
  piece(k) {
    return this.pieces[k] ??= new Piece(this, this.secondGroup());
  }

  /** A group that tells the same; an id is there once in a page. */
  secondGroup() {
    const group = /** @type {SVGGElement} */ (this.group.cloneNode(false));
    group.removeAttribute("id");
    group.setAttribute("data-piece-of", this.item.gid);
    return group;
  }
}

const LEAST_CUT = 0.02;                             // of a tube: shorter ends are not cut off

/**
 * A tube, in two where it goes through the floor.
 * @param {Triple[]} ends
 * @param {number[]} radii
 * @param {number | undefined} height
 */
function cut(ends, radii, height) {
  const [a, b] = ends, share = height == null ? -1 : (height - a[2]) / (b[2] - a[2]);
  if (!(share > LEAST_CUT && share < 1 - LEAST_CUT)) return [{ ends, size: radii }];
  const middle = partway(a, b, share), radius = radii[0] + share * (radii[1] - radii[0]);
  return [{ ends: [a, middle], size: [radii[0], radius] },
          { ends: [middle, b], size: [radius, radii[1]] }];
}

/**
 * A piece of a solid as a body that others are drawn before or behind.
 * @type {(item: Whole, ends: Triple[], size: number[]) => Body}
 */
function bodyOf({ shape, part }, [p, q = p, u = p, v = p], size) {
  const wide = Math.max(norm(minus(u, p)), norm(minus(v, p)));
  return { p, q, r: shape === "box" ? 1.1 * wide : Math.max(...size),
           plane: part === "base" ? { normal: unit(minus(q, p)), at: q } : null };
}

/** What is drawn in one piece of a solid. */
class Piece {
  /** @type {Skin[]} */
  skins = [];

  /** @type {Triple[]} */
  ends = [];

  /** @type {number[]} */
  size = [];

  /** @type {Frame} */
  frame = [];

  /** @type {Body} */
  body = { p: [], q: [], r: 0 };

  shown = false;                                    // a rod may be wholly inside its sleeve

  /** @param {Solid} solid @param {SVGGElement} group */
  constructor(solid, group) {
    this.solid = solid;
    this.group = group;
  }

  /** @param {Triple[]} ends @param {number[]} size @param {Frame} frame */
  locate(ends, size, frame) {
    Object.assign(this, { ends, size, frame, body: bodyOf(this.solid.item, ends, size) });
    reveal(this.group, true);
  }

  /** @param {Lens} lens */
  draw(lens) {
    const { item: { shape }, paint, ramp: [plain, hub] } = this.solid;
    const all = faces(shape, lens, this.ends, this.size, paint, this.frame);
    all.forEach((face, k) => this.skin(k).draw(face, face.role === "hub" ? hub : plain));
    this.skins.slice(all.length).forEach((skin) => skin.hide());
    this.shown = all.length > 0;
  }

  /** @param {number} k */
  skin(k) {
    if (!this.skins[k]) this.group.append((this.skins[k] = new Skin()).group);
    return this.skins[k];
  }

  hide() {
    this.shown = false;
    reveal(this.group, false);
  }
}

/** One face of a solid, with the gradient that it may need. */
class Skin {
  path = drawn("path");

  group = drawn("g", {}, this.path);

  /** @type {SVGGradientElement | undefined} */
  gradient;

  /** @param {Face} face @param {string[]} ramp */
  draw({ role, points, level, gradient }, ramp) {
    reveal(this.group, true);
    put(this.path, "class", role === "mark" ? "kl-mark" : "kl-skin");
    put(this.path, "d", role === "mark" ? polyline(points) : polygon(points));
    if (gradient) put(this.path, "fill", this.across(gradient, ramp));
    else put(this.path, "fill", level == null ? "none" : ramp[level]);
  }

  /** @param {NonNullable<Face["gradient"]>} light @param {string[]} ramp */
  across(light, ramp) {
    const gradient = this.gradient ??= this.lit(light), matrix = unitOf(light).map(px).join(" ");
    put(gradient, "gradientTransform", `matrix(${matrix})`);
    light.levels.forEach((level, k) => put(gradient.children[k], "stop-color", ramp[level]));
    return `url(#${gradient.id})`;
  }

  /**
   * A gradient of length 1; where it lies is one attribute, which is set in every picture.
   * @param {NonNullable<Face["gradient"]>} light
   */
  lit(light) {
    const round = "center" in light, offsets = round ? OFFSETS.round : OFFSETS.across;
    const ends = round ? { cx: 0, cy: 0, r: 1 } : { x1: 0, y1: 0, x2: 1, y2: 0 };
    const gradient = drawn(round ? "radialGradient" : "linearGradient",
      { id: `kl-light-${lights += 1}`, gradientUnits: "userSpaceOnUse", ...ends },
      ...offsets.map((offset) => drawn("stop", { offset })));
    this.group.prepend(gradient);
    return gradient;
  }

  hide() { reveal(this.group, false); }
}

/**
 * The matrix that lays a gradient of length 1 where a light is.
 * @param {NonNullable<Face["gradient"]>} light
 */
function unitOf(light) {
  if ("center" in light) return [light.radius, 0, 0, light.radius, ...light.center];
  const { from: [x, y], to: [u, v] } = light;
  return [u - x, v - y, y - v, u - x, x, y];
}

// ---- axes of frames ----

const AXIS_SHARE = 0.075, AXIS_LEAST = 30, AXIS_MOST = 54;   // of the smaller side; px
const PART_OF_NAME = 10, FALLING = 1.25;            // px; the scale falls while arrows are framed
const PER_SHARED = 0.36;                            // longer for each frame at the same origin
const ARROW_HEAD = 9, SLACK = 1e-6;                 // px

/** @type {(from: number[], to: number[]) => number} */
const apart = ([x, y], [u, v]) => Math.hypot(u - x, v - y);

/**
 * Shaft and head; the head shrinks as the arrow turns towards the viewer. The shaft runs through
 * all the points, and back again, so that only the head can be filled.
 * @param {number[][]} points
 */
export function arrowPoints(points) {
  let k = points.length - 1, left = 0;              // from point k to the tip
  const tip = points[k], long = points.reduce((sum, p, i) => sum + apart(points[i - 1] ?? p, p), 0);
  const head = Math.min(ARROW_HEAD, 0.5 * long);
  while (k && left <= head + SLACK) left += apart(points[k], points[--k]);
  const [x, y] = points[k], share = (left - head) / apart(points[k], points[k + 1]) || 0;
  const neck = [x + share * (points[k + 1][0] - x), y + share * (points[k + 1][1] - y)];
  const side = 0.36 * head / (apart(neck, tip) || 1), shaft = [...points.slice(0, k + 1), neck];
  const wing = (/** @type {1 | -1} */ s) =>
    [neck[0] - s * side * (tip[1] - neck[1]), neck[1] + s * side * (tip[0] - neck[0])];
  return [...shaft, wing(1), tip, wing(-1), ...shaft.reverse()];
}

/** @type {(picture: number[]) => number} */
const axisLength = (picture) => clip(AXIS_SHARE * Math.min(...picture), AXIS_LEAST, AXIS_MOST);

/**
 * As much of an arrow as would not have room in the picture's margin.
 * @param {Triple[]} places its origin, and a unit vector from there
 * @param {number[]} size of the item
 * @param {number} scale of the picture, more or less
 * @param {number[]} picture its width and height
 */
export function longTip([origin, beyond], [inside, rank], scale, picture) {
  const over = axisLength(picture) * PER_SHARED * rank + PART_OF_NAME;
  return plus(origin, times(minus(beyond, origin), inside + FALLING * over / scale));
}

/**
 * Where an axis leaves the solids at its origin, and its tip: as long on every picture.
 * @param {Triple[]} places its origin, and a unit vector from there
 * @param {number[]} size of the item: where outside the arm it begins, and its rank there
 * @param {Lens} lens
 * @param {number[]} picture its width and height
 */
function axisEnds([origin, beyond], [inside, rank], lens, picture) {
  const long = axisLength(picture);
  const way = minus(beyond, origin), length = inside + long * (1 + PER_SHARED * rank) / lens.scale;
  return { origin, skin: plus(origin, times(way, 1.04 * inside)),
           tip: plus(origin, times(way, length)) };
}

/** An axis of a frame: an arrow among the solids, and dashed once more over all of them. */
export class Axis extends Part {
  path = drawn("path");

  /** @param {Whole} item */
  constructor(item) {
    super(item);
    this.group.append(this.path);
    const { gid, style, part, frame, link } = item;
    this.hint = drawn("path", { id: `${gid}-hint`, class: `kl-hint kl-${style}`,
      "data-part": part, "data-frame": frame, "data-link": link });
  }

  /** @param {boolean} on */
  show(on) {
    super.show(on);
    display(this.hint, this.on);
  }

  /** @param {boolean} lit */
  light(lit) {
    super.light(lit);
    reveal(this.hint, lit);
  }

  /** @param {Lens} lens @param {number[]} picture */
  locate(lens, picture) {
    this.ends = axisEnds(this.room, this.item.size, lens, picture);
    return { p: this.ends.skin, q: this.ends.tip, r: 0 };
  }

  /** @param {Lens} lens */
  draw(lens) {
    if (!this.ends) return;
    const [origin, skin, tip] = [this.ends.origin, this.ends.skin, this.ends.tip]
      .map((point) => onPicture(lens, point));
    put(this.path, "d", polygon(arrowPoints([skin, tip])));
    put(this.hint, "d", polygon(arrowPoints([origin, tip])));
    this.stroke = { a: origin, b: tip };
  }
}

// ---- strokes and faces on the picture ----

/** @param {number[][]} points */
function facing(points) {
  const area = points.reduce((sum, [x, y], k) => {
    const [u, v] = points[(k + 1) % points.length];
    return sum + x * v - u * y;
  }, 0);
  return area < 0 ? polygon(points) : "";           // y points down
}

/**
 * How the points of a shape become a path.
 * @type {Record<string, (points: number[][]) => string>}
 */
export const PATHS = { line: polyline, trace: polyline, sweep: polyline, way: polyline,
                       area: polygon, patch: polygon, face: facing,
                       arrow: (points) => polygon(arrowPoints(points)),
                       hull: (points) => polygon(hull(points)) };
const OPEN_SHAPES = ["line", "trace", "sweep", "way"];   // never filled

/** A line, an arrow, a face or an outline. */
export class Stroke extends Part {
  near = 0;                                         // how near it is in the middle

  /**
   * What words keep off.
   * @type {{ a: number[], b: number[] }[]}
   */
  stroke = [];

  /** @param {Whole} item @param {Paint} paint */
  constructor(item, paint) {
    super(item);
    const open = OPEN_SHAPES.includes(item.shape);
    this.path = drawn("path", { ...paint, fill: open ? "none" : paint.fill ?? "none" });
    this.group.append(this.path);
  }

  /** @param {Now} now */
  move(now) { this.room = cornersOf(this.item, now); }

  /** @param {Lens} lens */
  draw(lens) {
    const { room } = this;
    this.near = this.item.lift + room.reduce((sum, p) => sum + dot(p, lens.near), 0) / room.length;
    if (!this.on) return;
    const points = room.map((point) => onPicture(lens, point));
    put(this.path, "d", PATHS[this.item.shape](points));
    this.stroke = keptOff(this.item, points);
  }
}

const KEPT_OFF = ["arc", "line"], PIECE = 4;        // parts; how many steps of a line make a piece

/**
 * An arrow, and arcs and lines in pieces: no word stands on them.
 * @param {Whole} item
 * @param {number[][]} points
 */
function keptOff({ shape, part }, points) {
  if (shape !== "arrow" && (shape !== "line" || !KEPT_OFF.includes(part))) return [];
  const corners = points.filter((_, k) => k % PIECE === 0 || k === points.length - 1);
  return corners.slice(1).map((b, k) => ({ a: corners[k], b }));
}

// ---- words ----

const COME = 13;                                    // px

/**
 * From where words at a point come that stand away from another point.
 * @param {number[]} anchor
 * @param {number[]} away
 */
function besideOf([x, y], away) {
  const dx = x - away[0], dy = y - away[1], d = Math.hypot(dx, dy), far = d < 1 ? 0 : COME / d;
  return [x - far * dx, y - far * dy];
}

/** Words at a point, or the name of an axis at its tip. */
export class Words extends Part {
  /** @type {LabelState | null} */
  state = null;

  /** @param {Whole} item @param {Paint} paint */
  constructor(item, paint) {
    super(item);
    this.leader = drawn("path", { class: "kl-leader" });
    this.node = drawn("text", { fill: paint.words ?? paint.fill ?? paint.stroke }, item.text);
    this.group.append(this.leader, this.node);
    this.box = textSize(item.text);
  }

  /** @param {Now} now */
  move(now) {
    super.move(now);
    const { shape, size: [k] } = this.item, knob = shape === "text" && now.knobs?.[k];
    if (!knob) return;
    write(this.node, valued(knob, now.q[k]));
    this.box = textSize(this.node.textContent ?? "");
  }

  /** @param {Lens} lens @param {number[]} picture @returns {Label} */
  locate(lens, picture) {
    const { room } = this, axis = this.item.shape === "name";
    const ends = axis ? axisEnds(room, this.item.size, lens, picture) : null;
    const [anchor, away] = [ends?.tip ?? room[0], ends?.origin ?? room[1] ?? null]
      .map((point) => point && onPicture(lens, point));
    const from = axis || !away ? away : besideOf(anchor ?? away, away);
    const [w, h] = this.box;
    return { anchor: anchor ?? [0, 0], from, w, h, state: this.state };
  }

  /** @param {Placed | null} place */
  draw(place) {
    this.state = place?.state ?? null;
    reveal(this.node, Boolean(place));
    reveal(this.leader, Boolean(place?.leader));
    if (!place) return;
    put(this.node, "x", px(place.x));
    put(this.node, "y", px(place.y));
    if (place.leader) put(this.leader, "d", polyline(place.leader));
  }
}
