"""A prediction: a question with its picture, answered once, then shown."""
from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from dataclasses import replace
from typing import Any, ClassVar, NamedTuple

import numpy as np
import traitlets

from ..answers.prediction import Asked, Case, Direction, Mark, Told
from ..arms import inputs
from ..browser import bundle, page
from ..drawing import guess, worker
from ..drawing.scene import Scene
from ..marks import record
from .live import LiveView

_BLANK = Scene(name="Prediction", motions=(), items=(), tip=0, center=(0.0, 0.0, 0.0), radius=1.0)


class Answered(NamedTuple):
    """A prediction that was committed: the number of its case, from 0, and the answer."""

    case: int
    answer: Any


class Prediction(LiveView):
    """A question that is answered before its picture moves.

    It holds a picture of its own, in which no other cell moves anything. Once an answer is
    committed, the picture goes to where the question asked for, what was marked stays, and the gap
    is drawn; from then on it is a live view like any other. An answer is not changed afterwards,
    and can be looked back at; "Another one" asks the next case.

    Parameters
    ----------
    name : str
    asked : Asked
        The cases, and the view whose picture it shows.
    view : LiveView, optional
        Another view to show a picture of; it goes along once an answer is committed.

    Attributes
    ----------
    name : str
    case : int
        Number of the case that is asked now, from 0.
    committed : bool
        Whether that has been answered.
    answers : list of Answered
        All that has been committed, in order.

    Examples
    --------
    >>> from kinlab.answers.prediction import Choice
    >>> asked = Asked(None, [Choice(ask="Do rotations commute?", why="Turn a book both ways.",
    ...     options={"in the plane": "", "everywhere": "Turn a book."}, right="in the plane")])
    >>> prediction = Prediction("rotation.order", asked)
    >>> prediction.commit("everywhere")
    >>> prediction.told
    Told(ok=False, said='Not so. Turn a book. The answer: in the plane.')
    """

    _esm = bundle.module("host_predict.js")
    _css = bundle.style("live.css", "predict.css")
    _page: ClassVar[dict] = {"script": "host_course.js", "styles": ("predict.css",)}
    question = traitlets.Dict().tag(sync=True)
    record: traitlets.List = traitlets.List().tag(sync=True)  # of {"case", "answer"}
    case = traitlets.Int().tag(sync=True)

    def __init__(self, name: str, asked: Asked, view: LiveView | None = None) -> None:
        shown = asked.view() if view is None and asked.view else view
        scene, values = shown.copied() if shown else (_BLANK, [])
        self.name, self._partner = name, view
        self.cases = tuple(_in_unit(case, scene) for case in asked.cases)
        self._guess = guess.with_guess(scene, _wanted(self.cases))
        self._own = self._guess.first
        self._begin = list(values)
        super().__init__(self._guess.scene, formula=shown.formula if shown else "")
        self.question = {"name": name, "first": self._own, "cases": list(map(self._told, range(
            len(self.cases))))}
        self._ask(0)
        self.observe(self._recorded, "record")

    # ---- what is asked and answered ----

    @property
    def committed(self) -> bool:
        return any(one.case == self.case for one in self.answers)

    @property
    def answers(self) -> list[Answered]:
        given: dict[int, Answered] = {}
        for one in self.record:  # the browser sends it, and a notebook keeps it
            with suppress(ValueError, TypeError, KeyError):
                case, answer = inputs.whole("case", one["case"], 0), one["answer"]
                if case < len(self.cases) and case not in given:
                    given[case] = Answered(case, answer if answer is None else
                                           self.cases[case].read(answer))
        return list(given.values())

    @property
    def told(self) -> Told | None:
        """What is said to the answer of the case that is asked now; None while it is open."""
        given = [one.answer for one in self.answers if one.case == self.case]
        return self.cases[self.case].told(given[0], self.truth(self.case)) if given else None

    def commit(self, answer: Any = None) -> None:
        """Answer the case that is asked now; None says that one has no guess.

        Raises
        ------
        ValueError
            If it has been answered, or the answer is none for this kind of question.
        """
        if self.committed:
            raise ValueError("answer: this prediction has been committed and stays as it is; "
                             "ask() asks another one")
        given = None if answer is None else self.cases[self.case].read(answer)
        self.record = [*self.record, {"case": self.case, "answer": given}]
        self._move(self._shown_at(self.case, given))

    def ask(self) -> None:
        """Ask the next case that has not been answered; ValueError if there is none."""
        answered = {one.case for one in self.answers}
        left = [k for k in range(len(self.cases)) if k not in answered]
        if not left:
            raise ValueError("There is no other case; look back at `answers`")
        self._ask(left[0])

    def truth(self, case: int) -> Any:
        """The right place of a mark, or direction of an arrow (degrees), from the picture."""
        one, q = self.cases[case], self._at(self.cases[case].start, self.cases[case].shows)
        if isinstance(one, Mark):
            return self._guess.place(one.of, q)
        return self._guess.turn(one.of, one.about, q) if isinstance(one, Direction) else None

    def _ask(self, case: int) -> None:
        self.case = case
        self._move(self._started(case))

    def _recorded(self, _: Any) -> None:
        """An answer has been committed, here or in the browser: it is kept, the partner goes along.
        """
        for case, answer in self.answers:
            ok = self.cases[case].told(answer, self.truth(case)).ok
            record.WORK.answered(self.name, case, ok)
        if self._partner and self.committed:
            self._partner.move(self._shown_at(self.case, None)[:len(self._partner.q)])

    # ---- where the knobs stand ----

    def move(self, q: Any) -> None:
        n = len(self.q)
        values = inputs.shaped("q", q, (n,), f"{n} values, one for each slider")
        self._move([*values, *self._values[n:]])

    def _joints_of(self, scene: Scene) -> int:
        return min(self._own, super()._joints_of(scene))

    def _at(self, *settings: Mapping[str, float]) -> list[float]:
        """Values of the view's own knobs, with some set in their sliders' units."""
        q = list(self._begin)
        names = list(self._named)[:self._own]
        for name, value in [pair for one in settings for pair in one.items()]:
            if name not in names:
                raise ValueError(f"view: has no slider {name!r}, which the question moves; hand "
                                 "over the view of its lesson, or none")
            knob = self.knob(name)
            q[names.index(name)] = float(value) * knob.scale
        return q

    def _started(self, case: int) -> list[float]:
        """All knobs, as they stand while the case is open."""
        one = self.cases[case]
        q = self._at(one.start)
        if isinstance(one, Mark):
            truth = self.truth(case)
            begin = self._guess.place(one.of, q) if one.begin is None else one.begin
            return [*q, *(b if axis in one.axes else t
                          for axis, b, t in zip("xyz", begin, truth)), 0.0]
        if isinstance(one, Direction):
            return [*q, *self._guess.place(one.of, q), np.radians(one.begin)]
        return [*q, *[0.0] * (len(self._guess.scene.knobs) - len(q))]

    def _shown_at(self, case: int, answer: Any) -> list[float]:
        """All knobs, as they stand once the case has been answered."""
        one = self.cases[case]
        q, own = self._at(one.start, one.shows), self._started(case)[self._own:]
        if isinstance(one, Mark):
            own = [*(own[:3] if answer is None else answer), 0.0]
        if isinstance(one, Direction):
            turn = one.begin if answer is None else answer
            own = [*self._guess.place(one.of, q), np.radians(turn)]
        return [*q, *own]

    # ---- for the browser, for places where no widget runs, and for readers ----

    def _told(self, case: int) -> dict:
        """One case as plain data."""
        one = self.cases[case]
        return one.data() | {
            "start": self._started(case), "shows": self._shown_at(case, None)[:self._own],
            "origin": self._shown_at(case, None)[self._own:self._own + 3],
            "truth": self.truth(case)}

    def html(self, *, address: bool = False) -> str:
        data = {"scene": self.scene, "q": self._started(0), "question": self.question}
        still = self._still() if self._scene.items else None
        return page.part(still, data, repr(self), self.formula)

    def _parts(self) -> list[str]:
        """Names of what belongs to the guess and is to be seen now."""
        one = self.cases[self.case]
        if not isinstance(one, Mark | Direction):
            return []
        yours = f"{guess.YOURS}arrow-{one.about}" if isinstance(one, Direction) else \
            f"{guess.YOURS}dot"
        return [yours, f"{yours}-name", *[f"{guess.GAP}{one.of}"] * self.committed]

    def _run(self) -> str:
        return "Run this cell to answer"

    def _still(self, words: str = "") -> bytes:
        scene = guess.still(self._scene, self._parts())
        seen = self.cases[self.case].seen if not self.committed else ""
        return worker.png(scene, self._values, seen or scene.seen_from, scene.shown,
                          words)

    def _elsewhere(self) -> tuple[dict, dict]:
        if not self._scene.items:
            return {"text/plain": f"{self!r}\n{self._run()}."}, {}
        return super()._elsewhere()

    def __repr__(self) -> str:
        one, told = self.cases[self.case], self.told
        state = "open" if told is None else told.said
        lines = [f"Prediction({self.name!r}): {one.ask}", *one.lines(), state]
        return "\n".join([*lines, one.why] if told else lines)


def _in_unit(case: Case, scene: Scene) -> Case:
    """A mark without a unit is in that of the view's table."""
    if not isinstance(case, Mark) or case.unit or not scene.pose:
        return case
    return replace(case, unit=scene.pose.unit)


def _wanted(cases: tuple[Case, ...]) -> list[guess.Wanted]:
    marks = [guess.Wanted(one.of, unit=one.unit) for one in cases if isinstance(one, Mark)]
    return marks + [guess.Wanted(one.of, one.about) for one in cases if isinstance(one, Direction)]
