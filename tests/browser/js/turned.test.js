// How frames are turned: by hand, and against Python's (written by ../fixtures.py).
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import { frames } from "../../../kinlab/browser/frames.js";
import { axisAndAngle, followed, rollPitchYaw, turnedAs } from
  "../../../kinlab/browser/turned.js";

const { motions, places } =
  JSON.parse(readFileSync(new URL("turned.json", import.meta.url), "utf8"));
const turns = [2, 1, 0].map((axis, joint) => ({ kind: "rotate", axis, joint }));
const rad = (...degrees) => degrees.map((angle) => angle * Math.PI / 180);
const shown = (kind, ...degrees) => {
  const q = rad(...degrees);
  return turnedAs({ kind, frame: 3 }, { motions: turns, all: frames(turns, q), q }, 3);
};

/** That numbers are the same, to a billionth; angles of 180 and of -180 degrees are one. */
function near(got, wanted, told) {
  if (typeof wanted === "string") return assert.equal(got, wanted, told);
  assert.equal(got.length, wanted.length, told);
  got.forEach((e, k) => assert.ok(Math.abs(e - wanted[k]) < 2e-9
    || Math.abs(Math.abs(e - wanted[k]) - 360) < 2e-9, `${told}: ${got} and ${wanted}`));
}

test("all descriptions are Python's, with all signs and at the singular places", () => {
  for (const { q, frame, read } of places) {
    const told = `frame ${frame} at ${q}`, whole = followed(motions, frame, q);
    const { axis, angle } = axisAndAngle(whole);
    near(whole, read.quaternion, told);
    near(axis ?? "any axis", read.axis, told);
    near([angle], read.angle, told);
    near(rollPitchYaw(frames(motions, q)[frame]), read.rpy, told);
  }
});

test("a quarter turn about each axis", () => {
  assert.equal(shown("quaternion", 90, 0, 0), "(0.707, 0.000, 0.000, 0.707)");
  assert.equal(shown("quaternion", 0, 90, 0), "(0.707, 0.000, 0.707, 0.000)");
  assert.equal(shown("quaternion", 0, 0, -90), "(0.707, −0.707, 0.000, 0.000)");
  assert.equal(shown("axis", 0, 0, -90), "(−1.000, 0.000, 0.000)");
  assert.equal(shown("angle", 0, 0, -90), "90.0");
});

test("a book that is turned about z, then about its own x, has turned about a diagonal", () => {
  assert.equal(shown("quaternion", 90, 0, 90), "(0.500, 0.500, 0.500, 0.500)");
  assert.equal(shown("axis", 90, 0, 90), "(0.577, 0.577, 0.577)");
  assert.equal(shown("angle", 90, 0, 90), "120.0");
});

test("after a whole turn the quaternion is the opposite one, and no sign jumps on the way", () => {
  const at = (angle) => followed([{ kind: "rotate", axis: 2, joint: 0 }], 1, rad(angle));
  near(at(360), [-1, 0, 0, 0], "360");
  for (let angle = -720; angle < 720; angle += 5) {
    at(angle + 5).forEach((e, k) => assert.ok(Math.abs(e - at(angle)[k]) < 0.05));
  }
  assert.equal(shown("axis", 360, 0, 0), "any axis");
  assert.equal(shown("axis", 0, 0, 0), "any axis");
  assert.equal(shown("angle", 0, 0, 0), "0.0");
  assert.equal(shown("angle", 180, 0, 0), "180.0");
  assert.equal(shown("angle", 270, 0, 0), "270.0");
});

test("roll, pitch and yaw, in this order, and what is left of them at 90 degrees", () => {
  assert.equal(shown("rpy", 40, 20, -30), "(−30.0, 20.0, 40.0)");
  assert.equal(shown("rpy", 40, 110, -30), "(150.0, 70.0, −140.0)");   // the other branch
  assert.equal(shown("rpy", 50, 90, 20), "pitch 90.0, yaw − roll = 30.0");
  assert.equal(shown("rpy", 50, -90, 20), "pitch −90.0, yaw + roll = 70.0");
  assert.equal(shown("rpy", 20, 90, 50), "pitch 90.0, yaw − roll = −30.0");
});
