"""A path, played: the arm on its way, and its joints, rates and tip over time."""
from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path as FilePath
from typing import ClassVar

import numpy as np

from ..arms import files, inputs
from ..arms.arm import Arm, check_arm
from ..arms.kinematics import forward_kinematics
from ..browser import bundle
from ..drawing.controls import joint_knobs
from ..drawing.path_picture import path_scene
from ..drawing.scene import SPATIAL
from ..paths.path import Path
from .arm_view import joints_text
from .live import LiveView, numbers


class PathView(LiveView):
    """A path, to be played and to be scrubbed through: the arm, and its curves over time.

    The picture shows the tool's whole way, pale, and what is gone of it. Beside it stand the
    joints' values, their rates and how far the tip has gone, and once they are switched on the
    accelerations and the speed of the tip; limits are dashed, and where one is broken a band marks
    it. A name of a joint singles its curves out. Play takes as long as the motion does.

    Parameters
    ----------
    arm : Arm
        That of the path.
    path : Path
        As `joint_path` and `straight_path` make it.
    show : sequence of {"frames", "labels", "axes", "names", "ghost"}
        What is switched on to begin with, besides the floor.
    preset : {"3-D", "top", "front", "side"}, optional
        Where the picture is seen from; planar arms are seen from the top.

    Attributes
    ----------
    arm : Arm
    path : Path
    time : float
        Seconds since the start; setting it moves the arm.
    T : array, shape (4, 4)
        Pose of the tool at this time.

    Raises
    ------
    ValueError
        If an argument is no arm or no path, or the path is another arm's.

    Examples
    --------
    >>> from kinlab import joint_path, robots
    >>> arm = robots.two_link()
    >>> view = PathView(arm, joint_path(arm, [0, 0], [1, -0.5], duration=2))
    >>> view.time = 1
    >>> view
    PathView('Two-link', t=1 s of 2 s, q=[28.6479, -14.3239] deg, p=[1.8465, 0.7268, 0] m)
    """

    _css = bundle.style("live.css", "timed.css")
    _page: ClassVar[dict] = {"styles": ("timed.css",)}

    def __init__(self, arm: Arm, path: Path, *, show: Sequence[str] = ("frames", "labels", "names"),
                 preset: str | None = None) -> None:
        check_arm(arm)
        if not isinstance(path, Path):
            raise ValueError(f"path: expected a path, got {inputs.brief(path)}; make one with "
                             "kl.joint_path or kl.straight_path")
        if not _same(arm, path.arm):
            raise ValueError("arm, path: expected the arm that the path was made for, got another "
                             "one; write kl.PathView(path.arm, path)")
        if preset is not None:
            inputs.choice("preset", preset, tuple(SPATIAL))
        self._path = path
        super().__init__(path_scene(arm, path, show=show, preset=preset or ""))

    @property
    def arm(self) -> Arm:
        return self._path.arm

    @property
    def path(self) -> Path:
        return self._path

    @property
    def T(self) -> np.ndarray:
        return forward_kinematics(self.arm, self._joints())

    def save_csv(self, path: str | os.PathLike) -> FilePath:
        """Write the path as a table; see `Path.save_csv`."""
        return self._path.save_csv(path)

    def save_gif(self, path: str | os.PathLike, *, fps: int = 15, width: int = 480) -> FilePath:
        """Write the motion as a film that plays in real time, again and again.

        It shows the picture as it is seen to begin with, and the curves under it. An older file of
        this name is replaced.

        Parameters
        ----------
        path : str or path
            Where to write it; ends in ``.gif``.
        fps : int
            Pictures in a second, 1 to 50; of the whole motion 600 at most.
        width : int
            Pixels, 100 to 1600.

        Returns
        -------
        pathlib.Path

        Raises
        ------
        ValueError
            If the name does not end in ``.gif``, the file cannot be written there, or a number is
            out of its range.
        """
        target = files.target("path", path, (".gif",), "a film is opened by its ending")
        fps, width = inputs.whole("fps", fps, 1, 50), inputs.whole("width", width, 100, 1600)
        from ..drawing.film import MOST, frame_times, gif

        count = len(frame_times(self._path.duration, fps))
        if count > MOST:
            raise ValueError(f"fps: expected a film of at most {MOST} pictures, got {fps} in a "
                             f"second, {count} in all; {_fewer(self._path.duration, MOST)}")

        film = gif(self._scene, self._scene.seen_from, self._scene.shown, self._path.duration,
                   fps=fps, width=width)
        return files.write("path", target, film)

    def _joints(self) -> np.ndarray:
        return self._path.at(min(float(self._values[0]), self._path.duration))

    def __repr__(self) -> str:
        q = self._joints()
        values = (q / [knob.scale for knob in joint_knobs(self.arm)]).tolist()
        p = numbers(forward_kinematics(self.arm, q)[:3, 3], self.decimals)
        name = f"{self.arm.name!r}, " if self.arm.name else ""
        time = f"t={numbers(self._values[:1], self.decimals)} s of {self._path.duration:g} s"
        said = [f"PathView({name}{time}, q={joints_text(self.arm, values, self.decimals)}, "
                f"p=[{p}] {self.arm.unit})", *map(str, self._path.broken)]
        return "\n".join(said)


def _fewer(duration: float, most: int) -> str:
    """What helps against too many pictures."""
    fps = int((most - 1) / duration)
    return f"write fps={fps} or less" if fps else "make a shorter path"


def _same(arm: Arm, other: Arm) -> bool:
    """Whether two arms stand alike at all joint values."""
    return arm is other or (arm.links == other.links and arm.convention == other.convention
                            and np.array_equal(arm.base, other.base)
                            and np.array_equal(arm.tool, other.tool))
