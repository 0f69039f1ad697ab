"""URDFs of arms that people know, written by hand: their lengths as data sheets and books have
them, their frames as each maker of such files likes them."""
from math import pi

RIGHT = pi / 2


def robot(name, *joints, root="base_link"):
    """A chain of joints, each with the link that it moves."""
    parts, parent = [f'<robot name="{name}"><link name="{root}"/>'], root
    for joint, kind, origin, rest in joints:
        child = f"{joint}_link"
        parts.append(f'<link name="{child}"/><joint name="{joint}" type="{kind}">'
                     f'<parent link="{parent}"/><child link="{child}"/>{origin}{rest}</joint>')
        parent = child
    return "".join([*parts, "</robot>"])


def turning(name, xyz, rpy="0 0 0", axis="0 0 1", limit='lower="-3" upper="3" velocity="2"'):
    return (name, "revolute", f'<origin xyz="{xyz}" rpy="{rpy}"/>',
            f'<axis xyz="{axis}"/><limit {limit}/>')


def sliding(name, xyz, rpy="0 0 0", axis="0 0 1", limit='lower="0" upper="1" velocity="0.5"'):
    return name, "prismatic", f'<origin xyz="{xyz}" rpy="{rpy}"/>', (f'<axis xyz="{axis}"/>'
                                                                     f'<limit {limit}/>')


def held(name, xyz, rpy="0 0 0"):
    return name, "fixed", f'<origin xyz="{xyz}" rpy="{rpy}"/>', ""


# Axes along y, as in the files that ROS had of it first: lengths from the maker's table.
UR5 = robot(
    "UR5", turning("pan", "0 0 0.089159"),
    turning("lift", "0 0.13585 0", f"0 {RIGHT} 0", "0 1 0"),
    turning("elbow", "0 -0.1197 0.425", axis="0 1 0"),
    turning("wrist_1", "0 0 0.39225", f"0 {RIGHT} 0", "0 1 0"),
    turning("wrist_2", "0 0.093 0"), turning("wrist_3", "0 0 0.09465", axis="0 1 0"),
    held("tool0", "0 0.0823 0", f"{-RIGHT} 0 0"))
# Its frames are Craig's: each joint's origin is a row of the modified table.
PANDA = robot(
    "Panda", turning("joint1", "0 0 0.333"), turning("joint2", "0 0 0", f"{-RIGHT} 0 0"),
    turning("joint3", "0 -0.316 0", f"{RIGHT} 0 0"),
    turning("joint4", "0.0825 0 0", f"{RIGHT} 0 0"),
    turning("joint5", "-0.0825 0.384 0", f"{-RIGHT} 0 0"),
    turning("joint6", "0 0 0", f"{RIGHT} 0 0"), turning("joint7", "0.088 0 0", f"{RIGHT} 0 0"),
    held("flange", "0 0 0.107"))
# No frame is turned, only axes are; joints 1, 4 and 6 count as KUKA counts them.
KR210 = robot(
    "KR 210", turning("a1", "0 0 0.75", axis="0 0 -1"),
    turning("a2", "0.35 0 0", axis="0 1 0"), turning("a3", "0 0 1.25", axis="0 1 0"),
    turning("a4", "0 0 -0.054", axis="-1 0 0"), turning("a5", "1.5 0 0", axis="0 1 0"),
    turning("a6", "0 0 0", axis="-1 0 0"), held("tool0", "0.303 0 0", f"0 {RIGHT} 0"))
PUMA = robot(
    "PUMA 560", turning("waist", "0 0 0.672"), turning("shoulder", "0 0 0", axis="0 -1 0"),
    turning("elbow", "0.4318 -0.15005 0", axis="0 -1 0"),
    turning("roll", "0.0203 0 0", axis="0 0 1"), turning("pitch", "0 0 0.4318", axis="0 -1 0"),
    turning("flange", "0 0 0"))
# The quill looks down; its joint stands above its axis' end, and away from it.
SCARA = robot(
    "SCARA", turning("shoulder", "0 0 0.877"), turning("elbow", "0.425 0 0"),
    sliding("quill", "0.2 0.05 0", f"{pi} 0 0", limit='lower="0" upper="0.2"'),
    turning("roll", "0.175 0.05 0.2"))
STANFORD = robot(
    "Stanford arm", turning("waist", "0 0 0.412"), turning("shoulder", "0 0 0", f"{-RIGHT} 0 0"),
    sliding("boom", "0 0 0.154", f"{RIGHT} 0 0", limit='lower="0.3" upper="1.2" velocity="1"'),
    turning("roll", "0 0 0"), turning("pitch", "0 0 0", f"{-RIGHT} 0 0"),
    turning("tool", "0 0 0", f"{RIGHT} 0 0"), held("tool0", "0 0 0.263"))
KNOWN = {"ur5": UR5, "panda": PANDA, "kr210": KR210, "puma_560": PUMA, "scara": SCARA,
         "stanford": STANFORD}
