"""Built-in arms and scenarios, each loaded once in a process for all tests.

They are immutable, so that no test can change what another one uses. Modules of tests load nothing when they are
imported (`tests/conftest.py` checks this); for parameters of tests, this module knows what the files contain.
"""

from __future__ import annotations

import functools
import tomllib
from pathlib import Path
from typing import Any

from aftdeck.kinematics.arm import Arm, load_arm
from aftdeck.scenario.load import about, built_in, load_scenario
from aftdeck.scenario.model import Scenario

CHAINS = Path(__file__).parent.parent / "examples" / "arms"
"""Arms without a closed form, one file for each, and flights of them."""


@functools.cache
def arm(name: str = "srms") -> Arm:
    """Return a built-in arm."""
    return load_arm(name)


@functools.cache
def chain(name: str) -> Arm:
    """Return an arm of examples/arms, which has no closed form."""
    return load_arm(CHAINS / f"{name}.toml")


@functools.cache
def scenario(name: str = "first-flight") -> Scenario:
    """Return a built-in scenario."""
    return load_scenario(name)


@functools.cache
def table(name: str) -> dict[str, Any]:
    """Return the contents of a built-in scenario's file."""
    return tomllib.loads(about(name).file)


def names_with(key: str) -> tuple[str, ...]:
    """Return the names of the built-in scenarios whose files have a key, for example ``phase`` or ``step``."""
    return tuple(name for name in built_in() if key in table(name))


def arm_name(scenario_name: str) -> str:
    """Return the name of the arm of a built-in scenario."""
    return str(table(scenario_name).get("arm", "srms"))
