// Frames and their axes as the buttons name them, and the stages that steps and Play go through.
import assert from "node:assert/strict";
import { test } from "node:test";

import { frameNames, sightlines } from "../../../kinlab/browser/bar.js";
import { Walk, stages } from "../../../kinlab/browser/stages.js";

const axis = (frame, k, end, part = "frame") =>
  ({ part, frame, shape: "axis", points: [[k, 0, 0, 0], [k, ...end]] });
const ITEMS = [axis("0", 0, [1, 0, 0]), axis("0", 0, [0, 1, 0]), axis("0", 0, [0, 0, 1]),
               axis("E", 9, [0, 0, 1]), axis("0", 0, [1, 0, 0], "label"),
               { part: "point", frame: "P", points: [[4, 0, 0, 0]] }, { points: [[0, 1, 2, 3]] }];

test("a frame is listed once, and what only has a name is none", () => {
  assert.deepEqual(frameNames(ITEMS), ["0", "E"]);
});

test("one looks along x and z axes, called as in the picture", () => {
  assert.deepEqual([...sightlines(ITEMS)],
    [["x₀", [0, [1, 0, 0]]], ["z₀", [0, [0, 0, 1]]], ["zₑ", [9, [0, 0, 1]]]]);
});

const KNOBS = [{ low: -1, high: 1 }, { low: 0, high: 3, whole: true }];

test("the whole numbers of a knob are stages, and other knobs stay where they are", () => {
  assert.deepEqual(stages({ knobs: KNOBS, poses: [] }, [0.25, 1.5]),
    [[0.25, 0], [0.25, 1], [0.25, 2], [0.25, 3]]);
  assert.deepEqual(stages({ knobs: KNOBS.slice(0, 1), poses: [[7]] }, [0]), [[7]]);
});

test("a step goes to the next whole number and stops at the last", () => {
  const walk = new Walk({ knobs: KNOBS, poses: [] });
  const from = (value, by) => walk.next([0, value], by)[1];
  assert.deepEqual([from(1.5, 1), from(1.5, -1), from(2, 1), from(2, -1)], [2, 1, 3, 1]);
  assert.deepEqual([from(3, 1), from(0, -1), from(1.9999999999, 1)], [3, 0, 3]);
  assert.equal(walk.has, true);
});

test("the way to a stage leads through all stages between", () => {
  const walk = new Walk({ knobs: KNOBS, poses: [] });
  const way = (value, stage) => walk.to([0, value], stage).map((q) => q[1]);
  assert.deepEqual([way(0, 3), way(2.5, 0), way(1.5, 2)], [[1, 2, 3], [2, 1, 0], [2]]);
  assert.deepEqual(way(2, 2), []);
  assert.deepEqual([walk.stage([0, 0.4]), walk.stage([0, 2.6])], [0, 3]);
});

test("a step goes from pose to pose and round, though one comes twice", () => {
  const poses = [[0], [1], [0], [-1]], walk = new Walk({ knobs: KNOBS.slice(0, 1), poses });
  let q = [0];
  const went = [1, 1, 1, 1, 1, -1].map((by) => (q = walk.next(q, by))[0]);
  assert.deepEqual(went, [1, 0, -1, 0, 1, 0]);
  assert.deepEqual(walk.next([0.8], 1), [1]);       // somebody has moved it: to the nearest
  assert.equal(new Walk({ knobs: KNOBS.slice(0, 1), poses: [] }).has, false);
});

test("where a target leads, only its place says at which pose the arm is", () => {
  const knobs = [{ low: -3, high: 3 }, { low: 0, high: 1 }], poses = [[9, 0], [9, 1]];
  const walk = new Walk({ knobs, poses, target: { knobs: [1] } });
  assert.deepEqual(walk.next([2, 0], 1), [9, 1]);
});
