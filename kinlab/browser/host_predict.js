// The script of a view's widget.

import { showView } from "./widget.js";

/** @import { Host } from "./types.js" */

/** @param {Host} host */
const render = ({ model, el }) => showView(model, el);

export default { render };
