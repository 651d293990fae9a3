"""Light as a scenario's condition: what its names stand for, and what is said of wrong ones."""

from __future__ import annotations

import math
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


def test_without_a_word_of_light_the_sun_is_high_and_all_lamps_are_lit() -> None:
    plain = scenario("")
    assert plain.lamps == SWITCHES
    assert plain.lighting.condition == conditions()[0].name == "high sun"
    assert plain.lighting.lamps == SWITCHES
    assert plain.lighting.locked == ()


@pytest.mark.parametrize("name", [condition.name for condition in conditions()])
def test_each_condition_can_be_named_and_lamps_come_in_their_order(name: str) -> None:
    lit = scenario(f'[light]\ncondition = "{name}"\nlamps = ["end effector", "fwd floods"]').lighting
    assert lit.condition == name
    assert lit.lamps == ("fwd floods", "end effector")


def test_lamps_can_all_be_dark() -> None:
    assert scenario("[light]\nlamps = []").lighting.lamps == ()


def test_a_place_without_lamps_has_no_switches() -> None:
    assert load_scenario("concept-1972").lamps == ()


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ('condition = "noon"', "no light condition 'noon': there are high sun, low sun, night, terminator"),
        (
            'lamps = ["bow"]',
            "light.lamps[0]: no lamp switch 'bow': there are fwd floods, mid floods, aft floods, end effector",
        ),
        ("condition = 3", "light.condition: Expected `str`"),
        ('lamps = "end effector"', "light.lamps: Expected `array`"),
        ('colour = "red"', "colour"),
    ],
)
def test_what_is_wrong_is_said_with_its_place_and_what_there_is(text: str, said: str) -> None:
    with pytest.raises(ScenarioError) as caught:
        scenario(f"[light]\n{text}")
    (problem,) = caught.value.problems
    assert problem.startswith("a.toml:5: light.")
    assert said in problem


def test_at_a_place_without_lamps_a_lamp_is_said_to_be_none_of_its() -> None:
    with pytest.raises(ScenarioError, match="no lamp switch 'end effector': this scenario has none"):
        text = '[initial]\njoints = [0, 1, -1, 0, 0, 0]\n[light]\nlamps = ["end effector"]'
        parse_scenario(f'title = "t"\narm = "concept-1972"\nworksite = "space"\n{text}', "a", "a.toml", Path())


def test_conditions_are_what_their_names_say() -> None:
    known = {condition.name: condition for condition in conditions()}
    assert list(known) == ["high sun", "low sun", "night", "terminator"]
    up = (0.0, 0.0, 1.0)
    limb = 71.4  # from the nadir, as seen from 350 km
    for name, condition in known.items():
        assert (condition.sun.strength == 0.0) == (name == "night")
        assert (angle(condition.to_sun, condition.nadir) < limb) == (name == "night"), "the Earth hides the sun"
    assert angle(known["high sun"].to_sun, up) < 45.0
    assert 65.0 < angle(known["low sun"].to_sun, up) < 80.0
    assert angle(known["low sun"].to_sun, (-1.0, 0.0, 0.0)) < 30.0
    assert abs(angle(known["terminator"].to_sun, known["terminator"].nadir) - 90.0) < 90.0 - limb
