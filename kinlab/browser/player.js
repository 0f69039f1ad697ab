// Movement between poses.

export const smooth = (t) => t * t * t * (10 - 15 * t + 6 * t * t);   // starts and ends at rest

export class Mover {
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
