// Tables that are pasted or dropped: what a clipboard or a file holds, as text for Python to read.

/** @import { Editor } from "./table.js" */

export const MOST = 100000;                         // characters in a table's text
const HTML = /<table\b/i;

/**
 * Whether a text has more than one cell. A number has no tab, comma or bar in it, and a copied cell
 * of a spreadsheet only ends in a line break.
 * @param {string} text
 */
export function hasCells(text) {
  return /[\t\n;|&]/.test(text.trim()) || text.split(",").length > 2 || HTML.test(text);
}

/**
 * The table in a clipboard; "" where a paste is only a number or a word. A page or a spreadsheet
 * gives its cells as HTML, beside a text that has lost some of its lines.
 * @param {Pick<DataTransfer, "getData">} clipboard
 */
export function pastedTable(clipboard) {
  const html = clipboard.getData("text/html"), plain = clipboard.getData("text/plain");
  if (!hasCells(plain || html)) return "";
  return HTML.test(html) && html.length <= MOST ? html : plain.slice(0, MOST);
}

/**
 * Let an editor take the tables that are pasted into it, or dropped on it as files.
 * @param {Editor} editor
 * @param {HTMLElement} element
 */
export function takeTables(editor, element) {
  element.addEventListener("paste", (event) => {
    const text = event.clipboardData && pastedTable(event.clipboardData);
    if (!text) return;
    event.preventDefault();
    if (event.target instanceof HTMLTextAreaElement) event.target.value = text;
    editor.load(text);
  });
  element.addEventListener("dragover", (event) => {
    if (event.dataTransfer?.types.includes("Files")) event.preventDefault();
  });
  element.addEventListener("drop", async (event) => {
    const [file] = event.dataTransfer?.files ?? [];
    if (!file) return;
    event.preventDefault();
    event.stopPropagation();                        // JupyterLab would upload it
    editor.load(await textOf(file));
  });
}

/**
 * The text of a file.
 * @param {File} file
 */
export const textOf = async (file) => (await file.text()).slice(0, MOST);
