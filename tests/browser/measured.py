"""What can be measured in the picture of a page: letters, names on names, how much it is filled.

MEASURE gives `text` and `page`, the height (px) of the smallest letters in the picture and beside
it; `overlap`, the names that cover each other by more than 2 px; `fill`, the longer side of what
is drawn as a share of the picture; `outside`, what is drawn beyond its edge; `scroll`, what is
wider than its place.
"""

MEASURE = """() => {
    const svg = document.querySelector('.kl-picture svg'), frame = svg.getBoundingClientRect();
    const seen = node => node.getClientRects().length   // none where an ancestor is switched off
        && node.checkVisibility({opacityProperty: true, visibilityProperty: true});
    const group = node => node.closest('[data-part]') ?? node.closest('g[id]') ?? node;
    const part = node => group(node).dataset.part || group(node).getAttribute('class') || '';
    const flat = node => node.closest('.kl-layer-floor, .kl-far')
        || /ground|shadow|ghost|axis|trace|mesh/.test(part(node));
    const placed = node => {
        const {x, y, width, height} = node.getBBox(), m = node.getScreenCTM();
        const corner = (u, v) => [m.a * u + m.c * v + m.e, m.b * u + m.d * v + m.f];
        const [[left, top], [right, bottom]] = [corner(x, y), corner(x + width, y + height)];
        return {left, top, right, bottom, px: parseFloat(getComputedStyle(node).fontSize) * m.a,
                name: node.textContent || group(node).id};
    };
    const letters = ({left, top, right, bottom, ...rest}) => {    // without the room above them
        const spare = 0.14 * (bottom - top);
        return {left, top: top + spare, right, bottom: bottom - spare, ...rest};
    };
    const shown = [...svg.querySelectorAll('text')].filter(
        node => seen(node) && node.textContent.trim()).map(placed).map(letters);
    const drawn = [...svg.querySelectorAll('path, line, circle, ellipse, polygon, polyline, rect')]
        .filter(node => seen(node) && !node.closest('defs, clipPath, mask') && !flat(node)
                && /[\\d]/.test(node.getAttribute('d') ?? '1')).map(placed)
        .filter(box => box.right - box.left + box.bottom - box.top > 0);
    const covered = (a, b) => Math.min(Math.min(a.right, b.right) - Math.max(a.left, b.left),
                                       Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top));
    const pairs = shown.flatMap((a, k) => shown.slice(k + 1).map(b => [covered(a, b), a, b]))
        .filter(([by]) => by > 2).sort((a, b) => b[0] - a[0]);
    const edge = (side, pick) => pick(...drawn.map(box => box[side]));
    const beyond = [...shown, ...drawn].filter(
        box => box.left < frame.left - 1 || box.right > frame.right + 1
            || box.top < frame.top - 1 || box.bottom > frame.bottom + 1);
    const words = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT), sizes = [];
    while (words.nextNode()) {
        const near = words.currentNode.parentElement;
        if (words.currentNode.data.trim() && !near.closest('svg, math, script, style, sub, sup')
            && seen(near)) sizes.push(parseFloat(getComputedStyle(near).fontSize));
    }
    const wide = [...document.querySelectorAll('html, .kl-view *:not(svg *, math *)')].filter(
        node => node.scrollWidth > node.clientWidth + 1 && seen(node)
            && (node.tagName === 'HTML' || /auto|scroll/.test(getComputedStyle(node).overflowX)));
    return {
        text: shown.length ? Math.min(...shown.map(({px}) => px)).toFixed(1) : '',
        page: Math.min(...sizes).toFixed(1),
        overlap: pairs.length ? `${pairs.length}: ${pairs.slice(0, 2).map(([by, a, b]) =>
            `${a.name}/${b.name} ${by.toFixed(0)} px`).join(', ')}` : '',
        fill: drawn.length ? Math.max(
            (edge('right', Math.max) - edge('left', Math.min)) / frame.width,
            (edge('bottom', Math.max) - edge('top', Math.min)) / frame.height).toFixed(2) : '',
        outside: [...new Set(beyond.map(({name}) => name))].slice(0, 6).join(' '),
        scroll: wide.map(node => node.className || node.tagName.toLowerCase()).join(' '),
    };
}"""
DRAWN = "() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))"
