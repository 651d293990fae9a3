"""Torques of the joints, bends, and loads inside the arm, on plants with masses."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

from aftdeck.plant.readings import CUTS, Readings
from aftdeck.report.metric import Found, Metric, Value
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.log import joint_label
from aftdeck.tuples import MOST_JOINTS

JOINTS = range(MOST_JOINTS)
"""Numbers of the joints that have metrics, from 0. A run has those of its arm's joints."""
TORQUES = tuple(
    Metric(
        f"peak_torque_joint_{k + 1}",
        f"Peak torque, joint {k + 1}",
        "torque",
        f"Greatest torque of motor or brake about joint {k + 1} at the end of a step.",
    )
    for k in JOINTS
)
AT_LIMIT = tuple(
    Metric(
        f"torque_limit_time_joint_{k + 1}",
        f"At torque limit, joint {k + 1}",
        "seconds",
        f"Time in which the motor of joint {k + 1} was at its greatest torque, or its brake at the holding torque.",
    )
    for k in JOINTS
)
_CUT_TITLES = {"upper_boom": "root of upper boom", "lower_boom": "root of lower boom", "end_effector": "end effector"}
MOMENTS = tuple(
    Metric(
        f"peak_moment_{cut}",
        f"Peak moment, {_CUT_TITLES[cut]}",
        "torque",
        f"Greatest moment inside the arm, {_CUT_TITLES[cut]} (docs/series.md). Needs gauges.",
    )
    for cut in CUTS
)
PARTS = ("base", "upper_boom", "lower_boom")
"""Parts that bend, as `Bend.part` names them."""
BENDS = {
    part: Metric(
        f"peak_bend_{part}",
        f"Peak bend, {part.replace('_', ' ')}",
        "gap",
        f"Greatest displacement of the end of the {part.replace('_', ' ')} by its bending.",
    )
    for part in PARTS[1:]
}
TURNS = {
    part: Metric(
        f"peak_bend_{part}",
        f"Peak bend angle, {part.replace('_', ' ')}",
        "angle",
        f"Greatest rotation of the end of the {part.replace('_', ' ')} by its bending and torsion.",
    )
    for part in PARTS
}
METRICS = (*TORQUES, *AT_LIMIT, *MOMENTS, *BENDS.values(), *TURNS.values())
NEED_GAUGES = frozenset(metric.column for metric in MOMENTS)
"""Columns of the metrics that need gauges."""
_ROUNDED = 1e-3
"""Torque below its limit at which it counts as at the limit [N m]: a recording rounds torques by half of it."""


class _Peak(NamedTuple):
    """Greatest value so far, and when it occurred."""

    value: float
    time_s: float


class Loads:
    """Torques, loads and bends of a run."""

    def __init__(self, scenario: Scenario) -> None:
        servo = scenario.arm.model.servo
        self._joints, self._period_s = scenario.arm.joints, scenario.control_period
        self._limits = ((), ()) if servo is None else (servo.torque_limit.tolist(), servo.holding_torque.tolist())
        self._peaks: dict[Metric, _Peak] = {}
        self._at_limit = [0] * len(self._joints)

    def see(self, frame: Frame, readings: Readings | None) -> None:
        """Add the next frame, and the readings of its step; None without gauges."""
        dynamics, time_s = frame.dynamics, frame.time_s
        if dynamics is None:
            return
        limits = self._limits[frame.brakes]
        for k, torque in enumerate(map(abs, dynamics.torques)):
            self._note(TORQUES[k], torque, time_s)
            self._at_limit[k] += torque >= limits[k] - _ROUNDED
        for bend in dynamics.bends:
            if bend.part in BENDS:
                self._note(BENDS[bend.part], math.hypot(*bend.displacement), time_s)
            self._note(TURNS[bend.part], math.hypot(*bend.rotation), time_s)
        if readings is not None:
            for metric, load in zip(MOMENTS, readings.loads, strict=True):
                self._note(metric, load.peak_moment, time_s)

    def _note(self, metric: Metric, value: float, time_s: float) -> None:
        peak = self._peaks.get(metric)
        if peak is None or value > peak.value:
            self._peaks[metric] = _Peak(value, time_s)

    def found(self) -> Iterator[Found]:
        """Yield the metrics for which there are data."""
        for metric, peak in self._peaks.items():
            joint = f"{joint_label(self._joints[TORQUES.index(metric)])}, " if metric in TORQUES else ""
            yield metric, Value(peak.value, detail=f"{joint}at {peak.time_s:.2f} s")
        if self._peaks:
            for metric, joint, steps in zip(AT_LIMIT, self._joints, self._at_limit, strict=False):
                yield metric, Value(steps * self._period_s, detail=joint_label(joint))
