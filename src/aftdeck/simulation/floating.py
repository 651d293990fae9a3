"""A payload that nothing holds: where it is in space, which does not move with the orbiter."""

from __future__ import annotations

from math import copysign

import msgspec
import numpy as np
from numpy.typing import NDArray

from aftdeck.worksite import model
from aftdeck.worksite.drift import LimitCycle, coast, limit_cycle

Array = NDArray[np.float64]


class Floating(msgspec.Struct):
    """Free flight.

    Attributes:
        pose: (12,) now, in L as it stood at the start.
        velocity: of the centre, in those axes [m/s].
        rates: angular velocity in the body's axes [rad/s].
        cycle: attitude control; None: it turns freely.
        reference: rotation about which it cycles, row by row.
        time: since the cycle began [s].
    """

    pose: list[float]
    velocity: list[float]
    rates: list[float]
    cycle: LimitCycle | None = None
    reference: list[float] = msgspec.field(default_factory=list)
    time: float = 0.0

    def move(self, period: float) -> None:
        """Go on for one control period [s]."""
        pose, motion = np.array(self.pose), np.array([*self.rates, *self.velocity])
        coast(pose, motion, period)
        if self.cycle is not None:
            self.time += period
            limit_cycle(self.cycle.packed(), np.array(self.reference).reshape(3, 3), self.time, pose, motion)
        self.pose, self.rates = pose.tolist(), motion[:3].tolist()


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
    if control is None:
        return Floating(pose.tolist(), velocity.tolist(), rates.tolist())
    x, y, z = (copysign(float(rate), float(turn)) for rate, turn in zip(control.rate, rates, strict=True))
    a, b, c = (float(band) for band in control.deadband)
    u, v, w = (0.0, 0.0, 0.0) if angles is None else (float(angle) for angle in angles)
    cycle = LimitCycle((a, b, c), (x, y, z), (u, v, w))
    return Floating(pose.tolist(), velocity.tolist(), [x, y, z], cycle, pose[3:].tolist())
