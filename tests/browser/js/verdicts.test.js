// What is taken of a record of answers that anybody may have changed.
import assert from "node:assert/strict";
import { test } from "node:test";

import { readable } from "../../../kinlab/browser/verdicts.js";

const options = [["left", ""], ["right", ""]];
const CASES = [
  { kind: "choice", options, right: "left" },
  { kind: "several", options, right: ["left"] },
  { kind: "number" },
  { kind: "signs", right: ["+-", "00"], among: [["+", "more"], ["-", "less"], ["0", "zero"]] },
  { kind: "mark" },
  { kind: "direction" },
];
const GOOD = ["right", ["left", "right"], 0.5, ["++", "-0"], [1, 2, 3], -90];
const WILD = [NaN, 1e300, "<img src=x onerror=alert(1)>", "__proto__", {}, [], true, [[]],
              { length: 3 }, ["+", "-"], ["++", "++", "++"], ["+x", "00"], [1, 2], [1, 2, "3"],
              [1, 2, 3, 4], [{}], () => 1, { then: 1 }, "x".repeat(1e6), Array(1e5).fill(0)];

test("every kind of answer is read back", () => {
  const record = GOOD.map((answer, k) => ({ case: k, answer }));
  assert.deepEqual(readable(CASES, record), record);
  const none = CASES.map((_, k) => ({ case: k, answer: null }));
  assert.deepEqual(readable(CASES, none), none);
});

test("of an answer given twice the first counts", () => {
  assert.deepEqual(readable(CASES, [{ case: 2, answer: 1 }, { case: 2, answer: 2 }]),
                   [{ case: 2, answer: 1 }]);
});

test("what is no answer of its kind is left out", () => {
  CASES.forEach((_, k) => WILD.forEach((answer) => {
    if (k === 1 && answer.length === 0) return;     // none of the options is an answer, too
    assert.deepEqual(readable(CASES, [{ case: k, answer }]), [], `${k}: ${typeof answer}`);
  }));
});

test("what is no record at all is an empty one", () => {
  const places = ["length", "constructor", "at", -1, 0.5, 6, "0", null, {}, [0]];
  for (const record of [undefined, null, 0, "x", {}, { length: 1 }, [null], [1], ["__proto__"],
                        [[]], ...places.map((at) => [{ case: at, answer: null }])]) {
    assert.deepEqual(readable(CASES, record), []);
  }
});
