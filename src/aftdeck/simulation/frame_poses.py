"""Poses of all coordinate frames, for the present joint angles or for other joint angles."""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array
from aftdeck.plant.state import FOLLOWING, PlantState
from aftdeck.simulation.constants.site import Site
from aftdeck.simulation.parts.worksite_state import WorksiteState
from aftdeck.worksite.watch.places import place_everything


def frames_at(
    site: Site, worksite: WorksiteState, plant: PlantState, angles: Array, stand: float, prong: float
) -> Array:
    """Return the poses of all frames in L, (F, 12), for joint angles (n,) [rad] and telescope and prong positions [m].

    The orbiter is at its present position. Each payload moves with its present carrier. Links and joints do not bend.
    """
    return _placed(site, worksite, plant.base, angles, stand, prong, FOLLOWING)


def frames_with_prong_at(site: Site, worksite: WorksiteState, plant: PlantState, prong: float) -> Array:
    """Return the poses of all frames in L, (F, 12), with the prong at `prong` [m] and everything else unchanged."""
    return _placed(site, worksite, plant.base, plant.angles, plant.stand.position, prong, plant.frames)


def _placed(
    site: Site, worksite: WorksiteState, base: Array, angles: Array, stand: float, prong: float, true: Array
) -> Array:
    """Return the poses of all frames, as `place_everything` computes them."""
    frames = np.empty_like(worksite.frames)
    place_everything(*worksite.places(site), angles, stand, prong, true, base, frames)
    return frames
