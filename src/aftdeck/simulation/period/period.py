"""A control period on the kinematic plant, as far as compiled code can take it."""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array, Indices, Mask
from aftdeck.bodies.pose import POSE
from aftdeck.law import law
from aftdeck.lent import lend
from aftdeck.simulation.period.attach import attached
from aftdeck.simulation.period.contact import judged, seen
from aftdeck.simulation.period.drive import driven
from aftdeck.simulation.period.observe import counted, observed
from aftdeck.simulation.period.steer import steered
from aftdeck.simulation.row.now import Flat, lent, motion_of
from aftdeck.simulation.row.scalars import STAND_VELOCITY

STEERED, DRIVEN, SEEN, JUDGED, ATTACHED, COUNTED = range(6)
"""How far a control period has come: see `advance`."""


@law
def advance(
    fixed_numbers: Array,
    fixed_indices: Indices,
    fixed_marks: Mask,
    numbers: Array,
    indices: Indices,
    marks: Mask,
    rules: Array,
    resting: Array,
    links: Array,
    observes: bool,
) -> int:
    """Make a control step after the operator's commands, until something happens that is not compiled.

    Args:
        fixed_numbers: constants of the run and row of the state (`row.now.Flat`).
        fixed_indices: the same.
        fixed_marks: the same.
        numbers: the same.
        indices: the same.
        marks: the same.
        rules: the steering's rules of the present mode, rate and law.
        resting: rules that replace `rules` while no automatic motion is in progress.
        links: the arm's links with its shoulder at the present height.
        observes: whether to mark the pairs that count for CLEARANCE and to observe the arm; a rehearsal does neither.

    Returns:
        `STEERED`: contacts or walls may limit the commanded motion. `DRIVEN`: the arm has moved, but the orbiter
        translates, or something may touch a floating payload or the prong. `SEEN`: contacts are counted, but a pair of
        the task is in contact. `JUDGED`: something may be captured, fixed or released. `ATTACHED`: a payload may be
        aligned, or the telescope has moved the arm. `COUNTED`: the step is complete.
    """
    flat = lent(fixed_numbers, fixed_indices, fixed_marks, numbers, indices, marks)
    reached = moved(flat, lend(rules), lend(resting))
    if reached < SEEN:
        return reached
    seen(flat, np.empty((0, POSE)))
    reached = settled(flat)
    if reached < ATTACHED or not observes or motion_of(flat).scalars[STAND_VELOCITY] != 0.0 or not counted(flat):
        return reached
    observed(flat, lend(links))
    return COUNTED


@law
def contacts(
    fixed_numbers: Array,
    fixed_indices: Indices,
    fixed_marks: Mask,
    numbers: Array,
    indices: Indices,
    marks: Mask,
    true: Array,
) -> None:
    """Place all frames, measure the clearances and count the contacts, after Python code has moved the bodies.

    The arguments are those of `advance`; `true` is that of `contact.seen`.
    """
    seen(lent(fixed_numbers, fixed_indices, fixed_marks, numbers, indices, marks), lend(true))


@law
def moved(flat: Flat, rules: Array, resting: Array) -> int:
    """Steer and move; return `STEERED` or `DRIVEN` as `advance` does, or `SEEN` if contacts can be counted."""
    if not steered(flat, rules, resting):
        return STEERED
    return SEEN if driven(flat) else DRIVEN


@law
def settled(flat: Flat) -> int:
    """Judge the contacts and what is captured or fixed; return `SEEN`, `JUDGED` or `ATTACHED` as `advance` does."""
    if not judged(flat):
        return SEEN
    return JUDGED if attached(flat) else ATTACHED
