// Curves over time: by numbers typed here, and against Python's (timed.json, by ../fixtures.py).
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import { laidOut, placeIn, placesOf } from "../../../kinlab/browser/timed.js";

const told = JSON.parse(readFileSync(new URL("timed.json", import.meta.url), "utf8"));
const HAND = { title: "angles", layer: "", low: -10, high: 30,
               courses: [{ name: "a", style: "first", values: [0, 10, 20], unit: "", joint: 1 }],
               bounds: [{ level: 15, style: "first", joint: 1 }],
               bands: [{ start: 0.75, end: 1, joint: 1 }] };

/** That two data are the same, numbers to a millionth of a pixel. */
function alike(got, wanted, what) {
  if (typeof wanted === "number") {
    return assert.ok(Math.abs(got - wanted) < 1e-6, `${what}: ${got}, not ${wanted}`);
  }
  if (wanted == null || typeof wanted !== "object") return assert.equal(got, wanted, what);
  assert.deepEqual(Object.keys(got).sort(), Object.keys(wanted).sort(), what);
  for (const key of Object.keys(wanted)) alike(got[key], wanted[key], `${what}.${key}`);
}

for (const { panel, plots } of told.panels) {
  test(`${panel.title}: the same points, ticks and bands as Python's`, () => {
    for (const { size, time, plot } of plots) {
      alike(laidOut(panel, told.times, size, time), plot, `${size} ${time}`);
    }
  });
}

test("a panel by hand: 200 px for 1 s, 80 px for 40 degrees", () => {
  const plot = laidOut(HAND, [0, 0.5, 1], [266, 128], 0.75);
  assert.deepEqual(plot.box, [54, 26, 254, 106]);
  assert.deepEqual(plot.whole, [[[54, 86], [154, 66], [254, 46]]]);
  assert.deepEqual(plot.gone, [[[54, 86], [154, 66], [204, 56]]]);
  assert.deepEqual(plot.bounds, [56]);
  assert.deepEqual(plot.bands, [[204, 254]]);
  assert.deepEqual(plot.signs, [[229, 35]]);
  assert.deepEqual([plot.zero, plot.now], [86, 204]);
  assert.deepEqual(plot.up, [[86, "0"], [46, "20"]]);
  assert.deepEqual(plot.across, [[54, "0.0 s"], [154, "0.5"], [254, "1.0"]]);
});

test("a place among samples that are not evenly apart", () => {
  const times = [0, 0.1, 0.4, 2];
  assert.deepEqual([-1, 0, 0.05, 0.1, 0.25, 1.2, 2, 9].map((t) => placeIn(times, t)),
                   [0, 0, 0.5, 1, 1.5, 2.5, 3, 3]);
  assert.ok(Math.abs(placeIn(times, 0.16) - 1.2) < 1e-9);
  assert.deepEqual(placesOf({ timed: { times } }, [0.25, 7]), [1.5, 7]);
  assert.deepEqual(placesOf({}, [0.25, 7]), [0.25, 7]);
});
