"""What Python computes of turned frames, for fixtures.py: all signs, and the singular places."""
from __future__ import annotations

from itertools import product
from math import radians

import numpy as np

from kinlab.arms.motions import ROTATE, TRANSLATE
from kinlab.drawing.readings import RollPitchYaw, TurnAngle, TurnAxis, Turned
from kinlab.drawing.scene import Scene, Step

X, Y, Z = 0, 1, 2
BODY, OTHER = 5, 7  # frames at the end of one branch and of another
PLACES = [*product((-130, 0, 180), (-90, -25, 90), (-75, 180)), (40, 120, 30), (0, 89.9, 50),
          (0, 0, 0), (0, 180, 0), (360, 0, 0), (0, 0, 720)]


def scene() -> Scene:
    """Yaw, pitch and roll with slides between them, and a branch that turns about its own y."""
    return Scene((Step(TRANSLATE, X, 0.7), Step(ROTATE, Z, joint=0), Step(ROTATE, Y, joint=1),
                  Step(TRANSLATE, Z, joint=0), Step(ROTATE, X, joint=2),
                  Step(ROTATE, X, 0.5, parent=2), Step(ROTATE, Y, 0.3, joint=2, gain=-2.0)),
                 (), BODY, (0.0, 0.0, 0.0), 1.0)


def turned() -> dict:
    """Each description of both frames, at places of the knobs."""
    made = scene()
    return {"motions": made.data()["motions"], "places": [
        {"q": q, "frame": frame, "read": {kind.kind: _plain(kind(frame).read(
            made.motions, made.frames(q), q)) for kind in
            (Turned, TurnAxis, TurnAngle, RollPitchYaw)}}
        for angles in PLACES for q in [[radians(angle) for angle in angles]]
        for frame in (BODY, OTHER)]}


def _plain(part: np.ndarray | str) -> list | str:
    return part if isinstance(part, str) else np.round(part, 12).tolist()
