// Moves the SVG that matplotlib drew. `mount` knows nothing of Jupyter: it takes the SVG, the
// scene (kinlab/drawing/scene.py) and the joints to read, write and listen to. host_jupyter.js ties it to
// ipywidgets' sliders.

// ---- geometry: the frame recurrence of kinlab/arms/motions.py, projected as in kinlab/drawing/figure.py ----

const ROTATE = 0, VELOCITY = 2;

const run = (since) => Math.min(1, Math.max(0, since));

/** What a list holds at 0, 1, 2, ..., and straight between them. */
function between(track, place) {
  const at = Math.max(0, Math.min(track.length - 1, place)), k = Math.floor(at);
  return track[k] + (at - k) * ((track[k + 1] ?? track[k]) - track[k]);
}

/** How far a motion goes: amount + gain q, as far as knobs have scrubbed it. */
function travel([, , amount, joint, gain, start, , scrub, track], q) {
  if (track) return between(track, q[joint]);
  const share = scrub ? run(q[scrub[0]] - scrub[1]) : 1;
  if (joint < 0) return share * amount;
  return share * (amount + gain * (start === null ? q[joint] : run(q[joint] - start)));
}

/** Every frame along the motions at the knobs' values q: [x, y, z, origin], each a triple. */
export function frames(motions, q) {
  const all = [[[1, 0, 0], [0, 1, 0], [0, 0, 1], [0, 0, 0]]];
  for (const motion of motions) {
    if (motion[0] === VELOCITY) { all.push(velocityFrame(motions, all, motion)); continue; }
    const [kind, axis] = motion, value = travel(motion, q), frame = all[motion[6]].slice();
    if (kind === ROTATE) {
      const i = (axis + 1) % 3, j = (axis + 2) % 3, c = Math.cos(value), s = Math.sin(value);
      const [u, v] = [frame[i], frame[j]];
      frame[i] = u.map((_, k) => c * u[k] + s * v[k]);
      frame[j] = u.map((_, k) => c * v[k] - s * u[k]);
    } else {
      frame[3] = frame[3].map((o, k) => o + value * frame[axis][k]);
    }
    all.push(frame);
  }
  return all;
}

const dot = (u, v) => u.reduce((sum, e, k) => sum + e * v[k], 0);
const cross = ([a, b, c], [d, e, f]) => [b * f - c * e, c * d - a * f, a * e - b * d];

/** Velocity of a frame's origin for a unit rate of each of n knobs, as kinlab/drawing/velocity.py. */
export function velocities(motions, all, of, n) {
  const columns = Array.from({ length: n }, () => [0, 0, 0]), tip = all[of][3];
  for (let k = of; k > 0; k = motions[k - 1][6]) {
    const [kind, axis, , joint, gain] = motions[k - 1], direction = all[k][axis];
    if (joint < 0) continue;
    const arm = tip.map((e, i) => e - all[k][3][i]);
    const turning = kind === ROTATE ? cross(direction, arm) : direction;
    columns[joint] = columns[joint].map((e, i) => e + gain * turning[i]);
  }
  return columns;
}

/** The end of a Jacobian's column, or the ellipsoid of all velocities. */
function velocityFrame(motions, all, [, of, rates, joint]) {
  const tip = all[of][3];
  const columns = velocities(motions, all, of, rates.length)
    .map((column, i) => column.map((e) => e * rates[i]));
  if (joint >= 0) return [...all[0].slice(0, 3), tip.map((e, k) => e + columns[joint][k])];
  return [...root([0, 1, 2].map((i) => [0, 1, 2].map((j) =>
    columns.reduce((sum, column) => sum + column[i] * column[j], 0)))), tip];
}

/** Columns of the lower triangle L with L Lᵀ = square; a direction that is flat gets zeros. */
function root(square) {
  const columns = [0, 1, 2].map(() => [0, 0, 0]), size = square[0][0] + square[1][1] + square[2][2];
  columns.forEach((column, k) => {
    const left = square.map((row, i) => row[k] - columns.reduce((sum, c) => sum + c[i] * c[k], 0));
    if (left[k] <= 1e-12 * size) return;
    for (let i = k; i < 3; i++) column[i] = left[i] / Math.sqrt(left[k]);
  });
  return columns;
}

/** A frame as another frame sees it. */
const seenFrom = ([x, y, z, o], [u, v, w, p]) =>
  [x, y, z, o.map((e, k) => e - p[k])].map((column) => [u, v, w].map((e) => dot(e, column)));

const inRoom = ([x, y, z, o], [a, b, c]) => o.map((_, k) => o[k] + a * x[k] + b * y[k] + c * z[k]);

/** The picture's right and up as directions of the room. */
function screenAxes(camera) {
  const [a, e] = [camera.azimuth, camera.elevation].map((angle) => angle * Math.PI / 180);
  const [ca, sa, ce, se] = [Math.cos(a), Math.sin(a), Math.cos(e), Math.sin(e)];
  return [[-sa, ca, 0], [-se * ca, -se * sa, ce]];
}

/** A function that takes points of the room to [right, down, nearness] on the picture. */
export function projector(scene, camera) {
  const [a, e] = [camera.azimuth, camera.elevation].map((angle) => angle * Math.PI / 180);
  const [ca, sa, ce, se] = [Math.cos(a), Math.sin(a), Math.cos(e), Math.sin(e)];
  const [[right, down], scale] = [scene.place, scene.scale * camera.zoom];
  return (p) => {
    const [x, y, z] = p.map((v, k) => v - scene.center[k]);
    const forward = ca * x + sa * y;
    return [right + scale * (ca * y - sa * x),
            down - scale * (ce * z - se * forward), ce * forward + se * z];
  };
}

const corner = ([x, y]) => `${x.toFixed(2)} ${y.toFixed(2)}`;
const polyline = (points) => `M ${points.map(corner).join(" L ")}`;

function face(points) {
  const area = points.reduce((sum, [x, y], k) => {
    const [u, v] = points[(k + 1) % points.length];
    return sum + x * v - u * y;
  }, 0);
  return area < 0 ? `${polyline(points)} Z` : "";   // y points down
}

function arrow([tail, tip]) {
  const [dx, dy] = [tip[0] - tail[0], tip[1] - tail[1]], length = Math.hypot(dx, dy);
  const [ux, uy] = length > 1e-9 ? [dx / length, dy / length] : [0, 0];
  const head = Math.min(9, 0.5 * length), side = 0.36 * head;
  const neck = [tip[0] - head * ux, tip[1] - head * uy];
  const wing = (s) => [neck[0] - s * side * uy, neck[1] + s * side * ux];
  return polyline([tail, neck, wing(1), tip, wing(-1), neck, tail]);
}

const turn = (o, a, b) => (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);

function hull(points) {                             // Andrew's monotone chain
  const ordered = [...points].sort((p, q) => p[0] - q[0] || p[1] - q[1]);
  const half = (chain) => {
    const kept = [];
    for (const p of chain) {
      while (kept.length > 1 && turn(kept.at(-2), kept.at(-1), p) <= 0) kept.pop();
      kept.push(p);
    }
    return kept.slice(0, -1);
  };
  return `${polyline([...half(ordered), ...half(ordered.reverse())])} Z`;
}

const PATHS = { line: polyline, trace: polyline, face, arrow, solid: hull };

// ---- picture: sets the SVG's attributes, and puts nearer groups over farther ones ----

const TRACE_LENGTH = 4000;
const PAPER = { azimuth: -90, elevation: 90, zoom: 1 };   // x to the right, y up

class Picture {
  constructor(svg, scene) {
    this.svg = svg;
    this.scene = scene;
    this.items = scene.items.map((item) => {
      const group = svg.getElementById(item.gid);
      group.classList.add(`kl-${item.style}`, `kl-shape-${item.shape}`);
      return { ...item, group, node: group.querySelector(item.shape === "text" ? "text" : "path") };
    });
    this.bodies = this.items.filter((item) => item.body >= 0);
    this.parent = this.items[0].group.parentNode;
    this.order = "";
    this.path = [];
    this.reset(Object.keys(scene.presets)[0]);
  }

  reset(preset) {
    const [azimuth, elevation] = this.scene.presets[preset];
    this.camera = { azimuth, elevation, zoom: 1 };
  }

  show(layer, visible) {
    if (layer === "trace") this.path = [];
    for (const { group } of this.items.filter((item) => item.layer === layer)) {
      group.style.display = visible ? "" : "none";
    }
  }

  draw(q) {
    const { motions, focus, tip, center } = this.scene, at = this.at = frames(motions, q);
    const middle = focus === null ? center : at[focus][3];
    const project = projector({ ...this.scene, center: middle }, this.camera);
    const onPaper = projector({ ...this.scene, center: middle }, PAPER);
    const depths = new Map();
    this.follow(at[tip][3]);
    for (const item of this.items) {
      const room = item.shape === "trace" ? this.path
        : item.points.map(([k, ...local]) => inRoom(at[k], local));
      const points = room.map(item.paper ? onPaper : project);
      this.set(item, points);
      if (item.body >= 0) {
        const near = item.lift + points.reduce((sum, p) => sum + p[2], 0) / points.length;
        depths.set(item.body, [...(depths.get(item.body) ?? []), near]);
      }
    }
    this.stack(depths);
    return at;
  }

  set({ shape, node }, points) {
    if (shape !== "text") return node.setAttribute("d", PATHS[shape](points));
    const [x, y] = points[0];
    node.removeAttribute("transform");
    node.setAttribute("x", x.toFixed(2));
    node.setAttribute("y", (y + 4).toFixed(2));    // half the height of the letters
  }

  follow(tip) {
    const last = this.path.at(-1);
    if (last && Math.hypot(...tip.map((v, k) => v - last[k])) * this.scene.scale < 0.2) return;
    this.path.push(tip);
    if (this.path.length > TRACE_LENGTH) this.path.shift();
  }

  stack(depths) {
    const mean = new Map([...depths].map(([body, near]) =>
      [body, near.reduce((sum, d) => sum + d, 0) / near.length]));
    const sorted = [...this.bodies].sort((a, b) => mean.get(a.body) - mean.get(b.body));
    const order = sorted.map((item) => item.body).join();
    if (order === this.order) return;
    this.order = order;
    this.parent.append(...sorted.map((item) => item.group));
  }
}

// ---- pointers and keys: drag or arrows orbit; wheel, pinch or +/- zoom; double click resets ----

function orbit(box, picture, redraw, resetView, grab) {
  const flat = Object.keys(picture.scene.presets).length === 1;   // a plane is seen from above
  const rotate = (right, up) => {
    if (flat) return;
    const camera = picture.camera;
    camera.azimuth -= right;
    camera.elevation = Math.max(-90, Math.min(90, camera.elevation + up));
    redraw();
  };
  const zoom = (factor) => {
    picture.camera.zoom = Math.max(0.4, Math.min(8, picture.camera.zoom * factor));
    redraw();
  };
  const held = new Map();                          // where each finger or the mouse is
  const spread = () => {
    const [[x, y], [u, v]] = held.values();
    return Math.max(1, Math.hypot(x - u, y - v));
  };
  let scrolled = 0, carry = null;
  // A page scrolls on past a flat picture in which nothing can be taken hold of.
  box.style.touchAction = flat && !grab ? "pan-y" : "none";
  box.addEventListener("pointerdown", (event) => {
    carry = held.size ? null : grab?.(event);
    held.set(event.pointerId, [event.clientX, event.clientY]);
    box.setPointerCapture(event.pointerId);
  });
  box.addEventListener("pointermove", (event) => {
    if (!held.has(event.pointerId)) return;
    const [x, y] = held.get(event.pointerId), before = held.size === 2 && spread();
    held.set(event.pointerId, [event.clientX, event.clientY]);
    if (held.size === 1 && carry) carry(event);
    else if (held.size === 1) rotate((event.clientX - x) * 0.5, (event.clientY - y) * 0.5);
    if (before) zoom(spread() / before);
  });
  for (const end of ["pointerup", "pointercancel"]) {
    box.addEventListener(end, (event) => {
      held.delete(event.pointerId);
      carry = null;
    });
  }
  box.addEventListener("dblclick", resetView);
  box.addEventListener("wheel", (event) => {
    if (event.timeStamp - scrolled < 250) { scrolled = event.timeStamp; return; }
    event.preventDefault();
    zoom(Math.exp(-event.deltaY * 0.0015));
  }, { passive: false });
  // A page that is being scrolled past the picture goes on scrolling.
  const elsewhere = (event) => { if (!box.contains(event.target)) scrolled = event.timeStamp; };
  document.addEventListener("wheel", elsewhere, { passive: true, capture: true });
  const keys = {
    ArrowLeft: () => rotate(-5, 0), ArrowRight: () => rotate(5, 0),
    ArrowUp: () => rotate(0, 5), ArrowDown: () => rotate(0, -5),
    "+": () => zoom(1.15), "=": () => zoom(1.15), "-": () => zoom(1 / 1.15), 0: resetView,
  };
  box.addEventListener("keydown", (event) => {
    if (!keys[event.key] || event.ctrlKey || event.metaKey || event.altKey) return;
    keys[event.key]();
    event.preventDefault();
    event.stopPropagation();                       // the notebook has uses for these keys too
  });
  return () => document.removeEventListener("wheel", elsewhere, { capture: true });
}

const GRASP = 26;                                   // px: a finger's width

/** Takes hold of the target under the pointer; in a plane the target comes to the pointer. */
function grasp(picture, chase) {
  const { scene, svg } = picture, { frame } = scene.target;
  return (event) => {
    const at = (e) => new DOMPoint(e.clientX, e.clientY).matrixTransform(svg.getScreenCTM().inverse());
    const place = picture.at[frame][3], [x, y] = projector(scene, picture.camera)(place);
    const hand = at(event), far = Math.hypot(hand.x - x, hand.y - y) > GRASP;
    if (far && Object.keys(scene.presets).length > 1) return null;
    const [right, up] = screenAxes(picture.camera), scale = scene.scale * picture.camera.zoom;
    const offset = far ? [0, 0] : [hand.x - x, hand.y - y];
    const take = (e) => {
      const now = at(e), across = (now.x - offset[0] - x) / scale, above = (y + offset[1] - now.y) / scale;
      chase.to(place.map((v, k) => v + across * right[k] + above * up[k]));
    };
    if (far) take(event);
    return take;
  };
}

/** What the error of a chased target is, and what the last solve took. */
function missed(scene, all, solved) {
  const { frame, tip, unit } = scene.target, gap = all[frame][3].map((v, k) => v - all[tip][3][k]);
  const error = Math.hypot(...gap), far = error > 1e-4 * scene.radius;
  const taken = solved ? ` after ${solved.steps} iteration${solved.steps === 1 ? "" : "s"}` : "";
  return `error |p* − p| = ${number(error, scene.decimals)} ${unit}${taken}` +
    (far && solved ? ": the arm gets no nearer from here" : "");
}

// ---- panels: buttons, the table of the tool's pose, the line of remarks ----

const make = (tag, attributes = {}, ...children) => {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  node.append(...children);
  return node;
};

function toolbar(groups) {
  const bar = make("div", { class: "kl-toolbar", role: "toolbar", "aria-label": "View" });
  for (const [label, ...buttons] of groups) {
    const group = make("span", { class: "kl-group", role: "group", "aria-label": label });
    for (const [text, title, action] of buttons) {
      const button = make("button", { type: "button", class: "kl-button", title }, text);
      button.addEventListener("click", () => action(button));
      group.append(button);
    }
    bar.append(group);
  }
  return bar;
}

function number(value, decimals) {
  const text = value.toFixed(decimals);
  return Number(text) === 0 ? (0).toFixed(decimals) : text.replace("-", "\u2212");
}

/** The matrix of the tip's frame: axes and origin as columns, or only `rows` axes as columns. */
function poseTable(pose) {
  const rows = pose.rows ?? pose.columns.length - 1;   // 3 in space, 2 in the plane
  const whole = pose.columns.length > rows;            // with an origin and a last row
  const sources = [...Array(rows).keys(), 3];       // the frame's axes, then its origin
  const style = (k) => ({ class: k < rows ? `kl-column-${"xyz"[k]}` : "kl-column-o" });
  const head = make("tr", {}, ...pose.columns.map(({ name, title }, k) =>
    make("th", { ...style(k), scope: "col", title },
         k === rows && pose.unit ? `${name} (${pose.unit})` : name)));
  const cells = pose.columns.map(() => pose.columns.map((_, k) => make("td", style(k))));
  const table = make("table", { class: "kl-pose" }, make("caption", {}, pose.title),
    make("thead", {}, head),
    make("tbody", {}, ...cells.map((row) => make("tr", {}, ...row))));
  cells[rows]?.forEach((cell, k) => { cell.textContent = k < rows ? "0" : "1"; });
  const update = (frame) => {
    cells.slice(0, rows).forEach((row, i) => row.forEach((cell, k) => {
      cell.textContent = number(frame[sources[k]][i], k < rows ? 3 : pose.decimals);
    }));
  };
  const text = () => cells.slice(0, rows).map((row) => row[rows].textContent).join(", ");
  const said = () => whole ? `${pose.said ?? "origin"} at ${text()} ${pose.unit}` : "";
  return { node: table, update, text: said };
}

/** Formulas under the picture, whose vectors and amounts follow the knobs. */
function readingLines({ readings, decimals, motions }) {
  const box = make("div", { class: "kl-readings" }), spans = [];
  for (const { text, vectors } of readings) {
    const [first, ...rest] = text.split("{}"), line = make("div", {}, first);
    rest.forEach((words, k) => {
      spans.push([make("span", { class: "kl-number" }), vectors[k]]);
      line.append(spans.at(-1)[0], words);
    });
    box.append(line);
  }
  const vector = ({ tail, head, frame, size, scale }, all) => {
    const [from, to] = [tail, head].map(([k, ...local]) => inRoom(all[k], local));
    const arrow = to.map((e, k) => e - from[k]);
    const parts = all[frame].slice(0, size).map((axis) => number(scale * dot(axis, arrow), decimals));
    return size > 1 ? `(${parts.join(", ")})` : parts[0];
  };
  const amount = (motion, q) => motion[0] === ROTATE
    ? number(travel(motion, q) * 180 / Math.PI, 1) : number(travel(motion, q), decimals);
  const volume = ({ ellipsoid, size, scale }, all) =>
    number(all[ellipsoid].slice(0, size).reduce((v, side, k) => v * side[k], scale), decimals);
  const entry = ({ knob, texts }, q) =>
    texts[Math.max(0, Math.min(texts.length - 1, Math.round(q[knob])))];
  const update = (all, q) => {
    for (const [span, part] of spans) {
      span.textContent = part.step ? amount(motions[part.step - 1], q)
        : part.texts ? entry(part, q) : part.ellipsoid ? volume(part, all) : vector(part, all);
    }
  };
  return { node: box, update, text: () => [...box.children].map((l) => l.textContent).join("; ") };
}

// ---- movement between poses ----

const smooth = (t) => t * t * t * (10 - 15 * t + 6 * t * t);   // starts and ends at rest

class Mover {
  constructor(onStop) {
    Object.assign(this, { onStop, request: 0, writing: false });
  }

  /** Move joints through poses, each in `duration` ms, for ever if `loop`. */
  start(joints, poses, duration, loop = false) {
    this.stop();
    if (matchMedia("(prefers-reduced-motion: reduce)").matches) duration = 0;
    let from = joints.read(), next = 0, began = performance.now();
    const step = (now) => {
      const t = duration ? Math.max(0, Math.min(1, (now - began) / duration)) : 1;
      const to = poses[next], s = smooth(t);
      this.write(joints, t < 1 ? from.map((q, i) => q + s * (to[i] - q)) : to);
      if (t === 1) {
        [from, began, next] = [to, now, next + 1];
        if (next === poses.length) {
          if (!loop || !duration) return this.stop();
          next = 0;
        }
      }
      this.request = requestAnimationFrame(step);
    };
    this.request = requestAnimationFrame(step);
  }

  write(joints, q) {
    this.writing = true;
    joints.write(q);
    this.writing = false;
  }

  stop() {
    cancelAnimationFrame(this.request);
    this.request = 0;
    this.onStop();
  }
}

// ---- steps: where a knob's slider stops under a hand, in the slider's units ----

const KEYS = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1, PageDown: -10, PageUp: 10,
               Home: -Infinity, End: Infinity };

const clip = (value, low, high) => Math.max(low, Math.min(high, value));

/** The nearest whole step; the limits need not be whole steps, and hold as well. */
function snap(value, { low, high, step }) {
  const whole = Number((Math.round(value / step) * step).toPrecision(12));
  return [low, high].find((end) => Math.abs(value - end) < step / 4) ?? clip(whole, low, high);
}

/** So many whole steps on, or tenths of them if `fine`. */
function stepped(value, steps, fine, { low, high, step: whole }) {
  const step = fine ? whole / 10 : whole, towards = steps > 0 ? Math.floor : Math.ceil;
  const next = (towards(value / step + (steps > 0 ? 1e-6 : -1e-6)) + steps) * step;
  return clip(Number(next.toPrecision(12)), low, high);
}

// ---- mount: one live arm in one element ----

const MOVE = 700, TOUR = 900;                       // ms from pose to pose

/**
 * Show a live arm.
 * @param element where to put it
 * @param svg the picture as matplotlib drew it, SVG text
 * @param scene plain data from kinlab's Scene and view (see kinlab/views/live.py)
 * @param joints { read() -> q, write(q), listen(callback) -> stop }, in radians and lengths
 * @param before what dismount() returned, to go on looking at another arm in the same way
 * @returns { note(text), freeze(), dismount() }
 */
export function mount(element, svg, scene, joints, before = null) {
  const box = make("div", { class: "kl-picture", tabindex: "0", role: "application",
    "aria-label": `${scene.name}: picture of the arm. Arrow keys turn the view, ` +
                  "plus and minus zoom, 0 resets." });
  box.innerHTML = svg;
  const picture = new Picture(box.querySelector("svg"), scene);
  picture.svg.setAttribute("role", "img");
  picture.svg.removeAttribute("width");
  picture.svg.removeAttribute("height");
  const pose = scene.pose && poseTable(scene.pose);
  const lines = readingLines(scene);
  const progress = make("div", { class: "kl-number" });
  if (scene.target) lines.node.append(progress);
  const remark = make("div", { class: "kl-remark", role: "status" });

  let preset = scene.preset, pending = 0, described = 0, note = "", solved = null;
  const remarks = () => {
    const q = joints.read();
    const text = note || scene.joints.flatMap(({ label, suffix, scale, low, high }, i) => {
      const slack = 1e-6 * (high - low);
      if (q[i] > low + slack && q[i] < high - slack) return [];
      return `${label} is at its limit, ${Number((q[i] / scale).toFixed(3))}${suffix}`;
    }).join("; ");
    if (remark.textContent !== text) remark.textContent = text;
  };
  const describe = () => {
    const state = [pose, lines].map((panel) => panel?.text()).filter(Boolean).join("; ");
    picture.svg.setAttribute("aria-label", `${scene.name}, ${state}`);
  };
  const draw = () => {
    pending = 0;
    const q = joints.read(), all = picture.draw(q);
    pose?.update(seenFrom(all[scene.tip], all[scene.pose.base ?? 0]));
    lines.update(all, q);
    if (chase) progress.textContent = missed(scene, all, solved);
    remarks();
    clearTimeout(described);
    described = setTimeout(describe, 400);          // a screen reader need not hear every step
  };
  const redraw = () => { pending ||= requestAnimationFrame(draw); };
  const look = (name) => { preset = name; picture.reset(name); redraw(); };

  const chase = scene.target && follower(scene, joints, (found) => { solved = found; });
  const drive = chase?.drive ?? joints;
  let play = null;
  const mover = new Mover(() => {
    play?.replaceChildren("▶ Play");
    play?.setAttribute("aria-pressed", "false");
  });
  const whole = () => element.closest(".kl-view") ?? element;
  const switches = scene.layers.map(({ layer, label, title, on }) => [label, title, (button) => {
    const pressed = button.getAttribute("aria-pressed") !== "true";
    button.setAttribute("aria-pressed", pressed);
    picture.show(layer, pressed);
    redraw();
  }, layer, on]);
  const presets = Object.keys(scene.presets);
  const playing = ["▶ Play", "Move smoothly from pose to pose", () => {
    if (mover.request) return mover.stop();
    mover.start(chase?.lead ?? joints, scene.poses, TOUR, true);
    play.replaceChildren("Pause");
    play.setAttribute("aria-pressed", "true");
  }];
  const bar = toolbar([
    ["Move", ["Home", "Move to where it began", () => mover.start(drive, [scene.home], MOVE)],
      ...(scene.poses.length
        ? [["Zero", "Set every joint to zero", () => mover.start(drive, [scene.zero], MOVE)], playing]
        : [])],
    ["View", ...(presets.length > 1 ? presets : []).map((name) =>
      [name[0].toUpperCase() + name.slice(1), `View: ${name}`, () => look(name)])],
    ["Show", ...switches],
    ["Screen", ...(document.fullscreenEnabled ? [["Full screen", "Fill the screen, with large type",
      () => document.fullscreenElement ? document.exitFullscreen() : whole().requestFullscreen(),
    ]] : [])],
  ].filter((group) => group.length > 1));
  play = scene.poses.length ? bar.querySelectorAll("button")[2] : null;
  const buttons = [...bar.querySelectorAll('[aria-label="Show"] button')];
  switches.forEach(([, , , layer, on], k) => {
    const pressed = before?.shown[layer] ?? on;
    buttons[k].setAttribute("aria-pressed", pressed);
    picture.show(layer, pressed);
  });

  element.classList.add("kl-live");
  element.append(bar, box, ...(pose ? [pose.node] : []), lines.node, remark);
  const release = orbit(box, picture, redraw, () => look(preset), chase && grasp(picture, chase));
  const silence = joints.listen(() => {
    if (mover.request && !mover.writing) mover.stop();   // a hand on a slider takes over
    note = "";
    if (!mover.writing) chase?.changed();
    redraw();
  });
  look(preset);
  if (before?.began === scene.preset) {
    preset = before.preset;
    picture.camera = before.camera;
  }
  draw();
  const freeze = () => {
    mover.stop();
    silence();
    cancelAnimationFrame(pending);
    pending = 0;
  };
  return {
    note(text) { note = text; remarks(); },
    freeze,
    dismount() {
      freeze();
      release();
      clearTimeout(described);
      element.replaceChildren();
      const shown = Object.fromEntries(switches.map(([, , , layer], k) =>
        [layer, buttons[k].getAttribute("aria-pressed") === "true"]));
      return { began: scene.preset, preset, camera: picture.camera, shown };
    },
  };
}
