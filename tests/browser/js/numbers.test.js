// What is typed into a field; numbers.json holds what Python reads in a cell, see ../fixtures.py.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import { read } from "../../../kinlab/browser/numbers.js";

const cells = JSON.parse(readFileSync(new URL("numbers.json", import.meta.url), "utf8"));
const FIELDS = { deg: { angle: true, unit: "°" }, rad: { angle: true, unit: "rad" },
                 length: { angle: false, unit: "m" } };

const near = (got, wanted) => Math.abs(got - wanted) <= 1e-12 * Math.abs(wanted);

test("a field reads what a cell of the table reads, and refuses what it refuses", () => {
  assert.ok(cells.length > 150);
  for (const { text, ...wanted } of cells) {
    for (const [name, field] of Object.entries(FIELDS)) {
      const { value, reason } = read(text, field), told = `${JSON.stringify(text)} in ${name}`;
      if (wanted[name] == null) {
        assert.equal(value, undefined, told);
        assert.match(reason, /^'.*; [^\n]+$/s, told);
      } else {
        assert.equal(reason, undefined, told);
        assert.ok(near(value, wanted[name]), `${told}: ${value}, not ${wanted[name]}`);
      }
    }
  }
});

test("where pi or a unit stands, a field in degrees hears of an angle", () => {
  const good = { "pi/2": 90, "π/6": 30, "30": 30, "30 deg": 30, "30°": 30, "-pi": -180,
                 "1 rad": 57.2957795130823, "45 deg + pi/4 rad": 90, "2*45": 90, "0.1": 0.1,
                 "179.9°": 179.9, "-0": 0 };
  for (const [text, value] of Object.entries(good)) {
    assert.deepEqual(read(text, FIELDS.deg), { value }, text);
  }
});

test("a decimal comma is read where it can mean nothing else", () => {
  const good = { "45,5": 45.5, "-0,125": -0.125, "1234,567": 1234.567, "2*1,5": 3, "1,5e2": 150,
                 "1,25": 1.25, "0,5 + 0,25": 0.75 };
  for (const [text, value] of Object.entries(good)) {
    assert.deepEqual(read(text, FIELDS.length), { value }, text);
  }
  const bad = { "1,000": "1,000 may be 1.000 or 1000", "12,345": "may be 12.345 or 12345",
                "1,2,3": "write the decimal point as .", "1.000,5": "write the decimal point as .",
                "1,000.5": "write the decimal point as .", ",5": "write the decimal point as .",
                "5,": "write the decimal point as .", "1, 5": "write the decimal point as .",
                "(1,5": "bracket", "1,5 2,5": "operator" };
  for (const [text, words] of Object.entries(bad)) {
    const { value, reason } = read(text, FIELDS.length);
    assert.equal(value, undefined, text);
    assert.ok(reason.includes(words), `${text}: ${reason}`);
  }
});

test("a reason is one sentence that shows what was typed", () => {
  assert.equal(read("2pi", FIELDS.deg).reason,
    "'2pi': expected a number such as -90 deg or pi/2; put an operator before pi");
  assert.equal(read("90 deg", FIELDS.length).reason,
    "'90 deg': expected a number such as 177.8 or 3/4; " +
    "no angle belongs here, leave out deg and rad");
  assert.equal(read("", FIELDS.length).reason,
    "'': expected a number such as 177.8 or 3/4; the field is empty");
  assert.ok(read("1".repeat(1e6), FIELDS.length).reason.length < 200);
});

test("whatever is typed, a number or a reason comes back", () => {
  const pieces = ["1", "90", ".5", "1e3", "1e308", "1e-320", "pi", "π", "deg", "°", " rad", "+",
                  "-", "*", "/", "**", "^", "(", ")", "sqrt(", "sin(", "cos", ",", ".", "_", "0x",
                  "[", "'", "\\", "\n", "\0", "\ud800", "²", "−", "constructor", "__proto__", "🦾",
                  "9**9**9", "((((", "----", "e", "E5", "NaN", "Infinity", ";", "${1}",
                  "toString", " "];
  let seed = 1, numbers = 0;
  const random = (n) => {
    seed = (seed * 48271) % 2147483647;
    return seed % n;
  };
  for (let turn = 0; turn < 6000; turn++) {
    const length = 1 + random(turn % 7 ? 5 : 40);
    const piece = () => turn % 3 ? pieces[random(pieces.length)]
      : String.fromCharCode(random(turn % 2 ? 128 : 65536));
    const text = Array.from({ length }, piece).join("");
    for (const field of Object.values(FIELDS)) {
      const { value, reason } = read(text, field);
      if (reason == null) {
        assert.ok(Number.isFinite(value), JSON.stringify(text));
        numbers += 1;
      } else assert.ok(value === undefined && reason.length < 300, JSON.stringify(text));
    }
  }
  assert.ok(numbers > 150, `${numbers} numbers`);
});
