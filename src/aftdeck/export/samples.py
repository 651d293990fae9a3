"""Samples of a flight at a fixed rate: what is seen, the action, and what comes of it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from aftdeck.export.flight import Flight
from aftdeck.export.pictures import Painter, Pixels
from aftdeck.export.state import Floats32, StateReader
from aftdeck.recording.reader import Recording
from aftdeck.recording.records import FrameRecord, LightRecord
from aftdeck.scenario.light import condition_named
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.run import Simulation
from aftdeck.task.progress import Progress
from aftdeck.task.remaining import Aims


class Seen(NamedTuple):
    """Observation of a learner at one time.

    Attributes:
        state: (numbers,) the state.
        pictures: (height, width, 3) picture of each camera, by its name.
    """

    state: Floats32
    pictures: dict[str, Pixels]


class Sample(NamedTuple):
    """One sample.

    Attributes:
        seen: what is seen before the action acts.
        then: what is seen afterwards.
        reward: 1 if the task becomes complete in this sample, otherwise 0.
        success: whether the task is complete afterwards.
        done: whether this is the last sample.
    """

    seen: Seen
    then: Seen
    reward: float
    success: bool
    done: bool


def samples(flight: Flight, per_sample: int, painter: Painter | None) -> Iterator[Sample]:
    """Yield the samples of a flight; sample k begins `k * per_sample` control steps after the start.

    The task is complete when the steps of the scenario's task are done; in a scenario without a task, when its script
    is completed.

    Args:
        flight: the flight.
        per_sample: control steps in a sample.
        painter: painter of the pictures; None for none.
    """
    scenario = flight.scenario
    reader, aims, task = StateReader(scenario), Aims(scenario), Progress(scenario)
    light = condition_named(scenario.lighting.condition)

    def seen(frame: Frame) -> Seen:
        left = aims.remaining(frame, task.present)
        return Seen(reader.of(frame, left), {} if painter is None else painter.draw(frame, light))

    recording = Recording(flight.recording.path)
    before, was = seen(Simulation(scenario, recording.opening.seed).look()), False
    for message in recording.messages():
        if isinstance(message, LightRecord):
            light = condition_named(message.condition)
        if not isinstance(message, FrameRecord):
            continue
        task.see(message)
        done = message.tick == flight.steps
        if message.tick % per_sample and not done:
            continue
        success = task.at == len(task.steps) if task.steps else done and flight.recording.ended == "completed"
        then = seen(message)
        yield Sample(before, then, float(success and not was), success, done)
        if done:
            return  # the file may have grown since the flight was read
        before, was = then, was or success
