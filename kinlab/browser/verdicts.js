// What is said to an answer, in the words of kinlab/answers/prediction.py.

import { LARGEST } from "./numbers.js";

/** @import { Asked, Told } from "./types.js" */

/**
 * A number with four digits and four decimals at most; halves go up, as in Python.
 * @param {number} value
 */
export const brief = (value) =>
  String(Number(Number((value * (1 + 1e-12)).toFixed(4)).toPrecision(4)) + 0).replace("-", "−");

/** @type {(unit: string) => string} */
const behind = (unit) => !unit || unit.startsWith("°") ? unit : ` ${unit}`;

/**
 * How much an answer is more than the right one; with a turn, the short way round.
 * @type {(answer: number, right: number, turn: number) => number}
 */
function beyond(answer, right, turn) {
  const off = answer - right;
  return turn ? off - turn * Math.floor(off / turn + 0.5) : off;
}

/** @type {(a: number[], b: number[]) => number} */
const gapOf = (a, b) => Math.hypot(...a.map((value, i) => value - b[i]));

/**
 * What is said to the nearest of the wrong answers, if it is near.
 * @type {(one: Asked, far: (wrong: any) => number) => string}
 */
function slipOf({ slips, tolerance }, far) {
  const [near] = slips.map(([wrong, said]) => ({ off: far(wrong), said }))
    .sort((a, b) => a.off - b.off);
  return near && near.off <= tolerance ? near.said : "";
}

/** @type {(...parts: string[]) => string} */
const joined = (...parts) => parts.filter(Boolean).join(" ");

/** @type {(text: string) => string} */
const stopped = (text) => /[.!?]$/.test(text) ? text : `${text}.`;

/**
 * The right answer in a sentence.
 * @type {Record<string, (one: Asked) => string>}
 */
const RIGHT = {
  choice: ({ right }) => `The answer: ${stopped(right)}`,
  several: ({ options, right }) => {
    const all = options.filter(([text]) => right.includes(text)).map(([text]) => `“${text}”`);
    return `The answer: ${all.join(", ") || "none of them"}.`;
  },
  number: ({ right, unit }) => `It is ${brief(right)}${behind(unit)}.`,
  signs: () => "The table shows the right ones.",
  mark: ({ axes, truth, unit }) => {
    const there = [...axes].map((axis) => brief(truth["xyz".indexOf(axis)]));
    return `It is at ${[...axes].join(", ")} = ${there.join(", ")}${behind(unit)}.`;
  },
  direction: () => "The picture shows it.",
};

/** @type {Record<string, (one: Asked, answer: any) => Told>} */
const SAID = {
  choice(one, answer) {
    const ok = answer === one.right;
    const said = one.options.find(([text]) => text === answer)?.[1] ?? "";
    return { ok, said: joined(ok ? "Right." : "Not so.", said, ok ? "" : RIGHT.choice(one)) };
  },
  several({ options, right }, answer) {
    const wrong = options.filter(([text]) => answer.includes(text) !== right.includes(text));
    const words = wrong.map(([text, said]) =>
      joined(`“${text}” ${answer.includes(text) ? "does not belong" : "is missing"}.`, said));
    return { ok: !wrong.length, said: joined(wrong.length ? "Not quite." : "Right.", ...words) };
  },
  number(one, answer) {
    const { right, tolerance, unit, turn } = one, off = beyond(answer, right, turn);
    if (Math.abs(off) <= tolerance) return { ok: true, said: `Right. ${RIGHT.number(one)}` };
    const size = `${brief(Math.abs(off))}${behind(unit)}`;
    const how = turn ? `${size} off` : `${size} too ${off > 0 ? "much" : "little"}`;
    const near = slipOf(one, (wrong) => Math.abs(beyond(answer, wrong, turn)));
    const said = `You said ${brief(answer)}${behind(unit)}, ${how}.`;
    return { ok: false, said: joined(said, near, RIGHT.number(one)) };
  },
  signs({ right }, answer) {
    const wanted = right.join(""), given = answer.join("");
    const wrong = [...wanted].filter((letter, k) => letter !== given[k]).length;
    if (!wrong) return { ok: true, said: "Right, in every entry." };
    return { ok: false, said: `${wanted.length - wrong} of ${wanted.length} entries are as you ` +
                              "said; the others are marked." };
  },
  mark(one, answer) {
    const { truth, tolerance, unit } = one, off = gapOf(answer, truth);
    const far = `Your mark is ${brief(off)}${behind(unit)} away.`;
    if (off <= tolerance) return { ok: true, said: `Right. ${far}` };
    const near = slipOf(one, (wrong) => gapOf(answer, wrong));
    return { ok: false, said: joined(far, near, RIGHT.mark(one)) };
  },
  direction(one, answer) {
    const { truth, tolerance } = one, off = Math.abs(beyond(answer, truth, 360));
    const far = `Your arrow is ${brief(off)}° off.`;
    if (off <= tolerance) return { ok: true, said: `Right. ${far}` };
    return { ok: false, said: joined(far, slipOf(one, (wrong) =>
      Math.abs(beyond(answer, wrong, 360)))) };
  },
};

/**
 * What there is to say to an answer; null is no guess.
 * @type {(one: Asked, answer: any) => Told}
 */
export const verdict = (one, answer) => answer == null
  ? { ok: false, said: `No guess. ${RIGHT[one.kind](one)}` } : SAID[one.kind](one, answer);

// ---- answers that were kept ----

/** @type {(value: any) => boolean} */
const isNumber = (value) => Number.isFinite(value) && Math.abs(value) <= LARGEST;

/** @type {(one: Asked, answer: any) => boolean} */
const isOption = ({ options }, answer) => options.some(([text]) => text === answer);

/** @type {Record<string, (one: Asked, answer: any) => boolean>} */
const FITS = {
  choice: isOption,
  several: (one, answer) => Array.isArray(answer) && answer.every((text) => isOption(one, text)),
  number: (_, answer) => isNumber(answer),
  signs: ({ right, among }, answer) => Array.isArray(answer) && answer.length === right.length &&
    answer.every((row, i) => typeof row === "string" && row.length === right[i].length &&
      [...row].every((sign) => among.some(([letter]) => letter === sign))),
  mark: (_, answer) => Array.isArray(answer) && answer.length === 3 && answer.every(isNumber),
  direction: (_, answer) => isNumber(answer),
};

/**
 * What can be read of a record that a notebook or a browser has kept: anybody may have changed it.
 * @param {Asked[]} cases
 * @param {any} record
 */
export function readable(cases, record) {
  const answered = new Map();
  for (const one of Array.isArray(record) ? record : []) {
    const at = one?.case, asked = Number.isInteger(at) ? cases[at] : undefined;
    const answer = one?.answer ?? null;
    const fits = asked && (answer == null || FITS[asked.kind](asked, answer));
    if (fits && !answered.has(at)) answered.set(at, { case: at, answer });
  }
  return [...answered.values()];
}

/** @type {Record<string, string>} */
const FROM = { x: "y", y: "z", z: "x" };             // whence turns about an axis are counted

/**
 * An answer in words, to be looked back at.
 * @type {(one: Asked, answer: any) => string}
 */
export function answerWords(one, answer) {
  if (one.kind === "number") return `${brief(answer)}${behind(one.unit)}`;
  if (one.kind === "direction") return `${brief(answer)}° from ${
    FROM[one.about]} about ${one.about}`;
  if (one.kind === "mark") return `(${answer.map(brief).join(", ")})${behind(one.unit)}`;
  return Array.isArray(answer) ? answer.join(", ") || "none" : answer;
}
