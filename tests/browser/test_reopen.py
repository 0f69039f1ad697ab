"""Whatever was done to a notebook before it was saved: a view lives, or is a picture."""
from random import Random

import nbformat
import pytest
from grades import chosen
from lab import KERNEL, READY, open_notebook, run_all, run_code

WIDGET_VIEW = "application/vnd.jupyter.widget-view+json"
WIDGET_STATE = "application/vnd.jupyter.widget-state+json"
CELLS = ["import ipywidgets\nimport kinlab as kl\n"
         "view = kl.ArmView(kl.robots.two_link())\nview",
         "view",
         "editor = kl.DHTableEditor(kl.robots.two_link())\neditor",
         "asked = kl.predict('rotation.riding')\nasked",
         "answer = kl.ArmView(kl.robots.alpha_ii())\nanswer",
         "slider = ipywidgets.FloatSlider()\nbox = ipywidgets.VBox([slider, answer])\nbox"]
FOLDED = 4
ALL = len(CELLS)
NOTEBOOK = "jupyterapp.shell.currentWidget"
SESSION = f"{NOTEBOOK}.sessionContext"
IDLE = f"{SESSION}.session?.kernel?.status === 'idle' && !{SESSION}.pendingInput"
# What a cell's output shows: a live thing, a picture, a text, nothing, or an error.
SHOWN = """() => [...document.querySelectorAll('.jp-Notebook:not(.lm-mod-hidden *) .jp-CodeCell')]
    .filter(cell => cell.closest('.jp-NotebookPanel:not(.lm-mod-hidden)')).map(cell => {
    const area = cell.querySelector('.jp-Cell-outputArea');
    const said = area?.innerText ?? '';
    if (/Loading widget/.test(said)) return 'nothing';
    if (/rror/.test(said) || area?.querySelector('.jupyter-widgets-error-widget'))
        return said || 'error';
    if (area?.querySelector('details.kl-answer, .kl-view .kl-picture svg, .widget-box'))
        return 'live';
    if (area?.querySelector('img')?.naturalWidth) return 'picture';
    return area?.querySelector('.jp-RenderedText')?.innerText.trim() ? 'text' : 'nothing';
})"""

THERE = f"""(what, cell) => what !== 'nothing' ||
    !{NOTEBOOK}.content.widgets[cell].model.outputs.length"""


class Student:
    """Does in a page of JupyterLab what students do to a notebook, step by step."""

    def __init__(self, page, lab, root):
        self.page, self.lab, self.root, self.name = page, lab, root, "kept.ipynb"
        cells = [nbformat.v4.new_code_cell(source) for source in CELLS]
        cells[FOLDED].metadata = {"jupyter": {"outputs_hidden": True}}
        notebook = nbformat.v4.new_notebook(cells=cells, metadata={"kernelspec": KERNEL})
        nbformat.write(notebook, root / self.name)
        self.load()

    def do(self, steps):
        for step in steps.split():
            name, _, cell = step.partition(":")
            getattr(self, name)(*([int(cell)] if cell else []))

    def command(self, name, **arguments):
        self.page.evaluate("""([name, given]) =>
            jupyterapp.commands.execute(name, given).then(() => 0)""", [name, arguments])

    def idle(self):
        self.page.wait_for_function(IDLE)

    # ---- steps ----

    def load(self):
        """The page is loaded anew."""
        open_notebook(self.page, self.lab, self.name)

    def run(self):
        run_all(self.page)

    def one(self, cell):
        self.choose(cell)
        self.command("notebook:run-cell")

    def restart(self):
        self.page.evaluate(f"{SESSION}.restartKernel()")
        self.idle()

    def clear(self):
        """Restart and clear all outputs."""
        self.restart()
        self.command("notebook:clear-all-cell-outputs")

    def shutdown(self):
        self.page.evaluate(f"{SESSION}.shutdown()")

    def kernel(self):
        """Change to another kernel."""
        self.page.evaluate(f"{SESSION}.changeKernel({{name: 'python3'}}).then(() => 0)")
        self.idle()

    def save(self):
        self.command("docmanager:save")

    def away(self):
        """Close the notebook without saving; its kernel goes on."""
        self.page.evaluate(f"() => {{ {NOTEBOOK}.dispose(); }}")

    def back(self):
        """Open it in the same page."""
        self.open()
        self.page.wait_for_function(READY, arg=self.name)

    def open(self):
        self.page.evaluate(
            "path => { jupyterapp.commands.execute('docmanager:open', {path}); }", self.name)

    def shutdown_all(self):
        """All kernels of the server."""
        self.page.evaluate("jupyterapp.serviceManager.sessions.shutdownAll()")

    def move(self):
        """A key on a slider of the first live view."""
        self.page.locator(".kl-view:visible").first.get_by_role("slider").first.press("PageUp")

    def shut(self, cell):
        """Python closes what a cell shows."""
        names = ["view", "view", "editor", "asked", "answer", "slider"]
        run_code(self.page, f"{names[cell]}.close()")

    def interrupt(self):
        """Stop a cell that runs."""
        self.page.evaluate(f"""() => {{ {SESSION}.session.kernel.requestExecute(
            {{code: 'while True: pass'}}).done.catch(() => {{}}); }}""")
        self.page.wait_for_function(f"{SESSION}.session.kernel.status === 'busy'")
        self.page.evaluate(f"{SESSION}.session.kernel.interrupt()")
        self.idle()

    def die(self):
        """The kernel dies, and starts anew by itself."""
        self.page.evaluate(f"""() => {{ {SESSION}.session.kernel.requestExecute(
            {{code: 'import os; os.kill(os.getpid(), 9)'}}).done.catch(() => {{}}); }}""")
        self.page.get_by_role("dialog").get_by_role("button", name="Ok").click()
        self.idle()

    def rename(self):
        new = f"renamed {self.name}"
        (self.root / new).unlink(missing_ok=True)
        self.page.evaluate(f"name => {NOTEBOOK}.context.rename(name)", new)
        self.name = new

    def cut(self, cell):
        """Cut a cell out, and paste it below the first."""
        self.choose(cell)
        self.command("notebook:cut-cell")
        self.choose(0)
        self.command("notebook:paste-cell-below")

    def drop(self, cell):
        """Delete a cell, and take that back."""
        self.choose(cell)
        self.command("notebook:delete-cell")
        self.command("notebook:undo-cell-action")

    def choose(self, cell):
        self.page.evaluate(f"cell => {{ {NOTEBOOK}.content.activeCellIndex = cell; }}", cell)

    def elsewhere(self):
        """Another browser runs the notebook and saves it; this one then saves over it."""
        with self.page.context.browser.new_context() as context:
            other = Student.__new__(Student)
            other.__dict__ |= vars(self) | {"page": context.new_page()}
            other.do("load run save")
        self.page.evaluate("() => { jupyterapp.commands.execute('docmanager:save'); }")
        self.page.get_by_role("dialog").get_by_role("button", name="Overwrite").click()
        self.page.get_by_role("dialog").wait_for(state="detached")

    def double(self):
        """Duplicate the file, and go on with that."""
        self.away()
        new = self.page.evaluate(
            "path => jupyterapp.serviceManager.contents.copy(path, '').then(file => file.path)",
            self.name)
        self.name = new
        self.back()

    def paste(self):
        """Copy all cells with their outputs into a new notebook, and go on with that."""
        self.command("notebook:select-all")
        self.command("notebook:copy-cell")
        nbformat.write(nbformat.v4.new_notebook(metadata={"kernelspec": KERNEL}),
                       self.root / "pasted.ipynb")
        self.name = "pasted.ipynb"
        self.back()
        self.command("notebook:paste-cell-above")
        self.page.wait_for_function(f"{NOTEBOOK}.content.widgets.length > {ALL}")
        self.one(ALL)

    def strip(self):
        """Another tool writes the file, and leaves out what widgets hold."""
        self.away()
        notebook = self.file()
        del notebook.metadata["widgets"]
        nbformat.write(notebook, self.root / self.name)
        self.back()

    def trust(self):
        """The student says that the file does no harm."""
        self.page.evaluate(
            f"[...{NOTEBOOK}.content.model.cells].forEach(cell => cell.trusted = true)")
        self.save()

    # ---- what there is ----

    def file(self):
        return nbformat.read(self.root / self.name, as_version=4)

    def seen(self):
        """What each cell shows, once all of it is there."""
        self.page.wait_for_function(f"({SHOWN})().length >= {ALL}")
        for cell in range(ALL):  # what is out of sight is not drawn before
            self.page.evaluate(f"""cell => {{ {NOTEBOOK}.content.activeCellIndex = cell;
                {NOTEBOOK}.content.scrollToItem(cell); }}""", cell)
            self.page.wait_for_function(f"cell => ({THERE})(({SHOWN})()[cell], cell)", arg=cell)
        self.page.wait_for_function(f"() => ({SHOWN})().slice(0, {ALL}).every({THERE})")
        return self.page.evaluate(f"({SHOWN})()")[:ALL]


# On a slow machine the widget manager gives a model up that comes after two seconds; the view is
# there all the same, and each test sees that.
SLOW = "Error: widget model not found"


@pytest.fixture
def student(browser, lab, root, watched):
    page = watched(browser.new_page(viewport={"width": 1280, "height": 900}), SLOW)
    student = Student(page, lab, root)
    yield student
    student.shutdown_all()
    page.close()


def outputs(notebook):
    return [output for cell in notebook.cells for output in cell.get("outputs", ())]


def references(state):
    """The ids that a state names, at any depth."""
    if isinstance(state, str):
        return {state.removeprefix("IPY_MODEL_")} if state.startswith("IPY_MODEL_") else set()
    inner = state.values() if isinstance(state, dict) else state if isinstance(state, list) else ()
    return set().union(*map(references, inner))


def assert_whole(notebook, elsewhere=False):
    """Each view has its state, no state refers to one that is not there, and none is left over.

    A file that was written elsewhere is as it came until a view has been shown from it.
    """
    kept = notebook.metadata.get("widgets", {}).get(WIDGET_STATE, {}).get("state")
    assert kept != {}
    views = [output.data[WIDGET_VIEW].model_id for output in outputs(notebook)
             if WIDGET_VIEW in output.get("data", {})]
    needed, new = set(), set(filter(None, views))
    if elsewhere and not kept:
        return
    while new:
        needed |= new
        assert new <= set(kept or ()), "a view or a part of one has no state"
        new = set().union(*(references(kept[one]) for one in new)) - needed
    assert set(kept or ()) == needed


LIVE, BARE = ["live"] * ALL, ["nothing"] * ALL
STILL = ["picture", "picture", "text", "picture", "picture", "text"]
ORDERS = {  # what is done, and what is seen when the notebook is opened again
    "run restart save": LIVE,
    "run shutdown save": LIVE,
    "run kernel save": LIVE,
    "run restart one:0 save": LIVE,
    "run save restart save": LIVE,
    "run save load one:1 save": LIVE,
    "run save away back save": LIVE,
    "run save one:0 away": LIVE,
    "run one:0 one:3 restart move save": LIVE,
    "run save shutdown load run restart save": LIVE,
    "run save shutdown load move save": LIVE,
    "run restart run save shutdown": LIVE,
    "run restart paste save": LIVE,
    "run save shutdown load paste save": LIVE,
    "run shutdown save double": LIVE,
    "run interrupt save": LIVE,
    "run die save": LIVE,
    "run rename restart rename save": LIVE,
    "run save cut:0 restart save": LIVE,
    "run drop:4 drop:0 shutdown save": LIVE,
    "run save elsewhere save": LIVE,
    "run": BARE,
    "run clear save": BARE,
    "run save clear save": BARE,
    "run shut:0 save": ["picture", "picture", "live", "live", "live", "live"],
    "run save shut:0 restart save": ["picture", "picture", "live", "live", "live", "live"],
    "run shut:4 restart save": [*LIVE[:4], "picture", "live"],  # the box holds it, too
    "run shut:3 save": [*LIVE[:3], "picture", *LIVE[4:]],
    "run shut:2 save": [*LIVE[:2], "text", *LIVE[3:]],
    "run save strip": STILL,
    "run save shutdown strip trust": STILL,
    "run save strip one:0 restart save": STILL,
}


@pytest.mark.parametrize("order", chosen(ORDERS, ["run restart save"]))
def test_opened_again_each_view_lives_or_is_its_picture(student, order):
    student.do(order)
    assert_whole(student.file(), "strip" in order)
    sizes = []
    for again in ("load", "shutdown load save", "away back save"):
        student.do(again)
        assert student.seen() == ORDERS[order], again
        sizes.append((student.root / student.name).stat().st_size)
    assert_whole(student.file(), "strip" in order)
    assert max(sizes) < sizes[0] + 2_000  # one view more would be a hundred times as long


def test_without_a_kernel_there_are_pictures(student):
    student.do("run save away shutdown_all")
    notebook = student.file()
    del notebook.metadata["kernelspec"]
    nbformat.write(notebook, student.root / student.name)
    student.open()
    student.page.get_by_title("Change kernel for").filter(has_text="No Kernel").wait_for()
    assert student.seen() == STILL
    words = student.page.locator(".jp-Cell-outputArea img").first.get_attribute("alt")
    assert words.startswith("Picture of the arm.")


@pytest.mark.thorough
def test_a_closed_widget_in_a_box_leaves_pictures(student):
    student.do("run shut:5 save load")  # ipywidgets restores nothing then
    assert student.seen() == STILL


@pytest.mark.thorough
@pytest.mark.parametrize("seed", range(6))
def test_whatever_is_done_no_view_is_lost(student, seed):
    choose, alive, done = Random(seed).choice, True, ["run"]
    student.do("run")
    for _ in range(14):
        steps = ["save", "save", "load", "away back", "move"]
        steps += ["run", "restart", "kernel", "shutdown load", "one:0", "clear"]
        steps += ["one:1", "one:2", "one:3", "one:5"] * alive
        step = choose(steps)
        if step == "move" and not student.page.locator(".kl-view:visible .kl-field").count():
            continue
        done.append(step)
        alive = step == "run" or (alive and step not in (
            "restart", "kernel", "shutdown load", "clear"))
        student.do(step)
        assert set(student.seen()) <= {"live", "picture", "text", "nothing"}, done
        if step == "save":
            assert_whole(student.file())
    student.do("save shutdown load")
    assert_whole(student.file())
    shown = [len(cell.outputs) > 0 for cell in student.file().cells[:ALL]]
    assert [seen == "live" for seen in student.seen()] == shown, done
