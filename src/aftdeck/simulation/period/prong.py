"""Motion of the prong in a control period, as far as the held payload's bar and contacts allow it."""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.pose import POSE
from aftdeck.law import large_law, law
from aftdeck.lent import lend
from aftdeck.simulation.period.actuator import after
from aftdeck.simulation.period.contact import place
from aftdeck.simulation.period.predict import looked_at
from aftdeck.simulation.row.now import Arrays, Flat, lent, monitor_of, motion_of, watch_of
from aftdeck.simulation.row.scalars import (
    CLOSES,
    HELD,
    PERIOD,
    PRONG_AT,
    PRONG_HIGH,
    PRONG_LOW,
    PRONG_RATE,
    PRONG_VELOCITY,
    STAND,
    STOPPED,
)
from aftdeck.simulation.row.world import pairs_of, world_of
from aftdeck.worksite.capture.acquisition import MEASURED, PRONG, acquire
from aftdeck.worksite.watch.contact_motion import relief
from aftdeck.worksite.watch.contact_trial import predict_contacts
from aftdeck.worksite.watch.measured import place_solids


@law
def close_or_open(arrays: Arrays, true: Array) -> None:
    """Move the prong after Python code has moved the bodies, as `prong_moved` does."""
    prong_moved(lent(arrays), lend(true))


@large_law
def prong_moved(flat: Flat, true: Array) -> None:
    """Close or open the prong. Under FINGER INHIBIT, only motion that relieves the prong's contacts is allowed.

    `true` as for `contact.seen`.
    """
    v, c = motion_of(flat).scalars, world_of(flat).constants
    before, drive = v[PRONG_AT], v[CLOSES]
    if drive > 0.0:
        drive *= _closing_fraction(flat, _reached(v, c, drive) - before)
    if drive != 0.0 and v[STOPPED] != 0.0 and not _relieves(flat, true, _reached(v, c, drive)):
        drive = 0.0
    if drive != 0.0 or v[PRONG_VELOCITY] != 0.0:
        v[PRONG_AT] = _reached(v, c, drive)
        v[PRONG_VELOCITY] = (v[PRONG_AT] - before) / c[PERIOD]


@law
def _reached(v: Array, c: Array, drive: float) -> float:
    """Return the position of the prong after a control period [m]."""
    return after(v[PRONG_AT], drive, c[PRONG_LOW], c[PRONG_HIGH], c[PRONG_RATE], c[PERIOD])


@law
def _closing_fraction(flat: Flat, distance: float) -> float:
    """Return the share of `distance` [m] that the prong moves until it touches the held payload's bar; at most 1."""
    world, held = world_of(flat), int(motion_of(flat).scalars[HELD])
    if held < 0 or len(world.bars) == 0 or world.bars[held, 0] < 0:
        return 1.0
    found = np.empty(MEASURED)
    own = monitor_of(watch_of(flat))
    place_solids(pairs_of(flat), own, world.bars[held])
    acquire(own.placed, world.bars[held], world.tolerances, found)
    clearance = max(found[PRONG], 0.0)
    return 1.0 if distance <= clearance else clearance / distance


@law
def _relieves(flat: Flat, true: Array, reached: float) -> bool:
    """Return whether the motion of the prong to a position [m] relieves its contacts."""
    world, now, watch = world_of(flat), motion_of(flat), watch_of(flat)
    v, groups = now.scalars, len(world.by_prong)
    before, then = np.empty((len(now.frames), POSE)), np.empty((len(now.frames), POSE))
    place(flat, now.angles, v[STAND], v[PRONG_AT], true, before)
    place(flat, now.angles, v[STAND], reached, true, then)
    counts, harmful = np.empty(groups, np.uint8), np.zeros(groups, np.uint8)
    for g in range(groups):
        counts[g] = world.by_prong[g] & watch.active[g]
        if watch.essential[g] == 0:
            harmful[g] = world.by_prong[g]
    return relief(predict_contacts(pairs_of(flat), looked_at(flat, before), counts, harmful, then)) > 0.0
