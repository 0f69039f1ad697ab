// Labels: by numbers typed here, and against Python's (labels.json, written by ../fixtures.py).
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import { place, textSize } from "../../../kinlab/browser/labels.js";

const { texts, crowds } = JSON.parse(readFileSync(new URL("labels.json", import.meta.url), "utf8"));
const SIZE = [580, 520];
const near = (got, wanted, told, far = 1e-5) => assert.ok(Math.abs(got - wanted) < far,
  `${told}: ${got}, not ${wanted}`);
const arrow = (from, anchor, state) => ({ from, anchor, w: 17, h: 14, state });
const words = (anchor, w = 60) => ({ from: null, anchor, w, h: 14 });
const bars = (list) => list.map(([a, b, radius]) => ({ a, b, radius }));

/** How deep one label lies in another, if not below 0. */
const overlap = (a, b, p, q) => Math.min((a.w + b.w) / 2 - Math.abs(p.x - q.x),
  (a.h + b.h) / 2 - Math.abs(p.y - q.y));

test("widths of words are Python's", () => {
  for (const [text, ...size] of texts) {
    textSize(text).forEach((e, k) => near(e, size[k], text, 1e-9));
  }
});

for (const [name, { size, pictures }] of Object.entries(crowds)) {
  test(`${name}: labels stand where Python puts them`, () => {
    let states = [];
    for (const { labels, crowd, fixed, restless, places } of pictures) {
      const asked = labels.map(([anchor, from, w, h], k) =>
        ({ anchor, from, w, h, state: states[k] }));
      const got = place(asked, ...crowd.map(bars), fixed, size);
      assert.equal(got.restless, restless);
      got.places.forEach((one, k) => {
        if (!places[k]) return assert.equal(one, null);
        const [x, y, spot, leader] = places[k];
        near(one.x, x, `label ${k}`);
        near(one.y, y, `label ${k}`);
        assert.equal(one.state.spot, spot);
        assert.equal(one.leader == null, leader == null);
        leader?.flat().forEach((e, i) => near(one.leader.flat()[i], e, `leader ${k}`));
      });
      states = got.places.map((one) => one?.state);
    }
  });
}

test("a label stands beside its arrowhead, words at their own place", () => {
  const { places: [right, up, towards, word] } = place([arrow([100, 100], [150, 100]),
    arrow([300, 150], [300, 100]), arrow([100, 300], [100, 300]), words([400, 400])],
    [], [], [], SIZE);
  near(right.x, 150 + 8.5 + 3, "to the right");
  near(right.y, 104, "and a little aside");
  near(up.x, 304, "aside of one that points up");
  near(up.y, 100 - 7 - 3, "over it");
  assert.deepEqual([towards.x, towards.y], [110, 291]);   // seen end-on
  assert.deepEqual([word.x, word.y], [400, 400]);
  assert.ok([right, up, towards, word].every(({ leader }) => leader == null));
});

test("what asks for one place stands side by side, inside the picture", () => {
  const labels = Array.from({ length: 6 }, () => words([300, 200]));
  const { places } = place(labels, [], [], [[300, 200, 50, 20]], SIZE);
  places.forEach((one, i) => {
    assert.ok(overlap(labels[i], { w: 50, h: 20 }, one, { x: 300, y: 200 }) <= 2);
    places.slice(i + 1).forEach((other) =>
      assert.ok(overlap(labels[i], labels[0], one, other) <= 2));
  });
  const { places: [corner, none] } = place([words([0, 0]), words([-1, 50])], [], [], [], SIZE);
  assert.deepEqual([corner.x, corner.y], [32, 9]);
  assert.equal(none, null);                               // its anchor is not on the picture
});

test("labels keep off strokes and solids", () => {
  const label = [words([300, 200], 20)];
  const [stroke, solid] = [{ a: [200, 203], b: [400, 203] }, { a: [300, 210], b: [300, 210],
    radius: 15 }];
  const { places: [over] } = place(label, [stroke], [], [], SIZE);
  assert.ok(over.y < 197.5 && over.x === 300, `${over.y}`);
  const { places: [off] } = place(label, [], [solid], [], SIZE);
  assert.ok(off.y < 194 && Math.abs(off.x - 300) < 1e-9, `${off.y}`);
});

test("the leader ends at the words' rim and starts beside the anchor", () => {
  const state = { x: 0, y: -40, spot: 0, age: 200, anchor: [300, 200] };
  const { places: [{ leader }] } = place([{ ...words([300, 200]), state }], [], [], [], SIZE);
  assert.deepEqual(leader, [[300, 198], [300, 167]]);     // 40 px up, 7 of them the words
  const { places: [close] } = place([{ ...words([300, 200]), state: { ...state, y: -15 } }],
    [], [], [], SIZE);
  assert.equal(close.leader, null);
});

test("a label that is left behind follows by 2 px a step, and comes to rest", () => {
  let { places: [one] } = place([arrow([100, 100], [150, 100])], [], [], [], SIZE), restless = true;
  const [from, anchor] = [[100, 100], [100, 150]];
  for (let k = 0; k < 60 && restless; k++) {
    const was = one.state;
    ({ places: [one], restless } = place([arrow(from, anchor, was)], [], [], [], SIZE));
    assert.ok(Math.hypot(one.state.x - was.x, one.state.y - was.y) < 6 + 1e-9);
  }
  assert.equal(restless, false);
  near(one.x, 96, "beside the arrow that points down", 0.5);
  near(one.y, 160, "below it", 0.5);
});

test("a label comes back when its usual spot is free", () => {
  let state = { x: 0, y: 45, spot: 19, age: 5, anchor: [300, 200] }, restless = true, one;
  for (let k = 0; k < 90 && restless; k++) {
    ({ places: [one], restless } = place([{ ...words([300, 200]), state }], [], [], [], SIZE));
    ({ state } = one);
  }
  assert.equal(state.spot, 0);
  near(one.y, 200, "at its anchor", 0.5);
});

test("nothing is changed but what is given back", () => {
  const [{ labels, crowd, fixed }] = crowds.wrist.pictures;
  const asked = labels.map(([anchor, from, w, h]) => Object.freeze({ anchor, from, w, h }));
  const once = place(asked, ...crowd.map(bars), fixed, [390, 380]);
  assert.deepEqual(place(asked, ...crowd.map(bars), fixed, [390, 380]), once);
});
