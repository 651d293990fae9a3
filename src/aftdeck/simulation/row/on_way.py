"""Clearances of a payload on its straight way into a berth, which the pairs of payload and berth may have there."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.pair import CONTACT
from aftdeck.bodies.pose import HERE
from aftdeck.matrices import product
from aftdeck.worksite.berths.on_way import NEAR
from aftdeck.worksite.watch.clearance_monitor import ClearanceMonitor
from aftdeck.worksite.watch.found import CLEARANCE

if TYPE_CHECKING:
    from aftdeck.simulation.constants.site import Site

STEP = 0.1
"""Distance of the positions on the way into a berth at which clearances are known [m] (assumed)."""
PLACES = int(NEAR / STEP) + 1
"""Number of rows of `least_on_way`."""


@lru_cache(maxsize=8)
def least_on_way(site: Site, k: int, number: int) -> Array:
    """Return the clearances (`PLACES`, g) up to which pairs of payload k and its berth `number` count [m].

    Row i is for a payload between `i * STEP` and the next step before its final position. They are those on the way,
    less the berth's tolerance or the half of them.
    """
    on_way, tolerance = clearances_on_way(site, k, number), site.fits[k][number].berth.distance
    nearest = np.minimum(on_way[:-1], on_way[1:])
    return np.asarray(np.maximum(np.maximum(nearest - tolerance, 0.5 * nearest), CONTACT))


def clearances_on_way(site: Site, k: int, number: int) -> Array:
    """Return the clearances (n, g) of a payload on its way into a berth and of the parts in the berth's frame [m].

    Row i is for a payload with its attitude in the berth, `i * STEP` before its final position. Pairs of other parts
    have the clearance inf.
    """
    fit = site.fits[k][number]
    frames, row = np.tile(HERE, (len(site.layout.frames), 1)), site.payload_rows[k]
    frames[row] = fit.place
    step = STEP * product(fit.place[3:].reshape(3, 3), fit.way_out)
    watch = ClearanceMonitor(site.layout)
    watch.active[:] = site.seated[k, fit.berth.name]
    found = np.empty((math.ceil(NEAR / STEP) + 2, len(watch.active)))
    for i in range(len(found)):
        frames[row, :3] = fit.place[:3] + i * step
        watch.update(frames)
        found[i] = watch.found[:, CLEARANCE]
    return found
