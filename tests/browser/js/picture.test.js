// Paths, by numbers typed here.
import assert from "node:assert/strict";
import { test } from "node:test";

import { PATHS } from "../../../kinlab/browser/picture.js";

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
