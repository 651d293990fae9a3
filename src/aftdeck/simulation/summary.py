"""How a run ended, in the fields that scripts rely on."""

from __future__ import annotations

import math
from typing import Literal

import msgspec

from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Event, Frame, Six, Vec3
from aftdeck.version import __version__

Ended = Literal["completed", "time", "fault"]


class TipState(msgspec.Struct, frozen=True):
    """Where the tip is, in L."""

    position_m: Vec3
    rotation: tuple[Vec3, Vec3, Vec3]


class SummaryEvent(msgspec.Struct, frozen=True):
    """A line of the log in a summary."""

    time_s: float
    kind: str
    text: str


class Summary(msgspec.Struct, frozen=True):
    """How a run ended; `aftdeck run --json` prints it. Poses are in L, frame 7."""

    scenario: str
    seed: int
    version: str
    ended: Ended
    time_s: float
    phase: str
    joints_rad: Six
    tip: TipState
    target: TipState | None
    position_error_m: float | None
    rotation_error_rad: float | None
    worst_rate_ratio: float
    """Largest |commanded joint rate| / limit in force."""
    min_clearance_m: float | None
    """Least clearance of all watched pairs that are not made to touch, negative where they overlapped; None: no pair
    was watched."""
    events: tuple[SummaryEvent, ...]
    frames_sha256: str


def summarise(
    scenario: Scenario,
    seed: int,
    ended: Ended,
    frame: Frame,
    worst: float,
    least: float,
    events: tuple[Event, ...],
    digest: str,
) -> Summary:
    """The summary of a run.

    Args:
        scenario: what was flown.
        seed: with which seed.
        ended: how it ended.
        frame: the last one.
        worst: largest |commanded joint rate| / limit in force.
        least: least clearance of all frames [m]; inf: no pair was watched.
        events: all of them.
        digest: SHA-256 of all frames.
    """
    goal = frame.goal
    return Summary(
        scenario=scenario.name,
        seed=seed,
        version=__version__,
        ended=ended,
        time_s=frame.time_s,
        phase=frame.phase,
        joints_rad=frame.angles,
        tip=TipState(frame.position, frame.orientation),
        target=None if goal is None else TipState(goal.position, goal.rotation),
        position_error_m=None if goal is None else goal.distance,
        rotation_error_rad=None if goal is None else goal.angle,
        worst_rate_ratio=worst,
        min_clearance_m=least if math.isfinite(least) else None,
        events=tuple(SummaryEvent(e.time_s, e.kind, e.text) for e in events),
        frames_sha256=digest,
    )
