"""Frame's part about the bodies behind the joints, on a plant with masses."""

from __future__ import annotations

import numpy as np

from aftdeck.bodies.pose import compose, rows, vec3
from aftdeck.frames import angle_between
from aftdeck.matrices import distance
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.frame import Dynamics, Placed
from aftdeck.simulation.observe.frame_numbers import six
from aftdeck.simulation.state import State


def dynamics_of(flight: Flight, state: State) -> Dynamics | None:
    """Return the true motion of the bodies; None on the kinematic plant."""
    bodies, site, target = state.plant.bodies, flight.site, state.panel.target
    if bodies is None:
        return None
    tip = np.empty(12)
    compose(state.worksite.frames[site.last_joint], site.hand, tip)
    position, orientation = vec3(tip, 0), rows(tip, 3)
    miss = None
    if target is not None:
        miss = distance(target.position, position), angle_between(target.rotation, orientation)
    overdriven = tuple(int(joint) for joint in np.flatnonzero(bodies.overdriven))
    return Dynamics(
        position,
        orientation,
        miss,
        six(bodies.torques, 0),
        overdriven,
        Placed(vec3(bodies.orbiter, 0), rows(bodies.orbiter, 3)),
    )
