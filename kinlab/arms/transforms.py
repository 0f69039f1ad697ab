"""Planar and spatial rotations and homogeneous matrices, for numbers, batches and symbols.

`T_ab` is the pose of frame b in frame a. It takes the coordinates of a point in b to its
coordinates in a: ``p_a = apply(T_ab, p_b)``, and poses chain: ``T_ac = T_ab @ T_bc``. Leading
axes broadcast. Symbols give arrays of sympy expressions; ``sympy.Matrix(T)`` typesets them.
Rotations that were rounded, to 3 decimals or more, are taken as the nearest ones, with a word.
"""
from __future__ import annotations

from functools import reduce
from typing import Any

import numpy as np

from . import inputs
from .motions import X, Y, Z, cos_sin, keep_whole, rotation, stack

__all__ = ["apply", "compose", "homogeneous", "inverse", "rotation_2d", "rotation_x",
           "rotation_y", "rotation_z", "translation"]


def rotation_2d(theta: Any) -> np.ndarray:
    """Planar rotation by `theta`.

    Parameters
    ----------
    theta : float, array (...) or sympy expression
        Angle in radians, counter-clockwise.

    Returns
    -------
    array, shape (..., 2, 2)

    Examples
    --------
    >>> rotation_2d(np.pi / 2) @ [1, 0]
    array([0., 1.])
    """
    c, s = cos_sin(inputs.angle("theta", theta))
    return stack([[c, -s], [s, c]])


def rotation_x(angle: Any) -> np.ndarray:
    """Rotation about x by `angle` radians, shape (..., 3, 3)."""
    return rotation(X, inputs.angle("angle", angle))


def rotation_y(angle: Any) -> np.ndarray:
    """Rotation about y by `angle` radians, shape (..., 3, 3)."""
    return rotation(Y, inputs.angle("angle", angle))


def rotation_z(angle: Any) -> np.ndarray:
    """Rotation about z by `angle` radians, shape (..., 3, 3).

    Examples
    --------
    >>> rotation_z(np.pi / 2)
    array([[ 0., -1.,  0.],
           [ 1.,  0.,  0.],
           [ 0.,  0.,  1.]])
    >>> import sympy as sp
    >>> sp.Matrix(rotation_z(sp.Symbol("theta")))[0, 1]
    -sin(theta)
    """
    return rotation(Z, inputs.angle("angle", angle))


def homogeneous(R: Any, o: Any) -> np.ndarray:
    """Homogeneous matrix of a rotation and an origin.

    Parameters
    ----------
    R : array, shape (..., 2, 2) or (..., 3, 3)
        Rotation of the new frame: its axes as columns.
    o : array, shape (..., 2) or (..., 3)
        Origin of the new frame, in the unit of your choice.

    Returns
    -------
    array, shape (..., 3, 3) or (..., 4, 4)

    Raises
    ------
    ValueError
        If `R` is not a rotation, or the shapes do not fit together.

    Examples
    --------
    >>> homogeneous(rotation_2d(0), [2, 1])
    array([[1., 0., 2.],
           [0., 1., 1.],
           [0., 0., 1.]])
    """
    R, o = inputs.components("R", R, "a rotation matrix"), inputs.components("o", o, "an origin")
    n = R.shape[-1] if R.ndim > 1 else 0
    if n not in (2, 3) or R.shape[-2:] != (n, n) or o.shape[-1:] != (n,):
        raise ValueError("R, o: expected shapes (..., 2, 2) and (..., 2), or (..., 3, 3) and "
                         f"(..., 3), got {R.shape} and {o.shape}")
    inputs.fit_together("R, o", R.shape[:-2], o.shape[:-1])
    R = _rotation("R", R)
    rows = [[R[..., i, j] for j in range(n)] + [o[..., i]] for i in range(n)]
    return stack([*rows, [0] * n + [1]])


def translation(o: Any) -> np.ndarray:
    """Homogeneous matrix that only translates by `o`, of 2 or 3 components.

    Examples
    --------
    >>> translation([2, 1])
    array([[1., 0., 2.],
           [0., 1., 1.],
           [0., 0., 1.]])
    """
    o = inputs.components("o", o, "an origin of 2 or 3 components")
    if o.shape[-1:] not in ((2,), (3,)):
        raise ValueError(f"o: expected shape (..., 2) or (..., 3), got {o.shape}")
    return homogeneous(np.eye(o.shape[-1]), o)


def inverse(T: Any) -> np.ndarray:
    """Inverse of a homogeneous matrix: R transposed, and -R transposed times the origin.

    Parameters
    ----------
    T : array, shape (..., 3, 3) or (..., 4, 4)
        Planar or spatial homogeneous matrix, numbers or symbols.

    Returns
    -------
    array of the same shape

    Raises
    ------
    ValueError
        If `T` is not rigid.

    Examples
    --------
    >>> inverse(translation([2, 1]))[:2, 2]
    array([-2., -1.])
    """
    R, o = _parts("T", T)
    R_inverse = np.swapaxes(R, -1, -2)
    return homogeneous(R_inverse, -_times(R_inverse, o))


def apply(T: Any, p: Any) -> np.ndarray:
    """Coordinates of points in frame a from their coordinates in frame b: R p + o.

    Parameters
    ----------
    T : array, shape (..., 3, 3) or (..., 4, 4)
        Pose of frame b in frame a.
    p : array, shape (..., 2) or (..., 3)
        Points in frame b, same unit as the origin of `T`.

    Returns
    -------
    array, shape (..., 2) or (..., 3)

    Examples
    --------
    >>> apply(homogeneous(rotation_2d(np.pi / 2), [2, 0]), [1, 0])
    array([2., 1.])
    """
    R, o = _parts("T", T)
    p = inputs.components("p", p, "a point")
    if p.shape[-1:] != o.shape[-1:]:
        raise ValueError(f"p: expected shape (..., {o.shape[-1]}) for this T, got {p.shape}; "
                         "leave out the 1 that augments a point")
    inputs.fit_together("T, p", o.shape[:-1], p.shape[:-1])
    R, o, p = keep_whole(R, o, p)
    return _times(R, p) + o


def compose(*transforms: Any) -> np.ndarray:
    """Product of homogeneous matrices in the order given: T_0n = T_01 T_12 ... .

    Examples
    --------
    >>> compose(translation([2, 0]), translation([0, 1]))[:2, 2]
    array([2., 1.])
    """
    if not transforms:
        raise ValueError("transforms: expected at least one matrix, got none")
    matrices = []
    for k, T in enumerate(transforms):
        R, o = _parts(f"transforms[{k}]", T)
        matrices.append(homogeneous(R, o))
    if len({T.shape[-1] for T in matrices}) > 1:
        raise ValueError("transforms: expected all planar (3x3) or all spatial (4x4), got both")
    inputs.fit_together("transforms", *(T.shape[:-2] for T in matrices))
    return reduce(np.matmul, keep_whole(*matrices))


def _parts(name: str, T: Any) -> tuple[np.ndarray, np.ndarray]:
    T = inputs.components(name, T, "a homogeneous matrix")
    n = T.shape[-1] - 1 if T.ndim > 1 else 0
    if n not in (2, 3) or T.shape[-2] != n + 1:
        raise ValueError(f"{name}: expected shape (..., 3, 3) or (..., 4, 4), got {T.shape}")
    last_row = [0] * n + [1]
    if inputs.has_symbols(T[..., n, :]) or not np.allclose(T[..., n, :].astype(float), last_row):
        raise ValueError(f"{name}: expected the last row {' '.join(map(str, last_row))} of a "
                         "homogeneous matrix; for a bare rotation use its transpose and R @ p")
    return _rotation(name, T[..., :n, :n]), T[..., :n, n]


def _rotation(name: str, R: np.ndarray) -> np.ndarray:
    """The rotation as it may be used; exact numbers stay exact."""
    if inputs.has_symbols(R):  # symbols are checked where numbers take their place
        return R
    taken, error = inputs.rotation_and_error(name, R)
    return taken if np.any(error > inputs.RIGID_TOLERANCE) else R


def _times(R: np.ndarray, p: np.ndarray) -> np.ndarray:
    return (R @ p[..., None])[..., 0]
