"""What Google Colab is told of a view, so that it loads a widget that is not its own.

Colab itself is not run: its module is played by one that does what google.colab.output does.
"""
import json
import subprocess
import sys

import pytest

STUB = """
import sys, types
manager = types.SimpleNamespace(_installed_url=None)
def enable_custom_widget_manager():
    manager._installed_url = "https://manager.example/v.js"
package, output = types.ModuleType("google.colab"), types.ModuleType("google.colab.output")
output.enable_custom_widget_manager, output._widgets = enable_custom_widget_manager, manager
package.output = output
sys.modules |= {"google": types.ModuleType("google"), "google.colab": package,
                "google.colab.output": output}
"""
SHOWN = """
import json
import kinlab as kl
from IPython.core.interactiveshell import InteractiveShell
show = InteractiveShell.instance().display_formatter.format
print(json.dumps([[sorted(data), metadata] for data, metadata in map(show, [{made}])]))
"""
WIDGET = "application/vnd.jupyter.widget-view+json"
VIEWS = ["kl.ArmView(kl.robots.two_link())", "kl.DHTableEditor()",
         "kl.TargetView(kl.robots.two_link())", "kl.link_view(kl.robots.two_link(), 1)",
         "kl.predict('rotation.riding')", "kl.predict('rotation.sum')"]


def shown(before):
    """Which kinds of data each view gives where it ends a cell, and the metadata."""
    code = before + SHOWN.format(made=", ".join(VIEWS))
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    return dict(zip(VIEWS, json.loads(run.stdout), strict=True))


@pytest.fixture(scope="module")
def in_colab():
    return shown(STUB)


@pytest.mark.parametrize("view", VIEWS)
def test_colab_is_told_which_manager_shows_the_widget(view, in_colab):
    kinds, metadata = in_colab[view]
    assert WIDGET in kinds and "text/plain" in kinds
    assert metadata[WIDGET] == {
        "colab": {"custom_widget_manager": {"url": "https://manager.example/v.js"}}}
    assert ("image/png" in kinds) == bool(metadata.get("image/png", {}).get("alt"))


def test_nobody_else_is_told_of_it():
    for kinds, metadata in shown("").values():
        assert WIDGET in kinds and WIDGET not in metadata
