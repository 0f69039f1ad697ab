// Frames against those of Python; frames.json is written by ../fixtures.py.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import { frames, inRoom, seenFrom, velocities } from "../../../kinlab/browser/frames.js";

const scenes = JSON.parse(readFileSync(new URL("frames.json", import.meta.url), "utf8"));
const near = (got, wanted, told) => assert.ok(Math.abs(got - wanted) < 1e-9,
  `${told}: ${got}, not ${wanted}`);

/** Every None as undefined, as it may arrive. */
const absent = (data) => JSON.parse(JSON.stringify(data), (_, value) => value ?? undefined);

for (const [name, { motions, poses }] of Object.entries(scenes)) {
  test(`${name}: frames are Python's`, () => {
    for (const { q, frames: wanted } of poses) {
      const got = frames(motions, q);
      assert.equal(got.length, wanted.length);
      wanted.flat(2).forEach((e, k) => near(got.flat(2)[k], e, `q = ${q}, number ${k}`));
      assert.deepEqual(frames(absent(motions), q), got);
    }
  });
}

test("velocities are what small moves of the knobs do", () => {
  const { motions, poses: [{ q }] } = scenes["base and tool"], tip = motions.length, h = 1e-6;
  const columns = velocities(motions, frames(motions, q), tip, q.length);
  columns.forEach((column, i) => {
    const [more, less] = [h, -h].map((step) =>
      frames(motions, q.map((value, k) => value + (k === i ? step : 0)))[tip][3]);
    column.forEach((e, k) => assert.ok(Math.abs((more[k] - less[k]) / (2 * h) - e) < 1e-8));
  });
});

test("a frame seen from another, and a point of a frame", () => {
  const turned = [[0, 1, 0], [-1, 0, 0], [0, 0, 1], [3, 4, 0]];
  const room = [[1, 0, 0], [0, 1, 0], [0, 0, 1], [0, 0, 0]];
  assert.deepEqual(inRoom(turned, [1, 2, 5]), [1, 5, 5]);
  assert.deepEqual(seenFrom(turned, room), turned);
  assert.deepEqual(seenFrom(room, turned).map((column) => column.map((e) => e + 0)),
    [[0, -1, 0], [1, 0, 0], [0, 0, 1], [-4, 3, 0]]);
});
