"""Light conditions of a scenario: their names, and the rejection of invalid conditions."""

from __future__ import annotations

import math
import re
from pathlib import Path

import pytest

from aftdeck.errors import ScenarioError
from aftdeck.scenario.light import conditions
from aftdeck.scenario.load import load_scenario, parse_scenario
from aftdeck.scenario.model import Scenario

HEAD = 'title = "t"\n[initial]\njoints = [0, 1, -1, 0, 0, 0]\n'
SWITCHES = ("fwd floods", "mid floods", "aft floods", "end effector")


def scenario(text: str, head: str = "") -> Scenario:
    return parse_scenario(head + HEAD + text, "a", "a.toml", Path())


def angle(a: tuple[float, float, float], b: tuple[float, float, float]) -> float:
    dot = sum(x * y for x, y in zip(a, b, strict=True))
    return math.degrees(math.acos(max(-1.0, min(1.0, dot / (math.hypot(*a) * math.hypot(*b))))))


def test_lighting_defaults_to_high_sun_with_all_lamps_on() -> None:
    plain = scenario("")
    assert plain.lamps == SWITCHES
    assert plain.lighting.condition == conditions()[0].name == "high sun"
    assert plain.lighting.lamps == SWITCHES
    assert plain.lighting.locked == ()


@pytest.mark.parametrize("name", [condition.name for condition in conditions()])
def test_light_condition_is_selected_by_name_and_lamps_are_sorted(name: str) -> None:
    lit = scenario(f'[light]\ncondition = "{name}"\nlamps = ["end effector", "fwd floods"]').lighting
    assert lit.condition == name
    assert lit.lamps == ("fwd floods", "end effector")


def test_all_lamps_can_be_off() -> None:
    assert scenario("[light]\nlamps = []").lighting.lamps == ()


def test_worksite_without_lamps_has_no_switches() -> None:
    assert load_scenario("concept-1972").lamps == ()


@pytest.mark.parametrize(
    ("text", "pattern"),
    [
        ('condition = "noon"', "'noon'.* high sun, low sun, night, terminator"),
        (
            'lamps = ["bow"]',
            r"light\.lamps\[0\]: .*'bow'.* fwd floods, mid floods, aft floods, end effector",
        ),
        ("condition = 3", r"light\.condition: .*`str`"),
        ('lamps = "end effector"', r"light\.lamps: .*`array`"),
        ('colour = "red"', "colour"),
    ],
)
def test_invalid_light_is_rejected_with_its_line_and_valid_names(text: str, pattern: str) -> None:
    with pytest.raises(ScenarioError) as caught:
        scenario(f"[light]\n{text}")
    (problem,) = caught.value.problems
    assert problem.startswith("a.toml:5: light.")
    assert re.search(pattern, problem)


def test_lamp_is_rejected_at_a_worksite_without_lamps() -> None:
    with pytest.raises(ScenarioError, match=r"'end effector'.* none"):
        text = '[initial]\njoints = [0, 1, -1, 0, 0, 0]\n[light]\nlamps = ["end effector"]'
        parse_scenario(f'title = "t"\narm = "concept-1972"\nworksite = "space"\n{text}', "a", "a.toml", Path())


def test_light_conditions_match_their_names() -> None:
    known = {condition.name: condition for condition in conditions()}
    assert list(known) == ["high sun", "low sun", "night", "terminator"]
    up = (0.0, 0.0, 1.0)
    limb = 71.4  # angle of the Earth's limb from the nadir, at an altitude of 350 km [deg]
    for name, condition in known.items():
        assert (condition.sun.strength == 0.0) == (name == "night")
        assert (angle(condition.to_sun, condition.nadir) < limb) == (name == "night"), "the sun is hidden at night"
    assert angle(known["high sun"].to_sun, up) < 45.0
    assert 65.0 < angle(known["low sun"].to_sun, up) < 80.0
    assert angle(known["low sun"].to_sun, (-1.0, 0.0, 0.0)) < 30.0
    assert abs(angle(known["terminator"].to_sun, known["terminator"].nadir) - 90.0) < 90.0 - limb
