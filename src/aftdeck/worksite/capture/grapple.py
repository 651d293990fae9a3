"""The capture envelope of the Shuttle arm's end effector: poses at which the snares can capture the grapple pin."""

from __future__ import annotations

from math import inf

import msgspec

from aftdeck.frames import oriend_rows
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
