"""Poses of all coordinate frames, for the present joint angles or for other joint angles."""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array
from aftdeck.plant.state import FOLLOWING
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.state import State
from aftdeck.worksite.watch.contact_update import place_everything


def frames_at(flight: Flight, state: State, angles: Array, stand: float, prong: float) -> Array:
    """Return the poses of all frames in L, (F, 12), for joint angles (6,) [rad] and telescope and prong positions [m].

    The orbiter is at its present position. Each payload moves with its present carrier. Links and joints do not bend.
    """
    return _placed(flight, state, angles, stand, prong, FOLLOWING)


def frames_with_prong_at(flight: Flight, state: State, prong: float) -> Array:
    """Return the poses of all frames in L, (F, 12), with the prong at `prong` [m] and everything else unchanged."""
    plant = state.plant
    return _placed(flight, state, plant.angles, plant.stand.position, prong, plant.frames)


def frames_after(flight: Flight, state: State, rates: Array, telescope: float) -> Array:
    """Return the poses of all frames in L, (F, 12), after one step with joint rates (6,) and a telescope drive.

    Frames that do not move with the arm keep their poses.
    """
    plant, period = state.plant, flight.scenario.control_period
    angles, stand = plant.angles + rates * period, plant.stand.after(flight.telescope, telescope, period)
    return frames_at(flight, state, angles, stand, state.worksite.prong.position)


def _placed(flight: Flight, state: State, angles: Array, stand: float, prong: float, true: Array) -> Array:
    """Return the poses of all frames, as `place_everything` computes them."""
    frames = np.empty_like(state.worksite.frames)
    place_everything(*state.worksite.places(flight.site), angles, stand, prong, true, state.plant.base, frames)
    return frames
