// Where an answer is given: a choice, several, a number, a table of signs, or words that send the
// hand to the picture.

import { make } from "./dom.js";
import { read } from "./numbers.js";

/** @import { Asked } from "./types.js" */
/** @typedef {{ value?: any, reason?: string }} Given an answer, or why there is none */
/**
 * A part of the page that takes an answer.
 * @typedef {object} Form
 * @property {Node[]} nodes
 * @property {() => Given} given
 * @property {(answer: any) => void} fill shows an answer that was given, and may not be changed
 */

let forms = 0;                                      // for the names of radio buttons

/**
 * Boxes to tick, or one of several.
 * @param {Asked} one
 * @param {"radio" | "checkbox"} type
 * @returns {Form}
 */
function options({ options: texts, right }, type) {
  const name = `kl-answer-${forms++}`;
  const boxes = texts.map(([text]) => make("input", { type, name, value: text }));
  const labels = boxes.map((box, k) => make("label", { class: "kl-option" }, box,
    make("span", {}, texts[k][0])));
  const taken = () => boxes.filter((box) => box.checked).map((box) => box.value);
  return {
    nodes: [make("div", { class: "kl-options" }, ...labels)],
    given: () => type === "checkbox" ? { value: taken() }
      : taken().length ? { value: taken()[0] } : { reason: "Choose one of them first." },
    fill(answer) {
      const mine = [answer ?? []].flat(), belong = [right].flat();
      boxes.forEach((box, k) => {
        box.checked = mine.includes(box.value);
        box.disabled = true;
        const is = belong.includes(box.value);
        labels[k].classList.toggle("kl-right", is);
        labels[k].classList.toggle("kl-missed", !is && box.checked);
        labels[k].append(make("span", { class: "kl-sign" },
          is ? " ✓" : box.checked ? " ✗" : ""));
      });
    },
  };
}

/**
 * @param {Asked} one
 * @returns {Form}
 */
function numberField({ unit, ask }) {
  const field = make("input", { type: "text", class: "kl-field", inputmode: "decimal",
    "aria-label": `${ask} A number${unit && " in "}${unit}`, autocomplete: "off",
    spellcheck: "false", maxlength: 200 });
  return {
    nodes: [make("div", { class: "kl-options" }, make("label", { class: "kl-option" }, field,
                 make("span", {}, unit)))],
    given() {
      if (!field.value.trim()) return { reason: "Type a number first." };
      const typed = read(field.value, { angle: unit === "°", unit });
      return typed.reason == null ? { value: typed.value } : { reason: typed.reason };
    },
    fill(answer) {
      field.value = answer == null ? "" : String(Number(Number(answer).toPrecision(6)));
      field.disabled = true;
    },
  };
}

/**
 * A matrix with a choice of letters in each entry.
 * @param {Asked} one
 * @returns {Form}
 */
function signTable({ rows, columns, among, right }) {
  const cells = rows.map((row) => columns.map((column) => make("select",
    { "class": "kl-letters", "aria-label": `${column}, ${row}` },
    make("option", { value: "" }, "…"),
    ...among.map(([letter, meaning]) =>
      make("option", { value: letter, title: meaning }, letter.replace("-", "−"))))));
  const head = make("tr", {}, make("td"), ...columns.map((name) =>
    make("th", { scope: "col" }, name)));
  const body = cells.map((line, i) => make("tr", {}, make("th", { scope: "row" }, rows[i]),
    ...line.map((cell) => make("td", {}, cell))));
  const legend = among.map(([letter, meaning]) =>
    `${letter.replace("-", "−")} ${meaning}`).join(",  ");
  return {
    nodes: [make("table", { class: "kl-sign-table" }, head, ...body),
            make("p", { class: "kl-advice" }, legend)],
    given: () => cells.flat().every(({ value }) => value)
      ? { value: cells.map((line) => line.map(({ value }) => value).join("")) }
      : { reason: "Fill every entry first." },
    fill(answer) {
      cells.forEach((line, i) => line.forEach((cell, j) => {
        const mine = answer?.[i]?.[j] ?? "", is = right[i][j];
        cell.value = mine || is;
        cell.disabled = true;
        if (mine === is) return;
        cell.parentElement?.classList.add("kl-missed");
        cell.after(make("span", { class: "kl-sign" }, ` ${is.replace("-", "−")}`));
      }));
    },
  };
}

/**
 * Words alone: the picture takes the answer.
 * @param {Asked} one
 * @param {() => any} set what is set in the picture, or nothing
 * @returns {Form}
 */
function inPicture({ kind }, set) {
  const what = kind === "mark" ? "mark" : "arrow";
  const hint = make("p", { class: "kl-advice" }, kind === "mark"
    ? "Drag the dot “you” in the picture, or set it with the sliders."
    : "Turn the arrow “you” in the picture by its tip, or with the slider.");
  return {
    nodes: [hint],
    given() {
      const value = set();
      return value == null ? { reason: `Move your ${what} first.` } : { value };
    },
    fill() { hint.remove(); },
  };
}

/**
 * The form for a kind of question.
 * @param {Asked} one
 * @param {() => any} set
 * @returns {Form}
 */
export function formFor(one, set) {
  if (one.kind === "choice") return options(one, "radio");
  if (one.kind === "several") return options(one, "checkbox");
  if (one.kind === "number") return numberField(one);
  return one.kind === "signs" ? signTable(one) : inPicture(one, set);
}
