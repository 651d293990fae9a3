"""Translation of the orbiter in a control period on the kinematic plant."""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.pose import POSE
from aftdeck.law import large_law, law
from aftdeck.simulation.period.contact import place
from aftdeck.simulation.period.predict import looked_at
from aftdeck.simulation.row.now import Flat, motion_of, watch_of
from aftdeck.simulation.row.scalars import (
    COMMAND_X,
    FREELY,
    HINDERED,
    INHIBITS,
    LOGGED,
    ORBITER_REACHED_IN,
    ORBITER_SPEED,
    ORBITS,
    PERIOD,
    PRONG_AT,
    REJECTED,
    STAND,
)
from aftdeck.simulation.row.world import pairs_of, world_of
from aftdeck.worksite.free_flight import translate
from aftdeck.worksite.watch.contact_motion import deepens
from aftdeck.worksite.watch.contact_trial import predict_contacts
from aftdeck.worksite.watch.contacts import FRAMES


@large_law
def translated(flat: Flat) -> None:
    """Translate the orbiter by one step, and write into the scalars what hinders it.

    The orbiter stops at once if the translation is not possible, or if it would deepen a detrimental contact.
    """
    now, c = motion_of(flat), world_of(flat).constants
    v, velocity = now.scalars, now.orbiter_velocity
    command = v[COMMAND_X : COMMAND_X + 3]
    v[HINDERED] = FREELY
    moves = False
    for i in range(3):
        moves = moves or command[i] != 0.0 or velocity[i] != 0.0
    if not moves:
        return
    if v[ORBITS] == 0.0:
        v[HINDERED] = REJECTED
        velocity[:] = 0.0
        return
    before, without = now.orbiter.copy(), np.empty((0, POSE))
    tested = c[INHIBITS] != 0.0 and v[LOGGED] != 0.0 and _touches(flat)
    if tested:
        without = _frames(flat)
    translate(now.orbiter, velocity, command, c[ORBITER_SPEED], c[ORBITER_REACHED_IN], c[PERIOD])
    if not tested:
        return
    group = _deepened(flat, without)
    if group >= 0:
        v[HINDERED] = group
        now.orbiter[:] = before
        velocity[:] = 0.0


@law
def _touches(flat: Flat) -> bool:
    """Return whether a detrimental contact has lasted for two steps."""
    watch, found = watch_of(flat), False
    for g in range(len(watch.essential)):
        found = found or (watch.essential[g] == 0 and watch.frames_touching[g] == FRAMES)
    return found


@law
def _frames(flat: Flat) -> Array:
    """Return the poses of all frames (F, 12), with the orbiter at its present position."""
    now = motion_of(flat)
    frames = np.empty((len(now.frames), POSE))
    place(flat, now.angles, now.scalars[STAND], now.scalars[PRONG_AT], np.empty((0, POSE)), frames)
    return frames


@law
def _deepened(flat: Flat, without: Array) -> int:
    """Return the detrimental contact that a translation makes or deepens most; -1 if there is none.

    `without` (F, 12) are the poses of all frames without the translation.
    """
    watch = watch_of(flat)
    counts, nothing = np.zeros(len(watch.essential), np.uint8), np.zeros(len(watch.essential), np.uint8)
    for g in range(len(counts)):
        if watch.essential[g] == 0:
            counts[g] = watch.active[g]
    trial = predict_contacts(pairs_of(flat), looked_at(flat, without), counts, nothing, _frames(flat))
    return trial.which if deepens(trial) else -1
