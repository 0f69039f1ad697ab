// The camera: by numbers typed here, and against Python's (camera.json, written by ../fixtures.py).
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import { lens } from "../../../kinlab/browser/camera.js";

const scene = { presets: { "3-D": [-60, 24] }, preset: "3-D",
                center: [1, 2, 3], radius: 14, fit: null };
const TOP = [-90, 90], FRONT = [-90, 0], SIDE = [0, 0];
const read = (name) => JSON.parse(readFileSync(new URL(`${name}.json`, import.meta.url), "utf8"));

/** Numbers that are the same to 1e-9. */
function near(got, wanted) {
  assert.equal(got.length, wanted.length);
  got.forEach((e, k) => assert.ok(Math.abs(e - wanted[k]) < 1e-9, `${got}, not ${wanted}`));
}

/** The lens of a side, 10 px per length unit if not zoomed. */
const from = ([azimuth, elevation], more = {}, drawn = scene, size = [400, 300]) =>
  lens(drawn, { azimuth, elevation, zoom: 1, ...more }, size);

test("the centre stands in its place from everywhere", () => {
  for (const camera of [TOP, FRONT, SIDE, [37, -12]]) {
    near(from(camera).see([1, 2, 3]), [200, 150, 1]);
    near(from(camera, { perspective: true }).see([1, 2, 3]), [200, 150, 1]);
  }
});

test("each side shows its two axes", () => {
  near(from(TOP).see([2, 4, 8]), [210, 130, 1]);    // x to the right, y up, z to the eye
  near(from(FRONT).see([2, 4, 8]), [210, 100, 1]);  // x to the right, z up, -y to the eye
  near(from(SIDE).see([2, 4, 8]), [220, 100, 1]);   // y to the right, z up, x to the eye
  near(from(TOP, { zoom: 2 }).see([2, 4, 8]), [220, 110, 1]);
  near(from(TOP).turn([2, 4, 8]), [2, 4, 8]);
  near(from(FRONT).turn([2, 4, 8]), [2, 8, -4]);
  near(from(SIDE).turn([2, 4, 8]), [4, 8, 2]);
});

test("a view from a corner", () => {
  const half = Math.SQRT1_2, { right, up, near: ahead, see, eye } = from([45, 30]);
  near(see([2, 2, 3]), [200 - 10 * half, 150 + 5 * half, 1]);
  near([...right, ...up], [-half, half, 0, -half / 2, -half / 2, Math.sqrt(3) / 2]);
  near(ahead, [half * Math.sqrt(3) / 2, half * Math.sqrt(3) / 2, 1 / 2]);
  assert.deepEqual(eye([5, 5, 5]), ahead);
});

test("in perspective what is nearer is larger, and the viewer is 3.4 radii away", () => {
  const { see, eye } = from(TOP, { perspective: true }, { ...scene, radius: 5 });
  const scale = 28 * Math.sqrt(1 - 1 / 3.4 ** 2);   // a ball seems larger: 5 fits 140 px just so
  near(see([2, 2, 3]), [200 + scale, 150, 1]);
  near(see([2, 2, 11.5]), [200 + 2 * scale, 150, 2]);          // half way to the viewer
  near(see([2, 4, -14]), [200 + scale / 2, 150 - scale, 1 / 2]);
  near(see([1, 2, 900]), [200, 150, 5]);                       // behind the viewer: no farther
  near(eye([1, 2, 11.5]), [0, 0, 1 / 2]);
  near(eye([2, 2, 3]), [-1 / 17, 0, 1]);
});

test("the ball round a scene fits pictures of any size", () => {
  near([from(TOP).scale, from(TOP, {}, scene, [800, 300]).scale], [10, 10]);
  near([from(TOP, {}, scene, [580, 860]).scale], [20]);
  near(from(TOP, {}, scene, [580, 860]).see([2, 2, 3]), [310, 430, 1]);
  near(from(TOP, { zoom: 3 }, scene, [30, 20]).see([2, 2, 3]), [15 + 3 * 5 / 14, 10, 1]);
});

for (const [k, made] of read("camera").entries()) {
  test(`a lens is Python's: ${k}`, () => {
    const { scene: framed, camera, size, extents, home, middle, points, lens: wanted } = made;
    const got = lens(framed, camera, size, extents, home, middle);
    near([got.scale, got.shrunk], [wanted.scale, wanted.shrunk]);
    for (const name of ["see", "eye", "turn"]) {
      points.forEach((point, i) => near(got[name](point), wanted[name][i]));
    }
  });
}
