"""Painter's order: which body is drawn over which. A plane between two bodies tells.

The one on the viewer's side of it is in front. kinlab/browser/order.js does the same.
"""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..arms.motions import Numbers
from .camera import Lens

_RIM = 1.5                      # px: half a stroke and a little air
_LEVEL = 1e-9                   # of a length: side by side, none in front
_TUCKED, _ENDS = 0.8, 0.01      # radii: a line that begins inside a solid
_SAME = 1e-6                    # px: depths that differ less are the same


@dataclass(frozen=True, eq=False)
class Body:
    """What lies within `r` of the line from `p` to `q`, in the room.

    With `plane`, a normal and a point of it, everything else stands before or behind the body as a
    whole, as round a flat base.
    """

    p: Numbers
    q: Numbers
    r: float
    plane: tuple[Numbers, Numbers] | None = None


def back_to_front(bodies: Sequence[Body], lens: Lens) -> list[int]:
    """Indices of bodies from the farthest to the nearest.

    Nothing is remembered from one picture to the next: the same pose gives the same order. Where
    several may come next, and where bodies cover each other in a circle, the farthest does, and of
    equal ones the first.
    """
    if not bodies:
        return []
    p, q = (np.array([getattr(body, end) for body in bodies], dtype=float) for end in "pq")
    r = np.array([body.r for body in bodies], dtype=float)
    depth = np.floor((p + q) / 2 @ lens.near * lens.scale / _SAME + 0.5)
    i, j = np.triu_indices(len(bodies), 1)
    meet = ((r[i] > 0) | (r[j] > 0)) & _meet(*_seen(p, q, r, lens), i, j)
    i, j = i[meet], j[meet]
    front = _in_front(p, q, r, i, j, lens)
    for k, (one, other) in enumerate(zip(i, j)):
        if (plane := bodies[one].plane) is not None:
            front[k] = _side_of(plane, bodies[other], lens)
        elif (plane := bodies[other].plane) is not None:
            front[k] = -_side_of(plane, bodies[one], lens)
    front = np.where(front, front, depth[j] - depth[i])
    back, fore = np.where(front > 0, [i, j], [j, i])[:, front != 0]
    return _sorted(depth, back, fore)


def _sorted(depth: np.ndarray, back: np.ndarray, fore: np.ndarray) -> list[int]:
    """All indices, each of `back` before its partner in `fore` as far as that can be."""
    left = sorted(range(len(depth)), key=lambda i: depth[i])
    below = np.bincount(fore, minlength=len(depth))
    order: list[int] = []
    while left:
        order.append(next((i for i in left if below[i] == 0), left[0]))
        left.remove(order[-1])
        np.subtract.at(below, fore[back == order[-1]], 1)
    return order


def _seen(p: np.ndarray, q: np.ndarray, r: np.ndarray,
          lens: Lens) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Bodies on the picture: the ends of strokes, and half their widths (px)."""
    a, b = lens.see(p), lens.see(q)
    wide = r * lens.scale * np.maximum(a[:, 2], b[:, 2]) + _RIM
    return a * [1, 1, 0], b * [1, 1, 0], wide


def _meet(a: np.ndarray, b: np.ndarray, wide: np.ndarray, i: np.ndarray,
          j: np.ndarray) -> np.ndarray:
    """Which pairs of strokes lie over each other on the picture."""
    from_, to = _nearest(a[i], b[i], a[j], b[j])
    return np.sum((to - from_)**2, axis=-1) <= (wide[i] + wide[j])**2


def _in_front(p: np.ndarray, q: np.ndarray, r: np.ndarray, i: np.ndarray, j: np.ndarray,
              lens: Lens) -> np.ndarray:
    """For each pair above zero where `j` is in front of `i`, below where it is behind.

    Zero where the plane between them says nothing.
    """
    a, b = _nearest(p[i], q[i], p[j], q[j])
    gap = np.linalg.norm(b - a, axis=-1)
    middle = np.clip(_ratio(gap + r[i] - r[j], 2 * gap), 0, 1)  # of what is free between them
    front = np.sum((b - a) * lens.eye(a + middle[:, None] * (b - a)), axis=-1)
    front[np.abs(front) <= _LEVEL * (gap + r[i] + r[j])] = 0
    front[(r[j] == 0) & _tucked(p[i], q[i], r[i], a, gap)] = -1
    front[(r[i] == 0) & _tucked(p[j], q[j], r[j], b, gap)] = 1
    return front


def _side_of(plane: tuple[Numbers, Numbers], body: Body, lens: Lens) -> float:
    """Above zero where a body is on the viewer's side of a plane, below where it is beyond."""
    normal, at = plane
    middle = (np.asarray(body.p) + body.q) / 2
    return float(np.sign(np.dot(middle - at, normal)) * np.sign(np.dot(normal, lens.eye(at))))


def _tucked(p: np.ndarray, q: np.ndarray, r: np.ndarray, at: np.ndarray,
            gap: np.ndarray) -> np.ndarray:
    """Whether lines come out of solids' sides: a solid covers what is inside it."""
    inside = np.minimum(np.linalg.norm(at - p, axis=-1), np.linalg.norm(at - q, axis=-1))
    return (gap < _TUCKED * r) & (inside > _ENDS * r)


def _nearest(p: np.ndarray, q: np.ndarray, s: np.ndarray,
             t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The points of segments that are nearest to each other; of parallel ones, those in the middle
    of what lies side by side: so it is all the same which of the two comes first.
    """
    d, e, r = q - p, t - s, p - s
    dd, ee, de, dr, er = (np.sum(u * v, axis=-1)
                          for u, v in ((d, d), (e, e), (d, e), (d, r), (e, r)))
    square = dd * ee - de**2
    beside = (np.clip(_ratio(-dr, dd), 0, 1) + np.clip(_ratio(de - dr, dd), 0, 1)) / 2
    first = np.where(square > 1e-9 * dd * ee,
                     np.clip(_ratio(de * er - dr * ee, square), 0, 1), beside)
    along = np.clip(_ratio(de * first + er, ee), 0, 1)
    back = np.clip(_ratio(de * along - dr, dd), 0, 1)
    return p + back[:, None] * d, s + along[:, None] * e


def _ratio(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """The quotient a / b, zero where b is."""
    return np.divide(a, b, out=np.zeros_like(a), where=b != 0)
