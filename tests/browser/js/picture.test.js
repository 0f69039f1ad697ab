// Projection and paths, by numbers typed here.
import assert from "node:assert/strict";
import { test } from "node:test";

import { PATHS, projector, screenAxes } from "../../../kinlab/browser/picture.js";

const scene = { place: [100, 200], scale: 10, center: [1, 2, 3] };
const TOP = [-90, 90], FRONT = [-90, 0], SIDE = [0, 0];
const near = (got, wanted) => got.forEach((e, k) =>
  assert.ok(Math.abs(e - wanted[k]) < 1e-9, `${got}, not ${wanted}`));

/** [right, down, nearness] of a point. */
function seen(point, [azimuth, elevation], zoom = 1) {
  return projector(scene, { azimuth, elevation, zoom })(point);
}

test("the centre stands in its place from everywhere", () => {
  for (const camera of [TOP, FRONT, SIDE, [37, -12]]) near(seen([1, 2, 3], camera), [100, 200, 0]);
});

test("each side shows its two axes, and what is nearer", () => {
  near(seen([2, 4, 8], TOP), [110, 180, 5]);        // x to the right, y up, z to the eye
  near(seen([2, 4, 8], FRONT), [110, 150, -2]);     // x to the right, z up, -y to the eye
  near(seen([2, 4, 8], SIDE), [120, 150, 1]);       // y to the right, z up, x to the eye
  near(seen([2, 4, 8], TOP, 2), [120, 160, 5]);
});

test("a view from a corner", () => {
  const half = Math.SQRT1_2;
  near(seen([2, 2, 3], [45, 30]), [100 - 10 * half, 200 + 5 * half, half * Math.sqrt(3) / 2]);
  near(screenAxes({ azimuth: 45, elevation: 30, zoom: 1 }).flat(),
       [-half, half, 0, -half / 2, -half / 2, Math.sqrt(3) / 2]);
});

test("points become paths", () => {
  assert.equal(PATHS.line([[0, 1], [2.345, 3], [4, 5]]), "M 0.00 1.00 L 2.35 3.00 L 4.00 5.00");
  assert.equal(PATHS.hull([[0, 0], [4, 0], [2, 1], [4, 4], [0, 4], [2, 0]]),
    "M 0.00 0.00 L 4.00 0.00 L 4.00 4.00 L 0.00 4.00 Z");
  assert.equal(PATHS.arrow([[0, 0], [100, 0]]), "M 0.00 0.00 L 91.00 0.00 L 91.00 3.24 " +
    "L 100.00 0.00 L 91.00 -3.24 L 91.00 0.00 L 0.00 0.00");
});

test("a face is drawn only from its front", () => {
  const face = [[0, 0], [0, 4], [4, 0]];
  assert.equal(PATHS.face(face), "M 0.00 0.00 L 0.00 4.00 L 4.00 0.00 Z");
  assert.equal(PATHS.face(face.reverse()), "");
});

test("an arrow without length is a point", () => {
  assert.ok(!PATHS.arrow([[3, 3], [3, 3]]).includes("NaN"));
});
