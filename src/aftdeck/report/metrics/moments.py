"""Captures, dockings, latchings and releases: misalignment and speed at each; of several, the last counts."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

from aftdeck.frames import angle_between
from aftdeck.report.metric import Found, Metric, Value
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.readings.source import PONTILLO
from aftdeck.worksite.conditions import Condition

_BEFORE = "in the step before the last"


class Kind(NamedTuple):
    """Metrics of one kind of moment, and the conditions that tell its misalignment.

    Attributes:
        distances: end of the names of the conditions that measure the distance off centre.
        number: number of such moments in the run.
        offset: distance off centre.
        angle: greatest angle.
        speed: closing speed.
    """

    distances: tuple[str, ...]
    number: Metric
    offset: Metric
    angle: Metric
    speed: Metric


def _kind(name: str, plural: str, title: str, ends: tuple[str, ...], what: str, off: str, speed: str) -> Kind:
    return Kind(
        ends,
        Metric(plural, plural.capitalize(), "count", f"Number of times that a payload was {what}."),
        Metric(f"{name}_offset", f"{title} misalignment", "gap", f"{off}, {_BEFORE} {name}.", PONTILLO),
        Metric(f"{name}_angle", f"{title} angle", "angle", f"Greatest angle off, {_BEFORE} {name}.", PONTILLO),
        Metric(f"{name}_speed", f"Rate at {name}", "speed", f"{speed}, {_BEFORE} {name}."),
    )


CAPTURE = _kind(
    "capture",
    "captures",
    "Capture",
    ("pin off axis", "palm along bar"),
    "captured",
    "Distance of the end effector from the grapple pin, or from the middle of the bar",
    "Speed of the tip relative to the payload's centre",
)
DOCK = _kind(
    "dock",
    "dockings",
    "Dock",
    ("probe at port",),
    "docked",
    "Distance of the probe from the port's centre",
    "Speed of the payload relative to the berth's body",
)
LATCH = _kind(
    "latch",
    "latchings",
    "Latch",
    ("latch ready", "payload stowed"),
    "fixed to a berth by latches",
    "Greatest distance of a trunnion, or of the payload, from its seat",
    "Speed of the payload relative to the berth's body",
)
RELEASES = Metric("releases", "Releases", "count", "Number of times that a payload was left floating free.")
TIP_OFF = Metric(
    "tip_off_rate",
    "Tip-off rate",
    "turn rate",
    "Angular rate of the payload relative to the orbiter, in the step after the last release.",
)
DRIFT = Metric(
    "tip_off_speed",
    "Tip-off speed",
    "speed",
    "Speed of the payload's centre relative to the orbiter, in the step after the last release.",
)
_KINDS = (CAPTURE, DOCK, LATCH)
METRICS = (
    *(metric for kind in _KINDS for metric in (kind.number, kind.offset, kind.angle, kind.speed)),
    RELEASES,
    TIP_OFF,
    DRIFT,
)


class Misalignment(NamedTuple):
    """Misalignment and speed at a moment; None for what no condition measures."""

    offset: float | None
    angle: float | None
    speed: float


class Moments:
    """Captures, dockings, latchings and releases of a run."""

    def __init__(self, scenario: Scenario) -> None:
        self._period_s = scenario.control_period
        self._ports = {berth.name for berth in scenario.worksite.berths if berth.docks}
        self._seen: dict[Kind, tuple[int, Misalignment]] = {}
        self._releases = 0
        self._freely: tuple[float, float] | None = None  # angular rate and speed after the last release
        self._freed: int | None = None  # number of the payload that was released in the last step

    def see(self, frame: Frame, before: Frame | None) -> None:
        """Add the next frame."""
        if before is None:
            return
        payloads = frame.work.cargo
        if self._freed is not None:
            old, new = before.work.cargo[self._freed], payloads[self._freed]
            rate = angle_between(old.orientation, new.orientation) / self._period_s
            self._freely, self._freed = (rate, math.hypot(*new.velocity)), None
        for number, (old, new) in enumerate(zip(before.work.cargo, payloads, strict=True)):
            if new.held and not old.held:
                self._note(CAPTURE, before, math.dist(before.twist[3:], old.velocity))
            if new.seat and not old.seat:
                self._note(DOCK if new.seat in self._ports else LATCH, before, math.hypot(*old.velocity))
            if old.held and not new.held and not new.seat:
                self._releases += 1
                self._freed, self._freely = number, None

    def _note(self, kind: Kind, before: Frame, speed: float) -> None:
        count, _ = self._seen.get(kind, (0, None))
        self._seen[kind] = count + 1, misalignment(kind, before.work.conditions, speed)

    def found(self) -> Iterator[Found]:
        """Yield the metrics of the kinds that occurred."""
        for kind in _KINDS:
            count, last = self._seen.get(kind, (0, None))
            yield kind.number, Value(float(count))
            if last is None:
                continue
            for metric, value in zip((kind.offset, kind.angle, kind.speed), last, strict=True):
                if value is not None:
                    yield metric, Value(value)
        yield RELEASES, Value(float(self._releases))
        if self._freely is not None:
            for metric, value in zip((TIP_OFF, DRIFT), self._freely, strict=True):
                yield metric, Value(value)


def misalignment(kind: Kind, conditions: tuple[Condition, ...], speed: float) -> Misalignment:
    """Return the misalignment that the conditions of a moment measure.

    Args:
        kind: kind of the moment.
        conditions: conditions in the step before it.
        speed: closing speed in that step [m/s].
    """
    return Misalignment(
        max((abs(c.value) for c in conditions if c.unit == "m" and c.name.endswith(kind.distances)), default=None),
        max((abs(c.value) for c in conditions if c.unit == "rad"), default=None),
        speed,
    )
