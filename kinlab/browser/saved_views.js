// Keeps in a saved notebook what its views hold, and what was predicted. This is the one place
// that reaches into JupyterLab's notebook: no interface tells a widget that it is being saved.

const STATE = "application/vnd.jupyter.widget-state+json";
const VIEW = "application/vnd.jupyter.widget-view+json";
const keeping = new WeakSet();

/**
 * Save with a notebook what its widgets hold: opened again, and not run, its views still move.
 *
 * JupyterLab's own setting for this forgets the views of a notebook that is opened and not run.
 * @param {any} manager
 */
export function keepViews(manager) {
  const context = manager?.context;                 // a notebook of JupyterLab, or nothing
  if (!context?.model.setMetadata || keeping.has(manager)) return;
  keeping.add(manager);
  context.saveState.connect((/** @type {any} */ _, /** @type {string} */ phase) => {
    if (phase !== "started") return;
    const all = { ...context.model.getMetadata("widgets")?.[STATE]?.state,
                  ...manager.get_state_sync({ drop_defaults: true }).state };
    /** @type {Record<string, object>} */
    const state = {};
    const keep = (/** @type {string} */ id) => {
      if (!all[id] || state[id]) return;
      state[id] = all[id];
      for (const [, inner] of JSON.stringify(all[id]).matchAll(/"IPY_MODEL_(.*?)"/g)) keep(inner);
    };
    for (const { outputs = [] } of context.model.toJSON().cells) {
      for (const output of outputs) keep(output.data?.[VIEW]?.model_id);
    }
    context.model.setMetadata("widgets",
      { [STATE]: { version_major: 2, version_minor: 0, state } });
  });
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
