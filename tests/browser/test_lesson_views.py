"""Every view of the lessons in the browser: frames, picture and formulas as Python has them."""
import re

import numpy as np
import pytest
from grades import crossed
from lesson_views import RARE, VIEWS
from painted import STYLE, assert_same_view
from plain import MOUNT
from reading import SETTLE
from test_plain_page import js_frames


@pytest.fixture(scope="module")
def styled(blank):
    """A blank page with the style of a view."""
    blank.add_style_tag(content=STYLE)
    return blank


@pytest.mark.parametrize("name, share", crossed(VIEWS, [0.31, 0.77], RARE))
def test_a_lessons_view_moves_as_python_says(styled, name, share):
    view = VIEWS[name]()
    scene = view._scene
    low, high = np.array([(knob.low, knob.high) for knob in view._scene.knobs]).T
    view._move(low + share * (high - low))
    q = view._values.tolist()
    styled.evaluate("window.live?.dismount()")
    styled.evaluate(MOUNT, [view.scene, q])
    np.testing.assert_allclose(js_frames(styled, scene, q), scene.frames(q), rtol=1e-9, atol=1e-9)
    styled.evaluate(SETTLE)
    assert_same_view(styled, scene, q, scene.seen_from, scene.shown)
    assert_formulas(styled, view)


def assert_formulas(page, view):
    """The numbers under the picture, where they are shown, are those that Python reads."""
    lines = page.locator(".kl-readings > div").filter(has=page.locator(".kl-number")).all()
    for line, parts in zip(lines, view.readings.values(), strict=True):
        shown = [span.inner_text() for span in line.locator(".kl-number").all()]
        for text, part in zip(shown, parts, strict=True):
            if isinstance(part, str):
                assert text == part
                continue
            numbers = [float(n) for n in re.findall(r"-?[\d.]+", text.replace("−", "-"))]
            decimals = len(text.rstrip(")").rpartition(".")[2])
            np.testing.assert_allclose(numbers, part, atol=0.51 * 10.0**-decimals)
