"""Without a browser the tests skip and say why; where one is required they fail."""
import os
import subprocess
import sys
from pathlib import Path

import pytest
from engines import open_engine


def test_a_page_is_opened_while_another_chromium_is_open(browser):
    with open_engine("chromium") as page:
        assert page.evaluate("() => 1 + 1") == 2
    page = browser.new_page()
    assert page.evaluate("1 + 1") == 2
    page.close()


@pytest.mark.parametrize("required, outcome", [
    pytest.param("0", "skipped", marks=pytest.mark.thorough), ("1", "error")])
def test_no_chromium(tmp_path, required, outcome):
    """Run one browser test where no Chromium can be found."""
    said = _run(tmp_path, "test_plain_page.py::test_a_screen_reader_hears_where_the_tool_is",
                required)
    assert f"1 {outcome}" in said.splitlines()[-1]
    assert "playwright install chromium" in said or required == "1"
    assert "KINLAB_REQUIRE_BROWSER=1 but no Chromium" in said or required == "0"


def _run(nowhere, test, required):
    """What pytest says of one test where no browser can be found."""
    environment = {**os.environ, "PATH": str(nowhere), "KINLAB_REQUIRE_BROWSER": required,
                   "PLAYWRIGHT_BROWSERS_PATH": str(nowhere)}
    here = Path(__file__).parent
    return subprocess.run(
        [sys.executable, "-m", "pytest", "-m", "", "-rs", "-p", "no:cacheprovider", here / test],
        env=environment, cwd=here.parents[1], capture_output=True, text=True).stdout


@pytest.mark.thorough
@pytest.mark.parametrize("required, outcome", [("0", "skipped"), ("1", "error")])
@pytest.mark.parametrize("engine, lacks", [("firefox", "no firefox-esr or firefox"),
                                           ("webkit", "no WebKitWebDriver"),
                                           ("chromium", "no Chromium")])
def test_no_engine(tmp_path, engine, lacks, required, outcome):
    said = _run(tmp_path, f"test_engines.py::test_it_fills_the_screen[{engine}]", required)
    assert f"1 {outcome}" in said.splitlines()[-1]
    assert ("KINLAB_REQUIRE_BROWSER=1 but " * int(required) + f"there is {lacks}") in said
