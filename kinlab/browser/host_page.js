// Ties the live picture (mount.js) to a plain page: its joints are range inputs beside number
// fields, and the page's address can hold their values.
// @ts-nocheck

import { mount } from "./mount.js";
import { make, toolbar } from "./dom.js";
import { KEYS, clip, snap, stepped } from "./steps.js";

const tidy = (value) => Number(value.toPrecision(6));

/** A slider and a field for one knob; `took` hears what a hand sets, in the knob's units. */
function slider(knob, took) {
  const { scale, digits, suffix, label, title } = knob;
  const units = { low: knob.low / scale, high: knob.high / scale, step: knob.step };
  const ends = { min: tidy(units.low), max: tidy(units.high), step: "any", title: title || label };
  const name = `${label}${title ? `, ${title}` : ""}`;
  const range = make("input", { type: "range", ...ends, "aria-label": name });
  const field = make("input", { type: "number", ...ends, "aria-label": `${name}, number` });
  const row = make("div", { class: "kl-knob" }, make("span", { title: title || label }, label),
    range, field, make("span", { class: "kl-unit" }, suffix.trim()));
  let value = 0;
  const show = (next) => {
    value = next;
    if (range.valueAsNumber !== value) range.value = value;
    range.setAttribute("aria-valuetext", value.toFixed(digits) + suffix);
    if (document.activeElement !== field) field.value = value.toFixed(digits);
  };
  const settle = () => {
    const typed = field.valueAsNumber;
    if (Number.isFinite(typed) && typed.toFixed(digits) !== value.toFixed(digits)) {
      took(clip(typed, units.low, units.high));
    }
    field.value = value.toFixed(digits);
  };
  range.addEventListener("input", () => took(snap(range.valueAsNumber, units)));
  range.addEventListener("keydown", (event) => {
    if (!(event.key in KEYS) || event.ctrlKey || event.metaKey || event.altKey) return;
    took(stepped(value, KEYS[event.key], event.shiftKey, units));
    event.preventDefault();
  });
  field.addEventListener("change", settle);
  field.addEventListener("blur", settle);
  return { row, show };
}

/** The joints of a view in a plain page: their values, their sliders, and who listens. */
function pageJoints(knobs, start) {
  const listeners = new Set();
  let q = start;
  const sliders = knobs.map((knob, i) => slider(knob, (value) =>
    joints.write(q.map((old, k) => (k === i ? value * knob.scale : old)))));
  const joints = {
    rows: sliders.map(({ row }) => row),
    read: () => q,
    write(wanted) {
      q = wanted;
      q.forEach((value, i) => sliders[i].show(value / knobs[i].scale));
      for (const listener of listeners) listener();
    },
    listen(listener) {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
  };
  joints.write(start);
  return joints;
}

// ---- the address: #q=30,40,-20, in the sliders' units ----

const ADDRESS_EVERY = 300;                          // ms; browsers refuse more than 100 in 30 s

const written = (q, knobs) => `#q=${q.map((value, i) => tidy(value / knobs[i].scale)).join(",")}`;

/** The joint values in an address; null if it has none, and words if they do not fit. */
function parsed(hash, knobs) {
  if (!hash.startsWith("#q=")) return null;
  const values = hash.slice(3).replaceAll("%2C", ",").split(",").map((v) => (v ? Number(v) : NaN));
  if (values.length !== knobs.length || !values.every(Number.isFinite)) {
    return `The address should hold ${knobs.length} numbers, as in ` +
           `${written(knobs.map((knob) => knob.home), knobs)}`;
  }
  return values.map((v, i) => clip(v * knobs[i].scale, knobs[i].low, knobs[i].high));
}

function followAddress(knobs, joints, live) {
  const take = () => {
    const q = parsed(location.hash, knobs);
    if (typeof q === "string") return live.note(q);
    if (q && written(q, knobs) !== written(joints.read(), knobs)) joints.write(q);
  };
  let timer = 0;
  const keep = () => {
    timer = 0;
    // A page inside another one, without an address of its own, may not have one written.
    try { history.replaceState(null, "", written(joints.read(), knobs)); } catch { /* no matter */ }
  };
  take();
  joints.listen(() => { timer ||= setTimeout(keep, ADDRESS_EVERY); });
  window.addEventListener("hashchange", take);
}

/** Copy the address with the joint values; of a page on one's own disk only its end. */
async function copyLink(knobs, joints, live) {
  const end = written(joints.read(), knobs), published = /^https?:/.test(location.protocol);
  const text = published ? location.href.split("#")[0] + end : end;
  const advice = published ? "" : " This page is a file: put that behind the address where it is " +
                                  "published.";
  try {
    await navigator.clipboard.writeText(text);
    live.note(`Copied ${published ? "the link" : text}.${advice}`);
  } catch {
    live.note(`Copy this by hand: ${text}${published ? "" : ` .${advice}`}`);
  }
}

// ---- every view of the page ----

function start(view) {
  const { scene, q } = JSON.parse(view.querySelector("script[type='application/json']").text);
  const still = view.querySelector(".kl-still"), svg = still.innerHTML;
  const joints = pageJoints(scene.joints, q), place = make("div", {});
  still.remove();
  view.prepend(place, make("div", { class: "kl-joints" }, ...joints.rows));
  const live = mount(place, svg, scene, joints);
  if (!("address" in view.dataset)) return;
  followAddress(scene.joints, joints, live);
  const share = toolbar([["Share", ["Copy link", "Copy a link to this pose",
    () => copyLink(scene.joints, joints, live)]]]);
  view.querySelector(".kl-toolbar").append(share.firstChild);
}

document.querySelectorAll(".kl-view").forEach(start);
