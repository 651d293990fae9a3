"""What a scenario may say of a payload in the grasp at the start."""

from __future__ import annotations

from pathlib import Path

import pytest

from aftdeck.errors import ScenarioError
from aftdeck.scenario.load import parse_scenario
from aftdeck.scenario.model import Scenario

HEAD = """title = "test"
arm = "concept-1972"
worksite = "concept-1972"
{extra}
[initial]
joints = ["0 deg", "32.25 deg", "-106.33 deg", "0 deg", "-15.92 deg", "0 deg"]
[[cargo]]
name = "payload"
{tables}
"""


def made(extra: str = "", tables: str = "") -> Scenario:
    return parse_scenario(HEAD.format(extra=extra, tables=tables), "test", "test.toml", Path("."))


@pytest.mark.parametrize("mode", ["ORB LD", "PL"])
def test_a_flight_does_not_begin_in_a_mode_that_moves_a_payload_which_only_lies_there(mode: str) -> None:
    with pytest.raises(
        ScenarioError, match=f"mode: {mode} moves a payload, and no payload is in the grasp: give initial"
    ):
        made(f'mode = "{mode}"')


def test_a_payload_that_stays_in_the_grasp_and_cargo_that_is_taken_and_let_go_exclude_each_other() -> None:
    with pytest.raises(ScenarioError, match=r"payload: is never released: in a scenario with \[\[cargo\]\]"):
        made(tables='[payload]\nmass = "100 lb"\nposition = [0, 0, 1]')
    assert made().payload is None
