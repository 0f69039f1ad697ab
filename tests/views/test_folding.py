"""What answers a prediction stays folded where the cell is marked, and nowhere else."""
import sys
from types import SimpleNamespace

import pytest

import kinlab as kl
from kinlab.views import folding


class Hook:
    """As ipykernel has it."""

    def __init__(self):
        self.hooks = []

    def register_hook(self, hook):
        self.hooks.append(hook)

    def unregister_hook(self, hook):
        self.hooks = [one for one in self.hooks if one is not hook]


@pytest.fixture
def shell(monkeypatch):
    """A running IPython whose cell is marked; `shell.sent` is what came along with the code."""
    shell = SimpleNamespace(sent={"metadata": {"jupyter": {"outputs_hidden": True}}},
                            displayhook=Hook())
    shell.kernel = SimpleNamespace(get_parent=lambda: shell.sent)
    monkeypatch.setattr(folding, "_shell", lambda: shell)
    return shell


def result(**data):
    return {"content": {"data": {key.replace("_", "/"): text for key, text in data.items()}}}


@pytest.mark.parametrize("data, inside", [
    (dict(text_plain="<1>"), "<pre>&lt;1&gt;</pre>"),
    (dict(text_plain="x", text_latex="$x$"), "$x$"),
    (dict(text_plain="x", text_latex="$x$", text_html="<b>x</b>"), "<b>x</b>"),
])
def test_a_marked_result_is_folded_and_keeps_its_text(shell, data, inside):
    after = folding.folded(result(**data))["content"]["data"]
    assert after["text/html"].startswith("<details")
    assert f"</summary>{inside}</details>" in after["text/html"]
    assert after["text/plain"] == data["text_plain"]


@pytest.mark.parametrize("sent", [{}, {"metadata": None}, {"metadata": {}},
                                  {"metadata": {"jupyter": {"outputs_hidden": False}}}])
def test_any_other_result_is_as_it_was(shell, sent):
    shell.sent = sent
    assert folding.folded(result(text_plain="1")) == result(text_plain="1")
    assert not folding.is_folded()


def test_a_view_of_a_marked_cell_is_drawn_when_it_is_opened(shell):
    view = kl.lessons.dh_recipe.rules_view()
    view._repr_mimebundle_()
    assert view.folded
    shell.sent = {}
    view._repr_mimebundle_()
    assert not view.folded
    widget = {"content": {"data": {folding.WIDGET: {}, "text/plain": "view"}}}
    assert "text/html" not in folding.folded(widget)["content"]["data"]


def test_predictions_ask_for_it_once(shell):
    kl.predict("dh_recipe.says")
    kl.predict("dh_recipe.swaps")
    assert shell.displayhook.hooks == [folding.folded]


def test_without_a_kernel_nothing_happens(monkeypatch):
    monkeypatch.setattr(folding, "_shell", lambda: None)
    folding.fold_answers()
    assert not folding.is_folded()
    monkeypatch.undo()
    monkeypatch.setitem(sys.modules, "IPython", SimpleNamespace(get_ipython=lambda: None))
    assert not folding.is_folded()
