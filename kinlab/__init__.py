"""kinlab: the forward kinematics of robot arms, to see, to derive and to check.

>>> import kinlab as kl
>>> arm = kl.robots.alpha_ii()
>>> kl.forward_kinematics(arm, arm.home)[:3, 3]
array([485.1,   0. , 215. ])
"""
from importlib import import_module
from typing import Any

_NAMES = {
    "arms.link": ("Link", "fixed", "prismatic", "revolute"),
    "arms.arm": ("Arm", "to_modified", "to_standard"),
    "arms.kinematics": ("forward_kinematics", "jacobian", "link_frames"),
    "arms.transforms": ("apply", "compose", "homogeneous", "inverse", "rotation_2d", "rotation_x",
                        "rotation_y", "rotation_z", "translation"),
    "arms.singularity": ("manipulability", "rank", "singular_directions"),
    "ik.solve": ("InverseBatch", "InverseResult", "inverse_kinematics", "inverse_kinematics_batch"),
    "paths.joint": ("joint_path",),
    "paths.path": ("Path",),
    "paths.straight": ("straight_path",),
    "arms.workspace": ("Workspace", "workspace"),
    "drawing.workspace_figures": ("density_picture", "envelope_picture", "slice_picture"),
    "arms.symbolic": ("ClosedForm", "closed_form", "jacobian_form"),
    "answers.same_mechanism": ("same_mechanism",),
    "answers.placed_frames": ("examine_frames",),
    "tables.numbers": ("parse_number",),
    "arms.euler": ("RPYAngles", "ZYZAngles", "rpy_angles", "rpy_matrix", "zyz_angles",
                   "zyz_matrix"),
    "arms.quaternions": ("AxisAngle", "Quaternion", "axis_angle", "quaternion",
                         "quaternion_matrix", "rotation_about"),
    "views.arm_view": ("ArmView",),
    "views.target_view": ("TargetView",),
    "views.link_view": ("frames_view", "link_view"),
    "views.path_view": ("PathView",),
    "views.studies": ("solve_view", "velocity_view"),
    "predictions": ("predict",),
    "arms.shown": ("show",),
    "views.table_editor": ("DHTableEditor",),
    "urdf.read": ("from_urdf", "urdf_frames"),
    "urdf.write": ("to_urdf",),
}
_HOME = {name: module for module, names in _NAMES.items() for name in names}
_MODULES = {"exercises": "exercises", "lessons": "lessons", "robots": "arms.robots"}
__all__ = [*_HOME, *_MODULES]
__version__ = "0.1.0"


def __getattr__(name: str) -> Any:
    """Load a name where it is first used: sympy, matplotlib and ipywidgets wait until then."""
    if name in _MODULES:
        return import_module(f"{__name__}.{_MODULES[name]}")
    if name not in _HOME:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = getattr(import_module(f"{__name__}.{_HOME[name]}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted([*globals(), *__all__])
