// Where a picture is seen from, and how the room is framed, as in kinlab/drawing/camera.py.

import { clip } from "./steps.js";
import { dot, minus, plus, times } from "./vectors.js";

/** @import { Camera, Lens, Scene, Triple } from "./types.js" */
/** @typedef {{ right: Triple, up: Triple, near: Triple, middle: Triple, closer: number }} Gaze */
/** @typedef {[middle: Triple, radius: number][]} Extents */
/** @typedef {number[]} Span from low to high */
/**
 * @typedef {Pick<Scene, "presets" | "preset" | "center" | "radius" | "fit">}
 *   Framed what a scene says of its frame
 */

const DISTANCE = 3.4;                               // of the viewer, in radii of the scene
const NEAREST = 0.2;                                // of it: what is nearer stays before the viewer
const EDGE = 10;                                    // px: half a name of an axis
const MARGINS = 0.075, NARROW = 24, WIDE = 50;      // of a side, and px: room for names
const LEAST_BOX = 0.5, LEAST_BALL = 1.5;            // in radii: the least box, and the least ball
const SOFT = 0.2;                                   // radii over which one bound relieves another

/**
 * Where a point is on the picture, whatever the size of things there.
 * @type {(lens: Pick<Lens, "see">, point: Triple) => number[]}
 */
export const onPicture = (lens, point) => lens.see(point).slice(0, 2);

/**
 * The picture's right, its up and the way to the viewer, as directions of the room.
 * @param {Pick<Camera, "azimuth" | "elevation">} camera
 */
export function cameraAxes({ azimuth, elevation }) {
  const [a, e] = [azimuth, elevation].map((angle) => angle * Math.PI / 180);
  const [ca, sa, ce, se] = [Math.cos(a), Math.sin(a), Math.cos(e), Math.sin(e)];
  return { right: [-sa, ca, 0], up: [-se * ca, -se * sa, ce], near: [ce * ca, ce * sa, se] };
}

/**
 * What a camera makes of the room. A scene with a `fit` is framed round `extents`, the balls
 * that have to be seen; `home` are those at its home. Others stand with `middle` in their place.
 * @param {Framed} scene
 * @param {Camera} camera
 * @param {number[]} size of the picture: width and height (px)
 * @param {Extents} [extents]
 * @param {Extents} [home]
 * @param {Triple} [middle]
 * @returns {Lens}
 */
export function lens(scene, camera, size, extents = [], home = [], middle = scene.center) {
  const { fit } = scene, gaze = gazeOf(scene, camera, fit ? fit.middle : middle);
  const { scale, shrunk, heart: [x, y] } = fit
    ? fitted(scene, camera, gaze, size, extents, home) : standing(scene, camera, gaze, size);
  return {
    right: gaze.right, up: gaze.up, near: gaze.near, scale, shrunk,
    see: (point) => {
      const d = minus(point, gaze.middle), f = 1 / ahead(gaze, d), s = scale * f;
      return [x + s * dot(d, gaze.right), y - s * dot(d, gaze.up), f];
    },
    eye: (point) => plus(gaze.near, times(minus(gaze.middle, point), gaze.closer)),
    turn: (d) => [dot(d, gaze.right), dot(d, gaze.up), dot(d, gaze.near)],
  };
}

/**
 * Axes of a camera and the point it looks at; `closer` is one over the viewer's distance.
 * @type {(scene: Framed, camera: Camera, middle: Triple) => Gaze}
 */
const gazeOf = (scene, camera, middle) => ({
  ...cameraAxes(camera), middle,
  closer: camera.perspective ? 1 / (DISTANCE * scene.radius) : 0,
});

/**
 * How far before the viewer a point lies, as a part of the middle's distance.
 * @type {(gaze: Gaze, d: Triple) => number}
 */
const ahead = (gaze, d) => Math.max(NEAREST, 1 - gaze.closer * dot(d, gaze.near));

/**
 * The ball round a scene just fits the picture.
 * @type {(scene: Framed, camera: Camera, gaze: Gaze, size: number[]) =>
 *   { scale: number, shrunk: number, heart: number[] }}
 */
function standing({ radius }, camera, { closer }, size) {
  const room = Math.min(...size);
  // In perspective a ball looks larger than the circle round its middle.
  const ball = radius / Math.sqrt(1 - (closer * radius) ** 2);
  return { scale: camera.zoom * Math.max(room / 2 - EDGE, room / 4) / ball, shrunk: 1,
           heart: size.map((side) => side / 2) };
}

/**
 * The balls fill the picture, and none leaves it. What they need is joined smoothly with what
 * home needs, from here and in the view that the scene begins with: what folds is not drawn larger.
 * @param {Framed} scene
 * @param {Camera} camera
 * @param {Gaze} gaze
 * @param {number[]} size
 * @param {Extents} extents
 * @param {Extents} home
 */
function fitted(scene, camera, gaze, size, extents, home) {
  const radius = scene.fit?.radius ?? 1, [azimuth, elevation] = scene.presets[scene.preset];
  const free = size.map((side) =>
    Math.max(side / 2, side - 2 * clip(MARGINS * side, NARROW, WIDE)));
  const first = spans(gazeOf(scene, { ...camera, azimuth, elevation }, gaze.middle), home);
  const now = spans(gaze, home), smallest = Math.min(...free), soft = SOFT * radius / smallest;
  const least = Math.max(LEAST_BALL * radius / smallest,
                         ...[first, now].flatMap((box) => lengthsPerPixel(box, free)));
  const needed = (/** @type {Span[]} */ box) => {
    const [wide, high] = lengthsPerPixel(box, free);
    return smoothMax(smoothMax(wide, high, soft), least, soft);
  };
  const box = widened(spans(gaze, extents), radius);
  const need = needed(box), [right, up] = box.map(([low, high]) => (low + high) / (2 * need));
  return { scale: camera.zoom / need, shrunk: needed(widened(now, radius)) / need,
           heart: [size[0] / 2 - camera.zoom * right, size[1] / 2 + camera.zoom * up] };
}

/** @type {(box: Span[], free: number[]) => number[]} */
const lengthsPerPixel = (box, free) => box.map(([low, high], k) => (high - low) / free[k]);

/**
 * How far balls reach to the right and up on a picture of scale 1, the middle at least.
 * @param {Gaze} gaze
 * @param {Extents} balls
 * @returns {Span[]}
 */
function spans(gaze, balls) {
  const box = [[0, 0], [0, 0]];
  for (const [middle, radius] of balls) {
    const d = minus(middle, gaze.middle), f = 1 / ahead(gaze, d);
    [gaze.right, gaze.up].forEach((axis, k) => {
      box[k][0] = Math.min(box[k][0], f * (dot(d, axis) - radius));
      box[k][1] = Math.max(box[k][1], f * (dot(d, axis) + radius));
    });
  }
  return box;
}

/**
 * Spans that hold a box round the middle as well, and change smoothly.
 * @type {(box: Span[], radius: number) => Span[]}
 */
const widened = (box, radius) => box.map((span) => {
  const [below, above] = span.map((e) => smoothMax(Math.abs(e), LEAST_BOX * radius, SOFT * radius));
  return [-below, above];
});

/**
 * A smooth maximum, never below either.
 * @type {(a: number, b: number, soft: number) => number}
 */
const smoothMax = (a, b, soft) => (a + b + Math.sqrt((a - b) ** 2 + soft * soft)) / 2;
