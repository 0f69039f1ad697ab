"""Robot descriptions: the time from a URDF to an arm with a DH table, and how exact its poses are.

The files are the public ones of the tests. Pinocchio, which reads URDF but finds no DH table, reads
the same texts, and its poses of the tip are those that kinlab's are compared with.

    python benchmarks/urdf.py [rounds]
"""
from __future__ import annotations

import sys
import warnings
from functools import partial
from pathlib import Path
from statistics import median

import numpy as np
from measure import NOT_INSTALLED, goal, header, interleaved, peer, table

import kinlab as kl

FILES = Path(__file__).parents[1] / "tests" / "urdf" / "public"
TIPS = {"baxter": "left_gripper", "kinova": "j2s6s200_end_effector", "kr210l150": "tool0",
        "panda": "panda_hand", "pr2": "r_gripper_tool_frame", "so100": "jaw", "ur5": "tool0"}
ROUNDS = int(sys.argv[1]) if len(sys.argv) > 1 else 7
POSES = 1_000
READ_MS, EXACT = 25, 1e-9  # goals: for one file; m and entries of a rotation

pinocchio = peer("pinocchio")


def read(text: str, tip: str | None) -> kl.Arm:
    with warnings.catch_warnings(action="ignore"):  # what it says of frames is not asked here
        return kl.from_urdf(text, tip)


def farthest(arm: kl.Arm, text: str, tip: str) -> float:
    """How far the poses of the tip are from Pinocchio's at most, at random joint values."""
    model = pinocchio.buildModelFromXML(text)
    data, frame = model.createData(), model.getFrameId(tip)
    rng, off = np.random.default_rng(0), 0.0
    for q in rng.uniform(-np.pi, np.pi, (POSES, arm.n)):
        pinocchio.framesForwardKinematics(model, data, placed(model, arm, q))
        off = max(off, np.abs(kl.forward_kinematics(arm, q) - data.oMf[frame].homogeneous).max())
    return off


def placed(model: object, arm: kl.Arm, q: np.ndarray) -> np.ndarray:
    """Joint values as Pinocchio has them: in its own order, continuous ones by cosine and sine."""
    full = pinocchio.neutral(model)
    for link, value in zip(arm.joints, q):
        joint = model.joints[model.getJointId(link.name)]
        full[joint.idx_q:joint.idx_q + joint.nq] = (
            [value] if joint.nq == 1 else [np.cos(value), np.sin(value)])
    return full


def main() -> None:
    header("From a URDF to an arm with a DH table", "pin")
    texts = {path.stem: path.read_text(encoding="utf-8") for path in sorted(FILES.glob("*.urdf"))}
    tasks = {f"{name}, kinlab": partial(read, text, TIPS.get(name))
             for name, text in texts.items()}
    if pinocchio:
        tasks |= {f"{name}, Pinocchio": partial(pinocchio.buildModelFromXML, text)
                  for name, text in texts.items()}
    times, rows, worst = interleaved(tasks, ROUNDS), [], 0.0
    for name, text in texts.items():
        arm = read(text, TIPS.get(name))
        tip = TIPS.get(name) or kl.urdf_frames(text).links[-1].link
        off = farthest(arm, text, tip) if pinocchio else NOT_INSTALLED
        worst = max(worst, off) if pinocchio else worst
        ours = times[f"{name}, kinlab"]
        theirs = 1e3 * median(times[f"{name}, Pinocchio"]) if pinocchio else NOT_INSTALLED
        rows.append([name, arm.n, arm.convention, 1e3 * median(ours), theirs, off])
    table(["file", "joints", "convention", "kinlab (ms)", "Pinocchio, no table (ms)",
           f"farthest of {POSES} poses"], rows)
    slowest = max(1e3 * min(times[f"{name}, kinlab"]) for name in texts)
    goal(f"each file within {READ_MS} ms: the slowest took {slowest:.3g}", slowest <= READ_MS)
    goal(f"poses to {EXACT:g}: the farthest is {worst:.1e}", worst <= EXACT if pinocchio else None)


if __name__ == "__main__":
    main()
