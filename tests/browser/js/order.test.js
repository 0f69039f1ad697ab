// Painter's order: by cases typed here, and against Python's (order.json, by ../fixtures.py).
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import { lens } from "../../../kinlab/browser/camera.js";
import { backToFront } from "../../../kinlab/browser/order.js";

const scene = { presets: { front: [-90, 0] }, preset: "front", size: [580, 520],
                place: [290, 260], center: [0, 0, 0], radius: 2, fit: null };
const FRONT = { azimuth: -90, elevation: 0, zoom: 1 };   // x to the right, z up, -y to the eye
const order = (bodies, camera = FRONT) => backToFront(bodies, lens(scene, camera, scene.size));
const ball = (point, r) => ({ p: point, q: point, r });

for (const [k, { bodies, camera, order: wanted }] of
  JSON.parse(readFileSync(new URL("order.json", import.meta.url), "utf8")).entries()) {
  test(`an order is Python's: ${k}`, () => assert.deepEqual(order(bodies, camera), wanted));
}

test("nothing, one, and what is nearer last", () => {
  assert.deepEqual(order([]), []);
  assert.deepEqual(order([ball([0, 0, 0], 0.1)]), [0]);
  assert.deepEqual(order([ball([0, -1, 0], 0.1), ball([0, 1, 0], 0.1), ball([0, 0, 0], 0.1)]),
    [1, 2, 0]);
});

test("a plane between two bodies tells more than how near their middles are", () => {
  const plank = { p: [0, 0.9, 0], q: [0.5, -1.5, 0], r: 0.05 };   // its middle is at y = -0.3
  assert.deepEqual(order([plank, ball([0, 0.7, 0], 0.05)]), [0, 1]);
  assert.deepEqual(order([plank, ball([0, 1.1, 0], 0.05)]), [1, 0]);
});

test("in perspective each plane is seen from where the viewer stands", () => {
  const rail = (x) => ({ p: [x, -1, 0], q: [x, 1, 0], r: 0.05 });
  const rails = [rail(1), rail(1.2), rail(-1.2), rail(-1)];   // the inner ones hide the outer ones
  assert.deepEqual(order(rails, { ...FRONT, perspective: true }), [1, 0, 2, 3]);
  assert.deepEqual(order(rails), [0, 1, 2, 3]);
});

test("of equal ones the first comes first", () => {
  const same = [ball([0, 0, 0], 0.1), ball([0, 0, 0], 0.1), ball([0.15, 0, 0], 0.1)];
  assert.deepEqual(order(same), [0, 1, 2]);
});

test("a solid covers an arrow's part that is inside it, not one that begins on its end", () => {
  const drum = { p: [0, 0, -0.2], q: [0, 0, 0.2], r: 0.2 };
  const arrow = { p: [0, -0.1, 0], q: [0.5, -0.2, 0], r: 0 }, out = { ...arrow, p: [0, -0.3, 0] };
  assert.deepEqual(order([drum, arrow]), [1, 0]);
  assert.deepEqual(order([arrow, drum]), [0, 1]);
  assert.deepEqual(order([drum, out]), [0, 1]);
  assert.deepEqual(order([{ p: [0, -0.1, 0.3], q: [0, -0.5, 0.5], r: 0 }, drum]), [1, 0]);
});

test("what stands on a base is before it from above, and behind it from below", () => {
  const plane = { normal: [0, 0, 1], at: [0, 0, 0] };
  const base = { p: [0, 0, -0.1], q: [0, 0, 0], r: 0.5, plane };
  const post = { p: [0, 0.3, 0.05], q: [0, 0.3, 0.6], r: 0.1 };
  for (const bodies of [[base, post], [post, base]]) {
    const place = bodies.indexOf(base);
    assert.equal(order(bodies, { ...FRONT, elevation: 30 }).indexOf(place), 0);
    assert.equal(order(bodies, { ...FRONT, elevation: -30 }).indexOf(place), 1);
  }
});

test("of three that cover each other in a circle the farthest comes first", () => {
  /** Far where it begins and near where it ends, on the next one's beginning. */
  const bar = (angle, y) => {
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    return { p: [0.3 * s - c, 0.3 + y, -0.3 * c - s], q: [0.3 * s + c, y - 0.3, -0.3 * c + s],
             r: 0.02 };
  };
  const third = 2 * Math.PI / 3, bars = [bar(0, 0), bar(third, 0.01), bar(2 * third, 0)];
  assert.deepEqual(order(bars), [1, 0, 2]);
});
