"""kinlab: the forward kinematics of robot arms, to see, to derive and to check.

>>> import kinlab as kl
>>> arm = kl.robots.alpha_ii()
>>> kl.forward_kinematics(arm, arm.home)[:3, 3]
array([485.1,   0. , 215. ])
"""
from importlib import import_module

_NAMES = {
    "arm": ("Arm", "Link", "prismatic", "revolute", "to_modified", "to_standard"),
    "kinematics": ("forward_kinematics", "jacobian", "link_frames"),
    "transforms": ("apply", "compose", "homogeneous", "inverse", "rotation_2d", "rotation_x",
                   "rotation_y", "rotation_z", "translation"),
    "singularity": ("manipulability", "rank", "singular_directions"),
    "ik": ("InverseBatch", "InverseResult", "inverse_kinematics", "inverse_kinematics_batch"),
    "sampling": ("Workspace", "workspace"),
    "workspace_plots": ("density_picture", "envelope_picture", "slice_picture"),
    "symbolic": ("ClosedForm", "closed_form", "jacobian_form"),
    "examiner": ("same_mechanism",),
    "frame_placement": ("examine_frames",),
    "parsing": ("parse_number",),
    "euler": ("ZYZAngles", "zyz_angles", "zyz_matrix"),
    "arm_view": ("ArmView",),
    "target_view": ("TargetView",),
    "jacobian_view": ("velocity_view",),
    "solve_picture": ("solve_view",),
    "table_editor": ("DHTableEditor",),
}
_HOME = {name: module for module, names in _NAMES.items() for name in names}
_MODULES = ("exercises", "lessons", "robots")
__all__ = [*_HOME, *_MODULES]
__version__ = "0.1.0"


def __getattr__(name):
    """Load a name where it is first used: sympy, matplotlib and ipywidgets wait until then."""
    if name in _MODULES:
        return import_module(f"{__name__}.{name}")
    if name not in _HOME:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = getattr(import_module(f"{__name__}.{_HOME[name]}"), name)
    globals()[name] = value
    return value


def __dir__():
    return sorted([*globals(), *__all__])
