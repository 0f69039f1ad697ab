"""The DH table's editor in a blank page: Python hears what is done in it, without Jupyter."""
from kinlab.browser import bundle

_EDIT = """([source, style, state]) => new Promise(done => {
    const listeners = {};
    const model = window.model = {
        state,
        get: name => model.state[name], set(name, value) { model.state[name] = value; },
        told: name => (listeners[`change:${name}`] ?? []).forEach(act => act()),
        on: (name, act) => (listeners[name] ??= []).push(act), off() {}, save_changes() {},
        async send(message) {
            const now = await window.python(message);
            for (const [name, value] of Object.entries(now)) {
                if (JSON.stringify(model.state[name]) === JSON.stringify(value)) continue;
                model.state[name] = value;
                model.told(name);
            }
        },
    };
    document.body.innerHTML = `<style>${style}</style><div id="editor"></div>`;
    import(URL.createObjectURL(new Blob([source], {type: 'text/javascript'}))).then(module => {
        module.default.render({model, el: document.getElementById('editor')});
        done();
    });
})"""


def shown_in(page):
    """A function that shows an editor in the page."""
    held = {}

    def state():
        return {key: value for key, value in held["editor"].get_state().items()
                if not key.startswith("_") and key not in ("layout", "tabbable", "tooltip")}

    def python(message):
        held["editor"]._hear(None, message, [])
        return state()

    page.expose_function("python", python)

    def show(editor):
        held["editor"] = editor
        page.evaluate(_EDIT, [bundle.module("host_table.js"),
                              bundle.style("live.css", "table.css"), state()])
        page.locator(".kl-dh").wait_for()
        return page

    return show
