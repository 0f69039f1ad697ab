// In JupyterLite: a fresh copy of a lesson, and a word where a saved copy is of an older edition.
// The browser keeps what a student saves and shows that ever after, whatever is published later.
// And an answer that its kernels owe to saved views: which of them Python knows.

const FRESH = "kinlab:fresh-copy";
const NARROW = 800;                                 // px: beside a list of files no lesson has room

// The published edition of each lesson, by its path; kinlab/course/lite.py puts it into the page.
const editions = JSON.parse(document.getElementById("kinlab-editions")?.textContent ?? "{}");

/** @param {any} app JupyterLab; the lesson in front, if one is there */
function lessonIn(app) {
  const { context, content } = app.shell.currentWidget ?? {};
  return context?.path in editions ? { context, content } : {};
}

/**
 * Keep the student's copy under another name, which its tab takes too, and open the lesson anew.
 * @param {any} app
 */
async function freshCopy(app) {
  const { context } = lessonIn(app), { contents } = app.serviceManager;
  if (!context) return;
  const { path } = context;
  await context.save();
  const folder = await contents.get(path.slice(0, Math.max(0, path.lastIndexOf("/"))),
                                    { content: true });
  const taken = folder.content.map((/** @type {any} */ file) => file.path);
  await contents.rename(path, freeName(path, taken));
  await app.commands.execute("docmanager:open", { path });
}

/** @param {string} path @param {string[]} taken */
function freeName(path, taken) {
  const stem = path.replace(/\.ipynb$/, " my copy");
  let name = `${stem}.ipynb`;
  for (let k = 2; taken.includes(name); k++) name = `${stem} ${k}.ipynb`;
  return name;
}

/** @param {any} app @param {Set<string>} told the lessons of which it was said already */
async function sayIfOlder(app, told) {
  const { context, content } = lessonIn(app);
  if (!context) return;
  await context.ready;
  const { path } = context, edition = content.model?.getMetadata("kinlab")?.edition;
  if (told.has(path) || edition === editions[path]) return;
  told.add(path);
  app.commands.execute("apputils:notify", {
    message: "This is your saved copy. A newer version of this lesson is here. "
      + "A fresh copy opens it and keeps yours beside it.",
    type: "info",
    options: { autoClose: false, actions: [{ label: "Fresh copy", commandId: FRESH }] },
  });
}

// Prints the views that Python knows, and leaves no name behind.
const KNOWN = 'print(__import__("json").dumps({k: {"target_name": comm.target_name} for k, comm in '
  + '__import__("comm").get_comm_manager().comms.items()}))';

/**
 * JupyterLite's kernels leave a question for their comms without an answer, and the manager of the
 * widgets waits for it before it shows a saved view.
 * @param {any} kernels
 */
function answerForComms(kernels) {
  const connect = kernels.connectTo.bind(kernels);
  kernels.connectTo = (/** @type {any} */ options) => {
    const kernel = connect(options);
    kernel.requestCommInfo = async () =>
      ({ content: { status: "ok", comms: await commsOf(kernel) } });
    return kernel;
  };
}

/** @param {any} kernel one that has not begun knows of none */
async function commsOf(kernel) {
  if (!["idle", "busy"].includes(kernel.status)) return {};
  let said = "";
  const asked = kernel.requestExecute({ code: KNOWN, silent: true, store_history: false });
  asked.onIOPub = (/** @type {any} */ { content }) => { said += content.text ?? ""; };
  await asked.done;
  return said ? JSON.parse(said) : {};
}

/**
 * On a phone, keep the lists at the sides closed until somebody touches the page.
 * @param {any} app
 */
function makeRoom({ shell }) {
  if (innerWidth >= NARROW) return;
  const close = () => {
    if (!shell.leftCollapsed) shell.collapseLeft();
    if (!shell.rightCollapsed) shell.collapseRight();
  };
  shell.layoutModified.connect(close);
  addEventListener("pointerdown", () => shell.layoutModified.disconnect(close),
                   { once: true, capture: true });
  close();
}

/**
 * Each lesson has a Python of its own, which takes ten seconds to start; at first it is downloaded.
 * @param {any} app
 * @param {WeakSet<any>} told the lessons of which it was said already
 */
async function sayThatPythonStarts(app, told) {
  const { context } = lessonIn(app), session = context?.sessionContext;
  if (!session || told.has(session)) return;
  told.add(session);
  if (session.session?.kernel?.status === "idle") return;
  const id = await app.commands.execute("apputils:notify", {
    message: "Python is starting in this browser. Read on; cells that you run wait for it.",
    type: "in-progress",
    options: { autoClose: false },
  });
  const ready = () => {
    if (session.session?.kernel?.status !== "idle" && !session.isDisposed) return;
    session.statusChanged.disconnect(ready);
    app.commands.execute("apputils:dismiss-notification", { id });
  };
  session.statusChanged.connect(ready);
  ready();
}

/** @param {any} app */
async function begin(app) {
  answerForComms(app.serviceManager.kernels);
  app.commands.addCommand(FRESH, {
    label: "Fresh copy of this lesson",
    caption: "Opens this lesson as it was published; your copy stays, under another name",
    isVisible: () => "content" in lessonIn(app),
    execute: () => freshCopy(app),
  });
  await app.restored;
  makeRoom(app);
  const older = new Set(), starting = new WeakSet();
  const look = () => {
    app.commands.notifyCommandChanged(FRESH);
    sayIfOlder(app, older);
    sayThatPythonStarts(app, starting);
  };
  app.shell.currentChanged.connect(look);
  look();
}

const waiting = setInterval(() => {
  const app = /** @type {any} */ (window).jupyterapp;
  if (!app) return;
  clearInterval(waiting);
  begin(app);
}, 50);
