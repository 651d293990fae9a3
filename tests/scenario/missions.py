"""Runs of the scripted missions at the worksites, each computed once: worksite, digests, log and saved states."""

from __future__ import annotations

import functools
from collections.abc import Iterable
from typing import NamedTuple

import numpy as np
import pytest
from _pytest.mark import ParameterSet

import aftdeck
from aftdeck.scenario.load import built_in
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Event
from aftdeck.simulation.run import SavedSimulation
from aftdeck.worksite.report import Work

MISSIONS = ("concept-1972-script", "free-flyer", "srms-berth", "srms-deploy", "tutorial")
"""Built-in scenarios with a whole task at a worksite, longer than the others."""
SCRIPTED = tuple(name for name in built_in() if name != "concept-1972")
"""Built-in scenarios with a script."""
VERY_LONG = "flight-test-loaded"
"""A flight of 40 minutes; `tests.plant.multibody.test_flight_tests` flies it, and few other tests do."""


def but_very_long(names: Iterable[str]) -> list[str | ParameterSet]:
    """Return scenarios as test parameters; `VERY_LONG` is marked long."""
    return [pytest.param(name, marks=pytest.mark.long) if name == VERY_LONG else name for name in names]


def takes_its_minutes(scenario: Scenario, time_s: float) -> bool:
    """Return whether a run took the minutes of the scenario's file, rounded up; a fifth of a minute is allowed."""
    assert scenario.minutes is not None
    return scenario.minutes - 1.2 < time_s / 60.0 <= scenario.minutes


LONG = {*MISSIONS, "flight-test", VERY_LONG}
FLOWN = [pytest.param(name, marks=pytest.mark.slow) if name in LONG else name for name in SCRIPTED if name != VERY_LONG]
"""The scripted scenarios as test parameters; missions and the flight test are marked slow."""
TURNING_POINTS = {"acquired", "released", "docked", "unseated", "latch", "latched", "unlatched"}
"""Kinds of log lines that mark the progress of a mission."""
ACQUIRE, RELEASE, DOCK, UNDOCK = "acquired", "released", "docked", "unseated"
EXPECTED_KINDS = {
    "concept-1972-script": [ACQUIRE, DOCK, RELEASE, ACQUIRE, UNDOCK, RELEASE],
    "free-flyer": [ACQUIRE, DOCK, RELEASE, ACQUIRE, UNDOCK, RELEASE],
    "srms-berth": ["latch", "latched", RELEASE, RELEASE],  # first the pin is released, then the payload
    "srms-deploy": [ACQUIRE, "unlatched", UNDOCK, RELEASE, RELEASE],
    "tutorial": [ACQUIRE, "unlatched", UNDOCK],
}
"""Expected turning points of each mission, in order."""
_SAVED = 1.0 / 1500.0
"""Probability that a state is saved before a step. A state is also saved after each turning point."""


class Flown(NamedTuple):
    """Record of a complete run of a mission.

    Attributes:
        scenario: the mission's scenario.
        work: the worksite after each step.
        digests: `sha256` of each frame.
        events: the log.
        saved: saved states by the number of steps before them.
        ended: how the script ended.
    """

    scenario: Scenario
    work: list[Work]
    digests: list[str]
    events: list[Event]
    saved: dict[int, SavedSimulation]
    ended: str

    def turning_points(self) -> list[str]:
        """Return the kinds of the log lines that mark the progress of the mission."""
        return [event.kind for event in self.events if event.kind in TURNING_POINTS]

    def at(self, kind: str, which: int = 0) -> Work:
        """Return the worksite after the step that logged line number `which` of a kind, counted from 0."""
        return self.about(kind, which)[1]

    def about(self, kind: str, which: int = 0) -> tuple[Work, Work]:
        """Return the worksite before and after the step that logged line number `which` of a kind, counted from 0."""
        ticks = [self.tick(event) for event in self.events if event.kind == kind]
        return self.work[ticks[which] - 2], self.work[ticks[which] - 1]

    def tick(self, event: Event) -> int:
        """Return the number of the step that wrote a log line; the first step is 1."""
        return round(event.time_s / self.scenario.control_period)

    def during(self, phase: str) -> list[Work]:
        """Return the worksite in each step of a phase, without the first and the last step."""
        begins = [(self.tick(event), event.text) for event in self.events if event.kind == "phase"]
        begin = next(k for k, (_, text) in enumerate(begins) if text == f"phase {phase!r} begins")
        end = begins[begin + 1][0] if begin + 1 < len(begins) else len(self.work)
        return self.work[begins[begin][0] : end - 1]


@functools.cache
def flown(name: str) -> Flown:
    """Run a mission to its end, once for all tests."""
    sim = aftdeck.Simulation(name)
    rng = np.random.default_rng(5)
    done = Flown(sim.scenario, [], [], [], {}, "")
    while not sim.ended:
        if rng.random() < _SAVED:
            done.saved[len(done.work)] = sim.save()
        frame = sim.step()
        done.work.append(frame.work)
        done.digests.append(frame.sha256)
        done.events.extend(frame.events)
        if {event.kind for event in frame.events} & TURNING_POINTS:
            done.saved[len(done.work)] = sim.save()
    return done._replace(ended=sim.ended)
