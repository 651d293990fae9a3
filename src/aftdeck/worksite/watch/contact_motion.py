"""ARM INHIBIT and FINGER INHIBIT: motions that an inhibited arm or prong may still make, and escape directions.

The report's inhibit stops all motion until the collision is relieved, but does not say how it can be relieved. Here
each step of an inhibited arm is predicted before the arm makes it. A step *relieves* if both of these conditions hold:

- No contact is made, and no contact, not even an essential one, deepens by more than `BESIDES` of the clearance gained.
- The sum of the clearances of all solids in a detrimental contact rises by at least `RELIEF` times the distance that a
  touching point of one solid moves along the other body.

An arm at depth `d` in one contact therefore slides at most `d / RELIEF` along it before it is free. Two walls, or a
body of several solids, may leave no such step. Therefore a step is also allowed if it deepens no contact (by more than
`ASIDE` of its sliding) and leads out when it is continued (`leads_out`). The arm then slides at most `d / ESCAPE`.
Only payloads that the task permits to slide may slide without relief (`worksite.sliding`).
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from aftdeck.arrays import Array, Mask
from aftdeck.worksite.watch.clearance_monitor import ClearanceMonitor
from aftdeck.worksite.watch.contact_trial import DEEPEST, GAINED, LESSENED, MADE, SLID, STEP, WORST, trials_of

DEEPER = 1e-12
"""Fall of a clearance in a step that counts as no change [m]: the accuracy of clearances."""
BESIDES = 1e-3
"""Share of the clearance gained by a step that another contact may lose [1]; assumed.

A step of the joints is curved. Without this share, an arm could leave one of two walls along the other only at
micrometres a step.
"""
RELIEF = 0.5
"""Clearance that a step has to gain for each metre that a touching point slides [1]; assumed.

A straight motion within 63 degrees of the escape direction passes. One of three perpendicular axes always passes: it is
within 55 degrees.
"""
LEAST_RELIEF = 1e-9
"""Least clearance that a step has to gain [m]: more than rounding gives, and less than the first step from rest at a
hundredth of vernier."""
ESCAPE = 0.25
"""Decrease of depth that a motion that leads out needs for each metre that a touching point slides [1]; assumed."""
ASIDE = 0.05
"""Depth that a step that leads out may add to a contact for each metre of sliding [1]: a normal a few degrees off."""


def relieves(watch: ClearanceMonitor, counts: Mask, harmful: Mask, after: Array) -> bool:
    """Return whether an inhibited arm may make a step's motion.

    Args:
        watch: the monitor, updated for the present frames.
        counts: (g,) 1 for the groups that move with the arm, except those that slide.
        harmful: (g,) 1 for the groups among them that are detrimental.
        after: (F, 12) the frames after the motion, in L; frames that do not move with the arm are unchanged.
    """
    return bool(_relief(trials_of(watch, counts, harmful, after[None]))[0] > 0.0)


def leads_out(watch: ClearanceMonitor, counts: Mask, harmful: Mask, afters: Array, ahead: Sequence[Array]) -> Array:
    """Return by how much each of several motions, continued for many steps, decreases the penetration of the parts.

    Args:
        watch: the monitor, updated for the present frames.
        counts: (g,) 1 for the groups that move with the arm, except those that slide.
        harmful: (g,) 1 for the groups among them that are detrimental.
        afters: (k, F, 12) the frames after one step of each motion, in L.
        ahead: arrays like `afters`, each after another number of steps.

    Returns:
        (k,) greatest fall of the sum of all depths over these numbers of steps [m]. A number of steps does not count if
        that fall is not above `ESCAPE` times the slide of a touching point. The result is 0 if no number counts, or if
        the first step makes a contact, or deepens one by more than `ASIDE` times its slide.
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
    """Return the group of the contact that a step deepens most or makes; -1 if none. Arguments as of `relieves`."""
    worst, which = trials_of(watch, counts, counts, after[None])[0, :GAINED].tolist()
    return int(which) if worst < -DEEPER else -1


def deeper(watch: ClearanceMonitor, counts: Mask, after: Array) -> float:
    """Return the greatest increase of a depth in a step [m]; 0 or less if there is none. Arguments as of `relieves`."""
    return float(trials_of(watch, counts, counts, after[None])[0, DEEPEST])


def looked_at(watch: ClearanceMonitor, frames: Array) -> ClearanceMonitor:
    """Return a copy of a monitor, updated for other frames (F, 12) and measured to the range of one step, `STEP`."""
    copy = watch.copied()
    copy.look_near(frames, frames, 1.0, np.zeros_like(watch.active), STEP)
    return copy


def ways_out(watch: ClearanceMonitor, counts: Mask, harmful: Mask, afters: Array) -> Array:
    """Return how much clearance a step of each of several motions gains in the present contacts.

    Args:
        watch: the monitor, updated for the present frames.
        counts: (g,) 1 for the groups that move with the arm, except those that slide.
        harmful: (g,) 1 for the groups among them that are detrimental.
        afters: (k, F, 12) the frames after one step of each motion, in L.

    Returns:
        (k,) rise of the sum of the clearances of all detrimental contacts, if the step relieves; else 0 or less [m].
    """
    return _relief(trials_of(watch, counts, harmful, afters))


def _relief(trials: Array) -> Array:
    """Return the clearance that each trial (k, 7) gains if it relieves; else 0 or the worst (negative) change [m]."""
    worst, gained = trials[:, WORST], trials[:, GAINED]
    slides = gained < np.maximum(RELIEF * trials[:, SLID], LEAST_RELIEF)
    besides = np.zeros_like(gained)
    kept = (trials[:, MADE] == 0.0) & np.isfinite(gained)
    besides[kept] = BESIDES * gained[kept]
    return np.where(worst < -np.maximum(DEEPER, besides), worst, np.where(slides, 0.0, gained))
