"""Judges of students' answers, made from a reference and a list of slips.

A judge takes an answer and returns a word of praise, or raises `Blank` (still the stub) or
`Wrong` (with the sentence the student reads). A slip is a wrong answer that can be computed,
with the sentence that explains it. Text from students is never evaluated.
"""
from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from numbers import Real
from typing import Any

import numpy as np

from ..arms import inputs

TOLERANCE = 1e-6

Judge = Callable[[Any], str]
Case = Mapping[str, float]
Slip = tuple[str, Callable]


class Wrong(Exception):
    """The answer is wrong; the text says where and, if it is a known slip, why."""


class Blank(Exception):
    """The answer is still the stub."""


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
    def judge(answer: Any) -> str:
        _refuse_stub(answer, "Replace the ... by your function.")
        if not callable(answer):
            raise Wrong(f"Expected a function, got {inputs.brief(answer)}; hand it over by its "
                        "name, without parentheses.")
        results = [_called(answer, case) for case in cases]
        if all(map(is_stub, results)):
            raise Blank("The function returns nothing so far. Replace the ... and end with "
                        "return.")
        _compare(results, reference, cases, entry, slips)
        return praise
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
    def judge(answer: Any) -> str:
        results = evaluated(answer, names, points, constants)
        _compare(results, reference, points, lambda index: names[index[0]], slips)
        return praise
    return judge


def evaluated(answer: Any, names: Sequence[str], points: Sequence[Case],
              constants: Case) -> list[list[float]]:
    """The numbers that a student's sympy expressions have at points; as in `expressions`."""
    parts = _parts(answer, names, "expression")
    return [[_value(name, part, point, constants) for name, part in zip(names, parts)]
            for point in points]


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

    def judge(answer: Any) -> str:
        _refuse_stub(answer, "Replace the ... by your numbers.")
        if isinstance(answer, (list, tuple)) and answer and all(map(is_stub, answer)):
            raise Blank("Replace every ... by a number.")
        _compare([answer], lambda: right, [{}], entry, named)
        return praise
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
    def judge(answer: Any) -> str:
        for (name, right), part in zip(expected.items(), _parts(answer, expected, "set")):
            given = _numbers(name, part, allowed, noun)
            faulty = sorted(given - right) or sorted(right - given)
            if faulty:
                fault = f"not {noun} {faulty[0]}" if faulty[0] in given else "one is missing"
                hint = reasons.get((name, faulty[0]), "")
                raise Wrong(f"{name}: got {_braces(given)}, but {fault}. {hint}".strip())
        return praise
    return judge


def joint_values(read: Callable[[Any], np.ndarray], conditions: Sequence[Callable], *,
                 slips: Sequence[Slip] = (), noun: str = "joint values", praise: str) -> Judge:
    """Judge of joint values that must meet conditions; there may be many right answers.

    Parameters
    ----------
    read : callable
        Makes an array of the answer, or raises a ValueError that says what was wrong.
    conditions : sequence of callables
        Each takes the joint values and says what fails and by how much, or "".
    slips : sequence of (message, test of the joint values)
        The first one that is true is named once a condition fails.
    noun : str
        What the answer holds.
    praise : str
    """
    def judge(answer: Any) -> str:
        _refuse_stub(answer, f"Replace the ... by your {noun}.")
        try:
            q = read(answer)
        except ValueError as error:
            raise Wrong(f"{error}.") from None
        faults = [fault for condition in conditions if (fault := condition(q))]
        if faults:
            raise Wrong(" ".join([faults[0], *first_of(slips, lambda test: test(q))]))
        return praise
    return judge


def is_stub(value: Any) -> bool:
    """True for what stands in an exercise before it is done: ... or None."""
    return value is None or value is ...


def _refuse_stub(answer: Any, message: str) -> None:
    if is_stub(answer):
        raise Blank(message)


def _called(answer: Callable, case: Case) -> Any:
    try:
        return answer(*case.values())
    except Exception as error:  # the student's own code: say what it said
        raise Wrong(f"For {_said(case)} your function raised {type(error).__name__}: "
                    f"{inputs.brief(str(error), 120)}") from None


def _compare(results: Sequence, reference: Callable, cases: Sequence[Case],
             entry: Callable[[tuple], str], slips: Sequence[Slip]) -> None:
    """Raise `Wrong` at the first case where the results leave the reference."""
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
            fault = _for(case) + (f"{entry(index)} should be {should}, got {got}." if case
                                  else f"{entry(index)} is not {got}.")
            raise Wrong(" ".join([fault, *first_of(slips, is_slip)]))


def _array(result: Any, shape: tuple, case: Case) -> np.ndarray:
    try:
        array = inputs.real_array("the result", result, f"numbers of shape {shape}")
    except ValueError as error:
        raise Wrong(f"{_for(case)}{error}.") from None
    if array.shape != shape:
        raise Wrong(f"{_for(case)}expected a result of shape {shape}, got {array.shape}.")
    return array


def _close(a: np.ndarray, b: Any) -> np.ndarray:
    return np.isclose(a, b, rtol=TOLERANCE, atol=TOLERANCE)


def first_of(slips: Sequence[Slip], matches: Callable) -> list[str]:
    """The message of the first slip that matches, as a list of one, or an empty list."""
    return next(([message] for message, wrong in slips if matches(wrong)), [])


def _parts(answer: Any, names: Any, noun: str) -> list:
    """The parts of an answer that comes as a list, a tuple, an array or a sympy matrix."""
    every = list(names)
    listed = every if len(every) < 7 else [every[0], "...", every[-1]]
    wanted = f"{len(every)} {noun}{'s' * (len(every) > 1)}: {', '.join(listed)}"
    _refuse_stub(answer, f"Give {wanted}.")
    if isinstance(answer, (str, bytes, dict, set)) or not hasattr(answer, "__len__"):
        raise Wrong(f"Expected {wanted}, in a list; got {inputs.brief(answer)}.")
    parts = list(np.ravel(answer)) if hasattr(answer, "shape") else list(answer)
    if parts and all(map(is_stub, parts)):
        raise Blank(f"Give {wanted}.")
    if len(parts) != len(names):
        raise Wrong(f"Expected {wanted}; got {len(parts)}.")
    stubs = [name for name, part in zip(names, parts) if is_stub(part)]
    if stubs:
        raise Wrong(f"{stubs[0]}: this {noun} is still the stub; replace its ...")
    return parts


def _value(name: str, part: Any, point: Case, constants: Case) -> float:
    import sympy  # only lessons with expressions to judge need it

    if not isinstance(part, (Real, sympy.Expr)):
        raise Wrong(f"{name}: expected a sympy expression, got {inputs.brief(part)}"
                    + ("; leave out the quotes." if isinstance(part, str) else "."))
    expression = sympy.sympify(part, strict=True)  # strict: numbers only, never text
    symbols, values = expression.free_symbols, {**constants, **point}
    strange = sorted({symbol.name for symbol in symbols} - set(values))
    if strange:
        raise Wrong(f"{name} holds {', '.join(strange)}; only "
                    f"{', '.join([*point, *constants])} may stand in it.")
    try:
        return float(expression.subs({s: values[s.name] for s in symbols}))
    except (TypeError, ValueError):
        raise Wrong(f"{name} is not a real number at {_said(point)}.") from None


def _numbers(name: str, part: Any, allowed: set, noun: str) -> set:
    if isinstance(part, (str, bytes)) or not hasattr(part, "__len__"):
        raise Wrong(f"{name}: expected a set of {noun} numbers such as {{1, 2}}, "
                    f"got {inputs.brief(part)}.")
    for joint in part:
        if joint not in allowed:
            raise Wrong(f"{name}: there is no {noun} {inputs.brief(joint)}; choose from "
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
