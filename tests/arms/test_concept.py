"""The concept arm's file: its dimensions are consistent, and inconsistent dimensions are rejected."""

from __future__ import annotations

import math
import re
from itertools import product
from pathlib import Path

import numpy as np
import pytest

import aftdeck
from aftdeck.arms.load import HERE, model_of
from aftdeck.arms.masses import masses_of
from aftdeck.arms.solids import solids_of
from aftdeck.errors import ScenarioError
from aftdeck.files import Text, read
from aftdeck.kinematics.arm import Arm

FOOT = 0.3048
TEXT = (HERE / "concept-1972.toml").read_text(encoding="utf-8")


def problems(tmp_path: Path, old: str, new: str) -> list[str]:
    assert old in TEXT
    bad = tmp_path / "bad.toml"
    text = TEXT.replace('shapes = "concept-1972.shapes.toml"', "# no shapes", 1)
    bad.write_text(text.replace(old, new, 1), encoding="utf-8")
    with pytest.raises(ScenarioError) as caught:
        aftdeck.load_arm(bad)
    return list(caught.value.problems)


def test_concept_arm_joints_have_the_reports_names_in_order() -> None:
    assert aftdeck.load_arm("concept-1972").joints == (
        "shoulder_heading", "shoulder_pitch", "elbow_pitch", "wrist_heading", "wrist_pitch", "wrist_roll",
    )  # fmt: skip


def test_reach_and_hard_limits_are_2_deg_from_the_soft_limits() -> None:
    limits = aftdeck.load_arm("concept-1972").limits
    inward = np.array([2.0, -2.0])
    assert np.degrees(limits.reach - limits.soft) == pytest.approx(np.tile(inward, (6, 1)))
    assert np.degrees(limits.hard - limits.soft) == pytest.approx(np.tile(-inward, (6, 1)))


def test_vernier_limits_are_a_third_of_the_coarse_limits() -> None:
    model = aftdeck.load_arm("concept-1972").model
    assert model.rates.vernier == pytest.approx(model.rates.coarse / 3.0, rel=1e-4)
    for mass in (0.0, 7000.0):
        por = model.por_limits(mass)
        assert por.translation == pytest.approx((2 * FOOT, 2 * FOOT / 3), rel=1e-4)
        assert np.degrees(por.rotation) == pytest.approx((5, 5 / 3), rel=1e-4)


def corners(begin: float, end: float, half_width: float) -> np.ndarray:
    """Return the corners (8, 3) of a square boom along x."""
    return np.array(list(product((begin, end), (-half_width, half_width), (-half_width, half_width))))


def test_bisecting_plane_separates_the_booms_at_the_elbow_limit() -> None:
    model = aftdeck.load_arm("concept-1972").model
    bend = -model.limits.hard[2, 0]
    set_back, least_y, _ = boom("lower boom").min(axis=0)
    half_width = -least_y
    lower = corners(set_back, 7.0, half_width)
    c, s = math.cos(bend), math.sin(bend)
    back = np.array([[-c, 0.0, -s], [0.0, 1.0, 0.0], [s, 0.0, -c]])  # from the elbow along the upper arm
    upper = lower @ back.T
    normal = lower.mean(axis=0) / np.linalg.norm(lower.mean(axis=0)) - upper.mean(axis=0) / np.linalg.norm(
        upper.mean(axis=0)
    )
    assert (lower @ normal).min() >= 0.0 >= (upper @ normal).max()
    # the plane cuts booms that are slightly thicker than `set_back` allows at this bend
    thicker = corners(set_back, 7.0, 1.001 * set_back / math.tan(0.5 * bend))
    assert (thicker @ normal).min() < 0.0


def boom(part: str) -> np.ndarray:
    """Return the vertices (8, 3) of a part of the concept arm, in the frame that carries it."""
    (found,) = [s.vertices for s in solids_of(aftdeck.load_arm("concept-1972").model) if s.part == part]
    return found


def test_parts_clear_each_other_at_the_wrist_and_at_the_housings() -> None:
    """The wrist bends in any direction: corners count. Housings stay behind the end planes of the booms."""
    hard = np.abs(aftdeck.load_arm("concept-1972").limits.hard).max(axis=1)
    heading, pitch = min(hard[3], math.pi), min(hard[4], math.pi)
    bend = math.acos(min(math.cos(h) * math.cos(p) for h in (0.0, heading) for p in (0.0, pitch)))
    ends = {}
    for part in ("lower boom", "stub"):
        ends[part], half, _ = np.abs(boom(part)).min(axis=0)
        assert ends[part] >= math.sqrt(2.0) * half * math.tan(0.5 * bend)
    for part, end in (("shoulder", ends["lower boom"]), ("elbow", ends["lower boom"]), ("wrist", ends["stub"])):
        assert np.linalg.norm(boom(part), axis=1).max() <= end


def test_parts_fit_together() -> None:
    model = aftdeck.load_arm("concept-1972").model
    assert model.telescope is not None and model.prong is not None
    low, high = boom("telescope").min(axis=0), boom("telescope").max(axis=0)
    assert high[2] - low[2] == pytest.approx(model.telescope.greatest - model.telescope.least)
    assert (high[:2] <= boom("stand").max(axis=0)[:2]).all()  # the tube slides in the sleeve
    assert boom("stub").max(axis=0)[0] == boom("palm").min(axis=0)[0]
    assert boom("palm").max(axis=0)[0] == boom("prong").min(axis=0)[0] == model.linkage.tip[0]
    assert model.prong.greatest - boom("prong").max(axis=0)[1] < model.prong.facing


@pytest.mark.parametrize(
    ("old", "new", "pattern"),
    [
        ('start]\nvalue = "12 ft"', 'start]\nvalue = "19 ft"', r"joint\[0\]: .*least.*start.*greatest"),
        ('value = "1 ft/s"', 'value = "0 ft/s"', r"joint\[0\]\.rate\.value: .*0 m/s; .*1e-06 to 10 m/s"),
        ('value = "-0.375 ft"', 'value = "0.5 ft"', r"joint\[7\]: .*prong.*fixed finger"),
        ('high = ["= palm", "1.75 ft"', 'high = ["1 ft", "1.75 ft"', r"bodies\[8\]: palm"),
        ("axes = [-3, 2, 1]", "axes = [-3, 3, 1]", r"bodies\[8\]: .*numbers 1, 2 and 3"),
        ("axes = [-3, 2, 1]", "axes = [-4, 2, 1]", r"bodies\[8\]\.axes\[0\]"),
        ('frame = "arm.prong"', 'frame = "arm.finger"', r"bodies\[10\]\.frame: .*arm\.prong"),
        (
            'label = "Sho pitch"\nkind = "turn"\nstep = [0.0, 0.0, 0.0]',
            'label = "Sho pitch"\nkind = "turn"\nstep = [0.0, 0.0, "-1 ft"]',
            r"joint\[0\]: .*telescope's end",
        ),
        ("axis = [0, 0, -1]", "axis = [0, 0, 1]", r"joint\[0\]: a telescope is the first joint"),
        ('driver = "prong"', 'driver = "telescope"', r"joint\[7\]\.driver: .*already"),
        ('driver = "prong"', 'driver = "wheel"', r"joint\[7\]\.driver: .*telescope, prong"),
        ('driver = "prong"', 'driver = "prong"\non = "stand"', r"joint\[7\]: a prong is on .*wrist_roll"),
        ('value = "900 lb"', 'value = "800 lb"', r"mass: .*408\.2"),
        ("\n[dimensions]", "\n[dimension]", "dimension: unknown"),
        ('boom = "25 ft"', 'bom = "25 ft"', "no dimension is named 'boom'"),
        ("[joint.rate]", "[joint.speed]", "speed: unknown field"),
    ],
)
def test_inconsistent_concept_arm_is_rejected_with_its_line(tmp_path: Path, old: str, new: str, pattern: str) -> None:
    found = problems(tmp_path, old, new)
    assert any(re.search(pattern, problem) for problem in found), found
    assert all(re.match(r"bad\.toml:\d+: ", problem) for problem in found), found


def test_dimension_changes_every_length_that_depends_on_it() -> None:
    text = TEXT.replace('boom = "25 ft"', 'boom = "26 ft"')
    model = model_of(Text("longer.toml", text), lambda name: read(HERE / name))
    assert model.links[1:3] == pytest.approx([26 * FOOT] * 2)
    for solid in solids_of(model):
        if "boom" in solid.part:
            assert solid.vertices[:, 0].max() == pytest.approx(25 * FOOT)
    assert masses_of(model).bodies["arm.elbow_pitch"].centre == pytest.approx([13 * FOOT, 0.0, 0.0])


def test_telescope_carries_an_arm_without_a_closed_form_too() -> None:
    text = TEXT.replace('stick = "THC Z"', 'stick = "THC Z"\nweight = 2.0')
    other = Arm(model_of(Text("other.toml", text), lambda name: read(HERE / name)))
    arm, rng = aftdeck.load_arm("concept-1972"), np.random.default_rng(8)
    assert arm.closed_form and not other.closed_form
    for stand in (9.5 * FOOT, 12 * FOOT, 18 * FOOT):
        q = rng.uniform(*arm.limits.soft.T)
        one, two = arm.at(stand=stand).forward(q), other.at(stand=stand).forward(q)
        assert two.position == pytest.approx(one.position, abs=1e-12)
        assert two.rotation == pytest.approx(one.rotation, abs=1e-12)
        assert other.at(stand=stand).stand == stand
