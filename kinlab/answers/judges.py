"""Judges of students' answers, made from a reference and a list of slips.

A judge takes an answer and returns a `Verdict`: a word of praise, or the sentence that says what
is wrong. A slip is a wrong answer that can be computed, with the sentence that explains it. Text
from students is never evaluated.
"""
from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import wraps
from numbers import Real
from typing import Any, TypeVar

import numpy as np

from ..arms import inputs
from .raised import in_words
from .verdict import BLANK, CORRECT, NOT_YET, Verdict

# Relative, and absolute near zero: what was printed with six decimals and typed again counts as
# right, and so does the rounding of any formula that a student may have taken.
SAME_NUMBER = 1e-6

Judge = Callable[[Any], Verdict]
Case = Mapping[str, object]  # arguments by their names: numbers, or lists of numbers
Slip = tuple[str, Callable]
Wrong = TypeVar("Wrong")


class _Unreadable(Exception):
    """What there is to say where an answer cannot be read any further."""

    def __init__(self, message: str, word: str = NOT_YET) -> None:
        super().__init__(message)
        self.verdict = Verdict(word, message)


def _reading(judge: Judge) -> Judge:
    """A judge for which an answer that cannot be read is an answer like any other."""
    @wraps(judge)
    def judged(answer: Any) -> Verdict:
        try:
            return judge(answer)
        except _Unreadable as end:
            return end.verdict
    return judged


def function(reference: Callable, cases: Sequence[Case], *, entry: Callable[[tuple], str],
             slips: Sequence[Slip] = (), praise: str) -> Judge:
    """Judge of a function: it must equal the reference in every case.

    Parameters
    ----------
    reference : callable
        Takes the values of a case in order, returns an array.
    cases : sequence of {argument: value}
    entry : callable
        Names an entry of the result by its index.
    slips : sequence of (message, wrong function)
        The first one that gives the student's results in every case is named.
    praise : str
    """
    @_reading
    def judge(answer: Any) -> Verdict:
        if is_stub(answer):
            return Verdict(BLANK, "Replace the ... by your function.")
        if not callable(answer):
            return Verdict(NOT_YET, f"Expected a function, got {inputs.brief(answer)}; hand it "
                                    "over by its name, without parentheses.")
        results = [_called(answer, case) for case in cases]
        if all(map(is_stub, results)):
            return Verdict(BLANK, "The function returns nothing so far. Replace the ... and end "
                                  "with return.")
        return _compared(results, reference, cases, entry, slips, praise)
    return judge


def expressions(names: Sequence[str], reference: Callable, points: Sequence[Case], *,
                constants: Case, slips: Sequence[Slip] = (), praise: str) -> Judge:
    """Judge of sympy expressions in any equivalent form: they are compared at points.

    Parameters
    ----------
    names : sequence of str
        What each expression stands for.
    reference : callable
        Takes the values of a point in order, returns one number per name.
    points : sequence of {symbol: value}
        Their symbols may stand in the answer, and those of `constants`.
    constants : {symbol: value}
        For students who write a_2 instead of its value.
    slips : sequence of (message, wrong function)
    praise : str
    """
    return evaluated(names, points, constants, lambda results: _compared(
        results, reference, points, lambda index: names[index[0]], slips, praise))


def evaluated(names: Sequence[str], points: Sequence[Case], constants: Case,
              verdict: Callable[[list[list[float]]], Verdict]) -> Judge:
    """Judge of sympy expressions by their numbers at points, one list for each point.

    Parameters
    ----------
    names, points, constants
        As in `expressions`.
    verdict : callable
        What there is to say of the numbers.
    """
    @_reading
    def judge(answer: Any) -> Verdict:
        parts = _parts(answer, names, "expression")
        return verdict([[_value(name, part, point, constants) for name, part in zip(names, parts)]
                        for point in points])
    return judge


def values(right: Any, *, entry: Callable[[tuple], str], slips: Sequence[tuple[str, Any]] = (),
           praise: str) -> Judge:
    """Judge of a vector or a matrix of numbers, which does not tell the right ones.

    Parameters
    ----------
    right : array
    entry : callable
        Names an entry by its index.
    slips : sequence of (message, wrong array)
    praise : str
    """
    named = [(message, lambda wrong=wrong: np.asarray(wrong)) for message, wrong in slips]

    @_reading
    def judge(answer: Any) -> Verdict:
        if is_stub(answer):
            return Verdict(BLANK, "Replace the ... by your numbers.")
        if isinstance(answer, (list, tuple)) and answer and all(map(is_stub, answer)):
            return Verdict(BLANK, "Replace every ... by a number.")
        return _compared([answer], lambda: right, [{}], entry, named, praise)
    return judge


def choices(expected: Mapping[str, set], allowed: set, reasons: Mapping[tuple, str], *,
            noun: str = "joint", praise: str) -> Judge:
    """Judge of sets of numbers, of joints or of other things, one set for each question.

    Parameters
    ----------
    expected : {question: set of numbers}
    allowed : set of numbers
    reasons : {(question, number): hint}
        Said when the number is missing, or is there and should not be.
    noun : str
        What the numbers stand for.
    praise : str
    """
    @_reading
    def judge(answer: Any) -> Verdict:
        for (name, right), part in zip(expected.items(), _parts(answer, expected, "set")):
            given = _numbers(name, part, allowed, noun)
            faulty = sorted(given - right) or sorted(right - given)
            if faulty:
                fault = f"not {noun} {faulty[0]}" if faulty[0] in given else "one is missing"
                hint = reasons.get((name, faulty[0]), "")
                return Verdict(NOT_YET,
                               f"{name}: got {_braces(given)}, but {fault}. {hint}".strip())
        return Verdict(CORRECT, praise)
    return judge


def is_stub(value: Any) -> bool:
    """True for what stands in an exercise before it is done: ... or None."""
    return value is None or value is ...


def _called(answer: Callable, case: Case) -> Any:
    try:
        return answer(*case.values())
    except Exception as error:  # the student's own code: say what it said
        raise _Unreadable(f"For {_said(case)} your function raised {in_words(error)}.") from None


def _compared(results: Sequence, reference: Callable, cases: Sequence[Case],
              entry: Callable[[tuple], str], slips: Sequence[Slip], praise: str) -> Verdict:
    """The praise, or the first case where the results leave the reference."""
    rights = [np.asarray(reference(*case.values())) for case in cases]
    results = [_array(result, right.shape, case)
               for result, right, case in zip(results, rights, cases)]

    def is_slip(wrong: Callable) -> bool:
        return all(np.all(_close(result, wrong(*case.values())))
                   for result, case in zip(results, cases))

    for result, right, case in zip(results, rights, cases):
        off = np.argwhere(~_close(result, right))
        if len(off):
            index = tuple(off[0])
            should, got = (f"{array[index] + 0.0:.6g}" for array in (right, result))
            where = _for(case) + (f"{entry(index)} should be {should}, got {got}." if case
                                  else f"{entry(index)} is not {got}.")
            hints = first_of(slips, is_slip) or _rounding(results, rights, "return" if case
                                                          else "give")
            return Verdict(NOT_YET, " ".join([where, *hints]))
    return Verdict(CORRECT, praise)


def _rounding(results: Sequence[np.ndarray], rights: Sequence[np.ndarray], verb: str) -> list[str]:
    """The hint that all results are right but for the decimals that are missing, if they are."""
    rounded = any(all(np.allclose(result, np.round(right, decimals), rtol=1e-12, atol=1e-12)
                      for result, right in zip(results, rights)) for decimals in range(1, 7))
    return [f"It looks rounded: {verb} all digits."] * rounded


def _array(result: Any, shape: tuple, case: Case) -> np.ndarray:
    try:
        array = inputs.real_array("the result", result, f"numbers of shape {shape}")
    except ValueError as error:
        raise _Unreadable(f"{_for(case)}{error}.") from None
    if array.shape != shape:
        raise _Unreadable(f"{_for(case)}expected a result of shape {shape}, got {array.shape}.")
    return array


def _close(a: np.ndarray, b: Any) -> np.ndarray:
    return np.isclose(a, b, rtol=SAME_NUMBER, atol=SAME_NUMBER)


def first_of(slips: Sequence[tuple[str, Wrong]],
             matches: Callable[[Wrong], bool]) -> list[str]:
    """The message of the first slip that matches, as a list of one, or an empty list."""
    return next(([message] for message, wrong in slips if matches(wrong)), [])


def _parts(answer: Any, names: Any, noun: str) -> list:
    """The parts of an answer that comes as a list, a tuple, an array or a sympy matrix."""
    every = list(names)
    listed = every if len(every) < 7 else [every[0], "...", every[-1]]
    wanted = f"{len(every)} {noun}{'s' * (len(every) > 1)}: {', '.join(listed)}"
    if is_stub(answer):
        raise _Unreadable(f"Give {wanted}.", BLANK)
    if isinstance(answer, (str, bytes, dict, set)) or not hasattr(answer, "__len__"):
        raise _Unreadable(f"Expected {wanted}, in a list; got {inputs.brief(answer)}.")
    parts = list(np.ravel(answer)) if hasattr(answer, "shape") else list(answer)
    if parts and all(map(is_stub, parts)):
        raise _Unreadable(f"Give {wanted}.", BLANK)
    if len(parts) != len(names):
        raise _Unreadable(f"Expected {wanted}; got {len(parts)}.")
    stubs = [name for name, part in zip(names, parts) if is_stub(part)]
    if stubs:
        raise _Unreadable(f"{stubs[0]}: this {noun} is still the stub; replace its ...")
    return parts


def _value(name: str, part: Any, point: Case, constants: Case) -> float:
    import sympy  # only lessons with expressions to judge need it

    if not isinstance(part, (Real, sympy.Expr)):
        raise _Unreadable(f"{name}: expected a sympy expression, got {inputs.brief(part)}"
                          + ("; leave out the quotes." if isinstance(part, str) else "."))
    expression = sympy.sympify(part, strict=True)  # strict: numbers only, never text
    symbols, values = expression.free_symbols, {**constants, **point}
    strange = sorted({symbol.name for symbol in symbols} - set(values))
    if strange:
        raise _Unreadable(f"{name} holds {', '.join(strange)}; only "
                          f"{', '.join([*point, *constants])} may stand in it.")
    try:
        return float(expression.subs({s: values[s.name] for s in symbols}))
    except (TypeError, ValueError):
        raise _Unreadable(f"{name} is not a real number at {_said(point)}.") from None


def _numbers(name: str, part: Any, allowed: set, noun: str) -> set:
    if isinstance(part, (str, bytes)) or not hasattr(part, "__len__"):
        raise _Unreadable(f"{name}: expected a set of {noun} numbers such as {{1, 2}}, "
                          f"got {inputs.brief(part)}.")
    for joint in part:
        if joint not in allowed:
            raise _Unreadable(f"{name}: there is no {noun} {inputs.brief(joint)}; choose from "
                              f"{_braces(allowed)}.")
    return {int(joint) for joint in part}


def _braces(numbers: set) -> str:
    return "{" + ", ".join(map(str, sorted(numbers))) + "}"


def _for(case: Case) -> str:
    return f"For {_said(case)}: " if case else "Your answer: "


def _said(case: Case) -> str:
    return ", ".join(f"{name} = {_written(value)}" for name, value in case.items())


def _written(value: Any) -> str:
    return f"[{', '.join(map(_written, value))}]" if np.ndim(value) else f"{value:.6g}"
