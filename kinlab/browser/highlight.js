// A view's parts light up together, and its entries flash when they change.

import { make, write } from "./dom.js";
import { Flashes } from "./flash.js";
import { frames } from "./frames.js";
import { lightUp, pointFrom, walkThrough } from "./hover.js";
import { Marks } from "./marks.js";
import { holdings, inWords, pictured } from "./pointing.js";

/** @import { Picture } from "./picture.js" */
/** @import { Pointing } from "./pointing.js" */
/** @import { Frame, Pointed, Scene } from "./types.js" */
/**
 * @typedef {object} Parts a view
 * @property {HTMLElement} element
 * @property {Scene} scene
 * @property {HTMLElement} box
 * @property {Picture} picture
 * @property {{ entries: Element[], read(frame: Frame): string[] } | null | undefined} pose
 * @property {{ entries: Element[], read(all: Frame[], q: number[]): string[] }} lines
 * @property {HTMLElement} formula
 * @property {{ light(now: Pointed | null): void } | null | undefined} timed
 * @property {(all: Frame[]) => Frame} posed
 * @property {() => void} redraw
 */

export class Highlight {
  flashes = new Flashes();

  caption = make("div", { class: "kl-pointed" });

  found = false;

  /**
   * Where the joints were when the picture was drawn last.
   * @type {number[] | null}
   */
  last = null;

  /**
   * @param {Parts} view
   * @param {Pointing} pointing
   */
  constructor(view, pointing) {
    this.view = view;
    this.pointing = pointing;
    this.marks = view.scene.timed ? null : new Marks(view.scene);   // the time is no joint
    view.box.append(this.caption);
  }

  /** Let hands point at parts of the view, and light them; gives what ends it. */
  begin() {
    const { view, pointing } = this;
    pointing.follow(view.scene);
    walkThrough(view.formula);
    view.box.addEventListener("keydown", ({ key }) => {
      if (key === "j" || key === "J") pointing.step(key === "j" ? 1 : -1);
    });
    const ends = [pointFrom(view.element, pointing), pointing.listen((now) => this.light(now))];
    return () => {
      pointing.clear();
      ends.forEach((end) => end());
    };
  }

  /** @param {Pointed | null} now */
  light(now) {
    const { view } = this;
    if (now) this.find();
    lightUp(view.element, now);
    view.picture.light(now && pictured(view.scene.items, now) ? now : null);
    view.timed?.light(now);
    view.redraw();
  }

  /** Note at each number the joints that move it, when somebody points for the first time. */
  find() {
    const { view } = this, { pose, lines, scene: { knobs, motions } } = view;
    if (this.found || view.timed) return;          // there the only knob is the time
    this.found = true;
    const at = (/** @type {number[]} */ q) => frames(motions, q);
    const tell = (/** @type {Element[]} */ entries, /** @type {number[][]} */ held) =>
      entries.forEach((entry, k) => entry.setAttribute("data-holds", held[k].join(" ")));
    if (pose) tell(pose.entries, holdings(knobs, (q) => pose.read(view.posed(at(q)))));
    tell(lines.entries, holdings(knobs, (q) => lines.read(at(q), q)));
  }

  /**
   * After each picture: what is pointed at goes along, and what has changed flashes, with what
   * holds the joints that have moved in the formula.
   * @param {Element[]} changed
   * @param {number[]} q
   */
  follow(changed, q) {
    const { last, view, pointing: { now } } = this;
    const moved = q.flatMap((value, i) => last && value !== last[i] ? [i + 1] : []);
    const held = moved.map((joint) => `[data-entry][data-holds~="${joint}"]`).join();
    this.last = q;
    this.marks?.draw(now, q, view.picture);
    write(this.caption, now ? inWords(now, view.scene, q) : "");
    this.flashes.flash([...changed, ...held ? view.formula.querySelectorAll(held) : []]);
  }
}
