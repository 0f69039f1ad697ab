// Curves that knobs shape, and clouds: by hand, and against Python's (written by ../fixtures.py).
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import { cameraAxes } from "../../../kinlab/browser/camera.js";
import { cloudLayers, unpacked } from "../../../kinlab/browser/cloud.js";
import { cornersOf, isThere } from "../../../kinlab/browser/curves.js";
import { frames } from "../../../kinlab/browser/frames.js";

const read = (name) =>
  JSON.parse(readFileSync(new URL(`${name}.json`, import.meta.url), "utf8"));
const { scene: { motions, items }, poses } = read("curves"), cloud = read("cloud");

/** That lists of points are the same, to a billionth. */
function near(got, wanted, told) {
  assert.equal(got.length, wanted.length, told);
  wanted.flat(3).forEach((e, k) => assert.ok(Math.abs(got.flat(3)[k] - e) < 2e-9, `${told} ${k}`));
}

for (const { gid } of items) {
  test(`${gid}: corners are Python's`, () => {
    const item = items.find((one) => one.gid === gid);
    for (const { q, items: wanted } of poses) {
      const now = { motions, all: frames(motions, q), q };
      near(cornersOf(item, now), wanted[gid].corners, `q = ${q}`);
      assert.equal(isThere(item, q), wanted[gid].there);
    }
  });
}

test("a quarter of a circle, from the knob's value to 90 degrees", () => {
  const turns = [{ kind: "rotate", axis: 2, joint: 0 },
                 { kind: "rotate", axis: 2, amount: Math.PI / 2, parent: 0 }];
  const now = { motions: turns, all: frames(turns, [0]), q: [0] };
  const arc = cornersOf({ shape: "sweep", points: [[1, 2, 0, 5]], size: [1, 2] }, now);
  assert.equal(arc.length, 31);                     // a corner every three degrees
  arc.forEach(([x, y, z], k) => {
    const angle = k * Math.PI / 60;
    near([[x, y, z]], [[2 * Math.cos(angle), 2 * Math.sin(angle), 5]], `corner ${k}`);
  });
});

test("a way ends where its knob stands", () => {
  const now = { motions: [], all: frames([], []), q: [1.25] };
  const points = [[0, 0, 0, 0], [0, 2, 0, 0], [0, 2, 4, 0]];
  assert.deepEqual(cornersOf({ shape: "way", points, size: [0] }, now),
    [[0, 0, 0], [2, 0, 0], [2, 1, 0]]);
});

test("dots come back from their letters, and fall into layers as in Python", () => {
  const dots = unpacked(cloud.corner.slice(1), cloud.letters, cloud.step);
  for (const { camera: [azimuth, elevation], cut, layers } of cloud.views) {
    const { near: towards } = cameraAxes({ azimuth, elevation });
    const got = cloudLayers(dots, cut ? cloud.plane : null, { near: towards }, cloud.middle,
      cloud.radius);
    layers.forEach((layer, k) => near(got[k], layer, `${azimuth} ${elevation}, layer ${k}`));
  }
});
