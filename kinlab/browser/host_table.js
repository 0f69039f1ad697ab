// The script of the table editor's widget: the table, the panel under it, and the live arm.

import { make } from "./dom.js";
import { lightUp, pointFrom, walkThrough } from "./hover.js";
import { keepKeys } from "./notebook_keys.js";
import { Pointing } from "./pointing.js";
import { afterOthers, keepViews } from "./saved_views.js";
import { letScroll } from "./scrolls.js";
import { showTable } from "./table.js";
import { showView } from "./widget.js";

/** @import { Host } from "./types.js" */

/** @param {Host} host */
function render({ model, el }) {
  const table = make("div"), panel = make("div", { class: "kl-panel" }), arm = make("div");
  const pointing = new Pointing(), beside = [table, panel];
  const light = () => beside.forEach((part) => lightUp(part, pointing.now));
  const fill = () => {
    panel.innerHTML = model.get("panel");           // HTML that kinlab has made
    walkThrough(panel);
    light();
  };
  el.classList.add("kl-editor");
  el.append(table, panel, arm);
  fill();
  letScroll(panel);
  model.on("change:panel", fill);
  const ends = [keepKeys(el), showTable(model, table, light), showView(model, arm, pointing),
                pointing.listen(light), ...beside.map((part) => pointFrom(part, pointing))];
  return () => {
    model.off("change:panel", fill);
    ends.forEach((end) => end());
  };
}

export default { initialize: keepViews, render: afterOthers(render) };
