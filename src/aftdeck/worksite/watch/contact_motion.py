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
continuation leads out of the contacts (`may_lead_out`, `lessens`). The arm then slides at most `d / ESCAPE`. In modes
1 to 7, a held payload may slide along walls (`worksite.sliding`). The conditions then do not apply to its contacts with
walls.
"""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array, Mask
from aftdeck.law import law
from aftdeck.worksite.watch.clearance_monitor import ClearanceMonitor
from aftdeck.worksite.watch.contact_trial import STEP, PredictedContacts, trial_of

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


def worst_new_contact(watch: ClearanceMonitor, counts: Mask, after: Array) -> int:
    """Return the group with the greatest decrease of clearance among the contacts that a step makes or deepens.

    The result is -1 if there is no such contact.

    Args:
        watch: the monitor, updated for the present frames.
        counts: (g,) 1 for groups whose contacts count.
        after: (F, 12) poses of the frames after the motion, in L.
    """
    trial = trial_of(watch, counts, counts, after)
    return trial.which if deepens(trial) else -1


def looked_at(watch: ClearanceMonitor, frames: Array) -> ClearanceMonitor:
    """Return a copy of a monitor, with the clearances below `STEP` measured for other poses (F, 12) of the frames."""
    copy = watch.copied()
    copy.look_near(frames, np.zeros_like(watch.active), STEP)
    return copy


@law
def relief(trial: PredictedContacts) -> float:
    """Return the clearance that a step gains in the present contacts [m]; 0 or less if it does not relieve them.

    It is the increase of the sum of the clearances of all pairs of solids in detrimental contact. If the step decreases
    a clearance too much, the result is the greatest decrease (negative). If it only gains too little, the result is 0.
    """
    besides = DEEPER
    if not trial.made and trial.gained < np.inf:
        besides = max(besides, BESIDES * trial.gained)
    if trial.worst < -besides:
        return trial.worst
    return 0.0 if trial.gained < max(RELIEF * trial.slid, LEAST_RELIEF) else trial.gained


@law
def deepens(trial: PredictedContacts) -> bool:
    """Return whether a step makes or deepens a contact."""
    return trial.worst < -DEEPER


@law
def may_lead_out(trial: PredictedContacts) -> bool:
    """Return whether a step may be the first of a motion that leads out of the contacts.

    It may make no contact, and deepen none by more than `ASIDE` times the distance that a touching point slides.
    """
    return trial.worst >= -ASIDE * trial.slid - DEEPER and not trial.made


@law
def lessens(trial: PredictedContacts) -> float:
    """Return the decrease of the sum of all depths that a continued motion brings [m]; 0 if it slides too far for it.

    Too far: the decrease is at most `ESCAPE` times the distance that a touching point slides.
    """
    return trial.lessened if trial.lessened > max(ESCAPE * trial.slid, LEAST_RELIEF) else 0.0
