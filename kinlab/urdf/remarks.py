"""What is to be said of a robot that was read: what its file leaves open, rounds or misspells."""
from __future__ import annotations

from collections.abc import Iterator
from difflib import get_close_matches
from itertools import groupby

import numpy as np

from ..arms import inputs
from ..arms.arm import Arm
from ..arms.link import FIXED
from ..arms.motions import ROTATE, motions_of
from ..arms.rounded import meant, plain_angle
from .axes import size_of
from .chain import Chain
from .frames import UrdfFrames
from .robot import CONTINUOUS, Joint, listed
from .rows import PARALLEL, plain_turn

_READ = {"parent": ("link",), "child": ("link",), "origin": ("xyz", "rpy"), "axis": ("xyz",),
         "limit": ("lower", "upper", "velocity", "effort")}
_FAR = 50       # m: hardly an arm is so long, and in millimetres all are longer
_NEARLY = 5e-3  # rad: more than a few rounded angles make together


def remarks(chain: Chain, frames: UrdfFrames) -> Iterator[str]:
    """A sentence on each thing that whoever gave the file should know."""
    yield from _of_words(chain)
    yield from _of_limits(chain)
    yield from _of_size(chain)
    yield from _of_frames(frames)
    yield from _of_angles(chain, frames.arm)


def _of_words(chain: Chain) -> Iterator[str]:
    """A sentence on each word of the joints that is not read."""
    found = sorted((word, k) for k, joint in enumerate(chain.joints) for word in _not_read(joint))
    for (what, advice), places in groupby(found, key=lambda one: one[0]):
        yield f"{what} of {listed([chain.joints[k].name for _, k in places])} is not read; {advice}"


def _not_read(joint: Joint) -> Iterator[tuple[str, str]]:
    """What stands in the joint in vain, and what to do about it."""
    for tag, known in _READ.items():
        first, *others = joint.element.findall(tag) or [joint.element]
        if others:
            yield f"the second <{tag}>", "leave one"
        for name in first.keys() if first is not joint.element else ():
            if name not in known and ":" not in name:
                near = get_close_matches(name, known, 1)
                yield (f"{inputs.brief(name)} in the <{tag}>",
                       f"is {near[0]} meant?" if near else f"URDF has {', '.join(known)} there")


def _of_limits(chain: Chain) -> Iterator[str]:
    """A sentence on joints whose limits the file leaves open."""
    limits = {chain.joints[k].name: chain.joints[k].element.find("limit") for k in chain.moving
              if chain.joints[k].kind != CONTINUOUS}
    if without := [name for name, limit in limits.items() if limit is None]:
        yield f"{listed(without)} got no limits, as the file has no <limit> there"
    if still := [name for name, limit in limits.items() if limit is not None
                 and not {"lower", "upper"} & {*limit.keys()}]:
        yield (f"{listed(still)} cannot move, as a <limit> without lower and upper is 0 to 0 in "
               "URDF; write both")


def _of_size(chain: Chain) -> Iterator[str]:
    """A sentence on an arm so long that its lengths are in millimetres, most likely."""
    if (size := size_of(chain)) > _FAR:
        yield (f"the arm is {size:.4g} m long, as lengths in URDF are in metres; if the file's are "
               "in millimetres, divide them by 1000")


def _of_frames(frames: UrdfFrames) -> Iterator[str]:
    """A sentence on convention and frames, where some are not the file's."""
    if differ := len(frames.differ):
        yield (f"{frames.arm.convention} DH, as {frames.why}; the frames of {differ} of "
               f"{len(frames.links)} links are not the file's own: kl.urdf_frames(...) lists them")


def _of_angles(chain: Chain, arm: Arm) -> Iterator[str]:
    """A sentence on angles that came rounded, and on what is off by them."""
    rounded = [(joint.name, angle) for joint in chain.joints for angle in joint.rpy().tolist()
               if meant(plain_turn(angle))]
    if rounded and (off := _all_off(arm)):
        angle = rounded[0][1]
        yield (f"angles of {listed(list(dict(rounded)))} in the file are rounded, such as "
               f"{angle:.15g} for {meant(angle)}; so angles "
               f"in {' and '.join(off)} are not exact{_tilted(arm)}; "
               f"write {float(plain_angle(angle) or 0) * np.pi!r} for {meant(angle)}")


def _all_off(arm: Arm) -> list[str]:
    """The rows and ends that have an angle which is off."""
    rows = [row for row, link in enumerate(arm.links, start=1)
            if _off(link.theta) or _off(link.alpha)]
    return [_numbered(rows)] * bool(rows) + [f"the {end}" for end in ("base", "tool") if any(
        map(_off, _turns(getattr(arm, end))))]


def _numbered(rows: list[int]) -> str:
    return f"row{'s' * (len(rows) > 1)} {listed(rows, show=str)}"


def _tilted(arm: Arm) -> str:
    """The fixed rows that are there because angles are rounded, as part of the sentence."""
    rows = [row for row, link in enumerate(arm.links, start=1) if link.kind == FIXED
            and _off(link.alpha)]
    if not rows:
        return ""
    return (f", and {_numbered(rows)} without a joint came in, as axes that should be parallel "
            "are not quite so")


def _turns(T: np.ndarray) -> list[float]:
    return [motion.amount for motion in motions_of(T) if motion.kind == ROTATE]


def _off(angle: float) -> bool:
    """Whether an angle is almost, and not quite, a multiple of 15 degrees."""
    return PARALLEL < abs(angle - round(angle * 12 / np.pi) * np.pi / 12) < _NEARLY
