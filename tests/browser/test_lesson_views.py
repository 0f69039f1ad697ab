"""Every view of the lessons in the browser: frames, picture and formulas as Python has them."""
import re

import numpy as np
import pytest
from lesson_views import VIEWS
from plain import MOUNT, PAINTED
from test_plain_page import assert_same_path, js_frames

from kinlab.drawing import figure


@pytest.mark.parametrize("make", VIEWS.values(), ids=VIEWS)
def test_a_lessons_view_moves_as_python_says(blank, make):
    view = make()
    scene = view._scene
    low, high = np.array([(knob.low, knob.high) for knob in view._scene.knobs]).T
    for share in (0.31, 0.77):
        view._move(low + share * (high - low))
        q = view._values.tolist()
        blank.evaluate(MOUNT, [view.scene, q])
        np.testing.assert_allclose(js_frames(blank, scene, q), scene.frames(q),
                                   rtol=1e-9, atol=1e-9)
        assert_as_drawn(blank.evaluate(PAINTED), scene, q, view._scene.seen_from)
        assert_formulas(blank, view)
        blank.evaluate("live.dismount()")


def assert_as_drawn(seen, scene, q, preset):
    frames, camera = scene.frames(q), figure.Camera(*scene.presets[preset]).axes
    for item in scene.items:
        points = figure.project(scene, frames, camera, item)
        if item.shape == "text":
            assert abs(seen["texts"][item.gid][0] - points[0, 0]) < 0.02
        elif item.shape != "trace":
            assert_same_path(item, seen["paths"][item.gid], points)


def assert_formulas(page, view):
    """The numbers under the picture, where they are shown, are those that Python reads."""
    for line, parts in zip(page.locator(".kl-readings > div").all(), view.readings.values()):
        shown = [span.inner_text() for span in line.locator(".kl-number").all()]
        for text, part in zip(shown, parts, strict=True):
            if isinstance(part, str):
                assert text == part
                continue
            numbers = [float(n) for n in re.findall(r"-?[\d.]+", text.replace("−", "-"))]
            decimals = len(text.rstrip(")").rpartition(".")[2])
            np.testing.assert_allclose(numbers, part, atol=0.51 * 10.0**-decimals)
