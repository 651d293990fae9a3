"""The capture envelope of the Shuttle arm's end effector: where a grapple fixture's pin can be taken by the snares."""

from __future__ import annotations

from math import hypot, inf

import msgspec

from aftdeck.frames import Pose, oriend
from aftdeck.worksite.conditions import Condition, Units, within


class CaptureEnvelope(msgspec.Struct, frozen=True):
    """Where the grapple fixture may stand, in the end effector's axes, for the snares to take its pin."""

    radial: float
    """From the end effector's axis [m]; SSV has 4 in [S]."""
    nearest: float
    """Along the axis, outwards, from where it stands when rigid [m]."""
    farthest: float
    """The same; the cylinder is about 4 in deep [R]."""
    pitch: float
    """About axis 2, to either side [rad]; SSV has 10 deg for all three [S], others 15 deg for pitch and yaw [R]."""
    yaw: float
    """About axis 3 [rad]."""
    roll: float
    """About axis 1 [rad]."""


def in_envelope(fixture: Pose, envelope: CaptureEnvelope, units: Units) -> tuple[Condition, ...]:
    """The conditions of capture.

    Args:
        fixture: pose of the grapple fixture in the end effector's axes (1 outwards), whose own axes are the end
            effector's when it is rigid, its origin theirs.
        envelope: where it may stand.
        units: the operator's.
    """
    out, y, z = fixture.position.tolist()
    roll, pitch, yaw = oriend(fixture.rotation)
    radial = hypot(y, z)
    return (
        within("pin off axis", radial, -inf, envelope.radial, "m", units, _RADIAL_SAYS),
        within("pin depth", out, envelope.nearest, envelope.farthest, "m", units, _DEPTH_SAYS),
        within("pitch", pitch, -envelope.pitch, envelope.pitch, "rad", units, ("pitch +{}", "pitch −{}")),
        within("yaw", yaw, -envelope.yaw, envelope.yaw, "rad", units, ("yaw +{}", "yaw −{}")),
        within("roll", roll, -envelope.roll, envelope.roll, "rad", units, ("roll +{}", "roll −{}")),
    )


_RADIAL_SAYS = ("pin {} off the end effector's axis", "")
_DEPTH_SAYS = ("pin {} out from its seat", "pin {} past its seat")
