"""Where every frame is now, or would be with the arm elsewhere."""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array
from aftdeck.simulation.flight import Flight
from aftdeck.simulation.state import State
from aftdeck.worksite.around import place_everything


def frames_at(flight: Flight, state: State, angles: Array, stand: float, prong: float) -> Array:
    """(F, 12) where every frame would be, in L: joints (6,) [rad], stand and prong [m] as given, the rest as now."""
    frames = np.empty_like(state.site.frames)
    place_everything(*state.site.places(flight.site), angles, stand, prong, frames)
    return frames


def frames_with(flight: Flight, state: State, prong: float) -> Array:
    """(F, 12) where every frame is now, in L, but for the prong, which is there [m]."""
    return frames_at(flight, state, state.plant.angles, state.plant.stand.position, prong)


def frames_after(flight: Flight, state: State, rates: Array, telescope: float) -> Array:
    """(F, 12) where every frame would be after a step of joint rates (6,) and the telescope's drive; others stay."""
    plant, period = state.plant, flight.scenario.control_period
    angles, stand = plant.angles + rates * period, plant.stand.after(flight.telescope, telescope, period)
    return frames_at(flight, state, angles, stand, state.site.prong.position)
