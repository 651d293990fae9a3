"""The capture envelope of the Shuttle arm's end effector: poses at which the snares can capture the grapple pin."""

from __future__ import annotations

from math import inf, sqrt

import msgspec
import numpy as np

from aftdeck.arrays import Array
from aftdeck.frames import oriend_elements, oriend_rows
from aftdeck.law import law
from aftdeck.matrices import length
from aftdeck.tuples import Rows, Vec3
from aftdeck.worksite.conditions import Condition, within


class CaptureEnvelope(msgspec.Struct, frozen=True):
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

    @property
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
def inside_envelope(envelope: Array, out: float, y: float, z: float, turned: Rows) -> bool:
    """Return whether all conditions of `in_envelope` hold.

    `out`: position of the fixture along axis 1 [m]; the other arguments are those of `around_axis`.
    """
    return bool(envelope[NEAREST] <= out <= envelope[FARTHEST]) and around_axis(envelope, y, z, turned, 1.0)


def in_envelope(fixture: tuple[Vec3, Rows], envelope: CaptureEnvelope) -> tuple[Condition, ...]:
    """Return the conditions of capture.

    Args:
        fixture: position [m] and rotation of the grapple fixture in the end effector's axes (axis 1 points
            outwards). In the rigid position, the fixture's axes and origin coincide with those of the end effector.
        envelope: the capture envelope.
    """
    (out, y, z), rows = fixture
    roll, pitch, yaw = oriend_rows(rows)
    radial = length((y, z))
    return (
        within("pin off axis", radial, -inf, envelope.radial, "m", _RADIAL_SAYS),
        within("pin depth", out, envelope.nearest, envelope.farthest, "m", _DEPTH_SAYS),
        within("pitch", pitch, -envelope.pitch, envelope.pitch, "rad", ("pitch +{}", "pitch −{}")),
        within("yaw", yaw, -envelope.yaw, envelope.yaw, "rad", ("yaw +{}", "yaw −{}")),
        within("roll", roll, -envelope.roll, envelope.roll, "rad", ("roll +{}", "roll −{}")),
    )


_RADIAL_SAYS = ("pin {} off the end effector's axis", "")
_DEPTH_SAYS = ("pin {} out from its seat", "pin {} past its seat")
