"""The numbers that the JavaScript is tested with under Node are still Python's."""
import json

import numpy as np
import pytest
from fixtures import FIXTURES, path, written

ANEW = "run `python tests/browser/fixtures.py` and see what the tests under Node say"


def alike(kept, made):
    """Whether two fixtures are the same, numbers to 1e-9."""
    if isinstance(made, dict):
        return isinstance(kept, dict) and kept.keys() == made.keys() and all(
            alike(kept[key], made[key]) for key in made)
    if isinstance(made, list):
        return isinstance(kept, list) and len(kept) == len(made) and all(map(alike, kept, made))
    if isinstance(made, float) and isinstance(kept, int | float):
        return bool(np.isclose(kept, made, rtol=1e-9, atol=1e-9))
    return type(kept) is type(made) and kept == made


@pytest.mark.parametrize("name", FIXTURES)
def test_fixtures_are_what_python_computes(name):
    made = json.loads(written(FIXTURES[name]()))
    assert alike(json.loads(path(name).read_text(encoding="utf-8")), made), ANEW
