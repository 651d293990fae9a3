"""The table of readings. Everything that shows numbers of a run chooses from it."""

from __future__ import annotations

from functools import cache

from aftdeck.scenario.model import Scenario
from aftdeck.simulation.readings.masses import FORCES, LOADS, of_bodies
from aftdeck.simulation.readings.motion import MOTION
from aftdeck.simulation.readings.panel import LIMITS, STICKS, TIMES
from aftdeck.simulation.readings.reading import Reading
from aftdeck.simulation.readings.work import CLEARANCE, WORK, of_payloads

SECTIONS: tuple[tuple[str, tuple[Reading, ...]], ...] = (
    ("Times", TIMES),
    ("Clearance", CLEARANCE),
    ("Path", MOTION),
    ("Clearance", WORK),
    ("Hand controllers", STICKS),
    ("Limits", LIMITS),
    ("Forces", FORCES),
    ("Torques, loads and bends", LOADS),
)
"""Readings of every run, each section with the subject of its metrics.

Their order is that of the strips, of a dataset's state, and of the metrics within a subject.
"""


def readings() -> tuple[Reading, ...]:
    """Return the readings of every run."""
    return tuple(reading for _, section in SECTIONS for reading in section)


def readings_of(scenario: Scenario) -> tuple[Reading, ...]:
    """Return the readings that a run of a scenario has, those of its payloads and of parts that bend at the end."""
    found = (*readings(), *of_payloads(scenario), *of_bodies(scenario))
    return tuple(reading for reading in found if scenario.plant != "kinematic" or not reading.needs)


@cache
def named(name: str) -> Reading:
    """Return the reading of every run with this name."""
    return next(reading for reading in readings() if reading.name == name)
