"""Effect that a motion of the arm would have on the contacts, predicted before the arm makes it."""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array, Mask
from aftdeck.bodies.pose import POSE
from aftdeck.law import large_law
from aftdeck.simulation.period.actuator import after
from aftdeck.simulation.period.contact import place
from aftdeck.simulation.row.now import Flat, monitor_of, motion_of, watch_of
from aftdeck.simulation.row.scalars import PERIOD, PRONG_AT, STAND, TELESCOPE_HIGH, TELESCOPE_LOW, TELESCOPE_RATE
from aftdeck.simulation.row.world import pairs_of, world_of
from aftdeck.worksite.watch.clearance_monitor import measure_groups
from aftdeck.worksite.watch.contact_trial import STEP, PredictedContacts, predict_contacts
from aftdeck.worksite.watch.measured import Measured, apart


@large_law
def predicted(flat: Flat, counts: Mask, harmful: Mask, rates: Array, drive: float, steps: float) -> PredictedContacts:
    """Return the effect of a motion on the contacts; the state does not change.

    Args:
        flat: constants of the run and row of the state, with measured clearances.
        counts: (g,) 1 for pairs whose contacts count, if they are monitored.
        harmful: (g,) 1 for each of these pairs whose contact the motion has to relieve.
        rates: (n,) rates of the joints [rad/s].
        drive: drive of the telescope, in [-1, 1].
        steps: number of control steps for which the motion lasts; it may be a fraction.
    """
    world, now, watch = world_of(flat), motion_of(flat), watch_of(flat)
    c = world.constants
    angles, frames = np.empty(len(now.angles)), np.empty((len(now.frames), POSE))
    for i in range(len(angles)):
        angles[i] = now.angles[i] + steps * rates[i] * c[PERIOD]
    low, high = c[TELESCOPE_LOW], c[TELESCOPE_HIGH]
    stand = after(now.scalars[STAND], steps * drive, low, high, c[TELESCOPE_RATE], c[PERIOD])
    place(flat, angles, stand, now.scalars[PRONG_AT], np.empty((0, POSE)), frames)
    monitored = np.empty(len(counts), np.uint8)
    for g in range(len(counts)):
        monitored[g] = counts[g] & watch.active[g]
    return predict_contacts(pairs_of(flat), apart(monitor_of(watch)), monitored, harmful, frames)


@large_law
def looked_at(flat: Flat, frames: Array) -> Measured:
    """Return the arrays of the monitor with the clearances below `STEP` measured for other poses (F, 12) of the frames.

    The row's own measurements do not change.
    """
    watch = watch_of(flat)
    here = apart(monitor_of(watch))
    own = Measured(
        here.at, here.placed, here.bound.copy(), here.moved, here.moved_then.copy(), here.beyond.copy(),
        here.pair_bound, here.memory, here.found.copy(), here.likely, here.moves, here.placed_after,
        here.listed.copy(), here.near.copy(), here.reviewed.copy(),
    )  # fmt: skip
    nothing = np.zeros(len(watch.active), np.uint8)
    measure_groups(pairs_of(flat), own, watch.active, nothing, frames, STEP)
    return own
