"""The concept arm's file: its dimensions fit together, and what is said where they do not."""

from __future__ import annotations

import math
import re
from itertools import product
from pathlib import Path

import numpy as np
import pytest

import aftdeck
from aftdeck.arms.load import HERE
from aftdeck.arms.model import Constant, HeadingArmFile
from aftdeck.errors import ScenarioError

FOOT = 0.3048
TEXT = (HERE / "concept-1972.toml").read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def file() -> HeadingArmFile:
    source = aftdeck.load_arm("concept-1972").model.source
    assert isinstance(source, HeadingArmFile)
    return source


def problems(tmp_path: Path, old: str, new: str) -> list[str]:
    assert old in TEXT
    bad = tmp_path / "bad.toml"
    bad.write_text(TEXT.replace(old, new, 1), encoding="utf-8")
    with pytest.raises(ScenarioError) as caught:
        aftdeck.load_arm(bad)
    return list(caught.value.problems)


def test_its_joints_have_the_reports_names_in_order() -> None:
    assert aftdeck.load_arm("concept-1972").joints == (
        "shoulder_heading", "shoulder_pitch", "elbow_pitch", "wrist_heading", "wrist_pitch", "wrist_roll",
    )  # fmt: skip


def test_reach_limits_lie_2_deg_inside_the_soft_ones_and_hard_ones_2_deg_outside() -> None:
    limits = aftdeck.load_arm("concept-1972").limits
    inward = np.array([2.0, -2.0])
    assert np.degrees(limits.reach - limits.soft) == pytest.approx(np.tile(inward, (6, 1)))
    assert np.degrees(limits.hard - limits.soft) == pytest.approx(np.tile(-inward, (6, 1)))


def test_vernier_limits_are_a_third_of_the_coarse_ones() -> None:
    model = aftdeck.load_arm("concept-1972").model
    assert model.rates.vernier == pytest.approx(model.rates.coarse / 3.0, rel=1e-4)
    for mass in (0.0, 7000.0):
        por = model.por_limits(mass)
        assert por.translation == pytest.approx((2 * FOOT, 2 * FOOT / 3), rel=1e-4)
        assert np.degrees(por.rotation) == pytest.approx((5, 5 / 3), rel=1e-4)


def test_every_constant_says_where_it_comes_from(file: HeadingArmFile) -> None:
    tables = (file.geometry, file.mount, file.stand, file.booms, file.effector, file.limits, file.rates, file.masses)
    constants = [getattr(table, name) for table in tables for name in table.__struct_fields__]
    assert len(constants) > 35 and all(isinstance(c, Constant) and c.source for c in constants)


def corners(begin: float, end: float, half_width: float) -> np.ndarray:
    """(8, 3) corners of a square boom along x."""
    return np.array(list(product((begin, end), (-half_width, half_width), (-half_width, half_width))))


def test_at_the_elbows_limit_the_bisecting_plane_has_each_boom_on_its_own_side(file: HeadingArmFile) -> None:
    bend = -file.limits.soft.value[2][0]
    half_width, set_back = 0.5 * file.booms.side.value, file.booms.set_back.value
    lower = corners(set_back, 7.0, half_width)
    c, s = math.cos(bend), math.sin(bend)
    back = np.array([[-c, 0.0, -s], [0.0, 1.0, 0.0], [s, 0.0, -c]])  # from the elbow back along the upper arm
    upper = lower @ back.T
    normal = lower.mean(axis=0) / np.linalg.norm(lower.mean(axis=0)) - upper.mean(axis=0) / np.linalg.norm(
        upper.mean(axis=0)
    )
    assert (lower @ normal).min() >= 0.0 >= (upper @ normal).max()
    # with the booms a little thicker, as the rule has it, the plane cuts them
    thicker = corners(set_back, 7.0, 1.001 * set_back / math.tan(0.5 * bend))
    assert (thicker @ normal).min() < 0.0


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        (
            '[booms.set_back] # of both ends of both booms from their pins\nvalue = "1 ft"',
            '[booms.set_back]\nvalue = "0.95 ft"',
            "the arm's booms set back by 0.28956 m from the elbow cannot bend by 126 deg",
        ),
        ('["-126 deg", "-3 deg"]', '["-127.5 deg", "-3 deg"]', "cannot bend by 127.5 deg, which the hard stops allow"),
        ('["0.5 ft", "1.5 ft"]', '["0.4 ft", "1.5 ft"]', "booms: the stub set back by 0.12192 m from the wrist cannot"),
        (
            '["0.5 ft", "1.5 ft"]',
            '["0.5 ft", "0.5 ft"]',
            "booms.stub: has to end farther along the end effector than it begins",
        ),
        (
            '[booms.elbow_housing]\nvalue = "1 ft"',
            '[booms.elbow_housing]\nvalue = "1.2 ft"',
            "booms.elbow_housing: its",
        ),
        (
            'value = "9.5 ft"',
            'value = "0.5 ft"',
            "stand.top_below_shoulder: has to be above 0 and less than the least length",
        ),
        ('value = "12 ft"', 'value = "19 ft"', "stand: expected 0 < least <= start <= greatest"),
        ('value = "1 ft/s"', 'value = "0 ft/s"', "stand.rate: has to be above 0, got 0"),
        ('value = "-1.25 ft"', 'value = "-0.25 ft"', "effector: the prong closes towards the fixed finger"),
        (
            '["1.5 ft", "2 ft"]',
            '["2 ft", "1.5 ft"]',
            "effector.palm: has to end farther along the end effector than it begins",
        ),
        ('value = "1.75 ft"', 'value = "0 ft"', "effector.palm_half_width: has to be above 0, got 0"),
        ('value = "25 ft"', 'value = "0 ft"', "geometry.upper_arm: has to be above 0, got 0 m"),
        ('value = "900 lb"', 'value = "800 lb"', "masses.total: has to be the sum of the parts' masses, 408.2"),
        ("[geometry.lower_arm]", "[geometry.forearm]", "forearm: unknown field; allowed here: upper_arm, lower_arm"),
        ("[stand.rate]", "[stand.speed]", "the field 'rate' is missing"),
        ("hand = ", "wrist = ", "masses.parts.value"),
    ],
)
def test_a_concept_arm_that_does_not_fit_together_is_refused_with_what_and_where(
    tmp_path: Path, old: str, new: str, said: str
) -> None:
    found = problems(tmp_path, old, new)
    assert any(said in problem for problem in found), found
    assert all(re.match(r"bad\.toml:\d+: ", problem) for problem in found), found


def test_the_file_is_told_apart_from_the_shuttles_by_its_family(tmp_path: Path) -> None:
    found = problems(tmp_path, "heading-pitch-pitch-heading-pitch-roll", "yaw-pitch-pitch-pitch-yaw-roll")
    assert any("stand: unknown field" in problem for problem in found)
    found = problems(tmp_path, 'family = "heading-pitch-pitch-heading-pitch-roll"\n', "")
    assert any("the field 'family' is missing" in problem for problem in found)
