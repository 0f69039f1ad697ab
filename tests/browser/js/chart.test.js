// A chart's layout: by numbers typed here, and against Python's (chart.json, by ../fixtures.py).
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import { plotted } from "../../../kinlab/browser/chart.js";

const charts = JSON.parse(readFileSync(new URL("chart.json", import.meta.url), "utf8"));
const HAND = { curves: [{ name: "a", style: "first", marker: "dot", values: [100, 1, 0.01] }],
               across: "step", up: "e", knob: 0, last: 2, low: -2, high: 2 };

/** That two data are the same, numbers to a millionth of a pixel. */
function alike(got, wanted, told) {
  if (typeof wanted === "number") {
    return assert.ok(Math.abs(got - wanted) < 1e-6, `${told}: ${got}, not ${wanted}`);
  }
  if (wanted == null || typeof wanted !== "object") return assert.equal(got, wanted, told);
  assert.deepEqual(Object.keys(got).sort(), Object.keys(wanted).sort(), told);
  for (const key of Object.keys(wanted)) alike(got[key], wanted[key], `${told}.${key}`);
}

for (const [name, { chart, plots }] of Object.entries(charts)) {
  test(`${name}: the same points, ticks and legend as Python's`, () => {
    for (const { size, q, plot } of plots) alike(plotted(chart, size, q), plot, `${size} ${q}`);
  });
}

test("a curve goes down by as much for each decade, as far as the knob says", () => {
  const { box, up, across, tracks: [{ gone, markers }] } = plotted(HAND, [264, 236], [1.5]);
  assert.deepEqual(box, [48, 34, 248, 194]);
  assert.deepEqual(up, [[34, "10²"], [74, "10¹"], [114, "10⁰"], [154, "10⁻¹"], [194, "10⁻²"]]);
  assert.deepEqual(across, [[48, "0"], [148, "1"], [248, "2"]]);
  assert.deepEqual(gone, [[48, 34], [148, 114], [198, 154]]);
  assert.deepEqual(markers, [[48, 34], [148, 114]]);
});

test("numbers of an axis keep apart, whatever the size", () => {
  for (const { chart, plots } of Object.values(charts)) {
    for (const { size, q } of plots) {
      const { up, across } = plotted(chart, size, q);
      across.slice(1).forEach(([x], k) => assert.ok(x - across[k][0] >= 34 - 1e-9));
      up.slice(1).forEach(([y], k) => assert.ok(y - up[k][0] >= 24 - 1e-9));
    }
  }
});
