"""Coordinates of an arm in MuJoCo: their names, arrays of their values, and the joints' stops."""

from __future__ import annotations

from typing import Any

import mujoco
import numpy as np
from numpy.typing import ArrayLike

from aftdeck.arms.by_joint import shown
from aftdeck.arms.load import ArmModel
from aftdeck.arrays import Array, Indices, floats_of
from aftdeck.errors import InputError, LimitError
from aftdeck.units import short

ROUNDED = 1e-9
"""Excess of an angle [rad], or of a share of a moment of inertia [1], that comes from rounding."""
SIX = ("x", "y", "z", "rx", "ry", "rz")
"""Displacement, then rotation, along L's axes: coordinates of a free orbiter, and outputs of the tip."""


def coordinates_of(model: Any) -> tuple[str, ...]:
    """Return the names of a model's coordinates, one for each of MuJoCo's velocities."""
    names: list[str] = []
    for number in range(model.njnt):
        joint = model.joint(number)
        free = int(joint.type[0]) == mujoco.mjtJoint.mjJNT_FREE
        names += [f"{joint.name}.{axis}" for axis in SIX] if free else [joint.name]
    return tuple(names)


def finite(values: ArrayLike, what: str) -> Array:
    """Return numbers as an array of float64; raise an InputError if one is not finite."""
    array = floats_of(values, what)
    if not np.isfinite(array).all():
        raise InputError(f"{what}: expected finite numbers, got {short(array.tolist())}")
    return array


def opened(model: ArmModel) -> float:
    """Return the position of the open prong [m]; 0 without a prong."""
    return 0.0 if model.prong is None else model.prong.least


def of_all(values: ArrayLike, motors: Indices, others: Array, what: str) -> Array:
    """Return values of all coordinates (..., n); if as many as there are joints are given, those of their motors.

    Args:
        values: values of all coordinates, or of the motors.
        motors: (j,) places of the motors.
        others: (n,) values of the other coordinates.
        what: description of the values, for the error message.

    Raises:
        InputError: the values are not finite numbers, or of another shape.
    """
    array, number = finite(values, what), len(others)
    if array.ndim and array.shape[-1] == number:
        return array
    if array.ndim == 0 or array.shape[-1] != len(motors):
        allowed = f"(..., {len(motors)})" + (f" or (..., {number})" if number != len(motors) else "")
        raise InputError(f"{what}: expected shape {allowed}, got {array.shape}")
    found = np.broadcast_to(others, (*array.shape[:-1], number)).copy()
    found[..., motors] = array
    return found


def check_stops(model: ArmModel, angles: Array) -> None:
    """Check that joint angles (..., j) [rad] are within the hard stops.

    Raises:
        LimitError: an angle is not.
    """
    low, high = model.limits.hard.T
    beyond = np.argwhere((angles < low - ROUNDED) | (angles > high + ROUNDED))
    if not len(beyond):
        return
    joint, angle = int(beyond[0, -1]), float(angles[tuple(beyond[0])])
    allowed = float(low[joint]), float(high[joint])
    least, got, most = (shown(value, model.slides[joint], ".4g") for value in (allowed[0], angle, allowed[1]))
    raise LimitError(
        f"{model.joints[joint]} at {got} ({angle:.4g} in SI units) is beyond its hard stops, {least} to {most}",
        model.joints[joint],
        angle,
        allowed,
    )
