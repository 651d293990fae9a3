"""Motion of the master arm by the sticks, for operators without a device that measures its angles.

Each stick axis moves one joint of the master arm; the sticks do not move the other joints.
"""

from __future__ import annotations

import numpy as np

from aftdeck.arms.joints import StickAxis
from aftdeck.arms.load import ArmModel
from aftdeck.arrays import Array
from aftdeck.steering.layout import HIGH, LOW, MASTER, RATE, STICKS

AXES: tuple[StickAxis, ...] = ("RHC roll", "RHC pitch", "RHC yaw", "THC X", "THC Y", "THC Z")
"""Stick axes, in the order of `steering.layout.STICKS`."""


def axes_of(model: ArmModel) -> tuple[int | None, ...]:
    """Return the index in `AXES` of the stick axis that moves each joint of the master arm; None for no axis."""
    return tuple(None if axis is None else AXES.index(axis) for axis in model.master)


def turn_master(axes: tuple[int | None, ...], rules: Array, command: Array, period: float) -> None:
    """Move the master arm by the sticks in `command`; full deflection moves a joint at its rate limit.

    The sticks do not move the master arm beyond the stops in force. If a device has moved a joint beyond a stop, the
    sticks can only move this joint back.

    Args:
        axes: result of `axes_of` for this arm.
        rules: the steering's rules in force.
        command: input of the steering laws; its angles of the master arm are changed.
        period: control period [s].
    """
    joints = len(axes)
    master = command[MASTER : MASTER + joints]
    sticks = np.array([0.0 if axis is None else command[STICKS + axis] for axis in axes])
    low, high = np.minimum(rules[LOW : LOW + joints], master), np.maximum(rules[HIGH : HIGH + joints], master)
    master[:] = np.clip(master + sticks * rules[RATE : RATE + joints] * period, low, high)
