"""Judges of students' answers, made from a reference and a list of slips.

A judge takes an answer and returns a `Verdict`: a word of praise, or the sentence that says what
is wrong. A slip is a wrong answer that can be computed, with the sentence that explains it. It is
named where it explains all that the student gave. Text from students is never evaluated, and what
they hand over is never changed.
"""
from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import wraps
from numbers import Real
from typing import Any, TypeVar

import numpy as np

from ..arms import inputs
from .calls import Call, called
from .given import MOST, Given, is_stub, length, numbers, untouched
from .hints import Names, Results, hint
from .raised import in_words
from .verdict import BLANK, CORRECT, NOT_YET, Verdict
from .words import apart, counted, listed, plain, right_but, to_do

__all__ = ["Case", "Judge", "Slip", "choices", "evaluated", "expressions", "first_of", "function",
           "is_stub", "values"]

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


# ---- Functions -----------------------------------------------------------------------------------


def function(reference: Callable, cases: Sequence[Case], *, entry: Names,
             slips: Sequence[Slip] = (), praise: str, angles: Any = False, without: str = "",
             prepare: Callable[..., Sequence] | None = None,
             read: Callable[[Any], Any] | None = None, part: Names | None = None) -> Judge:
    """Judge of a function: it must equal the reference in every case.

    Each case is copied before each call. The first one is tried once more at the end, since a
    function may keep something between its calls.

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
    angles : bool, or array of bool
        Which entries are angles: whole turns make no difference.
    without : str
        Said, if the task forbids kinlab's own functions, to who calls one.
    prepare : callable, optional
        Makes the student's arguments of a case's values; they are the arguments if left out.
    read : callable, optional
        Makes numbers of a result, or raises a ValueError that says what is wrong with it.
    part : callable, optional
        Names the part that an entry belongs to, for what is still to do.
    """
    @_reading
    def judge(answer: Any) -> Verdict:
        if is_stub(answer):
            return Verdict(BLANK, "Replace the ... by your function.")
        if not callable(answer):
            return Verdict(NOT_YET, f"Expected a function, got {inputs.brief(answer)}; hand it "
                                    "over by its name, without parentheses.")
        *calls, again = (called(answer, prepare(*case.values()) if prepare else [*case.values()],
                                watched=bool(without)) for case in [*cases, cases[0]])
        _refuse_help(calls, without)
        _refuse_errors(calls, cases, slips)
        if all(untouched(call.result) for call in calls):
            return Verdict(BLANK, "The function returns nothing so far. Replace the ... and end "
                                  "with return.")
        rights = [np.asarray(reference(*case.values())) for case in cases]
        given = [_result(call.result, right.shape, _for(case), read)
                 for call, right, case in zip(calls, rights, cases)]
        verdict = _compared(Results(given, rights, angles), cases, entry, slips, praise,
                            part or ())
        if verdict.ok:
            verdict = _repeated(again, rights[0], cases[0], entry, angles, read) or verdict
        return _with_remark(verdict, calls, cases, prepare is None)
    return judge


def _refuse_help(calls: Sequence[Call], without: str) -> None:
    helper = next((call.helper for call in calls if call.helper), "")
    if without and helper:
        raise _Unreadable(f"Your function calls kinlab's own `{helper}`. {without}")


def _refuse_errors(calls: Sequence[Call], cases: Sequence[Case],
                   slips: Sequence[Slip] = ()) -> None:
    for call, case in zip(calls, cases):
        if call.error is not None:
            raise _Unreadable(" ".join([
                f"For {_said(case)} your function raised {in_words(call.error)}.",
                *first_of(slips, lambda slip: _fails_alike(slip, calls, cases))]))


def _fails_alike(slip: Callable, calls: Sequence[Call], cases: Sequence[Case]) -> bool:
    """Whether a slip raises where the student's function does, and gives the same elsewhere."""
    wrongs = [called(slip, [*case.values()]) for case in cases]
    return all((call.error is None) == (wrong.error is None) and (
        call.error is not None or _close(call.result, wrong.result))
        for call, wrong in zip(calls, wrongs))


def _close(result: Any, wrong: Any) -> bool:
    try:
        return np.shape(result) == np.shape(wrong) and np.allclose(result, wrong)
    except (TypeError, ValueError):  # no numbers
        return False


def _result(result: Any, shape: tuple, start: str, read: Callable | None) -> Given:
    if is_stub(result):
        raise _Unreadable(f"{start}: your function returns nothing here. Does every way through it "
                          "end with return?")
    try:
        result = read(result) if read else result
    except ValueError as error:
        raise _Unreadable(f"{start}: {error}.") from None
    return _numbers_of(result, shape, start, "your function")


def _numbers_of(value: Any, shape: tuple, start: str, who: str) -> Given:
    try:
        return numbers(value, shape, start=start, who=who)
    except ValueError as error:
        raise _Unreadable(f"{error}.") from None


def _repeated(again: Call, right: np.ndarray, case: Case, entry: Names, angles: Any,
              read: Callable | None) -> Verdict | None:
    """What there is to say of a function that gives something else when it is called once more."""
    keeps = "Called with the same numbers again, your function should give the same again."
    _refuse_errors([again], [case])
    given = _result(again.result, right.shape, f"{keeps} {_for(case)}", read)
    wrong = _first_wrong(Results([given], [right], angles), [case], entry)
    return Verdict(NOT_YET, f"{keeps} {wrong} Does it keep something between two calls?") \
        if wrong else None


def _with_remark(verdict: Verdict, calls: Sequence[Call], cases: Sequence[Case],
                 named: bool) -> Verdict:
    """The praise, with a word on arguments that the function wrote into."""
    changed = next((call.changed for call in calls if call.changed), ())
    if not (verdict.ok and changed):
        return verdict
    what = f"the {list(cases[0])[changed[0]]}" if named else "what"
    return Verdict(CORRECT, f"{verdict.message} One remark: your function changes {what} that it "
                            "is given. Take a copy of it first, with np.array(...).")


# ---- Numbers -------------------------------------------------------------------------------------


def values(right: Any, *, entry: Names, slips: Sequence[tuple[str, Any]] = (), praise: str,
           angles: Any = False, parts: Sequence[str] = ()) -> Judge:
    """Judge of a vector or a matrix of numbers, which does not tell the right ones.

    Parameters
    ----------
    right : array
    entry : callable
        Names an entry by its index.
    slips : sequence of (message, wrong array)
    praise : str
    angles : bool, or array of bool
        Which entries are angles: whole turns make no difference.
    parts : sequence of str
        What each row is called, where each is an answer by itself.
    """
    right = np.asarray(right, dtype=float)
    named = [(message, lambda wrong=wrong: np.asarray(wrong)) for message, wrong in slips]

    @_reading
    def judge(answer: Any) -> Verdict:
        if is_stub(answer):
            return Verdict(BLANK, "Replace the ... by your numbers.")
        if untouched(answer):
            return Verdict(BLANK, "Replace every ... by a number.")
        given = (_by_parts(answer, right, parts) if parts else
                 _numbers_of(answer, right.shape, "Your answer", "you"))
        return _compared(Results([given], [right], angles), [{}], entry, named, praise, parts)
    return judge


def _by_parts(answer: Any, right: np.ndarray, parts: Sequence[str]) -> Given:
    """The rows of an answer, each read by itself, so that a message can name it."""
    if not isinstance(answer, (list, tuple, np.ndarray)) or len(answer) != len(parts):
        return _numbers_of(answer, right.shape, "Your answer", "you")
    rows = [_numbers_of(part, row.shape, name, "you")
            for name, part, row in zip(parts, answer, right)]
    return Given(np.array([row.numbers for row in rows]), any(row.whole for row in rows))


# ---- What numbers are compared with --------------------------------------------------------------


def _compared(results: Results, cases: Sequence[Case], entry: Names, slips: Sequence[Slip],
              praise: str, parts: Sequence[str] | Names = ()) -> Verdict:
    """The praise, or the first case where the results leave the reference."""
    if untouched_in := [k for k, given in enumerate(results.given) if given.missing.all()]:
        raise _Unreadable(f"{_for(cases[untouched_in[0]])}: replace every ... by a number.")
    missing = _missing(results.given[0].missing, entry, parts)
    if wrong := _first_wrong(results, cases, entry):
        hints = _slip(results, cases, slips) or hint(results, entry,
                                                     "return" if cases[0] else "give")
        more = [f"Besides, {to_do(missing)}."] if missing else []
        return Verdict(NOT_YET, " ".join([wrong, *hints, *more]))
    if missing:
        there = _missing(~results.given[0].missing, entry, parts)
        return Verdict(NOT_YET, right_but([name for name in there if name not in missing], missing))
    return Verdict(CORRECT, praise)


def _slip(results: Results, cases: Sequence[Case], slips: Sequence[Slip]) -> list[str]:
    """The message of a slip that explains all numbers, with as few of them wrong as it takes."""
    found = []
    for message, wrong in slips:
        others = [called(wrong, [*case.values()]).result for case in cases]
        if results.all_same(others):
            off = sum(int(np.sum(~np.isclose(*pair))) for pair in zip(others, results.right))
            found.append((off, message))
    return [min(found, key=lambda slip: slip[0])[1]] if found else []


def _first_wrong(results: Results, cases: Sequence[Case], entry: Names) -> str:
    """Which number is the first wrong one, or ""."""
    for k, (given, right, case) in enumerate(zip(results.given, results.right, cases)):
        off = np.argwhere(~results.same(k, right))
        if len(off):
            index = tuple(off[0].tolist())
            should, got = apart(right[index], given.numbers[index])
            return f"{_for(case)}: {entry(index)} " + (f"should be {should}, got {got}." if case
                                                       else f"is not {got}.")
    return ""


def _missing(where: np.ndarray, entry: Names, parts: Sequence[str] | Names) -> list[str]:
    """The names of entries, those of a whole part by the part's name."""
    if callable(parts):
        return list(dict.fromkeys(parts(tuple(index)) for index in np.argwhere(where).tolist()))
    if not parts:
        return [entry(tuple(index)) for index in np.argwhere(where).tolist()]
    names = []
    for i, (part, here) in enumerate(zip(parts, where)):
        entries = [entry((i, *index)) for index in np.argwhere(here).tolist()]
        names += [part] if here.all() else entries
    return names


def first_of(slips: Sequence[tuple[str, Wrong]],
             matches: Callable[[Wrong], bool]) -> list[str]:
    """The message of the first slip that matches, as a list of one, or an empty list."""
    return next(([message] for message, wrong in slips if matches(wrong)), [])


# ---- Expressions ---------------------------------------------------------------------------------


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
    def verdict(results: list[list[float]]) -> Verdict:
        rights = [np.asarray(reference(*point.values()), dtype=float) for point in points]
        given = [Given(np.array(numbers)) for numbers in results]
        return _compared(Results(given, rights), points, lambda index: names[index[0]], slips,
                         praise)
    return evaluated(names, points, constants, verdict)


def evaluated(names: Sequence[str], points: Sequence[Case], constants: Case,
              verdict: Callable[[list[list[float]]], Verdict]) -> Judge:
    """Judge of sympy expressions by their numbers at points, one list for each point.

    Parameters
    ----------
    names, points, constants
        As in `expressions`.
    verdict : callable
        What there is to say of the numbers; those still to come are nan.
    """
    @_reading
    def judge(answer: Any) -> Verdict:
        parts = _parts(answer, names, "expression")
        return verdict([[_value(name, part, point, constants) for name, part in zip(names, parts)]
                        for point in points])
    return judge


def _value(name: str, part: Any, point: Case, constants: Case) -> float:
    import sympy  # only lessons with expressions to judge need it

    if is_stub(part):
        return np.nan
    if not isinstance(part, (Real, sympy.Expr)):
        raise _Unreadable(f"{name}: expected a sympy expression, got {inputs.brief(part)}"
                          + ("; leave out the quotes." if isinstance(part, str) else "."))
    expression = sympy.sympify(part, strict=True)  # strict: numbers only, never text
    symbols, values = expression.free_symbols, {**constants, **point}
    strange = sorted({symbol.name for symbol in symbols} - set(values))
    if strange:
        raise _Unreadable(f"{name} holds {listed(strange)}; only "
                          f"{', '.join([*point, *constants])} may stand in it.")
    try:
        value = float(expression.subs({s: values[s.name] for s in symbols}))
    except (TypeError, ValueError, OverflowError):
        value = np.nan
    if not np.isfinite(value):
        raise _Unreadable(f"{name} is not a real number at {_said(point)}.")
    return value


# ---- Sets ----------------------------------------------------------------------------------------


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
        parts = dict(zip(expected, _parts(answer, expected, "set")))
        missing = [name for name, part in parts.items() if is_stub(part)]
        there = {name: _chosen(name, part, allowed, noun) for name, part in parts.items()
                 if name not in missing}
        for name, given in there.items():
            extra, lacking = sorted(given - expected[name]), sorted(expected[name] - given)
            if extra or lacking:
                fault = f"not {noun} {extra[0]}" if extra else (
                    f"{counted(len(lacking), 'thing').split()[0]} "
                    f"{'is' if len(lacking) == 1 else 'are'} missing")
                hint = reasons.get((name, (extra or lacking)[0]), "")
                return Verdict(NOT_YET,
                               f"{name}: got {_braces(given)}, but {fault}. {hint}".strip())
        if missing:
            return Verdict(NOT_YET, right_but(list(there), missing))
        return Verdict(CORRECT, praise)
    return judge


def _chosen(name: str, part: Any, allowed: set, noun: str) -> set:
    if isinstance(part, (str, bytes)) or not hasattr(part, "__len__"):
        raise _Unreadable(f"{name}: expected a set of {noun} numbers such as {{1, 2}}, "
                          f"got {inputs.brief(part)}.")
    for number in part:
        if is_stub(number):
            raise _Unreadable(f"{name}: there is still a ... in it.")
        if not isinstance(number, (Real, np.number)) or number not in allowed:
            zero = f" {noun.capitalize()}s count from 1, not from 0." if number == 0 else ""
            raise _Unreadable(f"{name}: there is no {noun} {inputs.brief(number)}; choose from "
                              f"{_braces(allowed)}.{zero}")
    return {int(number) for number in part}


def _braces(numbers: set) -> str:
    return "{" + ", ".join(map(str, sorted(numbers))) + "}"


# ---- Parts of an answer --------------------------------------------------------------------------


def _parts(answer: Any, names: Any, noun: str) -> list:
    """The parts of an answer that comes as a list, a tuple, an array or a sympy matrix.

    Stubs may stand among them, if something stands there, too.
    """
    every = list(names)
    few = every if len(every) < 7 else [every[0], "...", every[-1]]
    wanted = f"{len(every)} {noun}{'s' * (len(every) > 1)}: {', '.join(few)}"
    if is_stub(answer):
        raise _Unreadable(f"Give {wanted}.", BLANK)
    if isinstance(answer, (str, bytes, dict, set)) or not hasattr(answer, "__len__"):
        raise _Unreadable(f"Expected {wanted}, in a list; got {inputs.brief(answer)}.")
    if (size := length(answer)) > MOST:
        raise _Unreadable(f"Expected {wanted}; got {size}.")
    parts = list(np.ravel(answer)) if hasattr(answer, "shape") else list(answer)
    if noun == "expression":
        parts = _flat(parts, len(every))
    if parts and all(map(is_stub, parts)):
        raise _Unreadable(f"Give {wanted}.", BLANK)
    if len(parts) != len(every):
        raise _Unreadable(f"Expected {wanted}; got {len(parts)}.")
    return parts


def _flat(parts: list, most: int) -> list:
    """Expressions that come row by row, or a column of them, as one list."""
    rows = [part for part in parts if isinstance(part, (list, tuple))]
    if not rows or len(rows) < len(parts) or sum(map(len, rows)) != most:
        return parts
    if {len(row) for row in rows} == {len(rows)}:
        raise _Unreadable(f"Your answer is a list of {counted(len(rows), 'row')}. Wrap it in "
                          "sp.Matrix(...), then it is a matrix.")
    return [part for row in rows for part in row]


def _for(case: Case) -> str:
    return f"For {_said(case)}" if case else "Your answer"


def _said(case: Case) -> str:
    return ", ".join(f"{name} = {_written(value)}" for name, value in case.items())


def _written(value: Any) -> str:
    return f"[{', '.join(map(_written, value))}]" if np.ndim(value) else plain(value)
