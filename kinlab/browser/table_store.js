// Saving and loading the DH table as text.

import { make } from "./dom.js";
import { choose, press } from "./table_parts.js";
import { textOf } from "./table_paste.js";

/** @import { Editor } from "./table.js" */
/** @import { Field } from "./types.js" */

const FORMATS = [["csv", "CSV"], ["markdown", "Markdown"], ["latex", "LaTeX"],
                 ["code", "kinlab code"]];
/** @type {Record<string, string>} */
const FILES = { csv: "csv", markdown: "md", latex: "tex", code: "py" };

/**
 * A box with the table as text, to load, copy and download; none while it is not asked for.
 * @param {Editor} editor
 */
export function store(editor) {
  if (!editor.saving) return [];
  const format = choose("Format", FORMATS, editor.saving, (value) => {
    editor.saving = value;
    editor.show();
  });
  const text = make("textarea", { "aria-label": "The table as text", "data-at": "text",
                                  rows: "9", spellcheck: "false" });
  const file = make("input", { type: "file", accept: ".csv,.txt,.md,.tex,.py,.html",
                               "aria-label": "Open a file" });
  file.addEventListener("change", async () => {
    if (file.files?.length) editor.load(await textOf(file.files[0]));
  });
  return [make("div", { class: "kl-store" }, text,
    make("div", { class: "kl-toolbar", role: "toolbar", "aria-label": "Text of the table" },
      make("label", {}, "as ", format),
      press("Load this text", "Load the text above", () => editor.load(text.value)),
      press("Copy", "Copy the text above", () => copy(editor, text)),
      press("Download", "Download the text above as a file",
            () => download(text.value, editor.saving)),
      make("label", {}, "Open a file ", file)))];
}

/**
 * The table as text, unless the student has changed that text.
 * @param {Editor} editor
 */
export function fill(editor) {
  /** @type {HTMLTextAreaElement & Field | null} */
  const area = editor.element.querySelector("textarea"), told = editor.state.texts[editor.saving];
  if (!area) return;
  if (area.committed === undefined || area.value === area.committed) {
    area.value = area.committed = told;
  }
  area.placeholder = told ? "" : "Correct the marked cells, or paste a table here.";
}

/**
 * @param {Editor} editor
 * @param {HTMLTextAreaElement} area
 */
function copy(editor, area) {
  area.select();
  document.execCommand("copy");                     // navigator.clipboard needs https
  editor.say("Copied.");
}

/**
 * @param {string} text
 * @param {string} saving
 */
function download(text, saving) {
  const link = make("a", { download: `dh_table.${FILES[saving]}`,
                           href: URL.createObjectURL(new Blob([text])) });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}
