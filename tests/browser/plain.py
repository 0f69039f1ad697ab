"""mount.js in a plain page: how it is loaded and mounted there, and what it has painted."""
from kinlab.browser import bundle

SOURCE = bundle.module("mount.js") + "export { frames, reach };\n"
LOAD = """async source => {
    const url = URL.createObjectURL(new Blob([source], {type: 'text/javascript'}));
    window.kinlab = await import(url);
}"""
MOUNT = """([scene, q]) => {
    window.listeners = new Set();
    window.joints = {
        q, read: () => joints.q,
        write(q) { joints.q = q; listeners.forEach(listener => listener()); },
        listen(listener) { listeners.add(listener); return () => listeners.delete(listener); },
    };
    document.body.innerHTML = '<div id="arm"></div>';
    window.live = kinlab.mount(document.getElementById('arm'), scene, joints);
}"""
PAINTED = """() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => {
    const groups = [...document.querySelectorAll('svg g[id]')].filter(g => g.firstElementChild);
    const node = g => g.firstElementChild;
    done({
        order: groups.map(g => g.id),
        paths: Object.fromEntries(groups.map(g => [g.id, node(g).getAttribute('d') ?? ''])),
        texts: Object.fromEntries(groups.filter(g => node(g).tagName === 'text').map(
            g => [g.id, [Number(node(g).getAttribute('x')), Number(node(g).getAttribute('y'))]])),
        fills: Object.fromEntries(groups.map(g => [g.id, getComputedStyle(node(g)).fill])),
    });
})))"""

