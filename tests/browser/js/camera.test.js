// The camera: by numbers typed here, and against Python's (camera.json, written by ../fixtures.py).
import assert from "node:assert/strict";
import { test } from "node:test";

import { lens } from "../../../kinlab/browser/camera.js";

const scene = { presets: { "3-D": [-60, 24] }, preset: "3-D", size: [400, 300], place: [200, 150],
                center: [1, 2, 3], radius: 14, fit: null };
const TOP = [-90, 90], FRONT = [-90, 0], SIDE = [0, 0];
const near = (got, wanted, far = 1e-9) => got.forEach((e, k) =>
  assert.ok(Math.abs(e - wanted[k]) < far, `${got}, not ${wanted}`));

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
