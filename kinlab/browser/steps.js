// Where a knob's slider stops under a hand, in the slider's units.

/** @import { Knob, Stops } from "./types.js" */

/**
 * How many whole steps a key goes.
 * @type {Record<string, number>}
 */
export const KEYS = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1,
                      PageDown: -10, PageUp: 10, Home: -Infinity, End: Infinity };

/** @type {(value: number, low: number, high: number) => number} */
export const clip = (value, low, high) => Math.max(low, Math.min(high, value));

/**
 * Values with another one in one place.
 * @param {number[]} q
 * @param {number} i
 * @param {number} value
 */
export const replaced = (q, i, value) => q.map((old, k) => k === i ? value : old);

/**
 * Limits and step of a knob, in its slider's units.
 * @param {Pick<Knob, "low" | "high" | "scale" | "step">} knob
 * @returns {Stops}
 */
export const stopsOf = ({ low, high, scale, step }) =>
  ({ low: low / scale, high: high / scale, step });

/**
 * The nearest whole step; the limits need not be whole steps, and hold as well.
 * @param {number} value
 * @param {Stops} stops
 */
export function snap(value, { low, high, step }) {
  const whole = Number((Math.round(value / step) * step).toPrecision(12));
  return [low, high].find((end) => Math.abs(value - end) < step / 4) ?? clip(whole, low, high);
}

/**
 * So many whole steps on, or tenths of them if `fine`.
 * @param {number} value
 * @param {number} steps
 * @param {boolean} fine
 * @param {Stops} stops
 */
export function stepped(value, steps, fine, { low, high, step: whole }) {
  const step = fine ? whole / 10 : whole, towards = steps > 0 ? Math.floor : Math.ceil;
  const next = (towards(value / step + (steps > 0 ? 1e-6 : -1e-6)) + steps) * step;
  return clip(Number(next.toPrecision(12)), low, high);
}
