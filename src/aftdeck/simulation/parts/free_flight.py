"""Free flight of a payload that is neither held nor fixed. The payload does not move with the orbiter."""

from __future__ import annotations

from math import copysign

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.pose import POSE, compose
from aftdeck.matrices import product
from aftdeck.simulation.constants.site import Site
from aftdeck.state_part import StatePart, copied
from aftdeck.worksite import payload
from aftdeck.worksite.free_flight import LimitCycle, coast, limit_cycle


class Floating(StatePart):
    """State of a free flight.

    Attributes:
        pose: (12,) present pose, in the frame fixed in space that coincided with L at the start.
        motion: (6,) angular velocity in the body's axes [rad/s], then velocity of the centre in L's axes [m/s].
        reference: (3, 3) orientation in the middle of the deadband of the attitude control.
        cycle: (9,) attitude control, packed for `worksite.free_flight.limit_cycle`; None if the body rotates without
            attitude control.
        time: time since the beginning of the limit cycle [s]; 0 without attitude control.
        met: whether a contact stopped or reflected the body in the last step.
    """

    pose: Array
    motion: Array
    reference: Array
    cycle: Array | None = None
    time: float = 0.0
    met: bool = False

    def move(self, period: float) -> None:
        """Move the body for one control period [s]."""
        coast(self.pose, self.motion, period)
        if self.cycle is not None:
            self.time += period
            limit_cycle(self.cycle, self.reference, self.time, self.pose, self.motion)

    def moved(self, period: float) -> Floating:
        """Return the free flight after a time `period` [s]; this object stays unchanged."""
        later = copied(self)
        later.move(period)
        return later


def at_start(site: Site, k: int) -> Floating:
    """Return the free flight of payload k at its start."""
    start, control, pose = site.payloads[k].start, site.payloads[k].limit_cycle, np.empty(POSE)
    compose(site.scene, site.starts[k], pose)
    velocity = product(site.scene[3:].reshape(3, 3), start.velocity)
    rates, angles = (start.rates, None) if control is None else (control.rate, control.start)
    return floating(pose, velocity, rates, control, angles)


def floating(
    pose: Array, velocity: Array, rates: Array, control: payload.LimitCycle | None, angles: Array | None = None
) -> Floating:
    """Return a free flight at its beginning. Attitude control, if there is any, keeps the attitude of `pose`.

    Args:
        pose: (12,) pose at the beginning, without the rotation by `angles`, in the frame fixed in space that coincided
            with L at the start of the run.
        velocity: (3,) velocity of the centre, in L's axes [m/s].
        rates: (3,) angular velocity in the body's axes [rad/s]. With attitude control, only the signs of `rates` are
            used: they are the initial directions of the limit cycle.
        control: the body's attitude control; None if the body has none.
        angles: (3,) angles within the deadband at the beginning [rad]; None for the middle of the deadband.
    """
    reference = pose[3:].reshape(3, 3).copy()
    if control is None:
        return Floating(pose.copy(), np.concatenate((rates, velocity)), reference)
    x, y, z = (copysign(float(rate), float(turn)) for rate, turn in zip(control.rate, rates, strict=True))
    a, b, c = (float(band) for band in control.deadband)
    u, v, w = (0.0, 0.0, 0.0) if angles is None else (float(angle) for angle in angles)
    cycle = LimitCycle((a, b, c), (x, y, z), (u, v, w))
    return Floating(pose.copy(), np.array([x, y, z, *velocity]), reference, cycle.packed())
