"""The master arm turned by the sticks, where no device gives its six angles: each axis turns one of its joints."""

from __future__ import annotations

import numpy as np

from aftdeck.arms.equipment import Axis
from aftdeck.arms.load import ArmModel
from aftdeck.simulation.flight import Flight
from aftdeck.simulation.state import State
from aftdeck.steering.layout import HIGH, LOW, MASTER, RATE, STICKS

AXES: tuple[Axis, ...] = ("RHC roll", "RHC pitch", "RHC yaw", "THC X", "THC Y", "THC Z")
"""In the order of `steering.layout.STICKS`."""


def axes_of(model: ArmModel) -> tuple[int, ...]:
    """For each joint, which of `AXES` turns the master's."""
    return tuple(AXES.index(axis) for axis in model.equipment.master)


def turn_master(flight: Flight, state: State) -> None:
    """Turn the master by the sticks in `state.command`: at full deflection at the limit of its joint's rate.

    It stays within the stops in force, or comes back to them from where a device has put it.
    """
    command, rules = state.command, state.rules
    axes, master = axes_of(flight.scenario.arm.model), command[MASTER : MASTER + 6]
    sticks = command[[STICKS + axis for axis in axes]]
    low, high = np.minimum(rules[LOW : LOW + 6], master), np.maximum(rules[HIGH : HIGH + 6], master)
    master[:] = np.clip(master + sticks * rules[RATE : RATE + 6] * flight.scenario.control_period, low, high)
