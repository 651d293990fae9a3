"""Payloads that are held at the start of a scenario."""

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
def test_payload_mode_without_a_held_payload_is_rejected(mode: str) -> None:
    with pytest.raises(ScenarioError, match=rf"mode: {mode} .*initial"):
        made(f'mode = "{mode}"')


def test_permanent_payload_and_cargo_are_mutually_exclusive() -> None:
    with pytest.raises(ScenarioError, match=r"payload: .*\[\[cargo\]\]"):
        made(tables='[payload]\nmass = "100 lb"\nposition = [0, 0, 1]')
    assert made().payload is None
