"""Without a browser the tests skip and say why; where one is required they fail."""
import os
import subprocess
import sys
from pathlib import Path

import pytest


@pytest.mark.parametrize("required, outcome", [("0", "skipped"), ("1", "error")])
def test_no_chromium(tmp_path, required, outcome):
    """Run one browser test where no Chromium can be found."""
    environment = {**os.environ, "PATH": str(tmp_path), "KINLAB_REQUIRE_BROWSER": required,
                   "PLAYWRIGHT_BROWSERS_PATH": str(tmp_path)}
    here = Path(__file__).with_name("test_plain_page.py")
    run = subprocess.run(
        [sys.executable, "-m", "pytest", "-rs", "-p", "no:cacheprovider",
         f"{here}::test_a_screen_reader_hears_where_the_tool_is"],
        env=environment, cwd=here.parents[2], capture_output=True, text=True)
    assert f"1 {outcome}" in run.stdout.splitlines()[-1]
    assert "playwright install chromium" in run.stdout or required == "1"
    assert "KINLAB_REQUIRE_BROWSER=1 but no Chromium" in run.stdout or required == "0"
