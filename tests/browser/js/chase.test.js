// Joints that follow a target: two links of 1 m, the scene "target" of ../fixtures.py.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import { kept } from "../../../kinlab/browser/chase.js";
import { follower, reach } from "../../../kinlab/browser/following.js";
import { frames } from "../../../kinlab/browser/frames.js";

const { motions } = JSON.parse(
  readFileSync(new URL("frames.json", import.meta.url), "utf8")).target;

/** The scene with limits for the two joints, in rad. */
function scene(first = [-Math.PI, Math.PI], second = [-Math.PI, Math.PI]) {
  const joint = ([low, high]) => ({ low, high, unit: "°" });
  const place = { low: -2, high: 2, unit: "m" };
  return { motions, radius: 2, knobs: [joint(first), joint(second), place, place],
           target: { frame: 6, tip: 4, joints: 2, knobs: [2, 3] } };
}
const near = (got, wanted, within = 1e-6) => got.forEach((e, k) =>
  assert.ok(Math.abs(e - wanted[k]) < within, `${got}, not ${wanted}`));
const tip = (q) => frames(motions, q)[4][3];

test("the tool comes to the goal", () => {
  const { q, error, steps } = reach(scene(), [0.3, 0.5, 7, 8], [1, 1, 0]);
  near(q, [0, Math.PI / 2, 7, 8]);
  assert.ok(error < 1e-6 && steps > 0 && steps <= 60);
});

test("an arm that is there already stays", () => {
  assert.deepEqual(reach(scene(), [0, Math.PI / 2, 0, 0], [1, 1, 0]).q, [0, Math.PI / 2, 0, 0]);
});

test("out of reach it points there", () => {
  const { q, error } = reach(scene(), [0.3, 0.5, 0, 0], [3, 0, 0]);
  near(q, [0, 0, 0, 0], 1e-2);
  assert.ok(Math.abs(error - 1) < 1e-3, String(error));
});

test("a stretched arm folds", () => {
  near(tip(reach(scene(), [0, 0, 0, 0], [1.2, 0, 0]).q), [1.2, 0, 0]);
});

test("limits hold, and the other joint goes on", () => {
  const { q, error } = reach(scene([-1, 0.2], [0, 0.5]), [0, 0.3, 0, 0], [0, 2, 0]);
  near(q, [0.2, 0.5, 0, 0], 1e-3);
  assert.ok(q[0] <= 0.2 && q[1] <= 0.5);
  const best = Math.hypot(Math.cos(0.2) + Math.cos(0.7), 2 - Math.sin(0.2) - Math.sin(0.7));
  assert.ok(Math.abs(error - best) < 1e-3, `${error}, not ${best}`);
});

test("a joint at its limit leaves the work to the others", () => {
  const { q, error } = reach(scene(undefined, [0, 0.5]), [0, 0.5, 0, 0], [1, 1, 0]);
  near(q, [Math.PI / 4 - 0.25, 0.5, 0, 0], 1e-2);
  near([error], [2 * Math.cos(0.25) - Math.SQRT2], 1e-3);
});

test("a joint that turns right round has no end", () => {
  const { q } = reach(scene(), [3.1, 0.3, 0, 0], [2 * Math.cos(3.3), 2 * Math.sin(3.3), 0]);
  assert.ok(q[0] >= -Math.PI && q[0] < -2.9, String(q));
});

test("a joint that turns round twice stays where it is, and goes on past its ends", () => {
  const twice = { low: -2 * Math.PI, high: 2 * Math.PI, unit: "°" };
  for (const value of [-6, -1, 0, 1, 6]) assert.equal(kept(value, twice), value);
  assert.ok(Math.abs(kept(6.5, twice) - (6.5 - 4 * Math.PI)) < 1e-12);
  assert.ok(Math.abs(kept(-6.5, twice) - (4 * Math.PI - 6.5)) < 1e-12);
  const more = { low: -3.5, high: 3.5, unit: "°" };       // once, and a little
  assert.ok(Math.abs(kept(3.6, more) - (3.6 - 2 * Math.PI)) < 1e-12);
});

/** Joints that keep what is written, and what a follower told. */
function followed(q) {
  const told = [], joints = { read: () => q, write: (next) => { q = next; } };
  const chase = follower(scene(), joints, (found) => told.push(found));
  return { chase, joints, told };
}

test("where the target goes the joints follow", () => {
  const { chase, joints, told } = followed([0.3, 0.5, ...tip([0.3, 0.5, 0, 0]).slice(0, 2)]);
  joints.write([...joints.read().slice(0, 2), 1, 1]);
  chase.changed();
  near(joints.read(), [0, Math.PI / 2, 1, 1]);
  assert.ok(told[0].error < 1e-6);
  joints.write([...joints.read().slice(0, 2), 0.5, 1.2]);
  chase.changed();
  near(tip(joints.read()), [0.5, 1.2, 0]);
});

test("where the joints go the target rides", () => {
  const { chase, joints, told } = followed([0, Math.PI / 2, 1, 1]);
  joints.write([Math.PI / 2, Math.PI / 2, 1, 1]);
  chase.changed();
  near(joints.read(), [Math.PI / 2, Math.PI / 2, -1, 1]);
  assert.deepEqual(told, [null]);
  chase.drive.write([0, 0, 0, 0]);
  near(joints.read(), [0, 0, 2, 0]);
  chase.lead.write([0.5, -1, 1, 1]);                // the joints there are not looked at
  assert.deepEqual(joints.read(), reach(scene(), [0, 0, 1, 1], [1, 1, 0]).q);
});

test("a joint that does not move the tool is not pushed", () => {
  const flat = scene(), tool = motions.slice(0, 4);   // a roll about the second link's own length
  const rolled = { ...flat, motions: [...tool, { kind: "rotate", axis: 0, joint: 2 }], knobs:
    [...flat.knobs.slice(0, 2), { low: -3, high: 3, unit: "°" }, ...flat.knobs.slice(2)],
                   target: { frame: 6, tip: 5, joints: 3, knobs: [3, 4] } };
  const { q } = reach(rolled, [0, 0, 0.5, 0, 0], [1.2, 0, 0]);
  near(frames(rolled.motions, q)[5][3], [1.2, 0, 0]);
  assert.equal(q[2], 0.5);
});
