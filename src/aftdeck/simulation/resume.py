"""Restoration of a saved state. A saved state has no caches, so their contents are computed again."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from aftdeck.bodies.pose import HERE
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.parts.carried import SteeringSetup
from aftdeck.simulation.parts.checking import Rehearsed
from aftdeck.simulation.parts.standing import Standing
from aftdeck.simulation.payloads.alignment import count
from aftdeck.simulation.payloads.grasp import carried_by
from aftdeck.simulation.state import State, new_state
from aftdeck.state_part import Cache, decoded
from aftdeck.worksite.watch.clearance_monitor import ClearanceMonitor


def resume(flight: Flight, saved: bytes) -> State:
    """Return the state that `saved` contains in encoded form (`state_part.encoded`), with its caches filled again.

    Raises:
        InputError: the bytes are not a state of this run.
    """
    nothing = SteeringSetup(None, {})
    empty: dict[type, Callable[[], Cache]] = {
        SteeringSetup: lambda: nothing,
        Standing: lambda: Standing(flight.scenario.arm),
        Rehearsed: Rehearsed,
        ClearanceMonitor: lambda: ClearanceMonitor(flight.site.layout),
    }
    like = new_state(flight, nothing)
    payloads = len(flight.site.payloads)
    flight.plant.begin(like.plant, 0, np.tile(HERE, (payloads, 1)), np.zeros((payloads, 6)), 0.0)
    state = decoded(like, saved, lambda kind: empty[kind]())
    state.carried = carried_by(flight.scenario, flight.site, state.worksite, state.script)
    restore_clearances(flight, state)
    return state


def restore_clearances(flight: Flight, state: State) -> None:
    """Measure the clearances of the last step again, starting with an empty cache."""
    worksite = state.worksite
    watch, nearest = worksite.watch, np.zeros_like(worksite.monitored_before)
    if worksite.nearest >= 0:
        nearest[worksite.nearest] = 1
    watch.forget()
    watch.active[:] = worksite.monitored_before
    watch.look_near(worksite.frames, nearest, flight.within)
    worksite.select_monitored(flight.site)
    count(flight, state)
