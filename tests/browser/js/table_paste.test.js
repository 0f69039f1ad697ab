// What counts as a table in a clipboard, and which of its texts is taken.
import assert from "node:assert/strict";
import { test } from "node:test";

import { MOST, hasCells, pastedTable } from "../../../kinlab/browser/table_paste.js";

const clipboard = (plain, html = "") => ({
  getData: (type) => ({ "text/plain": plain, "text/html": html })[type] ?? "" });

test("a number, a sum or a name has one cell", () => {
  for (const text of ["90", "-pi/2", "0.5 + L1", "  12 ", "1,5", "215\r\n", "0.303\n", "θ₁*", ""]) {
    assert.equal(hasCells(text), false, text);
  }
});

test("tabs, lines, bars and commas make cells", () => {
  for (const text of ["0\t0.1", "0 1 0 90\n0 0 1 0", "0;0.1;0;90", "| 1 | 0 |", "0,0.1,0,90",
                      "0 & 0.1 & 0 & 90 \\\\", "<table><tr><td>1</td></tr></table>"]) {
    assert.equal(hasCells(text), true, text);
  }
});

test("a copied cell of a spreadsheet is an ordinary paste, though it has a table beside it", () => {
  assert.equal(pastedTable(clipboard("0.5\r\n", "<table><tr><td>0.5</td></tr></table>")), "");
  assert.equal(pastedTable(clipboard("")), "");
});

test("cells as HTML are taken where there are any", () => {
  const html = "<meta><TABLE><tr><td>0</td><td>1</td></tr></TABLE>";
  assert.equal(pastedTable(clipboard("0\t1\n", html)), html);
  assert.equal(pastedTable(clipboard("", html)), html);
  assert.equal(pastedTable(clipboard("0\t1", "<b>0 1</b>")), "0\t1");
});

test("a page that is too long gives its plain text, and no more than is read", () => {
  const long = `<table>${"x".repeat(MOST)}</table>`;
  assert.equal(pastedTable(clipboard("0\t1", long)), "0\t1");
  assert.equal(pastedTable(clipboard("0\t1".repeat(MOST))).length, MOST);
});
