// Faces of solids against those of Python; solids.json is written by ../fixtures.py.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import { OFFSETS, dimmed, faces, hull, shades } from "../../../kinlab/browser/solids.js";
import { dot, minus, times } from "../../../kinlab/browser/vectors.js";

const { frame, styles, looks, seen } =
  JSON.parse(readFileSync(new URL("solids.json", import.meta.url), "utf8"));
const ROOM = [[1, 0, 0], [0, 1, 0], [0, 0, 1], [0, 0, 0]];

/** The camera of ../fixtures.py; `far` null for one without perspective. */
function lensOf({ rows, scale, far }) {
  const turn = (d) => rows.map((row) => dot(row, d));
  return {
    scale, turn,
    eye: (p) => far == null ? rows[2] : minus(times(rows[2], far), p),
    see: (p) => {
      const [right, up, near] = turn(p), size = far == null ? 1 : far / (far - near);
      return [300 + scale * size * right, 200 - scale * size * up, size];
    },
  };
}

const TOP = lensOf({ rows: ROOM.slice(0, 3), scale: 10, far: null });
const CIRCLE = Array.from({ length: 24 }, (_, k) =>
  [Math.cos(k * Math.PI / 12), Math.sin(k * Math.PI / 12)]);
const reachOf = (points) => CIRCLE.map(([c, s]) =>
  Math.max(...points.map(([x, y]) => c * x + s * y)));
const near = (got, wanted, told) => {
  const [have, want] = [[got].flat(2), [wanted].flat(2)];
  assert.equal(have.length, want.length, told);
  have.forEach((e, k) => assert.ok(Math.abs(e - want[k]) < 1e-6, `${told}: ${e}, not ${want[k]}`));
};

for (const name of Object.keys(looks)) {
  test(`${name}: faces are Python's`, () => {
    for (const { shape, style, points, size, look, faces: wanted } of seen) {
      if (look !== name) continue;
      const got = faces(shape, lensOf(looks[look]), points, size, styles[style], frame);
      const told = `${shape} of ${style} at ${points[0]}`;
      assert.deepEqual(got.map((face) => face.role), wanted.map((face) => face.role), told);
      got.forEach(({ level, gradient, points: corners }, k) => {
        const { level: tone, gradient: across, reach, points: true_ } = wanted[k];
        assert.equal(level, tone, told);
        near(reach ? reachOf(corners) : corners, reach ?? true_, told);
        near(gradient ? Object.values(gradient).flat() : [], (across ?? []).flat(), told);
      });
    }
  });
}

test("a ramp's colours are Python's", () => {
  for (const { ramp, shades: wanted } of Object.values(styles)) {
    assert.deepEqual(shades(ramp), wanted);
  }
  assert.equal(shades(["#000000", "#1b1b1b", "#363636"]).at(-2), "#343434");
});

test("a dimmed colour asks the theme for its paper", () => {
  assert.equal(dimmed("#6f7c89"), "color-mix(in srgb, #6f7c89 22%, var(--kl-paper))");
});

test("a hull leaves out what lies within and on its sides", () => {
  assert.deepEqual(hull([[0, 0], [4, 0], [4, 4], [0, 4], [2, 2], [2, 0], [0, 0], [4, 3]]),
    [[0, 0], [4, 0], [4, 4], [0, 4]]);
  assert.deepEqual(hull([[1, 1], [3, 3], [2, 2], [0, 0]]), [[0, 0], [3, 3]]);
  assert.deepEqual(hull([[5, 7], [5, 7], [5, 7]]), [[5, 7], [5, 7]]);
});

test("an upright tube from above and from in front, by hand", () => {
  const ends = [[0, 0, 0], [0, 0, 4]], paint = { cap: true, hub: ["", "", ""] };
  const [, cap, hub, mark] = faces("tube", TOP, ends, [2, 2], paint, ROOM);
  assert.deepEqual([cap.role, cap.level, hub.role, hub.level], ["cap", 27, "hub", 23]);
  near(mark.points, [[313.2, 200], [320, 200]], "the stripe along x");
  const front = lensOf({ rows: [[1, 0, 0], [0, 0, 1], [0, -1, 0]], scale: 10, far: null });
  const [side, ...rest] = faces("tube", front, ends, [1, 1], {}, ROOM);
  assert.deepEqual([side.gradient.levels, rest], [[12, 23, 23, 16, 2], []]);
  near([side.gradient.from, side.gradient.to], [[290, 180], [310, 180]], "as wide as the tube");
});

test("levels stand where the gradients have them", () => {
  near([...OFFSETS.across, ...OFFSETS.round], [0, 0.175, 0.5, 0.825, 1, 0, 0.5, 1], "offsets");
});

test("a rod is drawn only before its sleeve, and nothing that is shorter than a hair", () => {
  const rod = (z, size) =>
    faces("box", TOP, [[0, 0, 0], [0, 0, z], [1, 0, 0], [0, 1, 0]], size, {}, ROOM).length;
  assert.deepEqual([rod(2, [1]), rod(-2, [1]), rod(-2, []), rod(0.0009, []), rod(0.0011, [])],
    [1, 0, 1, 0, 1]);
});

test("there is an answer for every solid", () => {
  const spots = [[0, 0, 0], [0, 0, 1], [1, 0, 0], [0, 1, 0], [1e-12, 0, 0]];
  const behind = lensOf({ rows: ROOM.slice(0, 3), scale: 40, far: 0.7 });
  const paint = { cap: true, hub: ["", "", ""] };
  for (const lens of [TOP, behind]) for (const shape of ["tube", "ball", "box"]) {
    for (const size of [[0, 0], [1, 0], [0, 2], [5, 5]]) for (const a of spots) {
      for (const b of spots) for (const c of spots) for (const how of [{}, paint]) {
        const told = JSON.stringify(faces(shape, lens, [a, b, c, a], size, how, ROOM));
        assert.ok(!told.replaceAll(/"(level|gradient)":null/g, "").includes("null"), told);
      }
    }
  }
});
