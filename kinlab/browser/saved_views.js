// Keeps in a saved notebook what its views hold, and what was predicted. This is the one place
// that reaches into JupyterLab's notebook: no interface tells a widget that it is being saved.

const STATE = "application/vnd.jupyter.widget-state+json";
const VIEW = "application/vnd.jupyter.widget-view+json";
const NAMED = "IPY_MODEL_";                       // how a state names another model
const MANAGERS = Symbol.for("kinlab.managers");
const LOOKS = 100;                                  // ms until an output looks for its model again

/** @import { Host } from "./types.js" */
/** @typedef {(id: string) => any} States gives the state of a model, or nothing */

/**
 * The widget managers of open notebooks whose views are kept, when their outputs are looked after,
 * and whether they have restored what was saved: they forget that when the kernel starts anew.
 * Each view has this script for itself, so they are the page's.
 * @returns {Map<any, { timer?: number, restored?: boolean }>}
 */
const managers = () => /** @type {any} */ (globalThis)[MANAGERS] ??= new Map();

/** Layouts of views that were there before the page; a layout is a model's own. */
const restored = new WeakSet();

/**
 * Draws a view that a notebook was opened with after all its outputs have found their models.
 * They look every LOOKS ms for two seconds: a slow drawing would let that time pass.
 * @template {Pick<Host, "model">} T
 * @param {(host: T) => (() => void)} render
 * @returns {(host: T) => (() => void) | Promise<() => void>}
 */
export const afterOthers = (render) => (host) => restored.has(host.model.get("layout"))
  ? new Promise((done) => { setTimeout(() => done(render(host)), LOOKS); }) : render(host);

/**
 * Save with a notebook what its widgets hold: opened again, and not run, its views still move.
 *
 * JupyterLab's own setting for this forgets the views to which no Python listens.
 * @param {Pick<Host, "model">} host
 */
export function keepViews({ model }) {
  const manager = model.widget_manager;
  if (!manager?.context?.model.setMetadata) return;
  const layout = model.get("layout"), own = keepNotebook(manager);
  if (!own.restored || !layout.comm_live) restored.add(layout);
  clearTimeout(own.timer);
  own.timer = setTimeout(() => showAgain(manager), LOOKS);
}

/**
 * Look after the views of a manager's notebook, from now on.
 * @param {any} manager
 */
function keepNotebook(manager) {
  const before = managers().get(manager), { context } = manager;
  if (before) return before;
  /** @type {{ timer?: number, restored?: boolean }} */
  const own = { restored: manager.restoredStatus };
  manager.restored.connect(() => { own.restored = true; });
  managers().set(manager, own);
  context.disposed.connect(() => managers().delete(manager));
  lookAround(Object.getPrototypeOf(manager));
  let again = false;
  context.saveState.connect((/** @type {any} */ _, /** @type {string} */ phase) => {
    if (phase !== "started") return;
    const coming = storeViews(manager);
    if (!coming.length || again) return;
    again = true;                                   // saved once more as soon as they are there
    Promise.all(coming.map((id) => manager.get_model(id))).then(() => context.save(), () => {})
      .finally(() => { again = false; });
  });
  return own;
}

/**
 * Write the states of the views that are shown into the notebook, and of nothing else. A view
 * without a state would be an error when the notebook is opened: its picture stays.
 * @param {any} manager
 * @returns {string[]} the models of views that are still on their way
 */
function storeViews(manager) {
  const notebook = manager.context.model, states = statesOf(manager);
  /** @type {Record<string, object>} */
  const state = {};
  /** @type {Set<string>} */
  const coming = new Set();
  for (const { id, leaveOut } of shown(notebook)) {
    const parts = allOf(id, states) ?? allOf(id, elsewhere());
    if (parts) Object.assign(state, parts);
    else if (manager.has_model(id)) coming.add(id);
    else leaveOut();
  }
  if (Object.keys(state).length) {
    notebook.setMetadata("widgets", { [STATE]: { version_major: 2, version_minor: 0, state } });
  } else notebook.deleteMetadata("widgets");
  return [...coming];
}

/**
 * The states of a manager's models, whether or not Python listens to them. Those that it cannot
 * restore here, and those not restored yet, are as they were saved before.
 * @param {any} manager
 * @returns {States}
 */
function statesOf(manager) {
  const saved = manager.context.model.getMetadata("widgets")?.[STATE]?.state ?? {};
  const models = [...manager._modelsSync.values()]
    .filter((model) => model.get("_view_name") !== "ErrorWidgetView")
    .map((model) => Object.create(model, { comm_live: { value: true } }));
  const held = manager.get_state_sync.call({ _modelsSync: new Set(models) },
                                           { drop_defaults: true }).state;
  return (id) => held[id] ??
    (manager.has_model(id) || !managers().get(manager)?.restored ? saved[id] : undefined);
}

/**
 * The states of all models in the page's notebooks.
 * @returns {States}
 */
function elsewhere() {
  const all = [...managers().keys()].filter((one) => one.context).map(statesOf);
  return (id) => all.reduce((found, states) => found ?? states(id), undefined);
}

/**
 * The state of a model and of all that it refers to, by id; nothing if one is missing. Of a list,
 * as of a box's children, those that are left are enough.
 * @param {string} id
 * @param {States} states
 * @param {Record<string, object>} [found]
 * @returns {Record<string, object> | null}
 */
function allOf(id, states, found = {}) {
  if (found[id]) return found;
  /** @type {string[]} */
  const inner = [];
  const named = (/** @type {unknown} */ value) => typeof value === "string" &&
    value.startsWith(NAMED) ? value.slice(NAMED.length) : "";
  const there = (/** @type {unknown} */ value) => !named(value) || states(named(value));
  const text = JSON.stringify(states(id), (_, value) => {
    if (named(value)) inner.push(named(value));
    return Array.isArray(value) ? value.filter(there) : value;
  });
  if (!text) return null;
  found[id] = JSON.parse(text);
  return inner.every((name) => allOf(name, states, found)) ? found : null;
}

/**
 * The views in a notebook's outputs: their models, and how to show one again or to leave it out.
 * @param {any} notebook
 */
function* shown(notebook) {
  for (const { outputs } of notebook.cells) {
    for (const [k, output] of (outputs?.toJSON() ?? []).entries()) {
      const { [VIEW]: view, ...data } = output.data ?? {};
      // A widget that Python has closed has lost its name. Opened again, it shows nothing.
      if (!view || (!view.model_id && !data["image/png"])) continue;
      yield { id: view.model_id, again: () => outputs.set(k, output),
              leaveOut: () => outputs.set(k, { ...output, data: { "text/plain": "", ...data } }) };
    }
  }
}

/**
 * Show outputs again that gave up just before their models came, as they do on a slow machine.
 * @param {any} manager
 */
function showAgain(manager) {
  const lost = [...document.querySelectorAll(".jp-OutputArea-output")].some((output) =>
    output.textContent === "Error displaying widget: model not found" ||
    output.querySelector(".kl-still"));             // labextension/ puts that into its place
  if (!lost || manager.context?.isDisposed !== false) return;
  [...shown(manager.context.model)].forEach(({ id, again }) => manager.has_model(id) && again());
}

/**
 * In all notebooks of this page: a view that came in with a copied cell moves there too, and
 * one whose model is nowhere leaves its place to its picture.
 * @param {any} prototype of the page's widget managers
 */
function lookAround(prototype) {
  const find = prototype.get_model;
  if (find[MANAGERS]) return;
  /** @this {any} @param {string} id */
  async function get_model(id) {
    const manager = this;
    const ready = () => manager.context && (managers().get(manager)?.restored ??
                                            manager.restoredStatus);
    const bring = async () => {
      const state = manager.context && !manager.has_model(id) && allOf(id, elsewhere());
      if (state) keepNotebook(manager);             // saved with it from now on
      if (state && ready())
        await manager.set_state({ version_major: 2, version_minor: 0, state });
    };
    await bring();
    try {
      return await find.call(manager, id);
    } catch (error) {
      await bring();                                // it may have come at the last moment
      if (manager.has_model(id)) return find.call(manager, id);
      const here = ready() ? [...shown(manager.context.model)].filter((one) => one.id === id) : [];
      if (!here.length) throw error;
      here.forEach(({ leaveOut }) => leaveOut());
      return new Promise(() => {});                 // nobody waits for it any more
    }
  }
  prototype.get_model = Object.assign(get_model, { [MANAGERS]: true });
}

const OURS = "kinlab";                              // in the notebook's metadata

/**
 * The answers to predictions that a notebook keeps: run again, it still has them. Elsewhere nothing
 * is kept beside the widget itself.
 * @param {any} manager
 */
export function keptAnswers(manager) {
  const notebook = manager?.context?.model;
  const all = () => notebook?.getMetadata?.(OURS)?.predictions ?? {};
  return {
    /** @type {(name: string) => any[]} */
    read: (name) => Array.isArray(all()[name]) ? all()[name] : [],
    /** @type {(name: string, record: object[]) => void} */
    write(name, record) {
      notebook?.setMetadata?.(OURS, { ...notebook.getMetadata(OURS),
        predictions: { ...all(), [name]: record } });
    },
  };
}
