"""A link's stages in the browser: a button each, the product beside them, and two sight lines."""
import numpy as np
import pytest
from playwright.sync_api import expect
from reading import read
from textbook import rigid, turn

import kinlab as kl

X, Z = np.eye(3)[[0, 2]]
Q = [0.2, 0.3, 0.5]
# Link 2 of the exam arm: theta_2 + 90 degrees, d = 0.2, a = 0.4, alpha = 90 degrees.
FACTORS = [rigid(turn(Z, 0.3 + np.pi / 2)), rigid(o=0.2 * Z), rigid(o=0.4 * X),
           rigid(turn(X, np.pi / 2))]
PRODUCTS = [np.eye(4)]
for factor in FACTORS:
    PRODUCTS.append(PRODUCTS[-1] @ factor)


@pytest.fixture(scope="module")
def address(tmp_path_factory):
    path = tmp_path_factory.mktemp("stages") / "link.html"
    return kl.link_view(kl.robots.exam_2018(), 2, Q).save_html(path).as_uri()


@pytest.fixture
def view(page, address):
    page.emulate_media(reduced_motion="reduce")  # steps arrive at once
    page.goto(address)
    return page.locator(".kl-view")


def stages(view):
    return view.get_by_role("group", name="Stages").get_by_role("button")


def assert_at(view, stage):
    """The button, the sentence, the formula and the numbers are those of the stage."""
    expect(stages(view).nth(stage)).to_have_attribute("aria-pressed", "true")
    expect(stages(view).locator("xpath=self::*[@aria-pressed='true']")).to_have_count(1)
    expect(view.locator("[data-reading='stage']")).to_contain_text(f"{stage + 1}. ")
    done = max(0, stage - 2)
    shown = view.locator("[data-stages]:visible")
    expect(shown).to_have_count(1)
    text = shown.locator("p").inner_text()
    assert text.count("Rot") + text.count("Trans") == done
    np.testing.assert_allclose(read(view)["cells"], PRODUCTS[done], atol=6e-4)


def test_each_stage_has_a_button(view):
    assert_at(view, 0)
    for stage in (3, 1, 6, 4, 0):
        stages(view).nth(stage).click()
        assert_at(view, stage)


def test_step_back_and_the_keyboard_lead_through_them(view):
    for stage in (1, 2, 3):
        view.get_by_role("button", name="Step forward").press("Enter")
        assert_at(view, stage)
    view.get_by_role("button", name="Step back").press("Enter")
    assert_at(view, 2)
    stages(view).nth(5).press("Enter")
    assert_at(view, 5)
    view.get_by_role("slider", name="stage").press("End")
    assert_at(view, 6)


def test_play_goes_through_all_of_them(page, address):
    page.emulate_media(reduced_motion="no-preference")
    page.goto(address)
    view = page.locator(".kl-view")
    view.get_by_role("button", name="Play").click()
    expect(stages(view).nth(2)).to_have_attribute("aria-pressed", "true")
    expect(stages(view).nth(3)).to_have_attribute("aria-pressed", "true")
    view.get_by_role("button", name="Pause").click()


@pytest.mark.parametrize("name, frame, axis", [("z₁", 1, 2), ("x₂", 2, 0)])
def test_buttons_look_along_the_axes_of_measure(view, name, frame, axis):
    stages(view).nth(2).click()
    assert_at(view, 2)
    view.get_by_role("button", name=f"Along {name}", exact=True).click()
    drawn = read(view)["paths"][f"frame-{frame}-{'xyz'[axis]}"]
    ends = np.array([float(n) for n in drawn.replace("M", " ").replace("L", " ")
                     .replace("Z", " ").replace(",", " ").split()]).reshape(-1, 2)
    assert np.ptp(ends, axis=0).max() < 2  # px: it points at the viewer


def test_only_one_factor_of_each_formula_waits_for_the_tab_key(view):
    stages(view).nth(6).click()
    assert_at(view, 6)
    stops = view.locator("[data-stages]:visible [data-factor][tabindex='0']")
    expect(stops).to_have_count(1)


def test_a_link_is_chosen_among_all_frames(page, tmp_path):
    page.emulate_media(reduced_motion="reduce")
    page.goto(kl.frames_view(kl.robots.cylindrical()).save_html(tmp_path / "all.html").as_uri())
    view = page.locator(".kl-view")
    page.get_by_role("button", name="Link 2", exact=True).click()
    expect(view.locator("[data-reading='row']")).to_have_text(
        "Row 2: θ₂ = 90°, d₂ = d₂*, a₂ = 0, α₂ = 90°")
    expect(view.locator("[data-stages]:visible p")).to_contain_text("A₂, frame 2")
    expect(view.locator("#link-2-dimension-1")).to_be_visible()
    expect(view.locator("#link-1-dimension-1")).to_be_hidden()
    page.get_by_role("button", name="All", exact=True).click()
    expect(view.locator("[data-stages]:visible p")).to_contain_text("A₁ A₂ A₃")
