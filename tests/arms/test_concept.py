"""The concept arm's file: its dimensions are consistent, and inconsistent dimensions are rejected."""

from __future__ import annotations

import math
import re
from itertools import product
from pathlib import Path

import numpy as np
import pytest

import aftdeck
from aftdeck.arms.constant import Constant
from aftdeck.arms.load import HERE
from aftdeck.arms.model import HeadingArmFile
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


def test_every_constant_of_the_concept_arm_has_a_source(file: HeadingArmFile) -> None:
    tables = (file.geometry, file.mount, file.stand, file.booms, file.effector, file.limits, file.rates, file.masses)
    constants = [getattr(table, name) for table in tables for name in table.__struct_fields__]
    assert len(constants) > 35 and all(isinstance(c, Constant) and c.source for c in constants)


def corners(begin: float, end: float, half_width: float) -> np.ndarray:
    """Return the corners (8, 3) of a square boom along x."""
    return np.array(list(product((begin, end), (-half_width, half_width), (-half_width, half_width))))


def test_bisecting_plane_separates_the_booms_at_the_elbow_limit(file: HeadingArmFile) -> None:
    bend = -file.limits.soft.value[2][0]
    half_width, set_back = 0.5 * file.booms.side.value, file.booms.set_back.value
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


@pytest.mark.parametrize(
    ("old", "new", "pattern"),
    [
        (
            '[booms.set_back] # distance of both ends of ARM 0 and ARM 1 from the pins\nvalue = "1 ft"',
            '[booms.set_back]\nvalue = "0.95 ft"',
            r"booms .*0\.28956 m.*elbow.* 126 deg",
        ),
        ('["-126 deg", "-3 deg"]', '["-127.5 deg", "-3 deg"]', r"bend .*127\.5 deg.*hard stops"),
        ('["0.5 ft", "1.5 ft"]', '["0.4 ft", "1.5 ft"]', r"booms: .*stub.*0\.12192 m.*wrist"),
        ('["0.5 ft", "1.5 ft"]', '["0.5 ft", "0.5 ft"]', r"booms\.stub: .* end "),
        (
            '[booms.elbow_housing]\nvalue = "1 ft"',
            '[booms.elbow_housing]\nvalue = "1.2 ft"',
            r"booms\.elbow_housing: its",
        ),
        ('value = "9.5 ft"', 'value = "0.5 ft"', r"stand\.top_below_shoulder: .*less than the least length"),
        ('value = "12 ft"', 'value = "19 ft"', "stand: .*least.*start.*greatest"),
        ('value = "1 ft/s"', 'value = "0 ft/s"', r"stand\.rate\.value: .*0 m/s; .*1e-06 to 10 m/s"),
        ('value = "-1.25 ft"', 'value = "-0.25 ft"', "effector: .*prong.*fixed finger"),
        ('["1.5 ft", "2 ft"]', '["2 ft", "1.5 ft"]', r"effector\.palm: .* end "),
        ('value = "1.75 ft"', 'value = "0 ft"', r"effector\.palm_half_width\.value: .*0 m; .*0\.0005 to 200 m"),
        ('value = "25 ft"', 'value = "0 ft"', r"geometry\.upper_arm\.value: .*0 m; .*0\.0005 to 200 m"),
        ('value = "900 lb"', 'value = "800 lb"', r"masses\.total: .*parts.*408\.2"),
        ("[geometry.lower_arm]", "[geometry.forearm]", "forearm: unknown.* upper_arm, lower_arm"),
        ("[stand.rate]", "[stand.speed]", "field 'rate'"),
        ("hand = ", "wrist = ", r"masses\.parts\.value"),
    ],
)
def test_inconsistent_concept_arm_is_rejected_with_its_line(tmp_path: Path, old: str, new: str, pattern: str) -> None:
    found = problems(tmp_path, old, new)
    assert any(re.search(pattern, problem) for problem in found), found
    assert all(re.match(r"bad\.toml:\d+: ", problem) for problem in found), found


def test_family_selects_the_fields_of_an_arm_file(tmp_path: Path) -> None:
    found = problems(tmp_path, "heading-pitch-pitch-heading-pitch-roll", "yaw-pitch-pitch-pitch-yaw-roll")
    assert any("stand: unknown field" in problem for problem in found)
    found = problems(tmp_path, 'family = "heading-pitch-pitch-heading-pitch-roll"\n', "")
    assert any("the field 'family' is missing" in problem for problem in found)
