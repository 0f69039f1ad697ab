"""The package as a whole: what it loads, which module may know which, and its size."""
import ast
import re
import subprocess
import sys
from pathlib import Path

import pytest

import kinlab as kl

PACKAGE = Path(kl.__file__).parent
SOURCES = sorted([*PACKAGE.glob("*.py"), *PACKAGE.glob("*/*.py")])
SOURCES = [path for path in SOURCES if path.parent.name != "lessons"
           and (path.stem != "__init__" or path.parent == PACKAGE)]
TREES = {path.stem: ast.parse(path.read_text(encoding="utf-8")) for path in SOURCES}
HEAVY = ("sympy", "matplotlib", "ipywidgets", "anywidget", "IPython", "tqdm")

# What each module of the mathematics may import besides the standard library.
MATHEMATICS = {
    "inputs": {"numpy"},
    "motions": {"numpy", "sympy"},  # sympy only where a caller brings a symbol
    "transforms": {"numpy", "inputs", "motions"},
    "link": {"inputs"},
    "printed": {"link"},
    "arm": {"numpy", "inputs", "motions", "link", "printed"},
    "joints": {"numpy", "inputs", "link", "arm"},
    "kinematics": {"numpy", "motions", "link", "arm", "joints"},
    "singularity": {"numpy", "inputs", "arm", "kinematics"},
    "task": {"numpy", "link", "arm", "joints", "motions", "kinematics"},
    "descent": {"numpy", "task"},
    "attempt": {"numpy", "kinematics", "task", "descent"},
    "solve": {"numpy", "inputs", "arm", "kinematics", "task", "descent", "attempt"},
    "workspace": {"numpy", "tqdm", "inputs", "link", "arm", "joints", "motions", "kinematics"},
    "notation": {"sympy"},
    "symbolic": {"sympy", "inputs", "motions", "link", "arm", "kinematics", "notation"},
    "euler": {"numpy", "inputs", "motions", "transforms"},
    "robots": {"numpy", "link", "arm"},
    "mechanism": {"numpy", "link", "arm", "kinematics"},
    "verdict": set(),
    "zero_pose": {"numpy", "arm", "kinematics", "mechanism", "verdict"},
    "same_mechanism": {"numpy", "arm", "mechanism", "zero_pose", "verdict"},
    "placed_frames": {"numpy", "inputs", "link", "arm", "joints", "kinematics", "verdict"},
    "numbers": {"inputs"},
    "cells": {"inputs", "numbers"},
    "table": {"numpy", "inputs", "link", "arm", "cells"},
    "as_csv": {"inputs", "link", "arm", "cells", "table"},
    "as_code": {"inputs", "link", "numbers", "cells", "as_csv", "table"},
    "__init__": set(),
}
DRAWING = ("velocity", "scene", "arm_scene", "figure", "worker", "workspace_figures")
VIEWS = ("live", "arm_view", "sketch", "link_view", "target_view", "jacobian_view",
         "solve_picture", "table_editor", "site", "pieces", "__main__")
WIDGETS = {"ipywidgets", "anywidget", "traitlets", "IPython"}


def imports(tree):
    """Every module that a source imports, anywhere in it; kinlab's own by their bare names."""
    own, others = set(), set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            others |= {alias.name.split(".")[0] for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and not node.level:
            others.add(node.module.split(".")[0])
        elif isinstance(node, ast.ImportFrom):
            last = (node.module or "").split(".")[-1]
            own |= {last} if last in TREES else {alias.name for alias in node.names}
    return own | others - sys.stdlib_module_names


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


@pytest.mark.parametrize("module", MATHEMATICS)
def test_mathematics_knows_only_what_it_may(module):
    assert imports(TREES[module]) <= MATHEMATICS[module]


@pytest.mark.parametrize("module", sorted(set(TREES) - set(DRAWING) - set(VIEWS)))
def test_nothing_below_the_views_knows_drawing_or_widgets(module):
    assert not imports(TREES[module]) & {"matplotlib", *DRAWING, *VIEWS, *WIDGETS}


@pytest.mark.parametrize("module", sorted(set(DRAWING) & set(TREES)))
def test_drawing_knows_no_widgets(module):
    assert not imports(TREES[module]) & {*WIDGETS, *VIEWS}


def test_pyplot_is_never_used():
    """Its global state is not safe beside JupyterLab's threads."""
    assert not [path.name for path in SOURCES if "pyplot" in path.read_text(encoding="utf-8")]


def test_modules_import_each_other_in_one_direction():
    graph = {module: imports(tree) & set(TREES) for module, tree in TREES.items()}
    while graph:
        leaves = {module for module, needs in graph.items() if not needs & set(graph)}
        assert leaves, f"these import each other in a circle: {sorted(graph)}"
        graph = {module: needs for module, needs in graph.items() if module not in leaves}


def functions():
    for module, tree in TREES.items():
        for node in ast.walk(tree):
            if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
                yield f"{module}.{node.name}", code_lines(node)


def code_lines(function):
    """Lines of a function without its docstring."""
    doc = function.body[0] if ast.get_docstring(function) is not None else None
    return function.end_lineno - function.lineno + 1 - (
        doc.end_lineno - doc.lineno + 1 if doc else 0)


def test_style_functions_are_short():
    lengths = dict(functions())
    assert not {name: length for name, length in lengths.items() if length > 40}
    assert sorted(lengths.values())[len(lengths) // 2] < 8


def test_style_modules_are_short():
    lengths = {path.name: len(path.read_text(encoding="utf-8").splitlines()) for path in SOURCES}
    assert not {name: length for name, length in lengths.items() if length > 350}
