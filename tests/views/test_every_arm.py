"""Each arm that kinlab has, in every view, examiner and editor, in both conventions."""
import numpy as np
import pytest
from grades import chosen, crossed

import kinlab as kl

close = np.testing.assert_allclose
# A prismatic joint, seven joints, a base and Craig's order, and lengths in mm.
ORDINARY = ["stanford", "panda", "puma_560_craig", "scara"]
ARMS = {name: getattr(kl.robots, name) for name in kl.robots.__all__}
every = pytest.mark.parametrize("name", chosen(list(ARMS), ORDINARY))
CONVERT = {"as it is": lambda arm: arm, "standard": kl.to_standard, "modified": kl.to_modified}


def nearby(arm):
    """A pose a little off home."""
    step = [0.2 if link.kind == "revolute" else 0.1 * arm.home[k] for k, link in enumerate(
        arm.joints)]
    return arm.home + step


def solve_view(arm, q):
    """Newton's method needs as many joints as directions."""
    methods = ("newton" if arm.n == 6 else "pseudoinverse", "damped")
    return kl.solve_view(arm, kl.forward_kinematics(arm, nearby(arm)), q, methods=methods)


VIEWS = {
    "arm": lambda arm, q: kl.ArmView(arm, q, closed_form=True, show=("frames", "labels", "axes")),
    "target": kl.TargetView, "velocity": kl.velocity_view, "frames": kl.frames_view,
    "solve": solve_view,
    "first link": lambda arm, q: kl.link_view(arm, 1, q),
    "last link": lambda arm, q: kl.link_view(arm, len(arm.links), q)}


@pytest.mark.parametrize("name, view", crossed(ARMS, VIEWS))
@pytest.mark.parametrize("convert", chosen(list(CONVERT), ["as it is"]))
def test_every_arm_opens_in_every_view(name, view, convert, tmp_path):
    arm = CONVERT[convert](ARMS[name]())
    shown = VIEWS[view](arm, arm.home)
    scene = shown._scene
    assert np.isfinite(np.concatenate([np.ravel(T) for T in scene.frames(scene.begin)])).all()
    if view in ("arm", "target"):
        close(shown.T, kl.forward_kinematics(arm, arm.home), atol=1e-9 * np.abs(shown.T).max())
    shown.save_html(tmp_path / "view.html")
    assert arm.name in (tmp_path / "view.html").read_text(encoding="utf-8")


@every
def test_every_arm_is_itself_in_the_other_convention(name):
    arm = ARMS[name]()
    for other in (kl.to_modified(arm), kl.to_standard(arm)):
        for q in (arm.home, nearby(arm)):
            close(kl.forward_kinematics(other, q), kl.forward_kinematics(arm, q), atol=1e-9)
        for strict in (False, True):
            assert kl.same_mechanism(other, arm, strict=strict).ok
            assert kl.same_mechanism(arm, other, strict=strict).ok
        assert [link.speed for link in other.links] == [link.speed for link in arm.links]


def test_every_two_arms_differ_but_for_the_two_tables_of_the_puma():
    arms = {name: make() for name, make in ARMS.items()}
    same = {(one, other) for one in arms for other in arms if one < other
            and kl.same_mechanism(arms[one], arms[other]).ok}
    assert same == {("puma_560", "puma_560_craig")}


@every
def test_a_slip_in_the_table_of_every_arm_is_named(name):
    """One length, one twist: neither is the arm any more, and the row is named."""
    arm = ARMS[name]()
    for row, column, text in ((2, "a", "12.5"), (2, "alpha", "37")):
        editor = kl.DHTableEditor(arm)
        editor.set(row, column, text)
        verdict = kl.same_mechanism(editor.arm, arm)
        assert not verdict.ok and verdict.fault is not None, verdict.message


@every
def test_the_frames_of_every_arm_give_its_table_back(name):
    standard = kl.to_standard(ARMS[name]())
    frames = [(T[:3, 2], T[:3, 0], T[:3, 3]) for T in kl.link_frames(standard, standard.home)]
    placement = kl.examine_frames(frames, ARMS[name]())
    assert placement.ok, placement.message
    assert kl.same_mechanism(placement.arm, standard, tip=False).ok
    wrong = [*frames[:1], (frames[1][1], frames[1][0], frames[1][2]), *frames[2:]]  # z along x
    assert not kl.examine_frames(wrong, ARMS[name]()).ok


@every
def test_the_editor_gives_every_arm_back(name):
    arm = ARMS[name]()
    editor = kl.DHTableEditor(arm)
    told(editor.arm, arm)
    other = kl.DHTableEditor()
    for text in (editor.to_csv(), editor.to_code(), editor.to_markdown(), editor.to_latex()):
        other.load(text)
        told(other.arm, arm)
    editor.q = nearby(arm)
    close(editor.T, kl.forward_kinematics(arm, nearby(arm)), atol=1e-9 * np.abs(editor.T).max())


def told(found, arm):
    """All that an arm is: to the last digit but one, since the table is in degrees."""
    assert (found.name, found.unit, found.convention) == (arm.name, arm.unit, arm.convention)
    for one, other in zip(found.links, arm.links, strict=True):
        assert (one.kind, one.name, one.flip) == (other.kind, other.name, other.flip)
        for part in ("theta", "d", "a", "alpha", "limits", "speed", "acceleration"):
            here, there = getattr(one, part), getattr(other, part)
            assert (here is None) == (there is None)
            if here is not None:
                close(here, there, rtol=1e-14)
    for part in ("base", "tool", "home"):
        close(getattr(found, part), getattr(arm, part), rtol=1e-14, atol=1e-15)


@every
def test_every_arm_comes_home_and_to_a_random_pose(name):
    arm, rng = ARMS[name](), np.random.default_rng(16)
    low, high = kl.arms.joints.joint_ranges(arm)
    for q in (arm.home, rng.uniform(low, high)):
        target = kl.forward_kinematics(arm, q)
        found = kl.inverse_kinematics(arm, target, nearby(arm))
        assert found.success, found.message
        close(kl.forward_kinematics(arm, found.q), target, atol=1e-5 * np.abs(target).max())
