"""The capture envelope of the Shuttle arm's end effector: poses at which the snares can capture the grapple pin."""

from __future__ import annotations

from functools import cached_property
from math import inf, sqrt

import msgspec
import numpy as np

from aftdeck.arrays import Array
from aftdeck.frames import oriend_elements
from aftdeck.law import law
from aftdeck.tuples import Rows, Vec3
from aftdeck.worksite.conditions import Condition, within
from aftdeck.worksite.within import Within


class CaptureEnvelope(msgspec.Struct, frozen=True, dict=True):
    """Range of poses of the grapple fixture, in the end effector's axes, in which the snares can capture its pin."""

    radial: float
    """Greatest distance from the end effector's axis [m]; SSV has 4 in [S]."""
    nearest: float
    """Least position of the fixture along the axis [m]: 0 in the rigid position, positive outwards."""
    farthest: float
    """Greatest position of the fixture along the axis [m], with the same zero as `nearest`; the cylinder of allowed
    positions is about 4 in deep [R]."""
    pitch: float
    """Greatest rotation about axis 2, in either direction [rad]. SSV has 10 deg for all three axes [S]; other sources
    have 15 deg for pitch and yaw [R]."""
    yaw: float
    """Greatest rotation about axis 3, in either direction [rad]."""
    roll: float
    """Greatest rotation about axis 1, in either direction [rad]."""

    @cached_property
    def packed(self) -> Array:
        """The values as an array (6,), in this order."""
        return np.array([self.radial, self.nearest, self.farthest, self.pitch, self.yaw, self.roll])


RADIAL, NEAREST, FARTHEST, PITCH, YAW, ROLL = range(6)
"""Indices in `CaptureEnvelope.packed`."""


@law
def around_axis(envelope: Array, y: float, z: float, turned: Rows, wide: float) -> bool:
    """Return whether a fixture is within the envelope's radius and angles, each multiplied by `wide`.

    Args:
        envelope: (6,) `CaptureEnvelope.packed`.
        y: position of the fixture along axis 2 of the end effector [m].
        z: its position along axis 3 [m].
        turned: its rotation in the end effector's axes.
        wide: factor on the limits [1].
    """
    if sqrt(y * y + z * z) > wide * envelope[RADIAL]:
        return False
    (a, b, _), (d, e, _), (g, h, i) = turned
    roll, pitch, yaw = oriend_elements(a, b, d, e, g, h, i)
    return bool(
        abs(roll) <= wide * envelope[ROLL] and abs(pitch) <= wide * envelope[PITCH] and abs(yaw) <= wide * envelope[YAW]
    )


@law
def envelope_values(
    envelope: Array, out: float, y: float, z: float, turned: Rows
) -> tuple[Within, Within, Within, Within, Within]:
    """Return the values of the conditions with their ranges: distance from the axis, depth [m], pitch, yaw, roll [rad].

    `out`: position of the fixture along axis 1 [m]; the other arguments are those of `around_axis`.
    """
    (a, b, _), (d, e, _), (g, h, i) = turned
    roll, pitch, yaw = oriend_elements(a, b, d, e, g, h, i)
    return (
        (sqrt(y * y + z * z), -inf, envelope[RADIAL]),
        (out, envelope[NEAREST], envelope[FARTHEST]),
        (pitch, -envelope[PITCH], envelope[PITCH]),
        (yaw, -envelope[YAW], envelope[YAW]),
        (roll, -envelope[ROLL], envelope[ROLL]),
    )


def in_envelope(fixture: tuple[Vec3, Rows], envelope: Array) -> tuple[Condition, ...]:
    """Return the conditions of capture.

    Args:
        fixture: position [m] and rotation of the grapple fixture in the end effector's axes (axis 1 points
            outwards). In the rigid position, the fixture's axes and origin coincide with those of the end effector.
        envelope: (6,) `CaptureEnvelope.packed`.
    """
    (out, y, z), rows = fixture
    radial, depth, *angles = envelope_values(envelope, out, y, z, rows)
    return (
        within("pin off axis", *radial, "m", _RADIAL_SAYS),
        within("pin depth", *depth, "m", _DEPTH_SAYS),
        *(within(name, *angle, "rad", says) for (name, says), angle in zip(_ANGLES, angles, strict=True)),
    )


_RADIAL_SAYS = ("pin {} off the end effector's axis", "")
_DEPTH_SAYS = ("pin {} out from its seat", "pin {} past its seat")
_ANGLES = tuple((name, (f"{name} +{{}}", f"{name} −{{}}")) for name in ("pitch", "yaw", "roll"))
"""Names of the angles, with their texts."""
