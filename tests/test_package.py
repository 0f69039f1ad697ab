"""The package as a whole: its names, and what it loads."""
import re
import subprocess
import sys

import pytest

import kinlab as kl

HEAVY = ("sympy", "matplotlib", "ipywidgets", "anywidget", "IPython", "tqdm")


def fresh(code):
    """What a fresh Python prints."""
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    return run.stdout.split()


def loaded_by(code):
    return set(fresh(f"import sys\n{code}\nprint(*sys.modules)"))


def test_import_loads_no_heavy_library():
    assert not loaded_by("import kinlab").intersection(HEAVY)


def test_numbers_need_no_heavy_library():
    code = ("import kinlab as kl; arm = kl.to_modified(kl.robots.alpha_ii())\n"
            "kl.inverse_kinematics(arm, [0, 0, 0]).message; kl.rank(arm, arm.home)\n"
            "kl.workspace(arm, 99).envelope()\n"
            "kl.jacobian(arm, arm.home); kl.zyz_angles(kl.rotation_x(0.1)); kl.compose(arm.base)")
    assert not loaded_by(code).intersection(HEAVY)


def test_closed_forms_need_no_drawing():
    code = "import kinlab as kl; kl.closed_form(kl.robots.two_link()).text"
    modules = loaded_by(code)
    assert "sympy" in modules and not modules.intersection({"matplotlib", "ipywidgets"})


@pytest.mark.parametrize("name", kl.__all__)
def test_every_public_name_resolves(name):
    assert getattr(kl, name) is not None
    assert name in dir(kl)


def test_an_unknown_name_is_an_attribute_error():
    with pytest.raises(AttributeError, match="module 'kinlab' has no attribute 'forward'"):
        kl.forward  # noqa: B018


def test_public_names_are_documented():
    for name in kl.__all__:
        assert getattr(kl, name).__doc__, name


def test_version_is_a_release_number():
    assert re.fullmatch(r"\d+\.\d+\.\d+", kl.__version__)
