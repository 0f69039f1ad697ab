// The script of a page with views and with predictions, whose answers the browser keeps.

import { Listeners } from "./listeners.js";
import { mount } from "./mount.js";
import { startViews } from "./page_views.js";
import { ask } from "./predict.js";
import { readable } from "./verdicts.js";

/** @import { Question, Sheet } from "./types.js" */

const STORE_KEY = "kinlab predictions";                  // in the browser's store

/** What the browser keeps of all predictions: records by name. */
function storedAnswers() {
  try { return JSON.parse(localStorage.getItem(STORE_KEY) ?? "") ?? {}; } catch { return {}; }
}

/**
 * @param {Question} question
 * @returns {Sheet}
 */
function pageSheet(question) {
  const listeners = new Listeners();
  const record = readable(question.cases, storedAnswers()[question.name]);
  let state = { record, case: record.at(-1)?.case ?? 0 };
  return {
    question,
    restored: record.length > 0,
    read: () => state,
    write(answers, now) {
      state = { record: answers, case: now };
      // A page may be kept from storing; the prediction is there until it is closed.
      try {
        const all = { ...storedAnswers(), [question.name]: answers };
        localStorage.setItem(STORE_KEY, JSON.stringify(all));
      } catch { /* no matter */ }
      listeners.tell();
    },
    listen: (listener) => listeners.add(listener),
  };
}

startViews((element, scene, joints, formula, question) => question
  ? ask(element, scene, joints, formula, undefined, pageSheet(question))
  : mount(element, scene, joints, formula));
