// The script of a prediction's widget: its answers are the widget's, and the notebook keeps them.

import { keepKeys } from "./notebook_keys.js";
import { ask } from "./predict.js";
import { afterOthers, keepViews, keptAnswers } from "./saved_views.js";
import { readable } from "./verdicts.js";
import { showView } from "./widget.js";

/** @import { Host, Model, Sheet } from "./types.js" */

/**
 * @param {Model} model
 * @returns {Sheet}
 */
function modelSheet(model) {
  const question = model.get("question"), notebook = keptAnswers(model.widget_manager);
  const told = () => readable(question.cases, model.get("record"));
  const known = readable(question.cases, notebook.read(question.name));
  const restored = !told().length && known.length > 0;
  const write = (/** @type {any[]} */ record, /** @type {number} */ now) => {
    model.set("case", now);
    model.set("record", record);
    model.save_changes();
    notebook.write(question.name, record);
  };
  if (restored) write(known, known[known.length - 1].case);
  return {
    question, restored, write,
    read: () => ({ record: told(), case: model.get("case") }),
    listen(callback) {
      const names = ["change:record", "change:case"];
      names.forEach((name) => model.on(name, callback));
      return () => names.forEach((name) => model.off(name, callback));
    },
  };
}

/** @param {Host} host */
function render({ model, el }) {
  const sheet = modelSheet(model), free = keepKeys(el);
  const leave = showView(model, el, undefined, (place, scene, joints, formula = "", _, pointing) =>
    ask(place, scene, joints, formula, pointing, sheet));
  return () => {
    free();
    leave();
  };
}

export default { initialize: keepViews, render: afterOthers(render) };
