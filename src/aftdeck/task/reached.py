"""Test whether a run has reached the state that a step of the task names."""

from __future__ import annotations

import math
from typing import NamedTuple

from aftdeck.frames import angle_between
from aftdeck.scenario.task_file import StateSpec
from aftdeck.scenario.task_step import TaskStep
from aftdeck.simulation.frame import Frame
from aftdeck.steering.mode import MODES
from aftdeck.task.remaining import Aims
from aftdeck.tuples import Rows, Vec3
from aftdeck.worksite.conditions import Condition, all_ready

REST_M, REST_RAD = 1e-3, 1e-3
"""Speed [m/s] and angular rate [rad/s] below which the tip is at rest."""
ORBITER_REST_M = 0.01
"""Speed below which the orbiter is at rest [m/s]: with masses, its jets never stop it completely."""


class Since(NamedTuple):
    """What has to be remembered from the beginning of a step.

    Attributes:
        position: position of the tip [m].
        orientation: attitude of the tip.
        looked: whether the operator has put another camera on a monitor since then.
    """

    position: Vec3
    orientation: Rows
    looked: bool = False


def reached(aims: Aims, step: TaskStep, wanted: StateSpec, now: Frame, since: Since) -> bool:
    """Return whether all fields that `wanted` gives hold in a frame."""
    return (
        _panel(wanted, now)
        and _work(wanted, now)
        and wanted.looked in (None, since.looked)
        and (wanted.moved is None or math.dist(now.position, since.position) >= wanted.moved)
        and (wanted.turned is None or angle_between(now.orientation, since.orientation) >= wanted.turned)
        and wanted.sticks_released in (None, sticks_released(now))
        and wanted.at_rest in (None, at_rest(now))
        and wanted.orbiter_at_rest in (None, math.hypot(*now.work.orbiter_velocity) <= ORBITER_REST_M)
        and _near(aims, step, wanted, now)
        and _above(aims, step, wanted, now)
    )


def sticks_released(now: Frame) -> bool:
    """Return whether no stick is deflected."""
    return not any(now.translation) and not any(now.rotation) and now.drive == 0.0


def at_rest(now: Frame) -> bool:
    """Return whether no stick is deflected and the tip is at rest."""
    return sticks_released(now) and math.hypot(*now.twist[3:]) <= REST_M and math.hypot(*now.twist[:3]) <= REST_RAD


def _panel(wanted: StateSpec, now: Frame) -> bool:
    return (
        wanted.mode in (None, now.mode)
        and wanted.rate in (None, now.rate)
        and wanted.sequence in (None, now.sequence)
        and wanted.point in (None, now.point)
        and wanted.singular in (None, bool(now.singular))
        and wanted.alarm in (None, now.work.clearance_level == "warning")
    )


def _work(wanted: StateSpec, now: Frame) -> bool:
    hand, payloads = now.work.hand, now.work.cargo
    held = [payload for payload in payloads if payload.held]
    seats = {payload.seat for payload in held or payloads}
    return (
        wanted.held in (None, bool(held))
        and wanted.fixed in (None, any(seats))
        and (wanted.berth is None or wanted.berth in seats)
        and (wanted.flag is None or wanted.flag in hand.flags)
        and wanted.switch in (None, hand.switch)
        and wanted.moves in (None, bool(now.motions))
        and (wanted.ready is None or wanted.ready == all_ready(now.work.conditions))
        and _conditions(wanted, now.work.conditions)
    )


def _conditions(wanted: StateSpec, conditions: tuple[Condition, ...]) -> bool:
    """Return whether each named condition exists and holds within the wanted share of its limit."""
    if not wanted.holds:
        return True
    found = {condition.name: condition for condition in conditions}
    return all(
        (condition := found.get(name)) is not None
        and condition.holds
        and (wanted.share == 1.0 or abs(condition.value) <= wanted.share * abs(condition.limit))
        for name in wanted.holds
    )


def _near(aims: Aims, step: TaskStep, wanted: StateSpec, now: Frame) -> bool:
    if wanted.within is None and wanted.within_angle is None:
        return True
    aimed = step.target is not None or step.joint is not None
    if not aimed and (now.goal is None or MODES[now.mode].kind != "automatic"):
        return False
    if wanted.within is not None and aims.is_beyond(now, step, wanted.within):
        return False
    left = aims.remaining(now, step)
    return (
        left is not None
        and (wanted.within is None or left.distance <= wanted.within)
        and (wanted.within_angle is None or abs(left.angle) <= wanted.within_angle)
    )


def _above(aims: Aims, step: TaskStep, wanted: StateSpec, now: Frame) -> bool:
    if wanted.above is None or step.target is None:
        return wanted.above is None
    above = aims.places.above(now, step.target)
    return above is not None and above >= wanted.above
