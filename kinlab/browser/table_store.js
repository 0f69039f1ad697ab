// Saving and loading the DH table as text.

import { make } from "./dom.js";
import { choose, press } from "./table_parts.js";

const MOST = 60000;                                 // characters in a file

/** A box with the table as text, to load, save and download; empty while it is not asked for. */
export function store(editor) {
  if (!editor.saving) return [];
  const format = choose("Format", [["csv", "CSV"], ["code", "kinlab code"]], editor.saving, (value) => {
    editor.saving = value;
    editor.show();
  });
  const text = make("textarea", { "aria-label": "The table as text", rows: "9", spellcheck: "false",
                                  "data-at": "text" });
  const file = make("input", { type: "file", accept: ".csv,.py,.txt", "aria-label": "Open a file" });
  file.addEventListener("change", async () => {
    if (file.files[0]) editor.send("load", (await file.files[0].text()).slice(0, MOST));
  });
  return [make("div", { class: "kl-store" }, text,
    make("div", { class: "kl-toolbar" }, make("label", {}, "as ", format),
      press("Load this text", "Load the text above", () => editor.send("load", text.value)),
      press("Download", "Download the text above as a file", () => download(text.value, editor.saving)),
      make("label", {}, "Open a file ", file)))];
}

/** The table as text, unless the student has changed that text. */
export function fill(editor) {
  const area = editor.element.querySelector("textarea"), now = editor.state[editor.saving];
  if (!area) return;
  if (area.committed === undefined || area.value === area.committed) area.value = area.committed = now;
  area.placeholder = editor.saving === "code" ? "Correct the marked cells, or paste code here." : "";
}

function download(text, saving) {
  const name = saving === "code" ? "dh_table.py" : "dh_table.csv";
  const link = make("a", { download: name, href: URL.createObjectURL(new Blob([text])) });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}
