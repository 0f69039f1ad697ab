// Arithmetic with vectors, by numbers typed here.
import assert from "node:assert/strict";
import { test } from "node:test";

import {
  cross, dot, minus, norm, partway, plus, times, unit,
} from "../../../kinlab/browser/vectors.js";

test("sums, multiples and products", () => {
  assert.equal(dot([1, 2, 3], [4, 5, 6]), 32);
  assert.deepEqual(cross([1, 2, 3], [4, 5, 6]), [-3, 6, -3]);
  assert.deepEqual(plus([1, 2, 3], [4, 5, 6]), [5, 7, 9]);
  assert.deepEqual(minus([1, 2, 3], [6, 5, 4]), [-5, -3, -1]);
  assert.deepEqual(times([1, 2, 3], -2), [-2, -4, -6]);
});

test("lengths, directions and ways between", () => {
  assert.equal(norm([2, 3, 6]), 7);
  assert.deepEqual(unit([0, 0, -4]).map((e) => e + 0), [0, 0, -1]);
  assert.deepEqual(unit([0, 0, 0]), [0, 0, 0]);
  assert.deepEqual(partway([1, 2, 3], [5, 2, -1], 0.25), [2, 2, 2]);
});
