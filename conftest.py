"""How the tests are graded and shared among workers (`pytest -n auto`)."""
import pytest
from xdist.scheduler import LoadFileScheduling

# Files that take longest come first.
LONG = ("tests/test_workflow.py", "tests/browser/test_reopen.py", "tests/browser/test_hostile.py",
        "tests/browser", "notebooks", "tests/course")


class Shared(LoadFileScheduling):
    """A file stays with one worker, as do its pages and its kernel, and both tests of the site."""

    def _split_scope(self, nodeid):
        return "site" if "/test_site" in nodeid else super()._split_scope(nodeid)


def pytest_xdist_make_scheduler(config, log):
    config.option.loadscopereorder = False  # by our own order, not by the count of tests
    return Shared(config, log)


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items):
    for item in items:
        if item.path.suffix == ".ipynb" and item.path.parent.name in ("solutions", "tests"):
            item.add_marker("thorough")  # what a lesson's exercises say is tested without them
    items.sort(key=_turn)


def _turn(item):
    return next((k for k, place in enumerate(LONG) if item.nodeid.startswith(place)), len(LONG))
