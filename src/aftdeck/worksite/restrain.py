"""ARM INHIBIT and FINGER INHIBIT: which motions an inhibited arm or prong still makes, and which lead out.

The report's inhibit holds all motion until the collision is relieved, and leaves open how it could be. Here each step
of an inhibited arm is tried before it is made. A step *relieves* where all of this holds:

- no contact is made, and none, an essential one neither, deepens by more than `BESIDES` of what is won;
- the clearances of all solids in a detrimental contact, taken together, rise by at least `RELIEF` times as much as a
  touching point of one moves along the other body.

So an arm that is `d` deep in one contact slides at most `d / RELIEF` along it before it is free. Two walls, or a body
of several solids, may leave no such step. Therefore a step also passes that deepens no contact (by more than `ASIDE`)
and, gone on with, leads out (`leads_out`): the arm then slides at most `d / ESCAPE`. Sliding without relief is for what
the task permits to slide (`worksite.sliding`).
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from aftdeck.arrays import Array, Mask
from aftdeck.worksite.trial import DEEPEST, GAINED, LESSENED, MADE, SLID, STEP, WORST, trials_of
from aftdeck.worksite.watch import Watch

DEEPER = 1e-12
"""By how much a clearance may fall in a step and count as kept [m]: clearances are right to that."""
BESIDES = 1e-3
"""How much of what a step wins another contact may lose by it [1]; assumed. Steps of joints bend: without it, an arm
that leaves one of two walls along the other could do so only at micrometres a step.
"""
RELIEF = 0.5
"""How much clearance a step has to win for each metre that a touching point slides [1]; assumed.

A straight motion within 63 degrees of the way out passes. Of three axes square to each other one always does: it is
within 55 degrees.
"""
LEAST_RELIEF = 1e-9
"""How much clearance a step has to win at least [m]: more than rounding gives, and less than the first step from rest
at a hundredth of vernier."""
ESCAPE = 0.25
"""How much depth a motion that leads out has to win for each metre that a touching point slides [1]; assumed."""
ASIDE = 0.05
"""How much a step that leads out may deepen a contact for each metre that it slides [1]: a normal a few degrees off."""


def relieves(watch: Watch, counts: Mask, harmful: Mask, after: Array) -> bool:
    """Return whether an inhibited arm may make a step's motion.

    Args:
        watch: as it has looked at the present frames.
        counts: (g,) 1 for the groups that move with the arm, but those that slide.
        harmful: (g,) 1 for those of them that are detrimental.
        after: (F, 12) the frames after the motion, in L; what does not move with the arm stands where it is.
    """
    return bool(_relief(trials_of(watch, counts, harmful, after[None]))[0] > 0.0)


def leads_out(watch: Watch, counts: Mask, harmful: Mask, afters: Array, ahead: Sequence[Array]) -> Array:
    """Return how far motions take the parts out of each other when they go on for a while.

    Args:
        watch: as it has looked at the present frames.
        counts: (g,) 1 for the groups that move with the arm, but those that slide.
        harmful: (g,) 1 for those of them that are detrimental.
        afters: (k, F, 12) the frames after a step of each, in L.
        ahead: the same after several numbers of steps.

    Returns:
        (k,) by how much all depths together fall in as many steps as suit it best; 0 where that is less than `ESCAPE`
        of what a touching point slides, and where the first step deepens a contact [m].
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


def worsened(watch: Watch, counts: Mask, after: Array) -> int:
    """Return the contact that a step deepens most, or makes; -1 where it does neither. Arguments as of `relieves`."""
    worst, which = trials_of(watch, counts, counts, after[None])[0, :GAINED].tolist()
    return int(which) if worst < -DEEPER else -1


def deeper(watch: Watch, counts: Mask, after: Array) -> float:
    """Return how much deeper in each other a step takes two parts [m]. Arguments as of `relieves`."""
    return float(trials_of(watch, counts, counts, after[None])[0, DEEPEST])


def looked_at(watch: Watch, frames: Array) -> Watch:
    """Return a copy of a watch that has looked at other frames (F, 12), as far as a step may go."""
    copy = watch.copied()
    copy.look_near(frames, frames, 1.0, np.zeros_like(watch.active), STEP)
    return copy


def ways_out(watch: Watch, counts: Mask, harmful: Mask, afters: Array) -> Array:
    """Return how fast each of several motions leads out of the present contacts.

    Args:
        watch: as it has looked at the present frames.
        counts: (g,) 1 for the groups that move with the arm, but those that slide.
        harmful: (g,) 1 for those of them that are detrimental.
        afters: (k, F, 12) the frames after a step of each, in L.

    Returns:
        (k,) by how much the clearances of all contacts rise together, where the step relieves; else 0 or less [m].
    """
    return _relief(trials_of(watch, counts, harmful, afters))


def _relief(trials: Array) -> Array:
    """(k,) what each trial (k, 7) wins where it relieves; else 0, or by how much the worst contact deepens [m]."""
    worst, gained = trials[:, WORST], trials[:, GAINED]
    slides = gained < np.maximum(RELIEF * trials[:, SLID], LEAST_RELIEF)
    besides = np.zeros_like(gained)
    kept = (trials[:, MADE] == 0.0) & np.isfinite(gained)
    besides[kept] = BESIDES * gained[kept]
    return np.where(worst < -np.maximum(DEEPER, besides), worst, np.where(slides, 0.0, gained))
