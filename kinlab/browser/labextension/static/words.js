// JupyterLab shows the picture of an output without the words that describe it, which stand in the
// output's metadata as nbconvert wants them. This gives the picture those words, in notebooks that
// nobody has run yet, too.

{
  let shared = {};                                  // JupyterLab's own modules, by name and version

  const PICTURE = "image/png";

  // A renderer's factory, made one whose pictures have their words.
  const withWords = (factory) => ({
    ...factory,
    createRenderer(options) {
      const widget = factory.createRenderer(options), render = widget.renderModel.bind(widget);
      widget.renderModel = async (model) => {
        await render(model);
        const words = model.metadata[options.mimeType]?.alt;
        const image = widget.node.querySelector("img");
        if (image && words) image.alt = words;
      };
      return widget;
    },
  });

  const plugin = async () => {
    const [module] = Object.values(shared["@jupyterlab/rendermime"]);
    const { IRenderMimeRegistry } = (await module.get())();
    return {
      id: "kinlab:words",
      autoStart: true,
      requires: [IRenderMimeRegistry],
      activate(_, registry) {
        const factory = registry.getFactory(PICTURE), rank = registry.getRank(PICTURE);
        if (factory) registry.addFactory(withWords(factory), rank);
      },
    };
  };

  (window._JUPYTERLAB ??= {}).kinlab = {
    init: (scope) => { shared = scope; },
    get: async () => {
      const made = await plugin();
      return () => made;
    },
  };
}
