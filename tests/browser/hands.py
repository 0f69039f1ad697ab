"""Both hands beside each other: what a page shows of a scene, and marks of the still picture."""
import numpy as np

from kinlab.drawing.still import still

# What is seen of each item: its paths in the order of painting, and where its words stand.
SHOWN = """() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => {
    const svg = document.querySelector('.kl-picture svg'), paths = {}, words = {};
    for (const group of svg.querySelectorAll('g[data-part]:is([id], [data-piece-of])')) {
        const gid = group.dataset.pieceOf ?? group.id;
        for (const node of group.querySelectorAll('path, text')) {
            const hidden = !node.getClientRects().length
                || !node.checkVisibility({visibilityProperty: true});
            if (hidden || !(node.getAttribute('d') ?? node.textContent)) continue;
            if (node.tagName === 'text') {
                words[gid] = ['x', 'y'].map(name => Number(node.getAttribute(name)));
            } else if (!node.classList.contains('kl-leader')) {
                (paths[gid] ??= []).push(node.getAttribute('d'));
            }
        }
    }
    const { width, height } = svg.viewBox.baseVal;
    const ids = [...document.querySelectorAll('[id]')].map(node => node.id);
    done({paths, words, ids, size: [width, height]});
})))"""
PATHS_PX, WORDS_PX = 0.08, 4.0  # names in the page go on finding their places
_TURNS = np.linspace(0, 2 * np.pi, 48)
_RAYS = np.stack([np.cos(_TURNS), np.sin(_TURNS)])


def corners(path):
    """The points of an SVG path of straight lines."""
    words = path.replace(",", " ").replace("Z", " ").replace("M", " ").replace("L", " ").split()
    return np.array([float(word) for word in words]).reshape(-1, 2)


def assert_both_hands_agree(page, scene, q, preset, show):
    """Every outline, arrow and line is where Python has it, and so is every name."""
    seen = page.evaluate(SHOWN)
    assert len(seen["ids"]) == len(set(seen["ids"]))  # a page has every id once
    paths, words = {}, {}
    for drawn in still(scene, q, preset, show, tuple(seen["size"])):
        if drawn.item is None or drawn.gid != drawn.item.gid:
            continue  # the floor, and the arrows that are dashed over solids
        for mark in drawn.marks:
            if mark.text:
                words[drawn.gid] = mark.lines[0][0]
            elif drawn.item.shape not in ("text", "name"):
                paths.setdefault(drawn.gid, []).extend(
                    [np.vstack(mark.lines)] if mark.lines else [])
    assert set(seen["words"]) == set(words)
    for gid, place in words.items():
        np.testing.assert_allclose(seen["words"][gid], place, atol=WORDS_PX, err_msg=gid)
    missing = {gid for gid, drawn in paths.items() if drawn} - set(seen["paths"])
    assert not missing
    for gid, outlines in paths.items():
        assert len(seen["paths"].get(gid, [])) == len(outlines), gid
        for path, outline in zip(seen["paths"].get(gid, []), outlines):
            assert_same_outline(corners(path), outline, gid)


def assert_same_outline(one, other, gid):
    """Point for point, or, for outlines of solids, equally far in every direction."""
    if len(one) != len(other) or (len(one) > 4 and not np.allclose(one, other, atol=PATHS_PX)):
        one, other = ((points @ _RAYS).max(axis=0) for points in (one, other))
    np.testing.assert_allclose(one, other, atol=PATHS_PX, err_msg=gid)
