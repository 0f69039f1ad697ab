"""What is no number is refused before numpy makes one of it."""
import warnings
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest
import sympy as sp

from kinlab.arms.inputs import Note, note, real_array


@pytest.mark.parametrize("value", [[Decimal(1), "2"], [Fraction(1, 2), b"2"],
                                   [[sp.Integer(1), "1"]]])
def test_text_among_other_numbers_is_no_number(value):
    """numpy would read it as one."""
    with pytest.raises(ValueError, match=r"^q: expected two numbers, got .*; give plain numbers$"):
        real_array("q", value, "two numbers")


@pytest.mark.parametrize("value", [sp.nan, [sp.nan, 0], [[sp.nan]]])
def test_sympys_nan_is_refused_without_a_warning(value):
    """numpy 1.26 warns where it makes a float of it."""
    with warnings.catch_warnings(), pytest.raises(ValueError, match=r"^q: expected finite"):
        warnings.simplefilter("error")
        real_array("q", value, "two numbers")


@pytest.mark.parametrize("value, floats", [
    ([Decimal("0.5"), Fraction(1, 4), sp.Rational(3, 4)], [0.5, 0.25, 0.75]),
    ([[sp.pi, 1]], [[3.141592653589793, 1.0]]), (sp.Integer(2), 2.0),
    (np.array([], dtype=object), []), ([10**30, 1], [1e30, 1.0])])
def test_numbers_of_other_kinds_are_read_in_their_shape(value, floats):
    array = real_array("q", value, "numbers")
    assert array.dtype == float and array.tolist() == floats


def test_a_note_names_the_line_outside_the_package():
    inside = {"__name__": "kinlab.some.module", "note": note}
    exec("def taken(): deeper()\ndef deeper(): note('q: taken as it is')", inside)
    with pytest.warns(Note, match=r"^q: taken as it is$") as caught:
        inside["taken"]()
    assert caught[0].filename == __file__
    line = open(__file__).read().splitlines()[caught[0].lineno - 1]
    assert line.strip() == 'inside["taken"]()'


def test_a_note_of_a_script_that_calls_it_itself_names_that_line():
    with pytest.warns(Note) as caught:
        note("q: taken as it is")
    assert caught[0].filename == __file__


def test_a_package_with_a_longer_name_is_the_students():
    students = {"__name__": "kinlab_solutions.week_2", "note": note}
    exec(compile("def taken(): note('q: taken')", "week_2.py", "exec"), students)
    with pytest.warns(Note) as caught:
        students["taken"]()
    assert caught[0].filename == "week_2.py"
