// The buttons under a picture: how to move, where to look from, what to show. On a phone all but
// those that move stand behind one more button.

import { button, group, lowered, make } from "./dom.js";
import { menu, picker } from "./menu.js";
import { rove } from "./roving.js";

/** @import { Item, Scene } from "./types.js" */

/**
 * What the buttons do.
 * @typedef {object} Acts
 * @property {(q: (number | null)[]) => void} go a knob at null stays where it is
 * @property {() => void} play
 * @property {(by: number) => void} step
 * @property {(stage: number) => void} stage
 * @property {(preset: string) => void} look
 * @property {(frame: number, direction: number[]) => void} along
 * @property {(layer: string, on: boolean) => void} show
 * @property {(frame: string, on: boolean) => void} showFrame
 * @property {() => void} clear
 * @property {(on: boolean) => void} perspective
 * @property {() => void} fill
 */

/** @type {(name: string) => string} */
const capital = (name) => name[0].toUpperCase() + name.slice(1);

/**
 * The names of all frames that a picture holds.
 * @param {Item[]} items
 */
export const frameNames = (items) =>
  [...new Set(items.flatMap(({ part, frame }) => part === "frame" && frame || []))];

/**
 * The x and z axes of the frames, by their names: "x₁" is [frame's number, direction there].
 * @param {Item[]} items
 * @returns {Map<string, [frame: number, direction: number[]]>}
 */
export function sightlines(items) {
  const found = new Map();
  for (const { part, frame, points } of items) {
    if (!frame || part !== "frame" || points.length !== 2) continue;
    const [[k, ...tail], [head, ...tip]] = points, way = tip.map((v, i) => v - tail[i]);
    const letter = ["x", "y", "z"].find((_, i) => way[i] > 0 && way.every((v, j) => i === j || !v));
    if (k === head && letter && letter !== "y") found.set(`${letter}${lowered(frame)}`, [k, way]);
  }
  return found;
}

/**
 * A mark and a word; where there is little room the mark alone is seen.
 * @type {(icon: string, words: string, before?: boolean) => Node[]}
 */
const withIcon = (icon, words, before = true) => {
  const parts = [make("span", { class: "kl-icon", "aria-hidden": "true" }, icon),
                 make("span", { class: "kl-word" }, words)];
  return before ? parts : parts.reverse();
};

export class Bar {
  /**
   * @param {Scene} scene
   * @param {Acts} acts
   * @param {boolean} steps whether there is something to play
   */
  constructor(scene, acts, steps) {
    this.scene = scene;
    this.acts = acts;
    this.more = make("div", { class: "kl-more" }, ...this.screens(), ...this.views(),
                     ...this.shows());
    const [opener] = menu("More", "More buttons", this.more,
                          { class: "kl-button kl-opener" }, true);
    this.node = make("div", { class: "kl-toolbar", role: "toolbar", "aria-label": "View" },
                     this.moves(steps), ...this.stages(), opener, this.more);
    rove(this.node);
  }

  // ---- groups ----

  /** @param {boolean} steps */
  moves(steps) {
    const { scene, acts } = this;
    const parts = [button("Home", "Move to where it began", () => acts.go(scene.home))];
    const { zero, poses } = scene;
    if (zero && poses.length) {
      parts.push(button("Zero", "Set every joint to zero", () => acts.go(zero)));
    }
    if (steps) parts.push(this.step(-1), this.player(), this.step(1));
    return group("Move", ...parts);
  }

  /** @param {1 | -1} by */
  step(by) {
    const [icon, words] = by < 0 ? ["‹", "Back"] : ["›", "Step"];
    const title = by < 0 ? "Step back" : "Step forward";
    const node = button("", title, () => this.acts.step(by), { "aria-label": title });
    node.append(...withIcon(icon, words, by < 0));
    return node;
  }

  player() {
    const title = this.scene.timed ? "Play at its own speed" : "Move smoothly from pose to pose";
    const node = button("", title, () => this.acts.play(),
                        { "data-part": "play" });
    node.append(...withIcon("▶", "Play"));
    return node;
  }

  /** A button for each stage that has a name. */
  stages() {
    const knob = this.scene.knobs.find(({ names }) => names);
    if (!knob) return [];
    return [group(knob.title, ...knob.names?.map((name, k) => button(name,
      `${knob.label} ${k}: ${name}`, () => this.acts.stage(k), { "data-stage": k })) ?? [])];
  }

  views() {
    const names = Object.keys(this.scene.presets), axes = sightlines(this.scene.items);
    if (names.length < 2) return [];
    const buttons = names.map((name) =>
      button(capital(name), `View: ${name}`, () => this.acts.look(name)));
    const letters = ["z", "x"].map((letter) => ({ label: `${letter} axes`,
      options: [...axes.keys()].filter((name) => name.startsWith(letter)) }));
    const along = (/** @type {string} */ name) =>
      this.acts.along(.../** @type {[number, number[]]} */ (axes.get(name)));
    const list = picker("Along …", "Look along an axis, which then points at you", letters, along);
    const sights = this.scene.sights?.map((name) => button(`Along ${name}`,
      `Look along ${name}, which then points at you`, () => along(name))) ?? [];
    return [group("View", ...buttons, ...sights, ...(axes.size ? [list] : []),
                  this.perspective())];
  }

  perspective() {
    const node = button("Perspective", "Draw what is far away smaller", () => {
      const on = node.getAttribute("aria-pressed") !== "true";
      node.setAttribute("aria-pressed", String(on));
      this.acts.perspective(on);
    }, { "aria-pressed": "false" });
    return node;
  }

  shows() {
    const { scene, acts } = this;
    const parts = scene.layers.flatMap(({ layer, label, title }) => {
      const node = button(label, title, () => acts.show(layer, !this.shown()[layer]),
                          { "data-layer": layer, "aria-pressed": "false" });
      if (layer !== "trace") return [node];
      return [node, button("Clear", "Clear the trace", acts.clear, { "data-part": "clear" })];
    });
    const all = [...parts, ...this.frames()];
    return all.length ? [group("Show", ...all)] : [];
  }

  /** A menu that shows and hides frames one by one. */
  frames() {
    const names = frameNames(this.scene.items);
    if (names.length < 2) return [];
    const boxes = names.map((name) => {
      const box = make("input", { type: "checkbox", "data-shows": name,
        "aria-label": `frame ${name}` });
      box.checked = true;
      box.addEventListener("change", () => this.acts.showFrame(name, box.checked));
      return make("label", { class: "kl-choice" }, box, ` frame ${name}`);
    });
    const panel = make("div", { class: "kl-panel-over", role: "group", "aria-label": "Frames" },
                       ...boxes);
    return [make("span", { class: "kl-menu" },
                 ...menu("Which frames", "Show and hide frames one by one", panel))];
  }

  screens() {
    if (!document.fullscreenEnabled) return [];
    return [group("Screen", button("Full screen", "Fill the screen, with large type",
                                   () => this.acts.fill()))];
  }

  // ---- what they show ----

  /** @param {number} stage where it stands */
  stand(stage) {
    for (const node of this.node.querySelectorAll("[data-stage]")) {
      const here = node.getAttribute("data-stage") === String(stage);
      node.setAttribute("aria-pressed", String(here));
    }
  }

  /** @param {string} selector */
  part(selector) { return this.node.querySelector(selector); }

  /** Which layers are switched on. */
  shown() {
    return Object.fromEntries([...this.node.querySelectorAll("[data-layer]")].map((one) =>
      [one.getAttribute("data-layer"), one.getAttribute("aria-pressed") === "true"]));
  }

  /**
   * @param {string} layer
   * @param {boolean} on
   */
  press(layer, on) {
    this.part(`[data-layer="${layer}"]`)?.setAttribute("aria-pressed", String(on));
    if (layer === "trace") this.part('[data-part="clear"]')?.toggleAttribute("disabled", !on);
  }

  /** @param {boolean} on */
  playing(on) {
    const node = this.part('[data-part="play"]');
    node?.replaceChildren(...withIcon(on ? "❚❚" : "▶", on ? "Pause" : "Play"));
    node?.setAttribute("aria-pressed", String(on));
  }
}
