// A prediction: a question beside its picture. While it is open the picture stands still but for
// what is set in it; once an answer is committed, it goes to where the question asked for, and is a
// live view from then on.

import { formFor } from "./answer_form.js";
import { button, make, write } from "./dom.js";
import { mount } from "./mount.js";
import { answerWords, verdict } from "./verdicts.js";

/** @import { Form } from "./answer_form.js" */
/** @import { Pointing } from "./pointing.js" */
/** @import { Asked, Joints, Knob, Live, Looks, Question, Scene, Sheet } from "./types.js" */

const OWN = ["your mark", "your arrow"];            // handles (kinlab/drawing/guess.py)
const PLACE = 3;                                    // knobs of a mark: x, y, z, then its turn
const UNMOVED = 1e-9;                                // a widget keeps 13 digits of where it began

/**
 * Names of the items that are set in the picture for a case, and of the gap.
 * @param {Asked} one
 */
function itemsOf({ kind, about, of }) {
  const yours = kind === "mark" ? "guess-dot" : kind === "direction" ? `guess-arrow-${about}` : "";
  return { yours: yours ? [yours, `${yours}-name`] : [], gap: yours ? [`gap-${of}`] : [] };
}

/**
 * Which knobs of the mark a hand has in a case: of x, y, z and the turn.
 * @type {(one: Asked) => boolean[]}
 */
const movable = ({ kind, axes }) =>
  [..."xyz"].map((axis) => kind === "mark" && axes.includes(axis)).concat(kind === "direction");

/**
 * The axis across the plane in which a mark moves, if it moves in one.
 * @param {Asked} one
 */
function across(one) {
  const fixed = [0, 1, 2].filter((axis) => !movable(one)[axis]);
  return fixed.length === 1 ? fixed[0] : undefined;
}

class Prediction {
  /** @type {Live | null} */
  live = null;

  /** @type {Looks | null} */
  before = null;

  shown = "";                                       // the case and the state that stand there

  /**
   * @param {HTMLElement} element
   * @param {Scene} scene
   * @param {Joints} joints
   * @param {string} formula
   * @param {Pointing | undefined} pointing
   * @param {Sheet} sheet
   */
  constructor(element, scene, joints, formula, pointing, sheet) {
    this.element = element;
    this.scene = scene;
    this.joints = joints;
    this.formula = formula;
    this.pointing = pointing;
    this.sheet = sheet;
    this.question = sheet.question;
    this.node = make("div", { class: "kl-predict", role: "group", "aria-label": "Prediction" });
    this.node.addEventListener("keydown", (event) => {
      if (event.key !== "Tab") event.stopPropagation();   // a notebook has uses for keys, too
    });
    this.deaf = sheet.listen(() => this.show());
    if (sheet.restored && this.answered) joints.write(this.ended());
    this.show();
  }

  // ---- the case that is asked now ----

  get one() { return this.question.cases[this.sheet.read().case]; }

  /** The record of its answer, if it has one. */
  get answered() {
    const { record, case: now } = this.sheet.read();
    return record.find((one) => one.case === now);
  }

  /** The first case that has no answer yet; -1 if all have. */
  get next() {
    const { record } = this.sheet.read();
    return this.question.cases.findIndex((_, k) => !record.some((one) => one.case === k));
  }

  /** What a hand has set in the picture; nothing if it has set nothing. */
  set() {
    const { first } = this.question, q = this.joints.read(), { one } = this;
    const still = movable(one).every((free, k) =>
      !free || Math.abs(q[first + k] - one.start[first + k]) < UNMOVED);
    if (still) return null;
    return one.kind === "mark" ? q.slice(first, first + PLACE) : q[first + PLACE] * 180 / Math.PI;
  }

  // ---- where the knobs stand ----

  /** All knobs, once the case has been answered. */
  ended() {
    const { one, answered, question: { first } } = this, own = one.start.slice(first);
    const answer = answered?.answer;
    if (one.kind === "mark" && answer) own.splice(0, PLACE, ...answer);
    if (one.kind === "direction") {
      own.splice(0, PLACE, ...one.origin);
      if (answer != null) own[PLACE] = answer * Math.PI / 180;
    }
    return [...one.shows, ...own];
  }

  // ---- the two scenes ----

  /**
   * The scene while the question is open: no numbers, nothing to hold but the mark, and no trace,
   * which would lead from the answer of the case before.
   */
  open() {
    const { scene, one, question: { first } } = this, free = movable(one);
    const knobs = scene.knobs.map((knob, i) => free[i - first]
      ? { ...knob, quantity: "mark" }
      : { ...knob, low: one.start[i], high: one.start[i], quantity: "" });
    const shown = this.with(itemsOf(one).yours);
    return { ...shown, items: shown.items.filter(({ shape }) => shape !== "trace"), knobs,
             handles: this.handle(free), pose: null, across: across(one), readings: [],
             chart: null, target: null, poses: [], home: one.start };
  }

  /**
   * The handle of the mark or of the arrow that the case has; it goes where a hand may move it.
   * @param {boolean[]} free
   */
  handle(free) {
    const { scene, one, question: { first } } = this, [, tip] = scene.items.find(({ gid }) =>
      gid === itemsOf(one).yours[0])?.points ?? [];
    return scene.handles.filter(({ name, point }) => name === OWN[0] ? one.kind === "mark"
      : name === OWN[1] && String(point) === String(tip))
      .map((handle) => ({ ...handle, knobs: handle.knobs.filter((k) => free[k - first]) }));
  }

  /** The scene once it has been answered: all of the view, what was set, and the gap. */
  told() {
    const { scene, one, answered, question: { first } } = this, { yours, gap } = itemsOf(one);
    const ended = this.ended(), own = ended.slice(first);
    /** @type {<Value>(q: Value[]) => (Value | number)[]} */
    const fixed = (q) => [...q.slice(0, first), ...own];
    const knobs = scene.knobs.map((knob, i) => i < first ? knob
      : { ...knob, low: ended[i], high: ended[i], quantity: "mark" });
    return { ...this.with(answered?.answer == null ? [] : [...yours, ...gap]), knobs,
             handles: scene.handles.filter(({ name }) => !OWN.includes(name)),
             home: fixed(scene.home), zero: scene.zero && fixed(scene.zero),
             poses: scene.poses.map(fixed) };
  }

  /**
   * The scene with these of the items that belong to a guess, seen from where the case wants.
   * @param {string[]} names
   */
  with(names) {
    const { scene, one } = this;
    return { ...scene, preset: one.seen || scene.preset,
             items: scene.items.filter(({ gid }) =>
               !/^(guess|gap)-/.test(gid) || names.includes(gid)) };
  }

  // ---- the page ----

  show() {
    const { case: now } = this.sheet.read(), state = `${now} ${Boolean(this.answered)}`;
    if (state === this.shown) return;
    const moves = this.shown !== "" && Boolean(this.answered);
    this.shown = state;
    this.picture();
    this.write();
    if (moves) this.see();
  }

  picture() {
    const { element, answered, scene } = this;
    element.classList.add("kl-view");
    element.classList.toggle("kl-asking", !answered);
    if (!scene.items.length) return element.append(this.node);
    this.before = this.live?.leave() ?? null;
    this.live = mount(element, answered ? this.told() : this.open(), this.joints,
      answered ? this.formula : "", this.before, this.pointing);
    element.querySelector(".kl-head")?.append(this.node);
  }

  write() {
    const { one, answered, node, question: { cases } } = this;
    const { record, case: now } = this.sheet.read();
    this.form = formFor(one, () => this.set());
    this.said = make("div", { class: "kl-told", role: "status", tabindex: "-1" });
    const place = cases.length > 1 ? ` ${now + 1} of ${cases.length}` : "";
    node.replaceChildren(make("div", { class: "kl-predict-name" }, `Predict${place}`),
      make("p", { class: "kl-ask" }, one.ask), ...this.form.nodes, this.said, this.buttons());
    if (answered) this.tell(one, answered.answer);
    if (record.length > 1) node.append(this.past());
  }

  /**
   * What is said to the answer, and why.
   * @param {Asked} one
   * @param {any} answer
   */
  tell(one, answer) {
    const { ok, said } = verdict(one, answer);
    this.form?.fill(answer);
    const [look, sign] = ok ? ["kl-right", "✓ "]
      : answer == null ? ["", ""] : ["kl-missed", "✗ "];
    this.said?.replaceChildren(make("p", { class: look },
      make("span", { class: "kl-sign", "aria-hidden": "true" }, sign), said),
      make("p", {}, one.why));
  }

  buttons() {
    const parts = this.answered
      ? [...this.live ? [button("See it again", "Go from the start to the answer once more",
                                () => this.again())] : [],
         ...this.next < 0 ? [] : [button("Another one", "The same question with other numbers",
                                         () => this.ask(this.next))]]
      : [button("Commit", "Answer, and see. An answer is not changed afterwards.",
                () => this.commit(), { class: "kl-button kl-commit" }),
         button("I do not know", "See without a guess", () => this.answer(null))];
    return make("div", { class: "kl-predict-buttons" }, ...parts);
  }

  /** All that was answered before, to be looked back at. */
  past() {
    const { record, case: now } = this.sheet.read();
    const lines = record.filter((one) => one.case !== now).map(({ case: k, answer }) => {
      const one = this.question.cases[k], { ok, said } = verdict(one, answer);
      const given = answer == null ? "" : `${ok ? "✓" : "✗"} You: ${answerWords(one, answer)}. `;
      return make("li", {}, make("p", {}, one.ask), make("p", {}, `${given}${said} ${one.why}`));
    });
    return make("details", { class: "kl-past" }, make("summary", {}, "Looking back"),
                make("ul", {}, ...lines));
  }

  // ---- what the buttons do ----

  commit() {
    const { value, reason } = /** @type {Form} */ (this.form).given();
    if (reason == null) return this.answer(value);
    if (this.said) write(this.said, reason);
  }

  /** @param {any} answer */
  answer(answer) {
    const { record, case: now } = this.sheet.read();
    this.sheet.write([...record, { case: now, answer }], now);
    this.show();
    this.said?.focus({ preventScroll: true });
  }

  /** @param {number} next */
  ask(next) {
    this.sheet.write(this.sheet.read().record, next);
    this.joints.write(this.one.start);
    this.show();
    /** @type {HTMLElement | null} */
    (this.node.querySelector("input, select, button"))?.focus({ preventScroll: true });
  }

  again() {
    const { first } = this.question;
    this.joints.write(this.ended().map((value, i) => i < first ? this.one.start[i] : value));
    this.live?.clear();                             // a leap back is no way
    this.see();
  }

  /** Go to where the question asked for. */
  see() { this.live?.go(this.ended()); }

  // ---- as any live view ----

  /** @param {string} text */
  note(text) { this.live?.note(text); }

  /**
   * @param {import("./types.js").Spot | null} spot
   * @param {import("./pointing.js").Source} [source]
   */
  point(spot, source) { this.live?.point(spot, source); }

  /** @param {number[]} q */
  go(q) { this.live?.go(q); }

  clear() { this.live?.clear(); }

  leave() {
    this.deaf();
    return /** @type {Looks} */ (this.live?.leave());
  }

  dismount() {
    this.deaf();
    this.live?.dismount();
    this.node.remove();
  }
}

/**
 * Show a prediction, in the place of a live view.
 * @param {HTMLElement} element
 * @param {Scene} scene
 * @param {Joints} joints
 * @param {string} formula
 * @param {Pointing | undefined} pointing
 * @param {Sheet} sheet what is asked, and where answers are kept
 * @returns {Live}
 */
export const ask = (element, scene, joints, formula, pointing, sheet) =>
  new Prediction(element, scene, joints, formula, pointing, sheet);
