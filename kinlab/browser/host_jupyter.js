// The script of a view's widget.

import { make } from "./dom.js";
import { keepKeys } from "./notebook_keys.js";
import { afterOthers, keepViews } from "./saved_views.js";
import { showView } from "./widget.js";

/** @import { Host } from "./types.js" */

/** @param {Host} host */
function render({ model, el }) {
  const free = keepKeys(el);
  const leave = model.get("folded")
    ? folded(el, (place) => showView(model, place)) : showView(model, el);
  return () => {
    free();
    leave();
  };
}

/**
 * A view that answers a prediction: it is drawn when it is opened.
 * @param {HTMLElement} el
 * @param {(place: HTMLElement) => () => void} show
 */
function folded(el, show) {
  const place = make("div");
  const answer = make("details", { class: "kl-answer" },
                      make("summary", {}, "The answer. Open it when you have committed yours."),
                      place);
  /** @type {(() => void) | null} */
  let leave = null;
  answer.addEventListener("toggle", () => { leave ??= show(place); });
  el.append(answer);
  return () => leave?.();
}

export default { initialize: keepViews, render: afterOthers(render) };
