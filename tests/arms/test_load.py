"""Arm files: what is built in, any other of the family by path, and what is said of a bad one."""

from __future__ import annotations

import math
import re
from pathlib import Path

import numpy as np
import pytest

import aftdeck
from aftdeck.arms.load import built_in
from aftdeck.errors import ArmError, ScenarioError
from tests.reference.tables import table

LIMITS = table("srms-limits")
MADE_UP = Path(__file__).parent / "made-up.toml"
TEXT = MADE_UP.read_text(encoding="utf-8")


def test_the_shuttles_arm_has_the_published_limits_and_rates() -> None:
    arm = aftdeck.load_arm("srms")
    for found, given in ((arm.limits.hard, "hard"), (arm.limits.soft, "soft")):
        assert np.degrees(found) == pytest.approx(np.array(LIMITS[given]))
    inside = np.array(LIMITS["soft"]) + np.array([1, -1]) * LIMITS["reach_inside_soft"]
    assert np.degrees(arm.limits.reach) == pytest.approx(inside)
    for which in ("servo", "coarse", "vernier"):
        assert np.degrees(getattr(arm.rates, which)) == pytest.approx(LIMITS[which])
    assert (arm.rate_limits == arm.rates.servo).all()


def test_the_shuttles_arm_is_as_long_as_published() -> None:
    # 50 ft 3 in from shoulder pitch to tip, stretched out at zero angles
    arm = aftdeck.load_arm("srms")
    assert arm.forward(np.zeros(6)).position == pytest.approx([50.25 * 0.3048, 0.0, -0.3048])


def test_the_joints_have_their_names_in_order() -> None:
    assert aftdeck.load_arm("srms").joints == (
        "shoulder_yaw", "shoulder_pitch", "elbow_pitch", "wrist_pitch", "wrist_yaw", "wrist_roll",
    )  # fmt: skip


def test_an_arms_arrays_cannot_be_changed() -> None:
    arm = aftdeck.load_arm("srms")
    for array in (arm.limits.hard, arm.limits.soft, arm.limits.reach, arm.rate_limits, arm.model.links):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 0.0


@pytest.mark.parametrize("name", built_in())
def test_a_built_in_arm_says_of_each_constant_where_it_comes_from(name: str) -> None:
    file = aftdeck.load_arm(name).model.source
    assert all(getattr(file.geometry, field).source for field in file.geometry.__struct_fields__)
    assert all(row.source for row in file.por)


def test_an_arm_file_loads_by_path_as_text_or_path() -> None:
    for given in (MADE_UP, str(MADE_UP)):
        arm = aftdeck.load_arm(given)
        assert arm.name == "made-up" and arm.joints == ("a", "b", "c", "d", "e", "f")
        assert repr(arm) == "Arm('made-up')"


@pytest.mark.parametrize("name", ["canadarm3", "", "SRMS", "../arms/srms", "srms.shapes"])
def test_an_unknown_arm_is_refused_with_the_names_there_are(name: str) -> None:
    with pytest.raises(ArmError, match=r"built in are concept-1972, srms; a path to an arm file ends in \.toml"):
        aftdeck.load_arm(name)


def problems(tmp_path: Path, old: str, new: str) -> list[str]:
    assert old in TEXT
    file = tmp_path / "bad.toml"
    file.write_text(TEXT.replace(old, new, 1), encoding="utf-8")
    with pytest.raises(ScenarioError) as caught:
        aftdeck.load_arm(file)
    return list(caught.value.problems)


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        (
            'family = "yaw-pitch-pitch-pitch-yaw-roll"',
            'family = "scara"',
            "family: expected one of yaw-pitch-pitch-pitch-yaw-roll, heading-pitch-pitch-heading-pitch-roll, "
            "got 'scara'",
        ),
        ('"e", "f"]\nlabels', '"e"]\nlabels', "joints: Expected `array` of length 6, got 5"),
        ('"e", "f"]\nlabels', '"e", "a"]\nlabels', "joints: has to be six different names, got a, b, c, d, e, a"),
        ('units = "SI"', 'units = "cubits"', "units: expected one of ft-in, SI, got 'cubits'"),
        ("value = 0.4,", "value = -0.4,", "geometry.shoulder_yaw_to_pitch: has to be 0 or more, got -0.4 m"),
        ("value = 0.4,", "value = nan,", "geometry.shoulder_yaw_to_pitch.value: expected a finite number in m"),
        ("value = 0.4,", "value = '1 kg',", "geometry.shoulder_yaw_to_pitch.value: '1 kg' is not a length"),
        (
            "value = [3.0, -0.25]",
            "value = [0.0, -0.25]",
            "geometry.upper_arm: the length along the arm has to be above 0",
        ),
        ("value = 0.3,", "value = -0.3,", "geometry.wrist_pitch_to_yaw: has to be 0 or more, got -0.3 m"),
        ('source = "made up"', 'source = ""', "source: Expected `str` of length >= 1"),
        (
            'confidence = "assumed"',
            'confidence = "sure"',
            "confidence: expected one of firm, single, derived, assumed, got 'sure'",
        ),
        ("singular = { value = 0.1", "singular = { value = 1.5", "limits.singular: has to be between 0 and 1, got 1.5"),
        ("singular = { value = 0.1", "singular = { value = nan", "limits.singular"),
        ("hard = { value = [[-3, 3]", "hard = { value = [[-2, 3]", "a: reach limits have to be inside the soft stops"),
        ("hard = { value = [[-3, 3]", "hard = { value = [[3, -3]", "a: reach limits have to be inside the soft stops"),
        (
            "vernier = { value = [0.05",
            "vernier = { value = [0.5",
            "a: expected 0 < vernier <= coarse <= servo, got 0.5",
        ),
        ("mass = 0\n", "mass = 1\n", "por[0].mass: the first row has to be for mass 0, without a payload; got 1 kg"),
        (
            'mass = "10 t"',
            'mass = "1 t"',
            "por[2].mass: masses have to increase from row to row, got 1000 after 1000 kg",
        ),
        ("reached_in = 2\n", "reached_in = 0\n", "por[0]: speeds and the time have to be above 0"),
        ("vernier_translation = 0.2", "vernier_translation = 0.7", "por[0]: "),
        (
            "total = { value = 9",
            "total = { value = 10",
            "masses.total: has to be the sum of the parts' masses, 9 kg; got 10 kg",
        ),
        ("elbow = 1", "elbow = -1", "masses"),
        ("title =", "colour =", "the field 'title' is missing"),
        ("[mount]", "[muont]", "the field 'mount' is missing"),
    ],
)
def test_a_bad_arm_file_is_refused_with_what_is_wrong_and_where(tmp_path: Path, old: str, new: str, said: str) -> None:
    found = problems(tmp_path, old, new)
    assert any(said in problem for problem in found), found
    assert all(re.match(r"bad\.toml:\d+: |bad\.toml: the field '\w+' is missing", problem) for problem in found), found


def test_everything_wrong_with_an_arm_file_comes_at_once(tmp_path: Path) -> None:
    text = TEXT.replace("value = 0.4,", "value = -0.4,").replace("total = { value = 9", "total = { value = 7")
    file = tmp_path / "bad.toml"
    file.write_text(text.replace("singular = { value = 0.1", "singular = { value = 7"), encoding="utf-8")
    with pytest.raises(ScenarioError) as caught:
        aftdeck.load_arm(file)
    assert [problem.split(": ", 1)[0] for problem in caught.value.problems] == [
        f"bad.toml:{line_of(text.replace('singular = { value = 0.1', 'singular = { value = 7'), what)}"
        for what in ("value = -0.4,", "singular = { value = 7", "total = { value = 7")
    ]


def line_of(text: str, what: str) -> int:
    return text[: text.index(what)].count("\n") + 1


def test_the_masses_of_the_parts_add_up_to_the_published_arm() -> None:
    file = aftdeck.load_arm("srms").model.source
    assert file.masses.total.value == pytest.approx(905 * 0.45359237)


@pytest.mark.parametrize("name", ["srms", str(MADE_UP)])
def test_por_limits_are_the_rows_own_at_the_rows(name: str) -> None:
    model = aftdeck.load_arm(name).model
    for row in model.por:
        found = model.por_limits(row.mass)
        assert found.translation == (row.translation, row.vernier_translation)
        assert found.rotation == (row.rotation, row.vernier_rotation)
        assert found.acceleration == pytest.approx(row.translation / row.reached_in, rel=1e-15)
        assert found.angular_acceleration == pytest.approx(row.rotation / row.reached_in, rel=1e-15)


@pytest.mark.parametrize("name", ["srms", str(MADE_UP)])
def test_por_limits_fall_from_row_to_row_without_a_jump(name: str) -> None:
    model = aftdeck.load_arm(name).model
    masses = np.concatenate([np.linspace(0, 3000, 400), np.geomspace(3000, 60000, 800)])
    rows = np.array([(*f.translation, *f.rotation, f.acceleration) for f in map(model.por_limits, masses.tolist())])
    steps = np.diff(rows, axis=0)
    assert (steps <= 1e-15).all()
    assert np.abs(steps).max(axis=0) == pytest.approx(np.zeros(5), abs=0.05)


def test_por_limits_half_way_in_the_masss_logarithm_are_half_way() -> None:
    model = aftdeck.load_arm(MADE_UP).model
    found = model.por_limits(math.sqrt(1000.0 * 10_000.0))
    assert found.translation == pytest.approx((0.2, 0.075)) and found.acceleration == pytest.approx(0.2 / 7.5)
    light = model.por_limits(500.0)
    assert light.translation == pytest.approx((0.4, 0.15)) and light.acceleration == pytest.approx(0.4 / 3.5)


def test_beyond_the_heaviest_row_its_limits_hold() -> None:
    model = aftdeck.load_arm("srms").model
    assert model.por_limits(1e6) == model.por_limits(65_000 * 0.45359237)


def test_the_published_speeds_are_those_of_the_empty_arm() -> None:
    found = aftdeck.load_arm("srms").model.por_limits(0.0)
    assert np.array(found.translation) / 0.3048 == pytest.approx(LIMITS["por_speed"])
    assert math.degrees(found.rotation[0]) == pytest.approx(LIMITS["por_turn_coarse"])
