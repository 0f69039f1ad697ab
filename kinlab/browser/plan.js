// Where the parts of a view stand: the picture with its buttons, and what is beside it. The sliders
// stay in the page while one scene follows another, so the places around them do, too.

import { make } from "./dom.js";

/** @typedef {"head" | "stage" | "side" | "below"} Area */

export class Plan {
  /** @param {HTMLElement} sliders */
  constructor(sliders) {
    this.sliders = sliders;
    this.title = make("div", { class: "kl-title" });
    this.head = make("div", { class: "kl-head" }, this.title);
    this.stage = make("div", { class: "kl-stage" });
    this.side = make("div", { class: "kl-side" }, sliders);
    this.below = make("div", { class: "kl-below" });
    this.node = make("div", { class: "kl-plan" }, this.head, this.stage, this.side, this.below);
  }

  /**
   * Put parts into an area, behind what is there.
   * @param {Area} area
   * @param {(Node | null | undefined)[]} parts
   */
  put(area, ...parts) { this[area].append(...parts.filter((part) => part != null)); }

  /** Take all parts out but the sliders, and what a page has put into the head. */
  clear() {
    for (const part of [...this.stage.children, ...this.side.children, ...this.below.children]) {
      if (part !== this.sliders) part.remove();
    }
  }
}
