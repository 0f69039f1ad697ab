// Entries that change flash once: not at every step of a drag, and not where the reader has asked
// the system for less motion.

import { wantsCalm } from "./player.js";

const REST = 500;                                   // ms without a change: the movement is over

export class Flashes {
  /** @type {Set<Element>} */
  done = new Set();

  timer = 0;

  /**
   * Flash these, if they have not yet since things began to move.
   * @param {Element[]} nodes
   */
  flash(nodes) {
    if (!nodes.length) return;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.done.clear(), REST);
    const calm = wantsCalm();
    for (const node of nodes) {
      if (this.done.has(node)) continue;
      this.done.add(node);
      if (calm) continue;
      node.classList.add("kl-flash");
      node.addEventListener("animationend", () => node.classList.remove("kl-flash"),
                            { once: true });
    }
  }
}
