"""Benchmark of the console: how late the control steps of a session are while lines are typed."""

from __future__ import annotations

import random
import sys
import time
from itertools import islice
from typing import NamedTuple

from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.run import Simulation
from aftdeck.station.core.asked import Asked
from aftdeck.station.core.step import Delay, Step
from aftdeck.station.server.serve import SWITCH_S
from aftdeck.station.session.driver import Driver
from aftdeck.station.session.session import Session
from benchmarks.measure import Figure
from tests.legal_changes import changing, random_change
from tests.station.test_typewriter import random_lines


class Size(NamedTuple):
    """Extent of the measurement.

    Attributes:
        seconds: time without a line [s].
        changes: number of possible changes, one each second.
        lines: number of random lines, 20 each second.
    """

    seconds: float
    changes: int
    lines: int


FULL, TINY = Size(8.0, 40, 1000), Size(1.0, 2, 5)
NAMES = "concept-1972", "srms-berth"


class _Timed(Session):
    """Session that keeps how late its steps are."""

    late: list[float]

    def advance(self, asked: Asked, delay: Delay) -> Step:  # type: ignore[override]
        self.late.append(delay.late_s)
        return super().advance(asked, delay)

    def worst(self, title: str) -> list[Figure]:
        """Return how late the steps since the last call were."""
        late, self.late = self.late, []
        period = self.scenario.control_period
        beyond = sum(one > period for one in late)
        return [
            Figure(f"{title}, worst step", 1e3 * max(late), "ms", 1e3 * period, f"late; {len(late)} steps"),
            Figure(f"{title}, steps later than a period", beyond, "", 0),
        ]


def console(size: Size) -> list[Figure]:
    """Measure how late steps are without lines, with possible changes, and with random lines."""
    sys.setswitchinterval(SWITCH_S)
    return [figure for name in NAMES for figure in _of(name, size)]


def _of(name: str, size: Size) -> list[Figure]:
    scenario, rng = load_scenario(name), random.Random(3)
    twin, found = Simulation(scenario), []
    twin.step()
    entries = changing(scenario)
    changes = [random_change(rng, entries, twin.prepare) for _ in range(size.changes)]
    session = _Timed(scenario)
    session.late = []
    session.laws.wait(600.0)
    driver = Driver(session)
    driver.start(lambda: None)
    try:
        session.type_line("help")  # the process of the console starts
        time.sleep(2.0)
        session.late = []
        time.sleep(size.seconds)
        found += session.worst(f"{name}, no line")
        for change in changes:
            session.type_line("set " + "; ".join(f"{key} = {value}" for key, value in change.items()))
            time.sleep(1.0)
        found += session.worst(f"{name}, a change each second")
        for line in islice(random_lines(rng, scenario), size.lines):
            session.type_line(line)
            time.sleep(0.05)
        found += session.worst(f"{name}, 20 random lines a second")
    finally:
        driver.close()
    return found
