"""Elementary motions and the one frame recurrence that everything in kinlab follows.

A frame is three axis columns and an origin. It moves only along or about its own axes. A
rotation stays *pending* until a different axis turns, so the angles of parallel joints add up
before any cosine is taken: cos(q2 + q3 + q4) appears by construction, not by simplification.

Vectors are tuples of three components. A component may be a float, an array (a batch of poses)
or a sympy expression. The whole numbers 0, 1 and -1 mark constants that hold for every pose;
products with them are dropped, which keeps batches fast and symbols tidy.
"""
from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

# The values of the joints, or the components of a vector: numbers, batches or expressions.
Values = Sequence[Any] | np.ndarray
Numbers = Sequence[float] | np.ndarray  # one pose or one vector, in plain numbers

X, Y, Z = 0, 1, 2
ROTATE, TRANSLATE = "rotate", "translate"

# The doubles that stand for quarter turns: radians(90) means 90 degrees, so its cosine is 0.
_QUARTER_TURNS = {k * math.pi / 2: ((1, 0, -1, 0)[k % 4], (0, 1, 0, -1)[k % 4])
                  for k in range(-4, 5)}


@dataclass(frozen=True, slots=True)
class Motion:
    """Rotate about, or translate along, one of the moving frame's own axes.

    Parameters
    ----------
    kind : {"rotate", "translate"}
    axis : {0, 1, 2}
        x, y or z of the frame that moves.
    amount : float or sympy expression
        Constant part: an angle in radians or a length.
    joint : int, optional
        Index of the joint variable that is added to `amount`.
    sign : {1, -1}
        -1 where the joint variable is taken away instead.
    """

    kind: str
    axis: int
    amount: Any = 0
    joint: int | None = None
    sign: int = 1

    def value(self, q: Values) -> Any:
        """Angle or length of the motion at joint values `q`."""
        if self.joint is None:
            return self.amount
        q_i = q[self.joint]
        return (q_i if self.sign > 0 else -q_i) + self.amount

    @property
    def idle(self) -> bool:
        """True for a constant motion by nothing."""
        return self.joint is None and self.amount == 0


class Frame(NamedTuple):
    """Axis columns and origin of a frame, with the rotation that is still pending.

    `turned` keeps the axes after that rotation once a slide has asked for them.
    """

    axes: tuple = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
    origin: tuple = (0, 0, 0)
    about: int | None = None
    angle: Any = 0
    turned: tuple | None = None

    def settled(self) -> tuple:
        """The axis columns, with the pending rotation carried out."""
        if self.about is None or self.turned:
            return self.turned or self.axes
        i, j = (self.about + 1) % 3, (self.about + 2) % 3
        c, s = cos_sin(self.angle)
        axes = list(self.axes)
        u, v, minus_s = axes[i], axes[j], -s
        axes[i] = tuple(_sum(_product(c, a), _product(s, b)) for a, b in zip(u, v))
        axes[j] = tuple(_sum(_product(c, b), _product(minus_s, a)) for a, b in zip(u, v))
        return tuple(axes)

    def rotated(self, axis: int, angle: Any) -> Frame:
        """The frame turned about its own axis."""
        if self.about == axis:
            return Frame(self.axes, self.origin, axis, self.angle + angle)
        return Frame(self.settled(), self.origin, axis, angle)

    def translated(self, axis: int, distance: Any) -> Frame:
        """The frame slid along its own axis."""
        turned = self.turned if self.about in (None, axis) else self.settled()
        direction = (turned or self.axes)[axis]
        origin = tuple(_sum(o, _product(distance, e)) for o, e in zip(self.origin, direction))
        return Frame(self.axes, origin, self.about, self.angle, turned)

    def moved(self, motion: Motion, q: Values) -> Frame:
        """The frame after one elementary motion at joint values `q`."""
        if motion.idle:
            return self
        step = self.rotated if motion.kind == ROTATE else self.translated
        return step(motion.axis, motion.value(q))


def follow(motions: Iterable[Motion], q: Values, frame: Frame | None = None) -> Frame:
    """The frame at the end of a sequence of motions."""
    frame = Frame() if frame is None else frame
    for motion in motions:
        frame = frame.moved(motion, q)
    return frame


def along(chain: Iterable[Iterable[Motion]], q: Values) -> Iterator[Frame]:
    """The frame after each stretch of a chain (after base, link 1, link 2, ...)."""
    frame = Frame()
    for motions in chain:
        frame = follow(motions, q, frame)
        yield frame


def motions_of(T: np.ndarray) -> tuple[Motion, ...]:
    """Elementary motions Tx Ty Tz Rz Ry Rx that make a constant rigid matrix."""
    R, origin = T[:3, :3], T[:3, 3]
    # Where x points straight up, yaw and roll turn about one axis and rounding noise has no say.
    yaw = math.atan2(R[1, 0], R[0, 0]) if math.hypot(R[1, 0], R[0, 0]) > 1e-12 else 0.0
    c, s = math.cos(yaw), math.sin(yaw)
    # Taking the rest from Rz(-yaw) R keeps the product exact when x points straight up.
    pitch = math.atan2(-R[2, 0], c * R[0, 0] + s * R[1, 0])
    roll = math.atan2(s * R[0, 2] - c * R[1, 2], c * R[1, 1] - s * R[0, 1])
    slides = [Motion(TRANSLATE, axis, float(origin[axis])) for axis in (X, Y, Z)]
    turns = [Motion(ROTATE, axis, angle) for axis, angle in ((Z, yaw), (Y, pitch), (X, roll))]
    return tuple(motion for motion in slides + turns if not motion.idle)


def cos_sin(angle: Any) -> tuple[Any, Any]:
    """Cosine and sine of a number, an array or a sympy expression."""
    if isinstance(angle, (int, float)):
        return _QUARTER_TURNS.get(angle) or (math.cos(angle), math.sin(angle))
    if isinstance(angle, np.ndarray) and angle.dtype != object:
        return np.cos(angle), np.sin(angle)
    import sympy  # the caller brought a symbol, so sympy is loaded already

    return tuple(np.frompyfunc(f, 1, 1)(angle) for f in (sympy.cos, sympy.sin))


def stack(rows: Sequence[Sequence[Any]]) -> np.ndarray:
    """A matrix (..., r, c) from its components, each a number, a batch or a symbol."""
    entries = [entry for row in rows for entry in row]
    if all(isinstance(entry, (int, float)) for entry in entries):
        return np.array(rows, dtype=float)
    symbolic = any(np.asarray(entry).dtype == object for entry in entries)
    shape = np.broadcast_shapes(*map(np.shape, entries))
    matrix = np.empty((*shape, len(rows), len(rows[0])), dtype=object if symbolic else float)
    for i, row in enumerate(rows):
        for j, entry in enumerate(row):
            matrix[..., i, j] = entry
    return keep_whole(matrix)[0]


def matrix(frame: Frame) -> np.ndarray:
    """The homogeneous matrix (..., 4, 4) of a frame."""
    columns = (*frame.settled(), frame.origin)
    return stack([*zip(*columns), (0, 0, 0, 1)])


def rotation(axis: int, angle: Any) -> np.ndarray:
    """The rotation matrix (..., 3, 3) about one of the three axes."""
    return matrix(Frame().rotated(axis, angle))[..., :3, :3]


def keep_whole(*arrays: np.ndarray) -> tuple[np.ndarray, ...]:
    """The arrays; beside symbols 1.0 becomes 1: nobody wants to read 1.0*cos(theta)."""
    if all(array.dtype != object for array in arrays):
        return arrays
    return tuple(_exact_wholes(array) for array in arrays)


_exact_wholes = np.frompyfunc(
    lambda entry: int(entry) if isinstance(entry, float) and entry.is_integer() else entry, 1, 1)


def cross(u: Values, v: Values) -> tuple:
    """The cross product of two vectors, each a sequence of three components."""
    return tuple(_difference(_product(u[i], v[j]), _product(u[j], v[i]))
                 for i, j in ((1, 2), (2, 0), (0, 1)))


def difference(u: Values, v: Values) -> tuple:
    """u - v, component by component."""
    return tuple(map(_difference, u, v))


def _product(a: Any, b: Any) -> Any:
    if type(a) is int and -1 <= a <= 1:
        return b if a == 1 else (a and -b)
    if type(b) is int and -1 <= b <= 1:
        return a if b == 1 else (b and -a)
    return a * b


def _sum(a: Any, b: Any) -> Any:
    if type(a) is int and a == 0:
        return b
    return a if type(b) is int and b == 0 else a + b


def _difference(a: Any, b: Any) -> Any:
    if type(b) is int and b == 0:
        return a
    return -b if type(a) is int and a == 0 else a - b
