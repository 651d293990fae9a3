"""Frames of a scripted run or of a recording at given times, for the commands that draw pictures."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from aftdeck.errors import InputError
from aftdeck.recording.bundle import scenario_of
from aftdeck.recording.reader import Recording
from aftdeck.recording.records import FrameRecord
from aftdeck.scenario.load import load_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.run import Simulation

RECORDING = ".mcap"
"""Ending of a recording's name."""
MOST_MOMENTS = 2000
"""Greatest number of moments in one file."""


class Source(NamedTuple):
    """A run to draw.

    Attributes:
        scenario: its scenario.
        frames: its frames in order; the first one is the state before the first step, if the run is simulated.
    """

    scenario: Scenario
    frames: Iterator[Frame]


def source(name: str) -> Source:
    """Return the run of a scenario's script, or a recorded run.

    Args:
        name: a scenario's name or path, or a path that ends in ``.mcap``.
    """
    if name.endswith(RECORDING):
        recording = Recording(Path(name))
        frames = (message for message in recording.messages() if isinstance(message, FrameRecord))
        return Source(scenario_of(recording.opening), frames)
    scenario = load_scenario(name)
    return Source(scenario, _simulated(scenario))


def at(frames: Iterator[Frame], time_s: float) -> Frame:
    """Return the last frame that is not later than a time; the first frame if it is later.

    Raises:
        InputError: the run ends before that time.
    """
    last = None
    for frame in frames:
        if last is not None and frame.time_s > time_s + _SLACK:
            return last
        last = frame
    if last is None or last.time_s < time_s - _SLACK:
        end = "it has no frames" if last is None else f"it ends at {last.time_s:g} s"
        raise InputError(f"--time: the run has no frame at {time_s:g} s: {end}")
    return last


def every(frames: Iterator[Frame], step_s: float) -> Iterator[Frame]:
    """Yield the first frame, and then a frame every `step_s` seconds, up to the end of the run.

    Raises:
        InputError: there would be more than MOST_MOMENTS frames.
    """
    due, count = None, 0
    for frame in frames:
        if due is None:
            due = frame.time_s
        if frame.time_s >= due - _SLACK:
            count += 1
            if count > MOST_MOMENTS:
                raise InputError(f"--every {step_s:g} s gives more than {MOST_MOMENTS} pictures; choose a longer time")
            yield frame
            due += step_s


_SLACK = 1e-6
"""Difference of two times that comes from rounding [s]."""


def _simulated(scenario: Scenario) -> Iterator[Frame]:
    simulation = Simulation(scenario)
    yield simulation.look()
    while not simulation.ended:
        yield simulation.step()
