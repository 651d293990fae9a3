"""Frames of a scripted run or of a recording at given times, for the commands that draw pictures."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import partial
from pathlib import Path
from typing import NamedTuple

from aftdeck.errors import InputError
from aftdeck.historical.frame_words import FrameBlock
from aftdeck.historical.rms_vs_output import Planes
from aftdeck.historical.scene_words import frames_from, read_blocks
from aftdeck.mainprior.received import NONE, kept
from aftdeck.recording.bundle import scenario_of
from aftdeck.recording.reader import Recording
from aftdeck.recording.records import FrameRecord
from aftdeck.scenario.load import load_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.run import Simulation

RECORDING = ".mcap"
"""Ending of a recording's name."""
WORDS = ".jsonl"
"""Ending of the name of a file of frame words."""
CONCEPT = "concept-1972"
"""Scenario of frame words."""
_EMPTY = "the recording has no frames: it was cut short before its first one"


_SLACK = 1e-6
"""Difference of two times that comes from rounding [s]."""


class Moment(NamedTuple):
    """Moment of a run.

    Attributes:
        time_s: simulated time [s].
        frame: returns the frame; it can be called until the next moment is taken.
        received: planes D1 to D3 that the words brought; None for other sources.
    """

    time_s: float
    frame: Callable[[], Frame]
    received: Planes | None = None


class Source(NamedTuple):
    """Run to draw.

    Attributes:
        scenario: its scenario.
        moments: its control steps in order; a simulated run begins with the state before the first step.
        end_s: time at which it ends at the latest [s]; None if this is not known before it is read.
    """

    scenario: Scenario
    moments: Iterator[Moment]
    end_s: float | None


def source(name: str, words_of: str | None = None) -> Source:
    """Return the run of a scenario's script, a recorded run, or a run from its frame words.

    Args:
        name: a scenario's name or path, or a path that ends in ``.mcap`` (recording) or ``.jsonl`` (frame words).
        words_of: the scenario of frame words; None for `CONCEPT`.

    Raises:
        InputError: `words_of` is given, but the file has no frame words.
    """
    if name.endswith(WORDS):
        scenario = load_scenario(CONCEPT if words_of is None else words_of)
        return Source(scenario, _from_words(scenario, read_blocks(Path(name))), None)
    if words_of is not None:
        raise InputError(f"--words-of can only be given with a file of frame words ({WORDS})")
    if name.endswith(RECORDING):
        recording = Recording(Path(name))
        return Source(scenario_of(recording.opening), _recorded(recording), None)
    scenario = load_scenario(name)
    return Source(scenario, _simulated(scenario), scenario.duration)


def at(run: Source, time_s: float) -> Moment:
    """Return the moment at a time: the last one that is not later.

    Raises:
        InputError: the run ends before that time.
    """
    if run.end_s is not None and time_s > run.end_s + _SLACK:
        raise InputError(f"--time: the run has no frame at {time_s:g} s: it ends at {run.end_s:g} s at the latest")
    last = None
    for moment in run.moments:
        last = moment.time_s
        if last + run.scenario.control_period > time_s + _SLACK:
            return moment
    if last is None:
        raise InputError(_EMPTY)
    raise InputError(f"--time: the run has no frame at {time_s:g} s: it ends at {last:g} s")


def every(run: Source, step_s: float, most: int | None) -> Iterator[Frame]:
    """Yield the first frame, and then a frame every `step_s` seconds, up to the end of the run.

    Args:
        run: the run.
        step_s: time between two frames [s].
        most: greatest number of frames; None for no limit.

    Raises:
        InputError: `step_s` is less than the control period, there are more than `most` frames, or there is none.
    """
    period = run.scenario.control_period
    if step_s < period - _SLACK:
        raise InputError(f"--every: got {step_s:g} s, expected at least the control period, {period:g} s")
    due, count = 0.0, 0
    for moment in run.moments:
        if count == 0:
            due = moment.time_s
        if moment.time_s >= due - _SLACK:
            count += 1
            if most is not None and count > most:
                raise InputError(
                    f"--every {step_s:g} s gives more than {most} pictures of this size for one file; choose a longer "
                    "time or a smaller size, or write numbered files with '#' in the name"
                )
            yield moment.frame()
            due += step_s
    if count == 0:
        raise InputError(_EMPTY)


def _from_words(scenario: Scenario, blocks: Sequence[FrameBlock]) -> Iterator[Moment]:
    received = NONE
    for frame, block in zip(frames_from(scenario, blocks), blocks, strict=True):
        received = kept(received, block.planes)
        yield Moment(frame.time_s, partial(_same, frame), received)


def _recorded(recording: Recording) -> Iterator[Moment]:
    for message in recording.messages():
        if isinstance(message, FrameRecord):
            yield Moment(message.time_s, partial(_same, message))


def _same(frame: Frame) -> Frame:
    return frame


def _simulated(scenario: Scenario) -> Iterator[Moment]:
    simulation, tick = Simulation(scenario), 0
    yield Moment(0.0, simulation.look)
    while not simulation.ended:
        simulation.advance()
        tick += 1
        yield Moment(round(tick * scenario.control_period, 9), simulation.look)
