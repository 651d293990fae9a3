"""Sliding along walls in flight: the commanded rates give way to those that keep a payload along its walls.

Remote Manipulator Simulation, final report, section VII.4.
"""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array
from aftdeck.simulation.ahead import frames_after
from aftdeck.simulation.flight import Flight
from aftdeck.simulation.state import State
from aftdeck.steering.layout import RATES
from aftdeck.worksite.restrain import deeper
from aftdeck.worksite.slide import LEAST, OUTWARD
from aftdeck.worksite.sliding import met, slid
from aftdeck.worksite.touches import touches

OUT = 0.01
"""Speed at which what stands inside a wall is brought out of it [m/s] (assumed)."""
INTO = 1e-7
"""How much deeper a step may take it into a wall [m]: more is a contact that is not among the touches."""


def slide_along(flight: Flight, state: State, telescope: float, held: int) -> float | None:
    """Keep what is held off the walls that it may slide along.

    Args:
        flight: what never changes.
        state: with the step's commanded rates, which are changed.
        telescope: how the stand is driven, in [-1, 1].
        held: the cargo in the grasp.

    Returns:
        How the stand is driven: it stops at a wall. None where only standing still keeps the cargo out.
    """
    site, things, period = flight.site, state.site, flight.scenario.control_period
    counts, travel = site.slides[held], flight.telescope
    near = met(things.watch.found, counts, state.steering, abs(telescope) * travel.rate, period)
    if near == 0.0:
        return telescope
    found = touches(things.watch, counts, site.cargo[held].name, near, period, OUT)
    telescope *= _room(found, -telescope * travel.rate)
    height = state.plant.stand.after(travel, telescope, period)
    rules = state.rules
    commanded, last = state.steering.copy(), things.frames[site.last_joint]
    for turning in (1.0, 0.0):
        state.steering[:] = commanded
        slid(rules, site.arm.joints, last, height, turning, found, state.steering)
        after = frames_after(flight, state, state.steering[RATES : RATES + 6], telescope)
        if deeper(things.watch, counts, after) <= INTO:
            return telescope
    return None


def _room(found: Array, speed: float) -> float:
    """The share of the stand's speed along axis 3 [m/s] that takes no touch (k, 7) into its wall."""
    into, gap = -speed * found[:, OUTWARD + 2], np.maximum(-found[:, LEAST], 0.0)
    held_up = into > gap
    return float((gap[held_up] / into[held_up]).min(initial=1.0))
