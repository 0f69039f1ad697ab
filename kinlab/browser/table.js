// The cells and buttons of the DH table. Python (kinlab/views/table_editor.py) holds the table: the
// browser tells it each edit and shows the state that comes back. What is being typed is never
// touched.

import { lowered, make, write } from "./dom.js";
import { rove } from "./roving.js";
import { LETTERS, ends, newEnds } from "./table_ends.js";
import { ask, briefly, choose, commitTo, press, typed, untouched } from "./table_parts.js";
import { takeTables } from "./table_paste.js";
import { fill, store } from "./table_store.js";

/** @import { Cell, Field, Model, Row, TableState } from "./types.js" */

/** @type {Record<string, string>} */
const GREEK = { theta: "θ", alpha: "α", d: "d", a: "a" };
/** @type {Record<string, string>} */
const NAMES = { theta: "joint angle", d: "link offset", a: "link length", alpha: "link twist",
                low: "lower limit", high: "upper limit", home: "home",
                speed: "largest speed", acceleration: "largest acceleration" };
/** @type {Record<string, string>} */
const TITLES = { standard: "standard (Spong, Schilling)", modified: "modified (Craig)" };
const PANELS = [["closed", "Closed form", "The arm matrix in closed form"],
                ["symbols", "… with symbols", "The arm matrix with letters for its lengths"],
                ["signs", "Sign pattern", "Only the signs of the table's numbers"],
                ["compare", "", "The same numbers in the other convention, side by side"]];
const LIMITS = ["low", "high", "home"];
const RATES = ["speed", "acceleration"];            // shown where a table has any
const KINDS = ["revolute", "prismatic", "fixed"];

/**
 * The parameter of a cell's column with its index: a modified table holds alpha and a of the link
 * before.
 * @type {(convention: string, column: string, row: number) => string}
 */
function indexed(convention, column, row) {
  const before = convention === "modified" && (column === "alpha" || column === "a");
  return `${GREEK[column]}${lowered(before ? row - 1 : row)}`;
}

export class Editor {
  static count = 0;

  id = Editor.count++;

  shape = "";

  limits = false;                                   // whether their columns are asked for

  asked = "";                                       // the convention to change to, if one is

  saving = "";                                      // the format of the text box, if it is open

  next = "";                                        // the place that gets the focus

  loading = "";                                     // the text that is to be loaded

  from = "";                                        // the place where it was pasted

  building = false;

  /**
   * The last row's key when a row was asked for.
   * @type {number | null}
   */
  after = null;

  /** @type {string[]} */
  columns = [];

  /**
   * What Python told last of each cell.
   * @type {Record<string, Pick<Cell, "text" | "error" | "reads" | "hint">>}
   */
  told = {};

  /**
   * @param {Model} model
   * @param {HTMLElement} element
   */
  constructor(model, element) {
    this.model = model;
    this.element = element;
    this.parts = make("div");
    this.spoken = make("div", { class: "kl-spoken", role: "status" });   // outlives all parts
    element.append(this.parts, this.spoken);
    element.classList.add("kl-table");
    const here = () => { this.next = ""; };         // the student has gone elsewhere
    for (const event of ["pointerdown", "keydown"]) element.addEventListener(event, here, true);
    takeTables(this, element);
    element.addEventListener("keydown", (event) => {
      this.key(event);
      if (!event.ctrlKey && !event.metaKey) event.stopPropagation();   // the notebook's own keys
    });
  }

  /** @returns {TableState} */
  get state() { return this.model.get("cells"); }

  /**
   * Ask Python for an edit.
   * @param {string} what
   * @param {unknown[]} parameters
   */
  send(what, ...parameters) {
    if (!this.building) this.model.send({ do: what, with: parameters });
  }

  /**
   * Ask Python to load a table; a question that comes of it gets the focus.
   * @param {string} text
   */
  load(text) {
    this.loading = text;
    this.from = placeOf(document.activeElement).join(" ");
    this.next = "answer 0";
    this.send("load", text);
  }

  /** Show the state: anew where rows or columns changed, else only the cells that did. */
  show() {
    const { state } = this;
    const { rows } = state;
    const rates = RATES.filter((column) => rows.some(({ cells }) => cells[column]));
    const others = [...LIMITS, ...rates];
    const hidden = rows.some(({ cells }) => others.some((column) => cells[column]?.error));
    this.columns = [...state.columns, ...(this.limits || hidden ? others : [])];
    const shape = JSON.stringify([
      state.rows.map(({ key, kind, name, flip, locked }) => [key, kind, name, flip, locked]),
      this.columns, state.convention, state.angles, state.unit, state.units,
      state.lengths.map(({ name }) => name), Object.values(state.ends).map((end) => end?.form),
      state.question, this.asked, this.saving]);
    if (shape !== this.shape) this.build();
    this.shape = shape;
    this.patch();
  }

  build() {
    const active = /** @type {Field | null} */ (document.activeElement);
    const within = active && this.element.contains(active) ? active : null;
    const at = this.next || within?.dataset.at;
    const half = within?.committed === undefined || within.value === within.committed ||
      within.value === this.loading ? null : within.value;
    this.told = {};
    this.building = true;                           // a cell that goes is not a cell that is left
    this.parts.replaceChildren(this.bar(), ...this.question(), this.table(), this.named(),
                                 ...ends(this), ...this.doubt(), this.foot(), ...store(this));
    this.building = false;
    this.loading = "";
    for (const bar of /** @type {NodeListOf<HTMLElement>} */ (
      this.element.querySelectorAll("[role=toolbar]"))) rove(bar);
    // Where the place has gone, such as by another table, the hands begin at the first cell.
    const found = at ? this.find(at) ?? this.find(`${this.state.rows[0].key} ${this.columns[0]}`)
      : null;
    if (found) {
      found.focus({ preventScroll: true });
      if (this.next) found.scrollIntoView({ block: "nearest" });
      if (half != null && !this.next) found.value = half;
      else if (this.next && found.select) found.select();
      this.next = "";
    }
  }

  /**
   * The cell or button of a place.
   * @param {string} at
   * @returns {Field | null}
   */
  find(at) { return this.element.querySelector(`[data-at="${CSS.escape(at)}"]`); }

  patch() {
    const { state } = this;
    state.rows.forEach((row) => this.columns.forEach((column) => {
      if (row.cells[column]) this.cell(`${row.key} ${column}`, row.cells[column]);
    }));
    for (const [end, told] of Object.entries(state.ends)) {
      for (const [column, cell] of Object.entries(told?.cells ?? {})) {
        this.cell(`${end} ${column}`, cell);
      }
    }
    state.lengths.forEach((length, k) => {
      this.cell(`length ${k}`, length);
      this.cell(`name ${k}`, { text: length.name, error: "" });
    });
    this.reasons();
    for (const [name, possible] of [["Undo", state.undo], ["Redo", state.redo]]) {
      this.find(String(name))?.toggleAttribute("disabled", !possible);
    }
    for (const [panel, , title] of PANELS) {
      this.find(title)?.setAttribute("aria-pressed", String(state.open === panel));
    }
    this.remark();
    fill(this);
  }

  /** Below each row, why its cells cannot be read, and what is odd about them. */
  reasons() {
    for (const line of /** @type {NodeListOf<HTMLElement>} */ (
      this.element.querySelectorAll(".kl-reason"))) {
      /** @type {string[]} */
      const places = JSON.parse(line.dataset.of ?? "[]");
      const told = places.filter((at) => this.told[at].error || this.told[at].hint);
      line.hidden = !told.length;
      line.querySelector("[id]")?.replaceChildren(...told.map((at) =>
        make("div", { class: this.told[at].error ? "" : "kl-hinted" },
          make("b", {}, `${this.label(at)} `), this.told[at].error || this.told[at].hint || "")));
    }
  }

  /** What Python said last, or how many cells are wrong. */
  remark() {
    const { said, wrong: count } = this.state;
    const cells = count === 1 ? "One cell is" : `${count} cells are`;
    const wrong = count && `${cells} wrong. ` +
      "The arm below is the last one that could be read.";
    const remark = this.say([said, wrong].filter(Boolean).join(" "));
    remark.classList.toggle("kl-warns", Boolean(wrong));
    remark.classList.toggle("kl-tells", Boolean(said));
  }

  /**
   * Say something below the table, and to a screen reader.
   * @param {string} text
   */
  say(text) {
    const remark = /** @type {Element} */ (this.parts.querySelector(".kl-said"));
    write(remark, text);
    write(this.spoken, text);
    return remark;
  }

  /**
   * A cell's text, mark and reading; its text only where Python changed it.
   * @param {string} at
   * @param {Pick<Cell, "text" | "error" | "reads" | "hint">} told
   */
  cell(at, { text, error, reads, hint }) {
    const input = /** @type {Field} */ (this.find(at)), before = this.told[at];
    this.told[at] = { text, error, reads, hint };
    if (before?.text !== text && input.committed !== text) {
      commitTo(input, text, input === document.activeElement && !untouched(input));
    }
    input.setAttribute("aria-invalid", String(Boolean(error)));
    input.classList.toggle("kl-odd", Boolean(hint));
    if (error || hint) input.setAttribute("aria-describedby", input.dataset.reason ?? "");
    else input.removeAttribute("aria-describedby");
    const whole = briefly(text) === text ? "" : text;
    input.title = error || hint || (reads ? `${text} = ${reads}` : whole);
    const beside = input.nextElementSibling;
    if (beside?.classList.contains("kl-reads")) beside.textContent = reads ? `= ${reads}` : "";
  }

  /**
   * What a cell is called where a reason is given.
   * @param {string} at
   */
  label(at) {
    const [key, column] = at.split(" "), { lengths } = this.state;
    if (key === "length") return `${lengths[Number(column)].name}:`;
    const row = this.state.rows[this.place(Number(key)) - 1];
    if (!row) return `${key} ${LETTERS[column] ?? column}:`;
    return `${GREEK[column] ? this.symbol(row, column) : NAMES[column]}:`;
  }

  /**
   * The parameter of a cell: the joint variable has its joint's number, all else its row's.
   * @param {Row} row
   * @param {string} column
   */
  symbol(row, column) {
    return column === row.variable ? `${GREEK[column]}${lowered(row.joint)}`
      : indexed(this.state.convention, column, this.place(row.key));
  }

  // ---- parts ----

  bar() {
    const { state } = this;
    const conventions = state.conventions.map((name) => [name, TITLES[name]]);
    return make("div", { class: "kl-toolbar", role: "toolbar", "aria-label": "Table" },
      make("label", {}, "Convention ", choose("Convention", conventions, state.convention,
        (value, list) => {
          list.value = state.convention;
          this.asked = value === state.convention ? "" : value;
          this.next = "answer 0";
          this.show();
        })),
      make("label", {}, "Angles ", choose("Angles", [["deg", "degrees"], ["rad", "radians"]],
        state.angles, (value) => this.send("in_angles", value))),
      make("label", {}, "Lengths ", choose("Lengths", state.units.map((unit) => [unit, unit]),
        state.unit, (value) => this.send("in_unit", value))),
      make("span", { class: "kl-group" },
        press("↶ Undo", "Undo", () => this.send("undo")),
        press("↷ Redo", "Redo", () => this.send("redo"))),
      press("Limits, home", "Show the limits and the home of each joint", () => {
        this.limits = !this.limits;
        this.show();
      }, { "aria-pressed": this.columns.includes("low") }));
  }

  question() {
    if (!this.asked || this.asked === this.state.convention) return [];
    const other = this.asked, answer = (/** @type {string} */ what) => () => {
      this.asked = "";
      this.next = "Convention";
      if (what) this.send(what, other);
      this.show();
    };
    const wrong = this.state.wrong > 0;
    return [ask("Change of convention",
      wrong ? "To convert, correct the marked cells first." : "",
      [[`Read the same numbers as ${other}`, answer("read_as")],
       [`Convert to ${other}: the same arm`, answer("converted_to"), { disabled: wrong }]],
      answer(""))];
  }

  /** What a pasted table leaves open. */
  doubt() {
    const { question } = this.state;
    if (!question) return [];
    return [ask(question.text, question.text,
      question.options.map((label, k) => [label, () => {
        this.next = "answer 0";                     // of a next question
        this.send("answer", k);
      }]),
      () => {
        this.next = this.from;
        this.send("dismiss");
      })];
  }

  table() {
    const { state, columns } = this;
    const shift = state.convention === "modified" ? "i−1" : "i";
    const head = columns.map((column) => make("th", { scope: "col", title: NAMES[column] },
      ...(GREEK[column] ? [GREEK[column], make("sub", {},
        column === "a" || column === "alpha" ? shift : "i"),
        ` (${state.rows[0].cells[column].unit})`]
        : [NAMES[column]])));
    const table = make("table", { class: "kl-dh", "aria-label": "DH table" },
      make("thead", {}, make("tr", {}, make("th", { scope: "col" }, "i"),
        make("th", { scope: "col" }, "joint"), ...head,
        make("th", { scope: "col" }, make("span", { class: "kl-unseen" }, "move, remove")))),
      make("tbody", {}, ...state.rows.flatMap((row, k) => this.row(row, k + 1))));
    rove(table, "button");                          // cells and lists are stops of their own
    return table;
  }

  /**
   * A row of cells, and the line below it for reasons.
   * @param {Row} row
   * @param {number} i
   */
  row(row, i) {
    const reason = `kl-reason-${this.id}-${row.key}`, last = this.state.rows.length;
    const cells = this.columns.map((column) => {
      const told = row.cells[column], star = column === row.variable;
      if (!told) return make("td");                 // a fixed row has no limits
      const symbol = GREEK[column] ? this.symbol(row, column) : `row ${i}`;
      const meaning = star ? "offset of the joint variable" : NAMES[column];
      const input = typed(`${row.key} ${column}`, `${symbol}, ${meaning}, row ${i}, ${told.unit}`,
        told.text, (text) => this.send("with_cell", this.place(row.key), column, text));
      input.dataset.reason = reason;
      if (!GREEK[column]) input.placeholder = column === "home" ? "0" : "none";
      const room = this.state.rows.some(({ variable }) => variable === column)
        ? [make("span", { class: "kl-room" })] : [];   // cells of a column stand in line
      return make("td", { class: star ? "kl-starred" : "" }, ...(star ? [this.star(row)] : room),
        input, make("span", { class: "kl-reads" }),
        ...(column === "home" && row.variable ? [this.lock(row)] : []));
    });
    const tools = make("td", { class: "kl-tools" },
      press("↑", `Move row ${i} up (Alt+↑)`, () => this.move(row.key, -1),
            { disabled: i === 1 }),
      press("↓", `Move row ${i} down (Alt+↓)`, () => this.move(row.key, 1),
            { disabled: i === last }),
      press("✕", `Remove row ${i} (Alt+Delete)`, () => this.remove(row.key),
            { disabled: last === 1 }));
    return [
      make("tr", row.variable ? { "data-joint": row.joint }
        : { "data-frame": i, "data-holds": "" },
        make("th", { scope: "row", title: row.name || (row.variable ? `joint ${row.joint}`
          : "a fixed row") }, String(i)),
        make("td", {}, choose(`Type of row ${i}`, KINDS.map((kind) => [kind, kind]), row.kind,
          (kind) => this.send("with_kind", this.place(row.key), kind)),
          ...(row.locked ? [make("span", { class: "kl-locked" }, "locked")] : [])),
        ...cells, tools),
      this.reason("tr", this.columns.filter((column) => row.cells[column])
        .map((column) => `${row.key} ${column}`),
        make("td"), make("td", { colspan: this.columns.length + 2, id: reason, role: "alert" }))];
  }

  /**
   * The joint variable before its offset; pressed, the joint counts the other way.
   * @param {Row} row
   */
  star(row) {
    const symbol = this.symbol(row, row.variable ?? "");
    return make("span", { class: "kl-star" },
      press(`${row.flip ? "−" : ""}${symbol}*`,
        `Let joint ${row.joint} count the ${row.flip ? "usual" : "other"} way: ` +
        `${row.flip ? "" : "−"}${symbol} (Alt+−)`,
        () => this.send("with_flip", this.place(row.key), !row.flip),
        { "data-at": `flip ${row.key}`, "aria-label": `${symbol} counts the other way`,
          "aria-pressed": String(row.flip) }),
      make("span", { class: "kl-plus" }, " +"));
  }

  /**
   * Lock a joint where it is now, or unlock it.
   * @param {Row} row
   */
  lock(row) {
    const [text, does, title] = row.locked ? ["Unlock", "unlock", "let it move without limits"]
      : ["Lock", "lock", "where it is now"];
    return press(text, `${text} joint ${row.joint}: ${title}`,
      () => this.send(does, this.place(row.key)), { "data-at": `lock ${row.key}` });
  }

  /**
   * A place for the reasons of some cells.
   * @param {"tr" | "div"} tag
   * @param {string[]} places
   * @param {HTMLElement[]} children
   */
  reason(tag, places, ...children) {
    return make(tag, { class: "kl-reason", hidden: "", "data-of": JSON.stringify(places) },
                ...children);
  }

  named() {
    const { lengths, unit } = this.state;
    const items = lengths.map(({ name, text }, k) => {
      const both = () => [`name ${k}`, `length ${k}`].map((at) => this.find(at)?.value);
      const change = () => this.send("with_length", k + 1, ...both());
      const inputs = [typed(`name ${k}`, `Name of length ${k + 1}`, name, change),
                      typed(`length ${k}`, `Length ${name}, ${unit}`, text, change)];
      inputs[0].classList.add("kl-name");
      inputs[1].dataset.reason = `kl-reason-${this.id}-lengths`;
      return make("span", { class: "kl-length" }, inputs[0], " = ", inputs[1], ` ${unit} `,
        press("✕", `Remove the length ${name}`, () => this.send("without_length", k + 1)));
    });
    return make("div", { class: "kl-lengths" }, ...items,
      this.reason("div", lengths.map((_, k) => `length ${k}`),
        make("div", { id: `kl-reason-${this.id}-lengths`, role: "alert" })));
  }

  /** Ask for one more named length, under the first free name. */
  more() {
    const { lengths } = this.state, taken = new Set(lengths.map(({ name }) => name));
    const free = Array.from({ length: 30 }, (_, k) => `l${k + 1}`).find((name) => !taken.has(name));
    this.next = `name ${lengths.length}`;
    this.send("with_length", lengths.length + 1, free, "0");
  }

  foot() {
    const other = this.state.conventions.find((name) => name !== this.state.convention);
    const panels = PANELS.map(([panel, text, title]) => press(
      text || `Compare with ${other}`, title,
      () => this.send("open", this.state.open === panel ? "" : panel),
      { "aria-pressed": "false" }));
    return make("div", { class: "kl-foot" },
      make("div", { class: "kl-toolbar", role: "toolbar", "aria-label": "Add and show" },
        make("span", { class: "kl-group" },
          press("+ Joint", "Add a joint below the last", () => {
            this.after = this.last.key;
            this.send("with_row");
          }),
          press("+ Named length", "Add a length that cells may name, such as -d2",
                () => this.more()),
          ...newEnds(this)),
        make("span", { class: "kl-group" }, ...panels),
        press("Save, load", "Save or load the table: CSV, Markdown, LaTeX, kinlab code", () => {
          this.saving = this.saving ? "" : "csv";
          this.show();
        }, { "aria-pressed": Boolean(this.saving), "aria-expanded": Boolean(this.saving) })),
      make("div", { class: "kl-said" }));
  }

  // ---- rows, by mouse and by keys ----

  get last() { return this.state.rows[this.state.rows.length - 1]; }

  /**
   * The number of a row, from 1; 0 if it is gone.
   * @param {number} key
   */
  place(key) { return this.state.rows.findIndex((row) => row.key === key) + 1; }

  /**
   * @param {number} key
   * @param {number} by
   */
  move(key, by) {
    const from = this.place(key), to = from + by;
    if (to >= 1 && to <= this.state.rows.length) this.send("with_row_moved", from, to);
  }

  /** @param {number} key */
  remove(key) {
    const { rows } = this.state, from = this.place(key);
    if (rows.length === 1) return;
    const [, column] = placeOf(document.activeElement);
    const beside = rows[from] ?? rows[from - 2];
    this.next = `${beside.key} ${this.columns.includes(column) ? column : this.columns[0]}`;
    this.send("without_row", from);
  }

  /** @param {KeyboardEvent} event */
  key(event) {
    const [key, column] = placeOf(event.target), { rows } = this.state;
    const at = this.place(Number(key)) - 1;
    if (at < 0 || !this.columns.includes(column) || event.ctrlKey || event.metaKey) return;
    const row = rows[at], step = { ArrowUp: -1, ArrowDown: 1 }[event.key];
    if (step && event.altKey) this.move(row.key, step);
    else if (event.altKey && event.key === "Delete") this.remove(row.key);
    else if (event.altKey && event.code === "Minus" && row.variable) {
      this.send("with_flip", at + 1, !row.flip);
    }
    else if (step && !event.shiftKey) {
      const beside = rows[at + step], input = beside && this.find(`${beside.key} ${column}`);
      input?.focus();
      input?.select();
    } else return;
    event.preventDefault();
  }
}

/**
 * The row and the column of a cell.
 * @param {EventTarget | null} node
 */
const placeOf = (node) => (node instanceof HTMLElement && node.dataset.at || "").split(" ");

/**
 * Show a model's table in an element.
 * @param {Model} model
 * @param {HTMLElement} element
 * @param {() => void} shown called when its parts may be others
 * @returns {() => void} ends it
 */
export function showTable(model, element, shown = () => {}) {
  const editor = new Editor(model, element);
  const show = () => {
    const { last } = editor;
    if (editor.after != null && last.key !== editor.after) {   // the row asked for has come
      editor.next = `${last.key} ${editor.state.columns[0]}`;
      editor.after = null;
    }
    editor.show();
    shown();
  };
  editor.show();
  model.on("change:cells", show);
  return () => model.off("change:cells", show);
}
