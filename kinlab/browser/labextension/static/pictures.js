// The pictures in a notebook's outputs, in JupyterLab: before any cell is run, no script of a view
// is there that could look after them.

{
  const PICTURE = "image/png", VIEW = "application/vnd.jupyter.widget-view+json";
  // What the widget manager says where it has no view: with no kernel it waits for ever.
  const ABSENT = /^(Loading widget\.\.\.|Error displaying widget)/, LONG = 1000;  // ms

  /** @type {Record<string, Record<string, { get(): Promise<() => any> }>>} */
  let shared = {};                                  // JupyterLab's own modules, by name and version

  /** @param {string} name of one of JupyterLab's modules */
  const moduleOf = async (name) => (await Object.values(shared[name])[0].get())();

  /**
   * The words that describe a picture stand in the output's metadata, as nbconvert wants them;
   * JupyterLab shows the picture without.
   * @param {HTMLElement} node
   * @param {any} model of the output
   */
  function giveWords(node, model) {
    const image = node.querySelector("img"), words = model.metadata[PICTURE]?.alt;
    if (image && words) image.alt = words;
  }

  /**
   * A view that is long in coming, or lost, leaves its place to its picture, or to its text.
   * @param {HTMLElement} node
   * @param {any} model of the output
   */
  function giveWay(node, model) {
    if (!ABSENT.test(node.textContent ?? "")) return;
    const { [PICTURE]: picture, "text/plain": text = "" } = model.data;
    const still = document.createElement("div");
    still.className = `${picture ? "jp-RenderedImage" : "jp-RenderedText"} kl-still`;
    still.append(picture
      ? Object.assign(new Image(), { src: `data:${PICTURE};base64,${picture}` })
      : Object.assign(document.createElement("pre"), { textContent: text }));
    node.replaceChildren(still);
    giveWords(node, model);
  }

  /** @param {any} registry what makes the renderers of one notebook */
  function lookAfter(registry) {
    const create = registry.createRenderer.bind(registry);
    registry.createRenderer = (/** @type {string} */ kind) => {
      const widget = create(kind), render = widget.renderModel.bind(widget);
      const look = kind === VIEW ? giveWay : giveWords;
      widget.renderModel = async (/** @type {any} */ model) => {
        const patience = setTimeout(() => look(widget.node, model), LONG);
        await render(model);
        clearTimeout(patience);
        look(widget.node, model);
      };
      return widget;
    };
  }

  const plugin = async () => {
    const { INotebookTracker } = await moduleOf("@jupyterlab/notebook");
    return {
      id: "kinlab:pictures",
      autoStart: true,
      requires: [INotebookTracker],
      /** @param {any} _ @param {any} notebooks */
      activate(_, notebooks) {
        notebooks.forEach((/** @type {any} */ one) => lookAfter(one.content.rendermime));
        notebooks.widgetAdded.connect(
          (/** @type {any} */ _, /** @type {any} */ one) => lookAfter(one.content.rendermime));
      },
    };
  };

  const page = /** @type {any} */ (window);
  (page["_JUPYTERLAB"] ??= {}).kinlab = {             // where JupyterLab looks for extensions
    init: (/** @type {typeof shared} */ scope) => { shared = scope; },
    get: async () => {
      const made = await plugin();
      return () => made;
    },
  };
}
