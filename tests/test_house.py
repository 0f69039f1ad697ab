"""The rooms of the house: which may know which, and which library lives where."""
import ast
import re
import sys
from pathlib import Path

import pytest

import kinlab as kl

PACKAGE = Path(kl.__file__).parent
PYTHON = sorted(PACKAGE.rglob("*.py"))
SCRIPTS = sorted(PACKAGE.rglob("*.js"))

# What each room may know besides itself. A dot names one module of a room.
MAY_KNOW = {
    "arms": set(),
    "ik": {"arms"},
    "paths": {"arms", "ik"},
    "answers": {"arms"},
    "drawing": {"arms"},
    "browser": {"arms.inputs", "arms.files"},
    "tables": {"arms", "answers"},
    "urdf": {"arms"},
    "marks": {"arms.inputs", "arms.files"},
    "views": {"arms", "ik", "paths", "answers", "tables", "drawing", "browser", "marks"},
    "lessons": {"arms", "ik", "paths", "answers", "tables", "drawing", "browser", "views"},
    "course": {"arms.robots", "views", "browser"},
    "exercises": {"arms.inputs", "arms.files", "answers", "lessons", "marks"},  # kl.exercises
    "predictions": {"arms.inputs", "lessons", "views"},   # the door kl.predict
    "__main__": {"course", "lessons", "marks"},
    "__init__": set(),
}
# Libraries besides Python's own, by room and, where only one module has it, by module.
LIBRARIES = {
    "arms": {"numpy"}, "ik": {"numpy"}, "paths": {"numpy"}, "answers": {"numpy", "sympy"},
    "drawing": {"numpy"},
    "browser": set(), "tables": {"numpy"}, "views": {"numpy"}, "lessons": {"numpy", "sympy"},
    "marks": set(), "urdf": {"numpy"},
    "course": {"numpy", "nbformat", "nbclient", "nbconvert", "pygments", "jupyterlab"},
    "arms.symbolic": {"sympy"}, "arms.letters": {"sympy"}, "arms.notation": {"sympy"},
    "arms.growing": {"sympy"},
    "arms.motions": {"sympy"}, "arms.workspace": {"tqdm"}, "drawing.figure": {"matplotlib", "PIL"},
    "drawing.film": {"PIL"}, "drawing.legend": {"matplotlib"},
    "drawing.workspace_figures": {"matplotlib"}, "browser.mathml": {"latex2mathml"},
    "browser.page": {"jinja2", "PIL"}, "browser.bundle": {"rjsmin"},
    "views.live": {"anywidget", "traitlets"}, "views.prediction": {"traitlets"},
    "views.table_editor": {"traitlets"},
}


def name_of(path):
    """A module by its place in the package: ("lessons", "views", "n_link")."""
    return path.relative_to(PACKAGE).with_suffix("").parts


def imported(path):
    """What a source imports, anywhere in it: kinlab's modules as parts, others by their names."""
    own, others, here = set(), set(), name_of(path)
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            others |= {alias.name.split(".")[0] for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.level:
            start = (*here[:len(here) - node.level], *(node.module or "").split("."))
            start = tuple(part for part in start if part)
            for alias in node.names:
                own.add((*start, alias.name) if is_module((*start, alias.name)) else start)
        elif isinstance(node, ast.ImportFrom):
            others.add(node.module.split(".")[0])
    return own, others - set(sys.stdlib_module_names)


def is_module(parts):
    return PACKAGE.joinpath(*parts).with_suffix(".py").exists() or PACKAGE.joinpath(*parts).is_dir()


def test_every_file_stands_in_a_room():
    assert {name_of(path)[0] for path in [*PYTHON, *SCRIPTS]} == set(MAY_KNOW)
    assert {name_of(path)[0] for path in SCRIPTS} == {"browser"}


@pytest.mark.parametrize("path", PYTHON, ids=lambda path: ".".join(name_of(path)))
def test_a_room_knows_only_what_it_may(path):
    room, own = name_of(path)[0], imported(path)[0]
    allowed = MAY_KNOW[room] | {room}
    beyond = {".".join(parts) for parts in own
              if parts and parts[0] not in allowed and ".".join(parts[:2]) not in allowed}
    assert not beyond, f"{'.'.join(name_of(path))} may not know {sorted(beyond)}"


@pytest.mark.parametrize("path", PYTHON, ids=lambda path: ".".join(name_of(path)))
def test_a_library_stays_in_its_place(path):
    parts, others = name_of(path), imported(path)[1]
    allowed = LIBRARIES.get(parts[0], set()) | LIBRARIES.get(".".join(parts[:2]), set())
    assert others <= allowed, f"{'.'.join(parts)} may not use {sorted(others - allowed)}"


def test_modules_import_each_other_in_one_direction():
    packages = {name_of(path)[:-1] for path in PYTHON if path.stem == "__init__"}
    graph = {name_of(path): imported(path)[0] - packages - {name_of(path)} for path in PYTHON}
    while graph:
        leaves = {module for module, needs in graph.items() if not needs & set(graph)}
        assert leaves, f"these import each other in a circle: {sorted(graph)}"
        graph = {module: needs for module, needs in graph.items() if module not in leaves}


def test_pyplot_is_never_used():
    """Its global state is not safe beside JupyterLab's threads."""
    assert not [path.name for path in PYTHON if "pyplot" in path.read_text(encoding="utf-8")]


# ---- JavaScript ----

HOSTS = {"widget", "saved_views", "host_jupyter", "host_table", "host_page", "host_course",
         "host_predict", "host_lite", "page_views"}


def lines(path):
    """The lines of a script, those that are only comment aside."""
    text = re.sub(r"/\*.*?\*/", "", path.read_text(encoding="utf-8"), flags=re.DOTALL)
    return [line for line in text.splitlines() if not line.lstrip().startswith("//")]


@pytest.mark.parametrize("path", SCRIPTS, ids=lambda path: path.stem)
def test_a_script_imports_its_neighbours_by_name_and_nothing_else(path):
    for line in lines(path):
        if found := re.match(r'\s*(?:import\b.*|.*\bimport\(.*|\} from .*)', line):
            source = re.search(r'from "\./(\w+)\.js";$', found[0])
            assert source or found[0].rstrip().endswith("{"), line
            assert not source or path.with_name(f"{source[1]}.js").exists(), line


@pytest.mark.parametrize("path", SCRIPTS, ids=lambda path: path.stem)
def test_only_hosts_know_where_they_are(path):
    """A picture, its controls and its table work wherever they stand."""
    names = re.compile(r"\b(?:widget_manager|comm_live|jupyterapp|save_changes|location|history)\b")
    assert path.stem in HOSTS or not [line for line in lines(path) if names.search(line)]


@pytest.mark.parametrize("path", SCRIPTS, ids=lambda path: path.stem)
def test_no_private_member_of_a_library_is_touched(path):
    private = re.compile(r"\.(?:_\w+|send_sync_message|get_state_sync|context)\b")
    touched = [line for line in lines(path) if private.search(line)]
    assert path.stem == "saved_views" or not touched, touched


@pytest.mark.parametrize("path", [p for p in PYTHON if name_of(p)[0] in ("views", "lessons")],
                         ids=lambda path: ".".join(name_of(path)))
def test_no_private_member_of_a_widget_is_touched(path):
    """What begins with an underscore is a module's own, or belongs to `self`."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Attribute) and re.fullmatch(r"_[a-z]\w*[a-z]", node.attr):
            owner = node.value
            own = isinstance(owner, ast.Name) and owner.id in ("self", "cls")
            above = isinstance(owner, ast.Call) and getattr(owner.func, "id", "") == "super"
            assert own or above, f"{path.name}:{node.lineno}: {ast.unparse(node)}"
