// The joints of a widget's model: who hears of what, how often, and who gives way.
import assert from "node:assert/strict";
import { mock, test } from "node:test";

import { modelJoints } from "../../../kinlab/browser/widget.js";

const DEGREE = Math.PI / 180;
const KNOBS = [{ name: "theta_1", scale: DEGREE }, { name: "d_2", scale: 1 }];

/** A model as anywidget gives it, that remembers what it was told and what it sent. */
function fakeModel(state) {
  const heard = new Map(), sent = [];
  let unsent = {};
  const set = (name, value) => {
    if (state[name] === value) return;
    state[name] = value;
    for (const callback of heard.get(`change:${name}`) ?? []) callback();
  };
  return {
    sent,
    get: (name) => state[name],
    set(name, value) { unsent[name] = value; set(name, value); },
    save_changes() { sent.push(unsent); unsent = {}; },
    on(event, callback) { heard.set(event, [...heard.get(event) ?? [], callback]); },
    off(event, callback) { heard.set(event, heard.get(event).filter((one) => one !== callback)); },
    /** What comes from Python: all values are there before anybody hears of one. */
    receive(values) {
      Object.assign(state, values);
      for (const name of Object.keys(values)) {
        for (const callback of heard.get(`change:${name}`) ?? []) callback();
      }
    },
    listeners: () => [...heard.values()].flat().length,
  };
}

function joints(state = { theta_1: 30, d_2: 0.5, note: "" }, listening = () => true) {
  const model = fakeModel(state), made = modelJoints(model, KNOBS, listening);
  return { model, made };
}

const microtasks = () => new Promise((done) => { setImmediate(done); });

test("values are in the scene's units, and a hand's go to the model in the slider's", () => {
  const { model, made } = joints();
  assert.deepEqual(made.read(), [30 * DEGREE, 0.5]);
  made.write([45 * DEGREE, 0.5]);
  assert.equal(model.get("theta_1"), 45);
  assert.equal(model.get("d_2"), 0.5);
  made.leave();
});

test("a drag is told ten times a second, and always its last value", () => {
  mock.timers.enable({ apis: ["setTimeout"] });
  const { model, made } = joints();
  for (let k = 1; k <= 60; k++) {                    // a second, sixty moves
    made.write([k * DEGREE, 0.5]);
    mock.timers.tick(1000 / 60);
  }
  mock.timers.tick(1000);
  assert.ok(model.sent.length >= 9 && model.sent.length <= 11, `${model.sent.length} messages`);
  assert.equal(model.sent.at(-1).theta_1, 60);
  assert.deepEqual(Object.keys(model.sent.at(-1)), ["theta_1"]);   // what did not move is not told
  mock.timers.reset();
  made.leave();
});

test("several joints set at once are heard of once", async () => {
  const { model, made } = joints();
  const seen = [];
  made.listen(() => seen.push(made.read()));
  model.receive({ theta_1: 10, d_2: 0.2 });
  await microtasks();
  assert.deepEqual(seen, [[10 * DEGREE, 0.2]]);
  made.leave();
});

test("what the hand has not told yet is not moved back by an older value", async () => {
  mock.timers.enable({ apis: ["setTimeout"] });
  const { model, made } = joints();
  made.write([31 * DEGREE, 0.5]);                    // told at once
  made.write([32 * DEGREE, 0.5]);                    // waits
  model.receive({ theta_1: 31, d_2: 0.3 });          // an echo, and a joint that Python has moved
  await microtasks();
  assert.deepEqual(made.read(), [32 * DEGREE, 0.3]);
  assert.equal(model.get("theta_1"), 32);
  mock.timers.tick(100);
  assert.equal(model.sent.at(-1).theta_1, 32);
  model.receive({ theta_1: 20 });                    // from now on Python may move it
  await microtasks();
  assert.deepEqual(made.read(), [20 * DEGREE, 0.3]);
  mock.timers.reset();
  made.leave();
});

test("a value from Python stays exact where the hand moves another joint", () => {
  const { model, made } = joints({ theta_1: 7.073552, d_2: 0.5, note: "" });
  const [first] = made.read();
  made.write([first, 0.25]);
  assert.equal(model.get("theta_1"), 7.073552);
  assert.deepEqual(model.sent, [{ d_2: 0.25 }]);
  made.leave();
});

test("a hand's move takes back what was remarked about the setting before", () => {
  const { model, made } = joints({ theta_1: 30, d_2: 0.5, note: "θ₁ stops at its limit" });
  made.write([0, 0.5]);
  assert.equal(model.get("note"), "");
  made.leave();
});

test("without Python nothing is sent, and the joints still move", () => {
  const { model, made } = joints(undefined, () => false);
  made.write([1, 1]);
  assert.deepEqual(model.sent, []);
  assert.deepEqual(made.read(), [1, 1]);
  made.leave();
});

test("who leaves tells what is left, and hears nothing more", () => {
  mock.timers.enable({ apis: ["setTimeout"] });
  const { model, made } = joints();
  made.write([31 * DEGREE, 0.5]);
  made.write([32 * DEGREE, 0.5]);
  made.leave();
  assert.equal(model.sent.at(-1).theta_1, 32);
  const messages = model.sent.length;
  mock.timers.tick(1000);
  assert.equal(model.sent.length, messages);
  assert.equal(model.listeners(), 0);
  mock.timers.reset();
});

test("a joint that a hand holds is moved by nobody else", async () => {
  mock.timers.enable({ apis: ["setTimeout"] });
  const { model, made } = joints();
  made.gripped.add("theta_1");
  made.write([47 * DEGREE, 0.5]);
  mock.timers.tick(1000);                            // told long ago, and the hand is still there
  model.receive({ theta_1: 11, d_2: 0.2 });
  await microtasks();
  assert.deepEqual(made.read(), [47 * DEGREE, 0.2]);
  mock.timers.tick(200);
  assert.equal(model.sent.at(-1).theta_1, 47);       // Python hears where the hand is
  made.gripped.delete("theta_1");
  model.receive({ theta_1: 11 });
  await microtasks();
  assert.deepEqual(made.read(), [11 * DEGREE, 0.2]);
  mock.timers.reset();
  made.leave();
});
