// A picture that follows its arm stands still while a hand holds something, or what is held would
// run away from the hand; then it goes smoothly to where it belongs.

import { smooth, wantsCalm } from "./player.js";
import { norm, minus } from "./vectors.js";

/** @import { Lens } from "./types.js" */

const HOMING = 350;                                 // ms

/**
 * A lens between two that look in the same direction.
 * @param {Lens} from
 * @param {Lens} to
 * @param {number} share
 * @returns {Lens}
 */
function betweenLenses(from, to, share) {
  const mix = (/** @type {number} */ a, /** @type {number} */ b) => a + share * (b - a);
  return { ...to, scale: mix(from.scale, to.scale), shrunk: mix(from.shrunk, to.shrunk),
           see: (point) => {
             const end = to.see(point);
             return from.see(point).map((e, k) => mix(e, end[k]));
           } };
}

/** The lens that a picture is seen through. */
export class Steady {
  /** @type {Lens | null} */
  kept = null;

  /** @type {number | null} */
  since = null;                                     // ms: when the hand let go

  /** @param {Lens} lens */
  hold(lens) {
    this.kept = lens;
    this.since = null;
  }

  release() {
    if (wantsCalm()) this.kept = null;
    this.since = performance.now();
  }

  /** Whether it is still on its way. */
  get moving() { return this.kept != null && this.since != null; }

  /**
   * @param {Lens} lens the one that belongs to the pose
   * @returns {Lens}
   */
  through(lens) {
    const { kept, since } = this;
    if (!kept) return lens;
    const share = since == null ? 0 : Math.min(1, (performance.now() - since) / HOMING);
    if (share === 1 || norm(minus(kept.near, lens.near)) > 1e-9) this.kept = null;
    return this.kept ? betweenLenses(kept, lens, smooth(share)) : lens;
  }
}
