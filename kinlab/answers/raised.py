"""What a student's own function raised, in words that say what to do.

numpy speaks of "gufunc signatures" and "core dimensions". The sentences here replace the texts
that classes meet; every other error is repeated as it is. Only the wording depends on this: an
answer that raises is wrong, whatever its error says.
"""
from __future__ import annotations

import re
import textwrap

_MATMUL = "two matrices do not fit: in A @ B the columns of A must be as many as the rows of B"
_ENTRYWISE = ("arrays of shapes {0} and {1} do not fit: + - * / work entry by entry. A product of "
              "matrices is written A @ B")
_DOTS = "a ... is still in it"
# The first pattern that is found in the error's text; {0}, {1} are what its groups hold.
_WORDS = tuple((re.compile(pattern), words) for pattern, words in (
    (r"^matmul: .* \(size (\d+) is different from (\d+)\)", f"{_MATMUL}; here {{1}} and {{0}}"),
    (r"^matmul: .* enough dimensions", "@ multiplies matrices and vectors; for a number take *"),
    (r"^solve.* \(size (\d+) is different from (\d+)\)",
     "np.linalg.solve(A, b) takes as many rows of b as A has; here {0} and {1}"),
    (r"^shapes \(.*\) not aligned: (\d+) .* != (\d+)", f"{_MATMUL}; here {{0}} and {{1}}"),
    (r"^operands could not be broadcast together with shapes (\(.*?\)) (\(.*?\))", _ENTRYWISE),
    (r"^non-broadcastable output operand with shape (\(.*?\)) .* shape (\(.*?\))", _ENTRYWISE),
    (r"must be square", "only a square matrix has an inverse. How many rows and columns has "
                        "yours?"),
    (r"^Singular matrix", "this matrix has no inverse"),
    (r"^index (-?\d+) is out of bounds for axis \d+ with size (\d+)",
     "there is no index {0}. Python counts from 0, so {1} entries end before index {1}"),
    (r"^(?:list|tuple) index out of range", "an index is too large. Python counts from 0"),
    (r"^too many indices", "there are more indices than the array has directions"),
    (r"indices must be integers or slices, not tuple",
     "a list of lists has no [i, j]: make it an array with np.array(...)"),
    (r"inhomogeneous", "the rows of an array have different lengths"),
    (r"can be converted to Python scalars", "an array stands where one number is needed; np.cos, "
                                            "np.sin, np.sqrt take arrays"),
    (r"takes (?:from \d+ to )?(\d+) positional arguments? but (\d+)",
     "it takes {0} arguments and was given {1}, those of the exercise"),
    (r"^(?:unsupported operand|bad operand).*'?ellipsis'?", _DOTS),
    (r"^unsupported operand.*'NoneType'",
     "a None is computed with. Does one of your own functions lack its return?"),
    (r"^unsupported operand.*'list'", "lists do not compute: make them arrays with np.array(...)"),
    (r"^'(?:list|tuple)' object has no attribute", "a list is no array: np.array(...) makes one"),
    (r"^name '(cos|sin|tan|sqrt|pi|arctan2|arccos|array|eye|linalg)' is not defined",
     "{0} is numpy's: write np.{0}"),
    (r"^division by zero", "it divides by zero"),
))


def in_words(error: BaseException) -> str:
    """The kind of an error and what it says, in plain words where there are any.

    Examples
    --------
    >>> in_words(NameError("name 'cos' is not defined"))
    "NameError: cos is numpy's: write np.cos"
    >>> in_words(ValueError("no"))
    'ValueError: no'
    """
    text = " ".join(str(error).split())
    found = ((pattern.search(text), words) for pattern, words in _WORDS)
    said = next((words.format(*match.groups()) for match, words in found if match),
                textwrap.shorten(text, 120, placeholder="..."))
    return f"{type(error).__name__}: {said}"
