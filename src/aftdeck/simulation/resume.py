"""Restoring a saved state: the contents of its caches are computed again."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.parts.carried import Carried
from aftdeck.simulation.parts.checking import Rehearsed
from aftdeck.simulation.parts.standing import Standing
from aftdeck.simulation.payloads.alignment import count
from aftdeck.simulation.payloads.grasp import steer
from aftdeck.simulation.state import State, new_state
from aftdeck.state_part import Cache, decoded
from aftdeck.worksite.watch.clearance_monitor import Watch


def resume(flight: Flight, saved: bytes) -> State:
    """Return the state decoded from the bytes that `encoded` made, with its caches filled again.

    Raises:
        InputError: the bytes are not a state of this flight.
    """
    nothing = Carried(None, {})
    empty: dict[type, Callable[[], Cache]] = {
        Carried: lambda: nothing,
        Standing: lambda: Standing(flight.scenario.arm),
        Rehearsed: Rehearsed,
        Watch: lambda: Watch(flight.site.layout),
    }
    state = decoded(new_state(flight, nothing), saved, lambda kind: empty[kind]())
    steer(flight, state)
    look_again(flight, state)
    return state


def look_again(flight: Flight, state: State) -> None:
    """Measure the clearances again as the last step did, starting from an empty watch."""
    things = state.site
    watch, nearest = things.watch, np.zeros_like(things.looked)
    if things.nearest >= 0:
        nearest[things.nearest] = 1
    watch.forget()
    watch.active[:] = things.looked
    watch.look_near(things.before, things.frames, flight.scenario.control_period, nearest, flight.within)
    things.choose(flight.site)
    count(flight, state)
