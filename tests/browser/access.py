"""What who cannot see, or has no mouse, gets of a page: axe-core's rules, and the Tab key."""
from __future__ import annotations

import os
from pathlib import Path

import pytest
from playwright.sync_api import Locator, Page

AXE = Path(__file__).parents[2] / "node_modules" / "axe-core" / "axe.min.js"
# What breaks a rule, in a line each: the rule, where, and what is wrong there.
RUN = """async within => {
    const { violations } = await axe.run(within,
        { resultTypes: ['violations'], preload: false });
    return violations.flatMap(({ id, nodes }) => nodes.map(({ target, failureSummary, html }) =>
        `${id} at ${target.join(' ')}: ${failureSummary.split('\\n')[1]?.trim()} in ${html}`));
}"""
HERE = """root => {
    const at = document.activeElement;
    if (!root.contains(at)) return null;
    return at.getAttribute('aria-label') || at.textContent.trim() || at.tagName;
}"""


def axe_script() -> str:
    """The text of axe-core; without it the test skips, or fails where a browser is required."""
    if not AXE.exists():
        word = "no axe-core here: run `npm install` in the folder of the project"
        if os.environ.get("KINLAB_REQUIRE_BROWSER") == "1":
            pytest.fail(word)
        pytest.skip(word)
    return AXE.read_text(encoding="utf-8")


def violations(page: Page, within: str = "html") -> list[str]:
    """What axe-core finds wrong in the part of a page that a selector names."""
    if not page.evaluate("'axe' in window"):
        page.evaluate(axe_script())
    return page.evaluate(RUN, within)


def stops(root: Locator) -> list[str]:
    """The names of all places where the Tab key stops on its way through an element."""
    page, names = root.page, []
    root.evaluate("""root => {
        const before = document.createElement('button');
        before.id = 'before-it';
        root.before(before);
        before.focus();
    }""")
    for _ in range(400):
        page.keyboard.press("Tab")
        if (name := root.evaluate(HERE)) is None:
            break
        names.append(name)
    page.evaluate("document.getElementById('before-it').remove()")
    return names
