// The picture: the frames of frames.js, projected as in kinlab/drawing/figure.py, set the attributes of
// the SVG that matplotlib drew, and nearer groups are put over farther ones.

import { frames, inRoom } from "./frames.js";

/** The picture's right and up as directions of the room. */
export function screenAxes(camera) {
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

const TRACE_LENGTH = 4000;
const PAPER = { azimuth: -90, elevation: 90, zoom: 1 };   // x to the right, y up

export class Picture {
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
