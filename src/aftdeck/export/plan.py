"""Plan of a dataset: what all its episodes have in common, checked before anything is written."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from aftdeck.errors import InputError
from aftdeck.export.columns import SCRIPT, Encoding
from aftdeck.export.flight import Flight
from aftdeck.export.pictures import SIZE, names_of
from aftdeck.export.state import StateReader, same_names

USUAL_RATE = 10.0
"""Default number of samples in a second, if the control rate is a multiple of it [1/s]."""
LEAST_RATE = 0.1
"""Least number of samples in a second [1/s]: a sample has the inputs of all its control steps."""
STICKS = Encoding((), 0).names[:6]
"""Columns that every dataset has: those of the hand controllers."""


@dataclass(frozen=True)
class Plan:
    """Plan of a dataset.

    Attributes:
        fps: samples in a second [1/s].
        per_sample: control steps in a sample.
        action: columns of the actions.
        inputs: columns of the inputs of each control step.
        state: names of the numbers of the state.
        pictures: camera of each picture, by the picture's name.
        size: width and height of a picture [pixels].
        task: task of all episodes; None for the titles of their scenarios.
    """

    fps: float
    per_sample: int
    action: tuple[str, ...]
    inputs: tuple[str, ...]
    state: tuple[str, ...]
    pictures: dict[str, str]
    size: tuple[int, int]
    task: str | None = None

    def task_of(self, flight: Flight) -> str:
        """Return the task of an episode."""
        return flight.scenario.title if self.task is None else self.task


def plan(
    flights: Sequence[Flight],
    *,
    fps: float | None = None,
    columns: Sequence[str] | None = None,
    cameras: Sequence[str] = (),
    size: tuple[int, int] = SIZE,
    task: str | None = None,
) -> Plan:
    """Return the plan of a dataset with these flights as its episodes.

    Args:
        flights: the flights, at least one.
        fps: samples in a second; None for `USUAL_RATE`, or the greatest possible rate below it.
        columns: columns of the actions; None for the hand controllers' and all others that a flight uses.
        cameras: cameras of the pictures.
        size: width and height of a picture [pixels].
        task: the task, as a text for learners; None for the titles of the scenarios.

    Raises:
        InputError: the flights do not fit together, or a rate, column or camera does not exist; the message states what
            is allowed.
    """
    first, *others = flights
    state = StateReader(first.scenario).names
    period = first.scenario.control_period
    for flight in others:
        where, there = str(flight.recording.path), str(first.recording.path)
        same_names("numbers of the state", StateReader(flight.scenario).names, state, where, there)
        if (other := flight.scenario.control_period) != period:
            raise InputError(
                f"{where}: the control period differs from that of {there}: {other:g} s instead of {period:g} s; "
                "export them into different folders"
            )
    encoding = first.encoding
    used = np.any([flight.inputs.any(axis=0) for flight in flights], axis=0)
    inputs = tuple(name for name, one in zip(encoding.names, used, strict=True) if one or name in STICKS)
    if "camera" in inputs:
        for flight in others:
            where, there = str(flight.recording.path), str(first.recording.path)
            same_names("cameras with a drive", flight.driven, first.driven, where, there)
    if columns is None:
        action = tuple(name for name in inputs if name != SCRIPT.name)
    else:
        encoding.index(columns)
        action = tuple(columns)
    rate, per_sample = _rate(fps, period)
    return Plan(rate, per_sample, action, inputs, state, names_of(cameras), size, task)


def _rate(fps: float | None, period: float) -> tuple[float, int]:
    """Return the samples in a second, and the control steps in a sample.

    Raises:
        InputError: the control rate is not a multiple of `fps`.
    """
    control = round(1.0 / period, 9)
    if fps is None:
        fps = control / math.ceil(control / USUAL_RATE - 1e-9)
    steps = control / fps if fps >= LEAST_RATE else 0.0
    if not math.isclose(steps, round(steps), rel_tol=1e-9) or round(steps) < 1:
        allowed = ", ".join(f"{control / n:g}" for n in range(1, 11))
        raise InputError(
            f"fps: got {fps:g}, expected {control:g}, the control rate, divided by a whole number: {allowed}, …; at "
            f"least {LEAST_RATE:g}"
        )
    return control / round(steps), round(steps)
