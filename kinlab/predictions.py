"""Questions that are answered before something moves.

`answers` says which kinds there are; `lessons` holds those of each lesson, with their views.
"""
from __future__ import annotations

from . import lessons
from .arms import inputs
from .views.folding import fold_answers
from .views.live import LiveView
from .views.prediction import Prediction


def predict(name: str, view: LiveView | None = None) -> Prediction:
    """Ask for a prediction: answer, commit, then see.

    Parameters
    ----------
    name : str
        Lesson and word, such as "rotation.riding".
    view : LiveView, optional
        Show a picture of this view, as it stands now; the lesson's own if left out. It goes along
        once an answer is committed.

    Returns
    -------
    Prediction
        A widget, with `commit(answer)`, `committed`, `answers` and `told`.

    Raises
    ------
    ValueError
        If there is no prediction of this name, or `view` is none or has not what is asked for.
    """
    fold_answers()
    lesson = inputs.choice("name", name.partition(".")[0] if isinstance(name, str) else name,
                           lessons.names())
    known = lessons.predictions(lesson)
    asked = known[inputs.choice("name", name, tuple(known))]
    if view is not None and not isinstance(view, LiveView):
        raise ValueError(f"view: expected a view such as kl.ArmView(arm), got {inputs.brief(view)}")
    return Prediction(name, asked, view)
