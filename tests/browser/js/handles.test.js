// From the pointer to the knobs, by numbers typed here; two links of 1 m unless said otherwise.
import assert from "node:assert/strict";
import { test } from "node:test";

import { frames, inRoom } from "../../../kinlab/browser/frames.js";
import { jointMotion, pullHandle, pullJoint, speeds, touched, under }
  from "../../../kinlab/browser/handles.js";

const DEGREE = Math.PI / 180;
const near = (got, wanted, within = 1e-6) => got.forEach((e, k) =>
  assert.ok(Math.abs(e - wanted[k]) < within, `${got}, not ${wanted}`));

/** 100 px to the unit, the origin at (300, 200); with a distance, in perspective. */
function seenFrom(azimuth, elevation, distance = Infinity) {
  const [a, e] = [azimuth * DEGREE, elevation * DEGREE];
  const [ca, sa, ce, se] = [Math.cos(a), Math.sin(a), Math.cos(e), Math.sin(e)];
  const axes = [[-sa, ca, 0], [-se * ca, -se * sa, ce], [ce * ca, ce * sa, se]];
  const turn = (d) => axes.map((axis) => axis.reduce((sum, v, k) => sum + v * d[k], 0));
  const [right, up, nearer] = axes;
  return {
    right, up, near: nearer, scale: 100, shrunk: 1, turn,
    see(p) {
      const [x, y, z] = turn(p), size = 1 / (1 - z / distance);
      return [300 + 100 * size * x, 200 - 100 * size * y, size];
    },
    eye: (p) => nearer.map((v, k) => v - p[k] / distance),
  };
}
const TOP = seenFrom(-90, 90), BELOW = seenFrom(-90, -90), CORNER = seenFrom(-60, 24);
const FRONT = seenFrom(-90, 0), CLOSE = seenFrom(-35, 30, 5);

const turn = (joint, more = {}) => ({ kind: "rotate", axis: 2, joint, ...more });
const slide = (axis, joint, more = {}) => ({ kind: "translate", axis, joint, ...more });
const along = (axis, amount, more = {}) => ({ kind: "translate", axis, amount, ...more });
const angle = (low = -180, high = 180) => ({ low: low * DEGREE, high: high * DEGREE, unit: "°" });
const length = (low = -9, high = 9) => ({ low, high, unit: "m" });

const ARM = { motions: [turn(0), along(0, 1), turn(1), along(0, 1)], radius: 2,
              knobs: [angle(), angle()] };
const TIP = { name: "tip", point: [4, 0, 0, 0], knobs: [0, 1], unit: "m" };

/** A hand that takes a place at values q, and is then at each of some places of the room. */
function drag(scene, k, q, place, lens, ways) {
  const hand = lens.see(place).slice(0, 2), all = frames(scene.motions, q);
  const pull = pullJoint(scene, k, place, { all, q, hand, lens });
  return ways.reduce((now, way) => pull(lens.see(way).slice(0, 2), lens, now), q);
}
const onCircle = (degrees, radius = 1) =>
  [radius * Math.cos(degrees * DEGREE), radius * Math.sin(degrees * DEGREE), 0];

test("a link turns to where the hand goes, however far from the axis that is", () => {
  near(drag(ARM, 0, [0, 0.4], [1, 0, 0], TOP, [[0, 1, 0]]), [Math.PI / 2, 0.4]);
  near(drag(ARM, 0, [0, 0.4], [0.5, 0, 0], TOP, [[0, 3, 0]]), [Math.PI / 2, 0.4]);
  near(drag(ARM, 0, [0, 0.4], [1, 0, 0], BELOW, [[0, 1, 0]]), [Math.PI / 2, 0.4]);
});

test("what is held stays under the hand from a corner, from below and in perspective", () => {
  for (const lens of [CORNER, CLOSE, seenFrom(20, -50), seenFrom(100, 60, 4)]) {
    near(drag(ARM, 0, [0.2, 1], onCircle(20, 0.7), lens, [onCircle(60, 0.7)]),
         [0.2 + 40 * DEGREE, 1]);
  }
});

test("the second link turns about its own joint", () => {
  const q = drag(ARM, 2, [Math.PI / 2, 0], [0, 1.5, 0], CORNER, [[-0.5, 1, 0]]);
  near(q, [Math.PI / 2, Math.PI / 2]);
});

test("a circle seen from its edge turns as a wheel under the hand", () => {
  const front = drag(ARM, 0, [0, 0], [0, -1, 0], FRONT, [[0.5, -1, 0]]);
  near(front, [0.5, 0]);                            // 50 px on a wheel of 100 px
  near(drag(ARM, 0, [0, 0], [1, 0, 0], FRONT, [[1.5, 0, 0]]), [0.5, 0]);
  near(drag(ARM, 0, [0, 0], [0, 1, 0], FRONT, [[0.5, 1, 0]]), [-0.5, 0]);   // its far side
});

test("close to its axis a hand does not say how far to turn", () => {
  const q = drag(ARM, 0, [0.3, 0], [0.02, 0, 0], TOP, [[-0.05, 0.01, 0], [0, 0.5, 0]]);
  near(q, [0.3, 0]);
  near(drag(ARM, 0, [0.3, 0], [0.02, 0, 0], TOP, [[0.5, 0, 0], [0, 0.5, 0]]),
       [0.3 + Math.PI / 2, 0]);
});

test("a joint on whose axis it is held turns as well", () => {
  near(drag(ARM, 0, [0.3, 0], [0, 0, 0.2], TOP, [[0.5, 0, 0], [0, 0.5, 0]]),
       [0.3 + Math.PI / 2, 0]);
});

test("at its limit a joint waits until the hand is back", () => {
  const scene = { ...ARM, knobs: [angle(-90, 60), angle()] };
  const round = [30, 60, 90, 120, 170].map((a) => onCircle(a));
  near(drag(scene, 0, [0, 0], [1, 0, 0], TOP, round), [60 * DEGREE, 0]);
  near(drag(scene, 0, [0, 0], [1, 0, 0], TOP, [...round, onCircle(200), onCircle(270)]),
       [60 * DEGREE, 0]);
  near(drag(scene, 0, [0, 0], [1, 0, 0], TOP, [...round, ...round.toReversed()]),
       [30 * DEGREE, 0]);
});

test("a joint that turns right round goes on past its ends", () => {
  const round = [60, 120, 180, 240, 300, 360, 420, 480].map((a) => onCircle(a));
  near(drag(ARM, 0, [0, 0], [1, 0, 0], TOP, round), [120 * DEGREE, 0]);
});

test("a joint counts with its gain", () => {
  const scene = { motions: [turn(0, { gain: -0.5, amount: 1 })], knobs: [angle()], radius: 1 };
  near(drag(scene, 0, [0.4], [1, 0, 0], TOP, [onCircle(10)]), [0.4 - 20 * DEGREE]);
});

test("a slide comes as near to the hand as its line", () => {
  const scene = { motions: [turn(0), slide(0, 1)], knobs: [angle(), length(0, 2)], radius: 2 };
  const q = [Math.PI / 2, 0.5], held = [0.1, 0.5, 0];   // slides along the room's y
  near(drag(scene, 1, q, held, TOP, [[0.7, 1.2, 0]]), [Math.PI / 2, 1.2]);
  near(drag(scene, 1, q, held, CORNER, [[0.1, 1.2, 0]]), [Math.PI / 2, 1.2]);
  near(drag(scene, 1, q, held, CLOSE, [[0.1, 1.2, 0]]), [Math.PI / 2, 1.2], 1e-4);
  near(drag(scene, 1, q, held, TOP, [[0.1, 9, 0]]), [Math.PI / 2, 2]);
});

test("a slide towards the viewer comes out as the hand goes up", () => {
  const scene = { motions: [slide(2, 0)], knobs: [length()], radius: 2 };
  near(drag(scene, 0, [0.5], [0, 0, 0], TOP, [[0.3, 0.4, 0]]), [0.9]);
});

// ---- several knobs ----

/** A hand on a handle, and then at a place of the room. */
function pulled(scene, handle, q, lens, to) {
  const all = frames(scene.motions, q), [frame, ...local] = handle.point;
  const hand = lens.see(inRoom(all[frame], local)).slice(0, 2);
  const pull = pullHandle(scene, handle, { all, q, hand, lens });
  return pull(lens.see(to).slice(0, 2), lens, q);
}
const tip = (q) => frames(ARM.motions, q)[4][3];

test("the tip of two links comes to the hand", () => {
  near(pulled(ARM, TIP, [0.3, 0.5], TOP, [1, 1, 0]), [0, Math.PI / 2]);
  near(tip(pulled(ARM, TIP, [0.3, 0.5], CORNER, [1.2, -0.4, 0])), [1.2, -0.4, 0]);
  near(tip(pulled(ARM, TIP, [0.3, 0.5], CLOSE, [1.2, -0.4, 0])), [1.2, -0.4, 0]);
});

test("out of reach the arm is stretched towards the hand", () => {
  near(pulled(ARM, TIP, [0.3, 0.5], TOP, onCircle(40, 3)), [40 * DEGREE, 0], 2e-3);
});

test("limits hold, and the other joint does what is left", () => {
  const scene = { ...ARM, knobs: [angle(-10, 10), angle(0, 90)] };
  near(pulled(scene, TIP, [0, 0.2], TOP, [1, 3, 0]), [10 * DEGREE, 79.692 * DEGREE], 2e-3);
});

test("an origin goes where the hand goes, and only the handle's knobs move", () => {
  const scene = { motions: [slide(0, 1), slide(1, 2), turn(0)], radius: 4,
                  knobs: [angle(), length(-2, 2), length(-2, 2)] };
  const origin = { name: "o", point: [3, 0, 0, 0], knobs: [1, 2], unit: "" };
  near(pulled(scene, origin, [0.7, 1, 1], TOP, [-0.5, 1.75, 0]), [0.7, -0.5, 1.75]);
  near(pulled(scene, origin, [0.7, 1, 1], TOP, [5, 1.75, 0]), [0.7, 2, 1.75]);
  const end = { name: "x", point: [3, 1, 0, 0], knobs: [0], unit: "" };
  near(pulled(scene, end, [0, 1, 1], TOP, [1, 5, 0]), [Math.PI / 2, 1, 1]);
});

test("three slides follow in the plane of the picture", () => {
  const scene = { motions: [slide(0, 0), slide(1, 1), slide(2, 2)], radius: 3,
                  knobs: [length(), length(), length()] };
  const handle = { name: "o", point: [3, 0, 0, 0], knobs: [0, 1, 2], unit: "" };
  const to = [1, 0.5, 0.2].map((v, k) => v + 0.3 * CORNER.right[k] - 0.2 * CORNER.up[k]);
  near(pulled(scene, handle, [1, 0.5, 0.2], CORNER, to), to);
});

test("an arm in space keeps its tip as near to the viewer as it was", () => {
  const bend = (joint) => ({ kind: "rotate", axis: 1, joint });
  const scene = { motions: [turn(0), bend(1), along(0, 1), bend(2), along(0, 1)], radius: 2,
                  knobs: [angle(), angle(), angle()] };
  const handle = { name: "tip", point: [5, 0, 0, 0], knobs: [0, 1, 2], unit: "" };
  const end = (q) => frames(scene.motions, q)[5][3], q = [0.4, -0.9, 1.1], from = end(q);
  const to = from.map((v, k) => v - 0.4 * CORNER.right[k] + 0.3 * CORNER.up[k]);
  near(end(pulled(scene, handle, q, CORNER, to)), to, 1e-5);
});

test("a knob that carries motions out one after the other follows through both", () => {
  const scene = { motions: [slide(0, 0, { gain: 2, start: 0 }), turn(0, { gain: 1, start: 1 })],
                  knobs: [length(0, 2)], radius: 3 };
  const end = { name: "x", point: [2, 1, 0, 0], knobs: [0], unit: "" };
  near(pulled(scene, end, [0.1], TOP, [2, 0, 0]), [0.5], 1e-4);
  near(pulled(scene, end, [1.1], TOP, [2 + Math.cos(0.5), Math.sin(0.5), 0]), [1.5], 1e-4);
});

test("speeds are those of small steps", () => {
  const chain = [turn(0), along(0, 1), slide(1, 1, { scrub: { knob: 2, start: 0 } })];
  const q = [0.3, 0.8, 0.4], end = (values) => frames(chain, values)[3][3], h = 1e-5;
  const found = speeds(chain, frames(chain, q), end(q), q, [0, 1, 2]);
  found.forEach((speed, k) => {
    const [b, a] = [h, -h].map((by) => end(q.map((v, i) => i === k ? v + by : v)));
    near(speed, b.map((v, i) => (v - a[i]) / (2 * h)), 1e-6);
  });
});

// ---- bodies ----

test("a body goes by its own joint", () => {
  const { motions } = ARM, body = (frame, about) => ({ points: [[frame, 0, 0, 0]], ...about });
  assert.equal(jointMotion(motions, body(1, { link: 1 })), 0);
  assert.equal(jointMotion(motions, body(4, { link: 2 })), 2);
  assert.equal(jointMotion(motions, body(3, { joint: 2, link: 2 })), 2);
  assert.equal(jointMotion(motions, body(2, { joint: 2, link: 1 })), 0);   // a sleeve on link 1
  assert.equal(jointMotion(motions, body(0, { joint: 1, link: 0 })), 0);   // one on the base
  assert.equal(jointMotion(motions, body(0, { link: 0 })), -1);
  assert.equal(jointMotion(motions, body(1, { link: 2 })), -1);
  const tracked = [turn(0, { track: [0, 1] })];
  assert.equal(jointMotion(tracked, body(1, { link: 1 })), -1);
});

test("a body is held on the side towards the viewer", () => {
  const all = frames([], []), tube = { points: [[0, 0, 0, 0], [0, 1, 0, 0]], size: [0.3, 0.3] };
  const { far, place } = touched(tube, all, [350, 200], TOP);
  near([far, ...place], [0, 0.5, 0, 0.3]);
  const beside = touched(tube, all, [350, 180], TOP);
  near([beside.far, ...beside.place], [20, 0.5, 0.2, Math.sqrt(0.05)]);
  near([touched(tube, all, [450, 200], TOP).far], [50]);
  for (const lens of [CORNER, CLOSE]) {
    near(lens.see(touched(tube, all, [330, 190], lens).place).slice(0, 2), [330, 190], 1e-6);
    near(lens.see(under([123, 45], [0.1, 0.2, 0.3], lens)).slice(0, 2), [123, 45]);
  }
});
