// Saving and loading the DH table as text.

import { make } from "./dom.js";
import { choose, press } from "./table_parts.js";

/** @import { Editor } from "./table.js" */
/** @import { Field } from "./types.js" */

const MOST = 60000;                                 // characters in a file
const FORMATS = [["csv", "CSV"], ["code", "kinlab code"]];

/**
 * A box with the table as text, to load, save and download; none while it is not asked for.
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
  const file = make("input", { type: "file", accept: ".csv,.py,.txt",
                               "aria-label": "Open a file" });
  file.addEventListener("change", async () => {
    if (file.files?.length) editor.send("load", (await file.files[0].text()).slice(0, MOST));
  });
  return [make("div", { class: "kl-store" }, text,
    make("div", { class: "kl-toolbar" }, make("label", {}, "as ", format),
      press("Load this text", "Load the text above", () => editor.send("load", text.value)),
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
  const area = editor.element.querySelector("textarea"), code = editor.saving === "code";
  if (!area) return;
  if (area.committed === undefined || area.value === area.committed) {
    area.value = area.committed = editor.state[code ? "code" : "csv"];
  }
  area.placeholder = code ? "Correct the marked cells, or paste code here." : "";
}

/**
 * @param {string} text
 * @param {string} saving
 */
function download(text, saving) {
  const name = saving === "code" ? "dh_table.py" : "dh_table.csv";
  const link = make("a", { download: name, href: URL.createObjectURL(new Blob([text])) });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}
