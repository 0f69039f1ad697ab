"""Every view of the lessons as it is seen first: letters one can read, no name on another."""
import pytest
from grades import crossed
from lesson_views import RARE, VIEWS
from measured import DRAWN, MEASURE

SMALLEST, WIDTHS = 12, {390: 844, 1280: 800}


@pytest.fixture(scope="module")
def measured(browser, tmp_path_factory):
    """A function that measures the page of a view at a width, in a page that all share."""
    folder, page = tmp_path_factory.mktemp("home"), browser.new_page()

    def measure(name, width):
        path = folder / f"{name}.html"
        if not path.exists():
            VIEWS[name]().save_html(path)
        page.set_viewport_size({"width": width, "height": WIDTHS[width]})
        page.goto(path.as_uri())
        page.locator(".kl-picture svg").wait_for()
        page.evaluate(DRAWN)
        return page.evaluate(MEASURE)

    yield measure
    page.close()


@pytest.mark.parametrize("name, width", crossed(VIEWS, WIDTHS, RARE))
def test_a_view_can_be_read_at_home(measured, name, width):
    seen = measured(name, width)
    assert seen["overlap"] == ""
    assert float(seen["text"]) >= SMALLEST
    assert float(seen["page"]) >= SMALLEST
    assert "html" not in seen["scroll"]
