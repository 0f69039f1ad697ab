// Where sliders stop, how joints move between poses, how numbers are written.
import assert from "node:assert/strict";
import { test } from "node:test";

import { number } from "../../../kinlab/browser/dom.js";
import { smooth } from "../../../kinlab/browser/player.js";
import { KEYS, clip, snap, stepped } from "../../../kinlab/browser/steps.js";

const turn = { low: -180, high: 180, step: 1 }, slide = { low: -0.135, high: 0.62, step: 0.01 };

test("a hand's value goes to the nearest whole step", () => {
  assert.equal(snap(12.4, turn), 12);
  assert.equal(snap(12.6, turn), 13);
  assert.equal(snap(-12.6, turn), -13);
  assert.equal(snap(0.572, slide), 0.57);           // and not 57 * 0.01, 0.5700000000000001
  assert.equal(snap(0.306, slide), 0.31);
});

test("limits hold though they are no whole steps", () => {
  assert.equal(snap(-0.134, slide), -0.135);
  assert.equal(snap(-0.13, slide), -0.13);
  assert.equal(snap(0.7, slide), 0.62);
  assert.equal(snap(-200, turn), -180);
});

test("keys go on by whole steps, or by tenths", () => {
  assert.equal(stepped(12, 1, false, turn), 13);
  assert.equal(stepped(12.4, 1, false, turn), 13);
  assert.equal(stepped(12.4, -1, false, turn), 12);
  assert.equal(stepped(12.4, 10, false, turn), 22);
  assert.equal(stepped(12, 1, true, turn), 12.1);
  assert.equal(stepped(12.1, -1, true, turn), 12);
  assert.equal(stepped(0.3, -1, false, slide), 0.29);
  assert.equal(stepped(0.29, 1, false, slide), 0.3);   // 0.29 / 0.01 is a little less than 29
  assert.equal(stepped(179.5, 10, false, turn), 180);
  assert.equal(stepped(0.05, KEYS.Home, false, slide), -0.135);
  assert.equal(stepped(0.05, KEYS.End, true, slide), 0.62);
  assert.equal(stepped(180, KEYS.ArrowLeft, false, turn), 179);
});

test("clip keeps a value between the limits", () => {
  assert.deepEqual([-2, 0.5, 3].map((value) => clip(value, -1, 1)), [-1, 0.5, 1]);
});

test("a movement starts and ends at rest, halfway at half time", () => {
  assert.deepEqual([0, 0.5, 1].map(smooth), [0, 0.5, 1]);
  assert.ok(smooth(0.01) < 1.1e-5 && smooth(0.99) > 1 - 1.1e-5);
});

test("numbers have a true minus and no negative zero", () => {
  assert.equal(number(-1.25, 1), "\u22121.3");
  assert.equal(number(-0.0004, 3), "0.000");
  assert.equal(number(485.1, 1), "485.1");
});
