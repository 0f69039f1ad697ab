// Paths, by numbers typed here.
import assert from "node:assert/strict";
import { test } from "node:test";

import { PATHS } from "../../../kinlab/browser/parts.js";

test("points become paths", () => {
  assert.equal(PATHS.line([[0, 1], [2.345, 3], [4, 5]]), "M0.0 1.0L2.3 3.0L4.0 5.0");
  assert.equal(PATHS.hull([[0, 0], [4, 0], [2, 1], [4, 4], [0, 4], [2, 0]]),
    "M0.0 0.0L4.0 0.0L4.0 4.0L0.0 4.0Z");
  assert.equal(PATHS.arrow([[0, 0], [100, 0]]), "M0.0 0.0L91.0 0.0L91.0 3.2L100.0 0.0" +
    "L91.0 -3.2L91.0 0.0L0.0 0.0Z");
});

test("a bent arrow has its head on its last way", () => {
  assert.equal(PATHS.arrow([[0, 0], [50, 0], [50, 20]]), "M0.0 0.0L50.0 0.0L50.0 11.0L46.8 11.0" +
    "L50.0 20.0L53.2 11.0L50.0 11.0L50.0 0.0L0.0 0.0Z");
  assert.equal(PATHS.arrow([[0, 0], [50, 0], [50, 9]]).split("L").length, 7);   // no corner twice
});

test("a face is drawn only from its front", () => {
  const face = [[0, 0], [0, 4], [4, 0]];
  assert.equal(PATHS.face(face), "M0.0 0.0L0.0 4.0L4.0 0.0Z");
  assert.equal(PATHS.face(face.reverse()), "");
});

test("an arrow without length is a point", () => {
  assert.ok(!PATHS.arrow([[3, 3], [3, 3], [3, 3]]).includes("NaN"));
});
