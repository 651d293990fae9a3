"""A payload that nothing holds: where it is in space, which does not move with the orbiter."""

from __future__ import annotations

from math import copysign

import msgspec
import numpy as np

from aftdeck.arrays import Array
from aftdeck.worksite import model
from aftdeck.worksite.drift import LimitCycle, coast, limit_cycle


class SavedFloating(msgspec.Struct, frozen=True):
    """What `Floating.save` gives."""

    pose: list[float]
    motion: list[float]
    cycle: LimitCycle | None
    reference: list[float]
    time: float
    met: bool


class Floating:
    """Free flight.

    Attributes:
        pose: (12,) now, in L as it stood at the start.
        motion: (6,) angular velocity in the body's axes [rad/s], then velocity of the centre, in L's [m/s].
        cycle: attitude control; None: it turns freely.
        reference: (3, 3) rotation about which it cycles.
        time: since the cycle began [s].
        met: whether a contact stopped it in the last step.
    """

    def __init__(self, pose: Array, motion: Array, cycle: LimitCycle | None) -> None:
        self.pose, self.motion = pose.copy(), motion.copy()
        self.cycle, self.reference, self.time = cycle, pose[3:].reshape(3, 3).copy(), 0.0
        self.met = False
        self._packed = None if cycle is None else cycle.packed()

    def move(self, period: float) -> None:
        """Go on for one control period [s]."""
        coast(self.pose, self.motion, period)
        if self._packed is not None:
            self.time += period
            limit_cycle(self._packed, self.reference, self.time, self.pose, self.motion)

    def moved(self, period: float) -> Floating:
        """Return the same flight a time later [s]; this one stays as it is."""
        later = floating_so(self.save())
        later.move(period)
        return later

    def save(self) -> SavedFloating:
        """Everything that its future depends on."""
        return SavedFloating(
            self.pose.tolist(), self.motion.tolist(), self.cycle, self.reference.ravel().tolist(), self.time, self.met
        )


def floating_so(saved: SavedFloating) -> Floating:
    """What `Floating.save` gave, to go on from."""
    flight = Floating(np.array(saved.pose), np.array(saved.motion), saved.cycle)
    flight.reference.ravel()[:], flight.time, flight.met = saved.reference, saved.time, saved.met
    return flight


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
        return Floating(pose, np.concatenate((rates, velocity)), None)
    x, y, z = (copysign(float(rate), float(turn)) for rate, turn in zip(control.rate, rates, strict=True))
    a, b, c = (float(band) for band in control.deadband)
    u, v, w = (0.0, 0.0, 0.0) if angles is None else (float(angle) for angle in angles)
    return Floating(pose, np.array([x, y, z, *velocity]), LimitCycle((a, b, c), (x, y, z), (u, v, w)))
