"""Summary of a run. Users' programs depend on its fields."""

from __future__ import annotations

import math
from hashlib import sha256
from typing import Literal

import msgspec

from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Event, Frame
from aftdeck.simulation.state import State
from aftdeck.steering.limiters import rate_ratio
from aftdeck.tuples import Joints, Vec3
from aftdeck.worksite.watch.found import CLEARANCE

Ended = Literal["completed", "time", "fault"]


class TipState(msgspec.Struct, frozen=True):
    """Pose of the tip, in L."""

    position_m: Vec3
    rotation: tuple[Vec3, Vec3, Vec3]


class SummaryEvent(msgspec.Struct, frozen=True):
    """Log line in a summary."""

    time_s: float
    kind: str
    text: str


class Summary(msgspec.Struct, frozen=True):
    """Summary of a run, as printed by `aftdeck run --json`. Its poses are poses of frame 7, in L."""

    scenario: str
    seed: int
    version: str
    ended: Ended
    time_s: float
    phase: str
    joints_rad: Joints
    tip: TipState
    target: TipState | None
    position_error_m: float | None
    rotation_error_rad: float | None
    worst_rate_ratio: float
    """Largest ratio of a commanded joint rate (magnitude) to its limit in force."""
    min_clearance_m: float | None
    """Minimum clearance in the run. Only pairs that count for CLEARANCE are included (`payloads.alignment`).

    Negative if a pair overlapped; None if no such pair was monitored.
    """
    events: tuple[SummaryEvent, ...]
    frames_sha256: str
    """SHA-256 over the state digests of all frames, in their order; empty in a run without digests."""
    true_position_error_m: float | None = None
    """Distance of the true tip from the target, with masses; the other error is by the encoders."""
    true_rotation_error_rad: float | None = None
    """Angle of the true tip from the target, with masses."""


class Tally:
    """Accumulator of the values in a summary that depend on all steps of a run.

    Attributes:
        ticks: number of steps added.
        events: log lines of all these steps.
        worst: largest ratio of a commanded joint rate (magnitude) to its limit in force.
        least: minimum clearance of the pairs that count for CLEARANCE [m]; inf if no such pair was monitored.
    """

    def __init__(self) -> None:
        self.ticks = 0
        self.events: list[Event] = []
        self.worst, self.least = 0.0, math.inf
        self._digest = sha256()

    def take(self, state: State, seal: bytes) -> None:
        """Add the state after a step, and its digest; the digest is empty in a run without digests."""
        self.ticks += 1
        self.events += state.events
        rules = state.rules
        self.worst = max(self.worst, rate_ratio(rules, state.steering))
        worksite = state.worksite
        if worksite.nearest >= 0:
            self.least = min(self.least, float(worksite.watch.found[worksite.nearest, CLEARANCE]))
        self._digest.update(seal)

    def summary(self, scenario: Scenario, seed: int, ended: Ended, frame: Frame) -> Summary:
        """Return the summary of a run that ended for the reason `ended`, with `frame` as its last frame."""
        from aftdeck.version import __version__  # noqa: PLC0415  (takes as long to find as ten runs' summaries)

        goal = frame.goal
        miss = None if frame.dynamics is None else frame.dynamics.miss
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
            worst_rate_ratio=self.worst,
            min_clearance_m=self.least if math.isfinite(self.least) else None,
            events=tuple(SummaryEvent(e.time_s, e.kind, e.text) for e in self.events),
            frames_sha256=self._digest.hexdigest() if frame.sha256 else "",
            true_position_error_m=None if miss is None else miss[0],
            true_rotation_error_rad=None if miss is None else miss[1],
        )
