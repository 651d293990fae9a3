"""Strips of a playback or a live run. For a playback the curves are thinned for drawing, and keep every peak."""

from __future__ import annotations

import math
from array import array
from collections.abc import Callable, Iterable, Sequence
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from aftdeck.kinematics.singular import NAMES
from aftdeck.report.curves import Curve, Strip
from aftdeck.report.metrics.path import worst_rate
from aftdeck.report.quantity import Quantity
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Force, Frame, Holding
from aftdeck.simulation.log import joint_label

BUCKETS = 1000
"""Number of equal parts of a run. A curve keeps the least and the greatest value of each part.

The drawn curve then has about two values for each pixel of the strip's width.
"""

Role = Literal["actual", "commanded"]
Value = Callable[[Frame, float | None], float | None]
"""Function that returns a curve's value from a frame and its recorded latency [ms]."""


class Source(NamedTuple):
    """Definition of a strip, with the functions that read the values of its curves."""

    name: str
    quantity: Quantity
    curves: tuple[tuple[Role, Value], ...]
    limit: float | None = None
    caution: float | None = None
    warning: float | None = None
    shown: bool = False
    rests: bool = True
    """True if zero is the value at rest; the drawn range then includes zero."""


def sources(scenario: Scenario) -> tuple[Source, ...]:
    """Return the definition of every strip that a recording of this scenario can show."""
    return (
        Source(
            "Clearance",
            "gap",
            (("actual", lambda f, _: f.work.nearest.clearance if f.work.nearest else None),),
            caution=scenario.caution,
            warning=scenario.warning,
            shown=True,
        ),
        Source(
            "POR rate",
            "speed",
            (("commanded", lambda f, _: _size(f.twist_demanded[3:])), ("actual", lambda f, _: _size(f.twist[3:]))),
            shown=True,
        ),
        Source(
            "Joint rate",
            "part of limit",
            (
                ("commanded", lambda f, _: worst_rate(f.rates_commanded, f.rate_limits)[0]),
                ("actual", lambda f, _: worst_rate(f.rates, f.rate_limits)[0]),
            ),
            limit=1.0,
            shown=True,
        ),
        Source(
            "POR turn rate",
            "turn rate",
            (("commanded", lambda f, _: _size(f.twist_demanded[:3])), ("actual", lambda f, _: _size(f.twist[:3]))),
        ),
        Source("Remaining distance", "distance", (("actual", lambda f, _: f.goal.distance if f.goal else None),)),
        Source("RATLMT ratio", "ratio", (("actual", lambda f, _: f.ratio),)),
        *(_singularity(i, name) for i, name in enumerate(NAMES)),
        *(_angle(i, label) for i, label in enumerate(scenario.arm.model.labels)),
        Source("THC", "share", (("commanded", lambda f, _: _deflection(f.translation)),)),
        Source("RHC", "share", (("commanded", lambda f, _: _deflection(f.rotation)),)),
        Source("Stick to picture", "milliseconds", (("actual", lambda _, latency: latency),)),
        *_dynamics(scenario),
    )


def _dynamics(scenario: Scenario) -> tuple[Source, ...]:
    """Return the strips of a plant with masses; () on the kinematic plant."""
    servo = scenario.arm.model.servo
    if scenario.plant == "kinematic" or servo is None:
        return ()
    motors, brakes = servo.torque_limit.tolist(), servo.holding_torque.tolist()
    return (
        Source(
            "Joint torque",
            "part of limit",
            (("actual", lambda f, _: _load(f, brakes if f.brakes else motors)),),
            limit=1.0,
            shown=True,
        ),
        Source("Contact force", "force", (("actual", lambda f, _: _greatest(one.peak for one in _touching(f))),)),
        Source("Holding force", "force", (("actual", lambda f, _: _greatest(one.peak for one in _holding(f))),)),
    )


def _load(frame: Frame, limits: Sequence[float]) -> float:
    """Return the greatest torque of a joint, as a part of the limits of motors or brakes."""
    if frame.dynamics is None:
        return 0.0
    return max(abs(torque) / limit for torque, limit in zip(frame.dynamics.torques, limits, strict=True))


def _touching(frame: Frame) -> Sequence[Force]:
    return () if frame.dynamics is None else frame.dynamics.contacts


def _holding(frame: Frame) -> Sequence[Holding]:
    return () if frame.dynamics is None else frame.dynamics.holds


def _greatest(values: Iterable[float]) -> float:
    """Return the greatest of some values that are not negative; 0 for none."""
    return max(values, default=0.0)


def readings(scenario: Scenario) -> Callable[[Frame, float | None], tuple[float | None, ...]]:
    """Return a function that returns the values of all curves, strip by strip, for a frame and its latency [ms]."""
    values = [value for source in sources(scenario) for _, value in source.curves]
    return lambda frame, latency_ms: tuple([value(frame, latency_ms) for value in values])


class Strips:
    """All curves of a run, collected frame by frame."""

    def __init__(self, scenario: Scenario, period_s: float) -> None:
        self._sources = sources(scenario)
        self._curves = sum(len(source.curves) for source in self._sources)
        self._values = array("d")  # of all curves, frame by frame
        self._period_s = period_s

    def add(self, values: Sequence[float | None]) -> None:
        """Add the values of the next frame."""
        self._values.extend([math.nan if value is None else value for value in values])

    def strips(self) -> tuple[Strip, ...]:
        """Return all strips, thinned; a curve without any value has no points."""
        curves = iter(np.asarray(self._values).reshape(-1, self._curves).T)
        return tuple(self._strip(source, [next(curves) for _ in source.curves]) for source in self._sources)

    def _strip(self, source: Source, columns: Sequence[NDArray[np.float64]]) -> Strip:
        curves, ends = [], [0.0] if source.rests else []
        for (role, _), values in zip(source.curves, columns, strict=True):
            if np.isnan(values).all():
                curves.append(Curve(role, (), ()))
                continue
            ends += [float(np.nanmin(values)), float(np.nanmax(values))]
            kept = thin(values)
            times = [round((i + 1) * self._period_s, 9) for i in kept.tolist()]
            shown = [None if math.isnan(value) else value for value in values[kept].tolist()]
            curves.append(Curve(role, tuple(times), tuple(shown)))
        return _strip(source, curves, ends)


def blank(scenario: Scenario) -> tuple[Strip, ...]:
    """Return all strips, with curves that have no points."""
    return tuple(_strip(source, [Curve(role, (), ()) for role, _ in source.curves], ()) for source in sources(scenario))


def _strip(source: Source, curves: Iterable[Curve], ends: Iterable[float]) -> Strip:
    """Return the strip with the given curves. Its range is from the least to the greatest value in `ends`."""
    ends = tuple(ends)
    return Strip(
        source.name,
        source.quantity,
        tuple(curves),
        min(ends, default=0.0),
        max(ends, default=0.0),
        source.limit,
        source.caution,
        source.warning,
        source.shown,
        source.rests,
    )


def thin(values: NDArray[np.float64]) -> NDArray[np.intp]:
    """Return the indices of the values to draw.

    Selected values: the first and the last; the two values next to each edge of a gap (NaN); the least and the greatest
    value of each part (`BUCKETS`). A selected value is omitted if it equals the selected values before and after it.

    Args:
        values: one value for each step, not empty; NaN where there is no value.

    Returns:
        Indices, ascending.
    """
    last = len(values) - 1
    width = -(-len(values) // BUCKETS)
    parts = np.full((-(-len(values) // width), width), math.nan)
    parts.flat[: len(values)] = values
    missing = np.isnan(parts)
    starts = np.arange(len(parts)) * width
    least = starts + np.where(missing, math.inf, parts).argmin(axis=1)
    greatest = starts + np.where(missing, -math.inf, parts).argmax(axis=1)
    breaks = np.flatnonzero(np.diff(np.isnan(values)))  # a gap begins or ends after each of these indices
    kept = np.unique(np.concatenate([[0, last], least, greatest, breaks, breaks + 1]))
    kept = kept[kept <= last]
    shown = np.nan_to_num(values[kept], nan=math.inf)
    level = np.zeros(len(kept), dtype=bool)
    level[1:-1] = (shown[1:-1] == shown[:-2]) & (shown[1:-1] == shown[2:])
    return kept[~level]


def worst_joint(frame: Frame, scenario: Scenario) -> str:
    """Return the display name of the joint nearest to its rate limit; empty if no joint moves."""
    _, joint = worst_rate(frame.rates, frame.rate_limits)
    return joint_label(scenario.arm.joints[joint]) if joint >= 0 else ""


def _singularity(i: int, name: str) -> Source:
    return Source(f"{name.capitalize()} singularity", "ratio", (("actual", lambda f, _: abs(f.singularity[i])),))


def _angle(i: int, label: str) -> Source:
    commanded: tuple[Role, Value] = ("commanded", lambda f, _: f.angles_commanded[i])
    return Source(label, "angle", (commanded, ("actual", lambda f, _: f.angles[i])), rests=False)


def _size(vector: Sequence[float]) -> float:
    return math.hypot(*vector)


def _deflection(stick: Sequence[float]) -> float:
    return max(map(abs, stick))
