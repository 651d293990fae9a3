"""Where everything would be after a step that is not made yet."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from aftdeck.simulation.flight import Flight
from aftdeck.simulation.state import State
from aftdeck.worksite.around import place_everything

Array = NDArray[np.float64]


def frames_after(flight: Flight, state: State, rates: Array, telescope: float) -> Array:
    """(F, 12) where every frame would be after a step of joint rates (6,) and the telescope's drive; others stay."""
    things, plant, period = state.site, state.plant, flight.scenario.control_period
    after = np.empty_like(things.frames)
    height, prong = plant.stand.after(telescope, period), things.prong.position
    place_everything(*things.places(flight.site), plant.angles + rates * period, height, prong, after)
    return after
