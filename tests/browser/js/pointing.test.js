import assert from "node:assert/strict";
import { test } from "node:test";

import { branch } from "../../../kinlab/browser/frames.js";
import { arcFigure, slideFigure } from "../../../kinlab/browser/marks.js";
import { Pointing, belonging, holdings, inWords, moversOf, pictured, ties }
  from "../../../kinlab/browser/pointing.js";
import { readTerm } from "../../../kinlab/browser/terms.js";

const turn = (joint, parent) => ({ kind: "rotate", axis: 2, joint, parent });
const slide = (amount, joint) => ({ kind: "translate", axis: 0, amount, joint });
const axisOf = (frame, at) => ({ gid: `frame-${frame}-x`, frame, points: [[at, 0, 0, 0]] });
const knob = (label, low, high, more = {}) => ({ label, low, high, title: "", scale: 1, digits: 1,
                                                 suffix: "", ...more });

/** Two links in the plane, and beside them a branch that turns by both angles. */
const PLANAR = {
  motions: [turn(0), slide(1), turn(1), slide(1), turn(0, 0), turn(1)],
  items: [axisOf("0", 0), axisOf("1", 2), axisOf("2", 4),
          { gid: "link", joint: 2, link: 2, points: [[2, 0, 0, 0]] }],
  knobs: [knob("θ₁", -3, 3), knob("θ₂", -3, 3)],
};

const sets = ({ joints, frames, links }) => [[...joints], [...frames], [...links]];

test("a branch leads from a frame back to the room", () => {
  assert.deepEqual(branch(PLANAR.motions, 4), [4, 3, 2, 1]);
  assert.deepEqual(branch(PLANAR.motions, 6), [6, 5]);
  assert.deepEqual(branch(PLANAR.motions, 0), []);
});

test("a joint leads from one named frame to the next", () => {
  assert.deepEqual(ties(PLANAR), [{ before: "0", after: "1" }, { before: "1", after: "2" }]);
});

test("three knobs may carry one frame, and a knob none", () => {
  const scene = { motions: [slide(0, 0), turn(1), slide(0, 2)], items: [axisOf("1", 3)],
                  knobs: [knob("x", 0, 1), knob("θ", 0, 1), knob("y", 0, 1), knob("t", 0, 1)] };
  assert.deepEqual(ties(scene).map(({ after }) => after), ["1", "1", "1", null]);
  assert.deepEqual(ties(scene).map(({ before }) => before), [null, null, null, null]);
});

test("all that belongs to a joint, to a frame, to the base", () => {
  const all = ties(PLANAR);
  assert.deepEqual(sets(belonging({ joints: [2] }, all)), [[2], ["1", "2"], [2]]);
  assert.deepEqual(sets(belonging({ frames: ["2"] }, all)), [[2], ["2"], [2]]);
  assert.deepEqual(sets(belonging({ frames: ["0"] }, all)), [[], ["0"], []]);
  assert.deepEqual(sets(belonging({ links: [1] }, all)), [[1], ["0", "1"], [1]]);
  assert.deepEqual(sets(belonging({ links: [0] }, all)), [[], [], [0]]);
});

test("nothing steps back in a picture that has nothing of what is pointed at", () => {
  const all = ties(PLANAR);
  assert.equal(pictured(PLANAR.items, belonging({ joints: [2] }, all)), true);
  assert.equal(pictured([{ gid: "dot", points: [[0, 0, 0, 0]] }],
                        belonging({ joints: [2] }, all)), false);
});

function heard() {
  const bus = new Pointing(), told = [];
  bus.follow(PLANAR);
  bus.listen((now) => told.push(now && [...now.joints].join()));
  return { bus, told };
}

test("everyone hears once of what is pointed at", () => {
  const { bus, told } = heard();
  bus.point({ joints: [2] });
  bus.point({ joints: [2] });
  bus.point({ links: [2] });                        // the same things light up
  bus.point(null);
  bus.point(null);
  assert.deepEqual(told, ["2", null]);
});

test("a hand counts before a tap, and a tap before the keyboard", () => {
  const { bus, told } = heard();
  bus.point({ joints: [1] }, "focus");
  bus.point({ joints: [2] }, "tap");
  bus.point({ joints: [1, 2] }, "hover");
  bus.point(null, "hover");
  bus.point(null, "tap");
  bus.point(null, "focus");
  assert.deepEqual(told, ["1", "2", "1,2", "2", "1", null]);
});

test("Escape ends all of it, and a listener may leave", () => {
  const { bus, told } = heard();
  bus.point({ joints: [1] }, "tap");
  bus.point({ joints: [2] }, "hover");
  bus.clear();
  assert.deepEqual(told, ["1", "2", null]);
  const leave = bus.listen(() => assert.fail());
  leave();
  bus.point({ joints: [1] });
});

test("a key steps from joint to joint and out again", () => {
  const { bus, told } = heard();
  for (const way of [1, 1, 1, 1, -1, -1]) bus.step(way);
  assert.deepEqual(told, ["1", "2", null, "1", null, "2"]);
});

test("another scene has other joints, and nothing is pointed at", () => {
  const { bus, told } = heard();
  bus.point({ joints: [2] }, "tap");
  bus.follow({ motions: [turn(0)], items: [axisOf("1", 1)], knobs: [knob("θ", 0, 1)] });
  assert.deepEqual(told, ["2", null]);
  bus.point({ joints: [1] });
  assert.deepEqual([...bus.now.frames], ["1"]);
});

test("numbers know the joints that move them", () => {
  const read = ([a, b]) => [Math.cos(a).toFixed(3), (a + b).toFixed(3), "0",
                            (Math.cos(a + b) + b).toFixed(1)];
  assert.deepEqual(holdings(PLANAR.knobs, read), [[1], [1, 2], [], [1, 2]]);
});

test("what is pointed at is said in words", () => {
  const knobs = [knob("θ₁", -3, 3, { title: "shoulder", scale: Math.PI / 180, suffix: "°" }),
                 knob("d₂", 0, 1, { suffix: " m", digits: 2 })];
  const items = [{ frame: "c", part: "label" }, { frame: "c", part: "point" },
                 { frame: "E", part: "frame" }];
  const say = (spot) => inWords(belonging(spot, []), { knobs, items },
                                 [-Math.PI / 6, 0.4]);
  assert.equal(say({ joints: [1, 2] }), "shoulder: θ₁ = −30.0°; d₂ = 0.40 m");
  assert.equal(say({ frames: ["E"] }), "frame E");
  assert.equal(say({ frames: ["c"] }), "point c");
  assert.equal(say({ links: [0] }), "the base");
  assert.equal(say({ joints: [7] }), "");
});

test("terms of a text name joints, frames and links", () => {
  assert.deepEqual(readTerm("#kl:joints=2,3"), { joints: [2, 3] });
  assert.deepEqual(readTerm("#kl:joint=2&frame=1"), { joints: [2], frames: ["1"] });
  assert.deepEqual(readTerm("https://here/page.html#kl:frames=3,E"), { frames: ["3", "E"] });
  assert.deepEqual(readTerm("#kl:joints=4%2C5&links=0"), { joints: [4, 5], links: [0] });
  for (const none of ["#kl:", "#kl:joints=two", "#kl:colour=red", "#summary", "#kl:joints="]) {
    assert.equal(readTerm(none), null, none);
  }
});

// ---- marks: seen from above, a pixel for a unit, y down ----

const above = ([x, y]) => [x, -y, 1];
const ROOM = [[1, 0, 0], [0, 1, 0], [0, 0, 1], [5, 1, 0]];
const close = (seen, wanted) => {
  assert.equal(seen.length, wanted.length);
  seen.forEach((value, k) => assert.ok(Math.abs(value - wanted[k]) < 1e-9, `${seen}: ${wanted}`));
};

test("an arc leads from the axis before a turn to where it is after", () => {
  const { way, thin, heads, name } = arcFigure(ROOM, 2, Math.PI / 2, 40, above);
  close(way[0].slice(0, 2), [45, -1]);              // on x
  close(way.at(-1).slice(0, 2), [5, -41]);          // on y
  for (const [x, y] of way) assert.ok(Math.abs(Math.hypot(x - 5, y + 1) - 40) < 1e-9);
  close(thin[0].flatMap((p) => p.slice(0, 2)), [5, -1, 51, -1]);
  close(thin[1].flatMap((p) => p.slice(0, 2)), [5, -1, 5, -47]);
  close(name.slice(0, 2), [5 + 52 * Math.SQRT1_2, -1 - 52 * Math.SQRT1_2]);
  assert.equal(heads.length, 1);
  close(heads[0][0].slice(0, 2), way.at(-1).slice(0, 2));
});

test("a turn about x is measured from y, and one the other way round goes back", () => {
  const side = ([, y, z]) => [y, -z, 1];
  const { way } = arcFigure(ROOM, 0, -Math.PI / 2, 10, side);
  close(way[0].slice(0, 2), [11, -0]);
  close(way.at(-1).slice(0, 2), [1, 10]);           // towards -z: down
});

test("a joint that has not turned has no arc", () => {
  const { way, heads } = arcFigure(ROOM, 2, 0, 40, above);
  assert.equal(heads.length, 0);
  close(way[0].slice(0, 2), way.at(-1).slice(0, 2));
});

test("a slide is measured beside itself", () => {
  const { way, thin, heads, name } = slideFigure([0, 0, 0], [100, 0, 0], above);
  close(way.flat(), [0, -20, 100, -20]);
  close(thin[0].flatMap((p) => p.slice(0, 2)), [0, 0, 0, -24]);
  close(name, [50, -35]);
  close(heads.map(([tip]) => tip).flat(), [0, -20, 100, -20]);
});

test("a slide that is seen end on has a name and no arrow heads", () => {
  const { way, heads, name } = slideFigure([3, 0, 0], [3, 0, 50], above);
  assert.ok([...way.flat(), ...name].every(Number.isFinite));
  assert.equal(heads.length, 0);
});

test("arrows and points that say nothing are moved by the joints before them", () => {
  const at = (frame, ...place) => [frame, ...place];
  const items = [
    { gid: "arrow", shape: "arrow", points: [at(0, 0, 0, 0), at(2, 1, 0, 0)] },
    { gid: "axis-point", shape: "line", points: [at(1, 0, 0, 0)] },
    { gid: "far", shape: "line", part: "point", frame: "P", points: [at(2, 0, 0, 0)] },
    { gid: "far-name", shape: "text", part: "label", frame: "P", points: [at(2, 0, 0, 0)] },
    { gid: "link", shape: "tube", link: 1, points: [at(1, 1, 0, 0)] },
    { gid: "x-1", shape: "arrow", part: "frame", frame: "1", points: [at(1, 1, 0, 0)] },
    { gid: "trace", shape: "trace", layer: "trace", points: [at(2, 0, 0, 0)] },
  ];
  const found = moversOf({ items, motions: [turn(0), slide(0, 1)], radius: 3,
                           knobs: [knob("θ₁", -1, 1), knob("d₂", 1, 2)] });
  assert.deepEqual([...found], [["arrow", [1, 2]], ["axis-point", []], ["far", [1, 2]],
                                ["far-name", [1, 2]]]);
});
