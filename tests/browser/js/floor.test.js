// The floor: by numbers typed here, and against Python's (floor.json, written by ../fixtures.py).
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import { lens } from "../../../kinlab/browser/camera.js";
import {
  drop, giveWay, ground, saidOnce, shadow, strength,
} from "../../../kinlab/browser/floor.js";

const cases = JSON.parse(readFileSync(new URL("floor.json", import.meta.url), "utf8"));
const TOP = { right: [1, 0, 0], up: [0, 1, 0], near: [0, 0, 1], scale: 100, shrunk: 1,
              see: ([x, y]) => [200 + 100 * x, 150 - 100 * y, 1], eye: () => [0, 0, 1],
              turn: (/** @type {number[]} */ d) => d };
const SIZE = [400, 300], FLOOR = { height: 0, step: 0.5, reach: 2, drops: [], decimals: 2 };

/** That two data are the same, numbers to a hundred-thousandth of a pixel. */
function alike(got, wanted, told) {
  if (typeof wanted === "number") {
    return assert.ok(Math.abs(got - wanted) < 1e-5, `${told}: ${got}, not ${wanted}`);
  }
  if (wanted == null || typeof wanted !== "object") return assert.equal(got, wanted, told);
  assert.deepEqual(Object.keys(got).sort(), Object.keys(wanted).sort(), told);
  for (const key of Object.keys(wanted)) alike(got[key], wanted[key], `${told}.${key}`);
}

for (const [name, { floor, camera, scene, size, point, solids, ...wanted }] of
  Object.entries(cases)) {
  test(`${name}: the floor is Python's`, () => {
    const look = lens(scene, camera, size);
    alike(ground(floor, look, size), wanted.ground, "ground");
    alike(drop(floor, look, size, point), wanted.drop, "drop");
    alike(shadow(floor, look, solids), wanted.shadow, "shadow");
  });
}

test("a ruler is numbered as often as there is room, on the viewer's side", () => {
  const { numbers, below } = ground(FLOOR, TOP, SIZE);
  const of = (axis) => numbers.filter((one) => one.axis === axis);
  assert.deepEqual(of("x").map(({ text }) => text),
    ["\u22121.5", "\u22121", "\u22120.5", "0.5", "1", "1.5"]);
  assert.deepEqual(of("x").map(({ place: [x] }) => Math.round(x)), [50, 100, 150, 250, 300, 350]);
  assert.deepEqual(of("y").map(({ text }) => text), ["\u22121", "\u22120.5", "0.5", "1"]);
  assert.ok(of("x").every(({ place }) => place[1] === 150 + 7 + 5));   // below the ruler
  assert.ok(of("y").every(({ place, w }) => Math.abs(place[0] + w / 2 + 5 - 200) < 1e-9));
  assert.equal(below, false);
  const far = ground(FLOOR, { ...TOP, scale: 30,
    see: ([x, y]) => [200 + 30 * x, 150 - 30 * y, 1] }, SIZE);
  assert.deepEqual(far.numbers.filter(({ axis }) => axis === "x").map(({ text }) => text),
    ["\u22121", "1"]);                                    // 15 px a step: every second one
});

test("numbers give way to what covers them", () => {
  const { numbers } = ground(FLOOR, TOP, SIZE);
  const after = giveWay(numbers, [[300, 160, 20, 10]]);
  assert.deepEqual(after.filter(({ opacity }) => !opacity).map(({ text, axis }) => axis + text),
    ["x1"]);
});

test("the floor fades towards its rim", () => {
  const { fade } = ground(FLOOR, TOP, SIZE);
  assert.deepEqual(fade, { center: [200, 150], radius: 200, squeeze: 1 });
  const at = [[200, 150], [310, 150], [200, 150 - 155], [401, 150]].map((p) => strength(fade, p));
  [1, 0.8, 0.4, 0].forEach((e, k) => assert.ok(Math.abs(at[k] - e) < 1e-9, `${at}`));
});

test("a drop line says where its foot stands, and how high its point", () => {
  const front = { ...TOP, see: ([x, , z]) => [200 + 100 * x, 150 - 100 * z, 1],
                  eye: () => [0, -1, 0], turn: ([x, y, z]) => [x, z, -y] };
  const { texts, line, ends, guides } = drop(FLOOR, front, SIZE, [1, -0.004, 0.8]);
  assert.deepEqual(texts.map(({ text }) => text), ["(1.00, 0.00)", "z 0.80"]);
  assert.deepEqual(line, [[300, 70], [300, 150]]);
  assert.deepEqual(ends, [[1, -0.004, 0.8], [1, -0.004, 0]]);
  assert.deepEqual(guides, [[[300, 150], [300, 150]], [[300, 150], [200, 150]]]);
  assert.equal(texts[0].place[1], 165);
  assert.deepEqual(drop(FLOOR, front, SIZE, [9, 0, 0.8]).texts.map(({ text }) => text), ["z 0.80"]);
  assert.deepEqual(drop(FLOOR, TOP, SIZE, [-1.255, -0.5, 0.8]).texts.map(({ text }) => text),
    ["(\u22121.25, \u22120.50)"]);                        // 1.255 is a little less than that
});

test("a shadow is what lies under a solid", () => {
  const spans = (outline) => [0, 1].map((k) => outline.map((p) => p[k]))
    .flatMap((e) => [Math.min(...e), Math.max(...e)].map((v) => Math.round(v)));
  const outlines = shadow(FLOOR, TOP, [
    { shape: "ball", ends: [[0.5, 0.5, 1]], size: [0.2] },
    { shape: "tube", ends: [[0, 0, 0.5], [1, 0, 0.5]], size: [0.2, 0.1] },
    { shape: "tube", ends: [[0, 0, 0], [0, 0, 1]], size: [0.2, 0.1] },
    { shape: "box", ends: [[0, 0, 0], [0, 0, 1], [0.3, 0, 0], [0, 0.1, 0]], size: [] }]);
  assert.deepEqual(outlines.map(spans), [[230, 270, 80, 120], [200, 300, 130, 170],
    [180, 220, 130, 170], [170, 230, 140, 160]]);
});

test("coordinates that stand on each other are said once", () => {
  const words = (text, x) => ({ text, place: [x, 100], w: 50, h: 16 });
  const [foot, high] = [words("(4, 0)", 30), words("z 2", 90)];
  const all = [{ texts: [foot, high] }, { texts: [words("(4, 0)", 31), words("z 2", 140)] }];
  assert.deepEqual(saidOnce(all).map(({ place: [x] }) => x), [30, 90, 140]);
});
