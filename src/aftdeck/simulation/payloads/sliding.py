"""Sliding along walls: the commanded joint rates are replaced by rates that keep a held payload out of the walls.

Source: Remote Manipulator Simulation, final report, section VII.4.
"""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.frame_poses import frames_after
from aftdeck.simulation.state import State
from aftdeck.steering.layout import RATES
from aftdeck.worksite.sliding.projection import LEAST, OUTWARD
from aftdeck.worksite.sliding.touches import touches
from aftdeck.worksite.sliding.walls import met, slid
from aftdeck.worksite.watch.contact_motion import deeper

OUT = 0.01
"""Speed at which a payload that overlaps a wall is moved out of it [m/s] (assumed)."""
INTO = 1e-7
"""Greatest allowed increase of a payload's penetration depth in a wall in one step [m].

A greater increase shows that `touches` has missed a contact.
"""


def slide_along(flight: Flight, state: State, telescope: float, held: int) -> float | None:
    """Change the commanded rates so that the held payload does not move into the walls that it may slide along.

    Args:
        flight: constants of the run.
        state: state with the step's commanded rates, which are changed.
        telescope: commanded drive of the telescope, in [-1, 1].
        held: index of the payload in the grasp.

    Returns:
        Allowed drive of the telescope, in [-1, 1]; the telescope stops at a wall. None if no rates are found that keep
        the payload out of the walls, so that the arm must stop.
    """
    site, worksite, period = flight.site, state.worksite, flight.scenario.control_period
    counts, travel, joints = site.slides[held], flight.telescope, len(state.plant.angles)
    watch = worksite.watch
    near = met(watch.found, watch.near, counts, state.steering, abs(telescope) * travel.rate, period)
    if near == 0.0:
        return telescope
    found = touches(worksite.watch, counts, site.payloads[held].name, near, period, OUT)
    telescope *= _telescope_fraction(found, -telescope * travel.rate)
    height = state.plant.stand.after(travel, telescope, period)
    rules = state.rules
    commanded, last = state.steering.copy(), worksite.frames[site.last_joint]
    for turning in (1.0, 0.0):
        state.steering[:] = commanded
        slid(rules, site.arm.joints, last, height, turning, found, state.steering)
        after = frames_after(flight, worksite, state.plant, state.steering[RATES : RATES + joints], telescope)
        if deeper(worksite.watch, counts, after) <= INTO:
            return telescope
    return None


def _telescope_fraction(found: Array, speed: float) -> float:
    """Return the fraction, 0 to 1, of the speed along axis 3 [m/s] at which no contact in `found` (k, 7) deepens."""
    into, allowed = -speed * found[:, OUTWARD + 2], np.maximum(-found[:, LEAST], 0.0)
    too_fast = into > allowed
    return float((allowed[too_fast] / into[too_fast]).min(initial=1.0))
