// Runs in the page, before JupyterLab. Notes when keys went down, when the picture had changed
// and was painted, and which values the slider took. All times: performance.now(), in ms.
(() => {
  const log = { keys: [], pictures: [], values: [] };
  let look = () => null, last = null, dirty = false;

  // A frame is painted before any message sent from its animation callbacks arrives.
  const afterPaint = new MessageChannel();
  afterPaint.port1.onmessage = () => {
    if (!dirty) return;
    const time = performance.now(), picture = look();
    if (picture === null) return;                  // an image that is still loading
    dirty = false;
    if (picture !== last) log.pictures.push({ time, picture: last = picture });
  };
  const frame = () => { afterPaint.port2.postMessage(0); requestAnimationFrame(frame); };
  requestAnimationFrame(frame);

  const touch = () => { dirty = true; };
  const drawImage = CanvasRenderingContext2D.prototype.drawImage;
  CanvasRenderingContext2D.prototype.drawImage = function (...args) {
    drawImage.apply(this, args);
    if (this.canvas.isConnected) touch();
  };

  window.addEventListener("keydown", (event) => log.keys.push(event.timeStamp), true);

  const fingerprint = (numbers) => {
    let hash = 2166136261;
    for (const number of numbers) hash = Math.imul(hash ^ number, 16777619);
    return String(hash >>> 0);
  };
  const looks = {
    svg: (box) => [...box.querySelectorAll("path")].map((path) => path.getAttribute("d")).join(),
    img: (box) => {
      const image = box.matches("img") ? box : box.querySelector("img");
      return image?.complete && image.naturalWidth ? image.src : null;
    },
    canvas: (box) => {
      const canvas = box.querySelector("canvas"), { width, height } = canvas;
      const pixels = canvas.getContext("2d").getImageData(0, 0, width, height).data;
      return fingerprint(new Uint32Array(pixels.buffer));
    },
  };

  /** Watch a picture of a kind (svg, img, canvas) and the handle of a slider. */
  window.watch = (kind, box, handle) => {
    look = () => looks[kind](box);
    last = look();
    const marks = { attributes: true, attributeFilter: ["d", "src"], childList: true };
    new MutationObserver(touch).observe(box, { ...marks, subtree: true });
    new MutationObserver(() => {
      const value = handle.getAttribute("aria-valuetext");
      if (value !== log.values.at(-1)) log.values.push(value);
    }).observe(handle, { attributeFilter: ["aria-valuetext"] });
    return log;
  };
  window.countPictures = () => log.pictures.length;
  window.takeLog = () => {
    const taken = structuredClone(log);
    for (const list of Object.values(log)) list.length = 0;
    return taken;
  };
})();
