"""A payload that nothing holds: where it is in space, which does not move with the orbiter."""

from __future__ import annotations

from math import copysign

import numpy as np

from aftdeck.arrays import Array
from aftdeck.state_part import StatePart, copied
from aftdeck.worksite import model
from aftdeck.worksite.drift import LimitCycle, coast, limit_cycle


class Floating(StatePart):
    """Free flight.

    Attributes:
        pose: (12,) now, in L as it stood at the start.
        motion: (6,) angular velocity in the body's axes [rad/s], then velocity of the centre, in L's [m/s].
        reference: (3, 3) rotation about which it cycles.
        cycle: (9,) attitude control, as `worksite.drift.limit_cycle` takes it; None: it turns freely.
        time: since the cycle began [s].
        met: whether a contact stopped it in the last step.
    """

    pose: Array
    motion: Array
    reference: Array
    cycle: Array | None = None
    time: float = 0.0
    met: bool = False

    def move(self, period: float) -> None:
        """Go on for one control period [s]."""
        coast(self.pose, self.motion, period)
        if self.cycle is not None:
            self.time += period
            limit_cycle(self.cycle, self.reference, self.time, self.pose, self.motion)

    def moved(self, period: float) -> Floating:
        """Return the same flight a time later [s]; this one stays as it is."""
        later = copied(self)
        later.move(period)
        return later


def floating(
    pose: Array, velocity: Array, rates: Array, control: model.LimitCycle | None, angles: Array | None = None
) -> Floating:
    """Free flight from an instant on; attitude control keeps the attitude of that instant.

    Args:
        pose: (12,) then, in L as it stood at the start.
        velocity: (3,) of the centre, in those axes [m/s].
        rates: (3,) angular velocity in the body's axes [rad/s]; their signs are the way in which a cycle sets out.
        control: the body's attitude control; None: it has none.
        angles: (3,) where in its deadband it is then [rad]; None: in the middle.
    """
    reference = pose[3:].reshape(3, 3).copy()
    if control is None:
        return Floating(pose.copy(), np.concatenate((rates, velocity)), reference)
    x, y, z = (copysign(float(rate), float(turn)) for rate, turn in zip(control.rate, rates, strict=True))
    a, b, c = (float(band) for band in control.deadband)
    u, v, w = (0.0, 0.0, 0.0) if angles is None else (float(angle) for angle in angles)
    cycle = LimitCycle((a, b, c), (x, y, z), (u, v, w))
    return Floating(pose.copy(), np.array([x, y, z, *velocity]), reference, cycle.packed())
