// The script of a page with views.

import { mount } from "./mount.js";
import { startViews } from "./page_views.js";

startViews((element, scene, joints, formula) => mount(element, scene, joints, formula));
