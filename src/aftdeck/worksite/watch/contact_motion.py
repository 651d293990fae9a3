"""ARM INHIBIT and FINGER INHIBIT: motions that an inhibited arm or prong may still make, and escape directions.

In the report, an inhibit stops all motion until the collision is relieved. The report does not say how a collision is
relieved. Here each step of an inhibited arm is predicted before the arm makes it. A step *relieves* the contacts if
these conditions hold:

- The step makes no new contact.
- The step deepens no contact, essential or detrimental, by more than `BESIDES` times the clearance that it gains. The
  clearance gained is the increase of the sum of the clearances of all pairs of solids in detrimental contact.
- The clearance gained is at least `RELIEF` times the distance that a touching point of one solid moves along the other.

An arm at depth `d` in one contact therefore slides at most `d / RELIEF` along the other body before it is free. Between
two walls, or at a body of several solids, there may be no step that relieves the contacts. Therefore a step is also
allowed if it deepens no contact by more than `ASIDE` times the distance that the touching points slide, and if its
continuation leads out of the contacts (`leads_out`). The arm then slides at most `d / ESCAPE`. In modes 1 to 7, a
held payload may slide along walls (`worksite.sliding`). The conditions then do not apply to its contacts with walls.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from aftdeck.arrays import Array, Mask
from aftdeck.worksite.watch.clearance_monitor import ClearanceMonitor
from aftdeck.worksite.watch.contact_trial import DEEPEST, GAINED, LESSENED, MADE, SLID, STEP, WORST, trials_of

DEEPER = 1e-12
"""Greatest decrease of a clearance that still counts as no change [m]: the accuracy of clearances."""
BESIDES = 1e-3
"""Greatest decrease of any contact's clearance in a step, as a share of the clearance that the step gains [1]
(assumed).

The motion of a step is curved. If no decrease were allowed, an arm that touches two walls could move away from one of
them, along the other, by only micrometres per step.
"""
RELIEF = 0.5
"""Clearance that a step has to gain for each metre that a touching point slides [1] (assumed).

A straight motion meets this condition if its direction is within 63 degrees of the escape direction. One of three
perpendicular axes always meets this condition: the axis that is within 55 degrees of the escape direction.
"""
LEAST_RELIEF = 1e-9
"""Least clearance that a step has to gain [m]. Rounding errors are smaller than this value. Even the first step from
rest at a hundredth of the vernier rate gains more than this value."""
ESCAPE = 0.25
"""For a motion that leads out of the contacts: least decrease of depth for each metre that a touching point slides [1]
(assumed)."""
ASIDE = 0.05
"""For a step that leads out of the contacts: greatest depth that it may add to a contact, for each metre that a
touching point slides [1]. This depth allows for a contact normal that is wrong by a few degrees."""


def relieves(watch: ClearanceMonitor, counts: Mask, harmful: Mask, after: Array) -> bool:
    """Return whether an inhibited arm may make a step's motion.

    Args:
        watch: the monitor, updated for the present frames.
        counts: (g,) 1 for groups with a part that moves with the arm, except groups that consist of a sliding payload
            and a wall.
        harmful: (g,) 1 for each of these groups whose contact is detrimental.
        after: (F, 12) poses of the frames after the motion, in L; only frames that move with the arm change.
    """
    return bool(_relief(trials_of(watch, counts, harmful, after[None]))[0] > 0.0)


def leads_out(watch: ClearanceMonitor, counts: Mask, harmful: Mask, afters: Array, ahead: Sequence[Array]) -> Array:
    """Return how much each of several motions decreases the penetration if the motion is continued for many steps.

    Args:
        watch: the monitor, updated for the present frames.
        counts: (g,) 1 for groups with a part that moves with the arm, except groups that consist of a sliding payload
            and a wall.
        harmful: (g,) 1 for each of these groups whose contact is detrimental.
        afters: (k, F, 12) poses of the frames after one step of each motion, in L.
        ahead: arrays of the same form as `afters`, each with the poses after a different number of steps.

    Returns:
        (k,) greatest decrease of the sum of all depths among the arrays in `ahead` [m]. An array counts only if its
        decrease is more than `ESCAPE` times the distance that a touching point slides. The result is 0 if no array
        counts. It is also 0 if the first step makes a contact, or deepens a contact by more than `ASIDE` times the
        distance that a touching point slides.
    """
    first = trials_of(watch, counts, harmful, afters)
    may = (first[:, WORST] >= -ASIDE * first[:, SLID] - DEEPER) & (first[:, MADE] == 0.0)
    won = np.zeros(len(afters))
    for frames in ahead:
        then = trials_of(watch, counts, harmful, frames)
        lessened = then[:, LESSENED]
        out = lessened > np.maximum(ESCAPE * then[:, SLID], LEAST_RELIEF)
        won = np.maximum(won, np.where(out, lessened, 0.0))
    return np.where(may, won, 0.0)


def worst_new_contact(watch: ClearanceMonitor, counts: Mask, after: Array) -> int:
    """Return the group with the greatest decrease of clearance among the contacts that a step makes or deepens.

    The result is -1 if there is no such contact.

    The arguments are those of `relieves`.
    """
    worst, which = trials_of(watch, counts, counts, after[None])[0, :GAINED].tolist()
    return int(which) if worst < -DEEPER else -1


def deeper(watch: ClearanceMonitor, counts: Mask, after: Array) -> float:
    """Return the greatest increase of a depth in a step [m]; 0 or less if no depth increases.

    The arguments are those of `relieves`.
    """
    return float(trials_of(watch, counts, counts, after[None])[0, DEEPEST])


def looked_at(watch: ClearanceMonitor, frames: Array) -> ClearanceMonitor:
    """Return a copy of a monitor, with the clearances below `STEP` measured for other poses (F, 12) of the frames."""
    copy = watch.copied()
    copy.look_near(frames, frames, 1.0, np.zeros_like(watch.active), STEP)
    return copy


def ways_out(watch: ClearanceMonitor, counts: Mask, harmful: Mask, afters: Array) -> Array:
    """Return for each of several motions the clearance that one step gains in the present contacts.

    Args:
        watch: the monitor, updated for the present frames.
        counts: (g,) 1 for groups with a part that moves with the arm, except groups that consist of a sliding payload
            and a wall.
        harmful: (g,) 1 for each of these groups whose contact is detrimental.
        afters: (k, F, 12) poses of the frames after one step of each motion, in L.

    Returns:
        (k,) increase of the sum of the clearances of all pairs of solids in detrimental contact [m], if the step
        relieves the contacts; 0 or less if it does not.
    """
    return _relief(trials_of(watch, counts, harmful, afters))


def _relief(trials: Array) -> Array:
    """Return the clearance (k,) that each predicted step gains [m], from the rows of `trials` (k, 7).

    If a step decreases a clearance too much, its value is the greatest decrease (negative). If a step only gains too
    little clearance, its value is 0.
    """
    worst, gained = trials[:, WORST], trials[:, GAINED]
    slides = gained < np.maximum(RELIEF * trials[:, SLID], LEAST_RELIEF)
    besides = np.zeros_like(gained)
    kept = (trials[:, MADE] == 0.0) & np.isfinite(gained)
    besides[kept] = BESIDES * gained[kept]
    return np.where(worst < -np.maximum(DEEPER, besides), worst, np.where(slides, 0.0, gained))
