"""Arm files of Aftdeck 0.2, which belonged to two families: they give the same arms, and errors name their places."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from aftdeck.arms.load import HERE, ArmModel, load_model, model_of
from aftdeck.arms.masses import masses_of
from aftdeck.arms.shapes import shapes_of
from aftdeck.arms.solids import solids_of
from aftdeck.errors import ArmError, ScenarioError
from aftdeck.files import Text, read

FOLDER = Path(__file__).parent
TEXTS = {
    name: (FOLDER / f"{name}-0.2.toml").read_text(encoding="utf-8") for name in ("srms", "concept-1972", "made-up")
}


def old_arm(text: str) -> ArmModel:
    return model_of(Text("old.toml", text), lambda name: read(HERE / name))


def same(one: object, other: object) -> bool:
    """Return whether two values are equal; arrays, and values in tuples and dictionaries, bit for bit."""
    if isinstance(one, np.ndarray) and isinstance(other, np.ndarray):
        return one.dtype == other.dtype and one.tobytes() == other.tobytes()
    if isinstance(one, dict) and isinstance(other, dict):
        return set(one) == set(other) and all(same(value, other[key]) for key, value in one.items())
    if isinstance(one, tuple) and isinstance(other, tuple):
        return len(one) == len(other) and all(map(same, one, other))
    return one == other


@pytest.mark.parametrize("name", ["srms", "concept-1972"])
def test_old_file_gives_the_built_in_arm(name: str) -> None:
    old, new = old_arm(TEXTS[name]), load_model(name)
    for field in old.__dataclass_fields__:
        if field not in ("por", "source", "text", "shapes"):
            assert same(getattr(old, field), getattr(new, field)), field
    assert [row.translation for row in old.por] == [row.translation for row in new.por]
    assert same(masses_of(old), masses_of(new))
    assert same(solids_of(old), solids_of(new))
    assert same(shapes_of(old).bodies, shapes_of(new).bodies)


def test_old_file_without_links_has_no_masses() -> None:
    old, new = old_arm(TEXTS["made-up"]), load_model(FOLDER / "made-up.toml")
    for field in ("joints", "labels", "linkage", "switched", "master", "limits", "rates", "singular"):
        assert same(getattr(old, field), getattr(new, field)), field
    masses_of(new)
    with pytest.raises(ArmError, match="no mass"):
        masses_of(old)


@pytest.mark.parametrize(
    ("name", "old", "new", "pattern"),
    [
        ("srms", '"251.05 in"', '"-251.05 in"', r"geometry\.upper_arm\.value\[0\]: "),
        ("srms", '"12 in"', '"12 kg"', r"geometry\.shoulder_yaw_to_pitch\.value: '12 kg'"),
        ("srms", '"18 in"', '"-18 in"', r"geometry\.wrist_pitch_to_yaw\.value: .*0 to 200 m"),
        ("srms", '"56 in"', '"1e6 in"', r"geometry\.wrist_yaw_to_tip\.value: .*200 m"),
        ("srms", '["-2 deg", "145 deg"]', '["-2 kg", "145 deg"]', r"limits\.hard\.value\[1\]\[0\]: '-2 kg'"),
        ("srms", '["-2 deg", "145 deg"]', '["2 deg", "145 deg"]', r"limits\.hard\.value\[1\]: shoulder_pitch: reach"),
        ("srms", '  ["-2 deg", "145 deg"],\n', "", r"limits\.hard\.value: .*`array`.*6.*5"),
        ("srms", '"0.42 deg/s"', '"4.2 deg/s"', r"rates\.servo\.value\[0\]: shoulder_yaw: .*vernier"),
        ("srms", '"wrist_roll"]', '"wrist_yaw"]', r"joints: .*different"),
        ("srms", "foot = 63.24", "foot = 6324", r"masses\.total: has to be the sum .*6682"),
        ("srms", "foot = 63.24", "feet = 63.24", r"masses\.parts\.value: .*foot"),
        ("srms", "[1.59, 632.9, 632.51]", "[1.59, 632.9, 2.51]", r"links\.inertia\.value\[3\]: "),
        ("srms", "[links.foot]", "[links.feet]", r"links: the field 'foot' is missing"),
        ("srms", "[geometry.lower_arm]", "[geometry.forearm]", r"geometry: the field 'lower_arm' is missing"),
        ("srms", "[rates.servo]", "[rates.more]\nvalue = 1\n[rates.servo]", r"rates: unknown field"),
        ("srms", "value = [3.9e6, 2.7e6]", "value = [3.9e6]", r"flexibility\.booms_bending\.value: .*2.*1"),
        ("concept-1972", 'value = "0.375 ft"', 'value = "-0.5 ft"', "effector: the prong"),
        ("concept-1972", 'value = "12 ft"', 'value = "19 ft"', "stand: .*least.*start.*greatest"),
        ("concept-1972", 'value = "1.75 ft"', 'value = "0 ft"', r"effector\."),
        ("concept-1972", 'value = "25 ft"', 'value = "0 ft"', r"geometry\.upper_arm\.value: "),
        ("concept-1972", 'value = "1 ft/s"', 'value = "0 ft/s"', r"stand\.rate\.value: .*0 m/s"),
        ("concept-1972", "hand = ", "wrist = ", r"masses\.parts\.value"),
        ("concept-1972", "[stand.rate]", "[stand.speed]", "stand: the field 'rate' is missing"),
        ("concept-1972", "heading-pitch-pitch-heading-pitch-roll", "scara", "family: unknown field"),
    ],
)
def test_error_in_an_old_file_names_the_place_in_that_file(name: str, old: str, new: str, pattern: str) -> None:
    assert old in TEXTS[name]
    with pytest.raises(ScenarioError) as caught:
        old_arm(TEXTS[name].replace(old, new, 1))
    found = caught.value.problems
    assert any(re.search(pattern, problem) for problem in found), found
    assert all(re.match(r"old\.toml:\d+: |old\.toml: the field '\w+' is missing", problem) for problem in found), found
