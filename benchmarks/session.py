"""Benchmark of a session's step, in the direct host and in the session of a server, alone and with a recording."""

from __future__ import annotations

import gc
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import NamedTuple

from aftdeck.recording.bundle import opening
from aftdeck.scenario.load import load_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.station.core.direct import Direct, DirectRecording
from aftdeck.station.session.session import Session
from benchmarks.measure import Figure


class Size(NamedTuple):
    """Extent of the measurement.

    Attributes:
        steps: number of steps in a round.
        rounds: number of rounds; the best one counts.
    """

    steps: int
    rounds: int


FULL, TINY = Size(500, 8), Size(5, 1)
NAME = "srms-berth"
WARM = 50
"""Number of steps before the measurement."""


def session(size: Size) -> list[Figure]:
    """Measure a step of a session: inputs, simulation, message to the pages, observers."""
    made = load_scenario(NAME)
    hosts = {
        "direct host": _direct(made, recorded=False),
        "direct host, recorded": _direct(made, recorded=True),
        "session of a server": _served(made, recorded=False),
        "session of a server, recorded": _served(made, recorded=True),
    }
    found = []
    for title, host in hosts.items():
        with host as step:
            took = _best(step, size)
        found.append(Figure(title, 1e6 * took, "us", None, f"{NAME}, best of {size.rounds} rounds of {size.steps}"))
    return found


@contextmanager
def _direct(made: Scenario, *, recorded: bool) -> Iterator[Callable[[], object]]:
    host = Direct(made, recording=DirectRecording(lambda of, seed: opening(of, seed, 0), 0) if recorded else None)
    host.join()
    yield host.step
    host.close()


@contextmanager
def _served(made: Scenario, *, recorded: bool) -> Iterator[Callable[[], object]]:
    with tempfile.TemporaryDirectory() as folder:
        served = Session(made, record=Path(folder) if recorded else None)
        served.join("page")
        served.begin()
        yield served.step
        served.close()


def _best(step: Callable[[], object], size: Size) -> float:
    """Return the time of a step in the best round [s]."""
    for _ in range(WARM):
        step()
    gc.unfreeze()
    gc.collect()
    gc.freeze()  # as the driver of a server does
    best = float("inf")
    for _ in range(size.rounds):
        began = time.perf_counter()
        for _ in range(size.steps):
            step()
        best = min(best, (time.perf_counter() - began) / size.steps)
    return best
