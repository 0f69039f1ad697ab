"""What is no number is refused before numpy makes one of it."""
import warnings
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest
import sympy as sp

from kinlab.arms.inputs import real_array


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
