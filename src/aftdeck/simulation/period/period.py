"""A control period on the kinematic plant, as far as compiled code can take it."""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array, Indices, Mask
from aftdeck.bodies.pose import POSE
from aftdeck.law import law
from aftdeck.lent import lend
from aftdeck.simulation.period.attach import attached
from aftdeck.simulation.period.contact import judged, seen
from aftdeck.simulation.period.drive import drifted, driven, free
from aftdeck.simulation.period.observe import counted, observed
from aftdeck.simulation.period.steer import steered
from aftdeck.simulation.row.now import Motion, Watch
from aftdeck.simulation.row.opened import opened
from aftdeck.simulation.row.scalars import BERTHS, STAND_VELOCITY
from aftdeck.simulation.row.world import World

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
        fixed_numbers: constants of the run (`row.world.Packed`).
        fixed_indices: the same.
        fixed_marks: the same.
        numbers: the state's row (`row.row.Row`).
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
    world, pairs, now, watch = opened(fixed_numbers, fixed_indices, fixed_marks, numbers, indices, marks)
    reached = moved(world, now, watch, lend(rules), lend(resting))
    if reached < SEEN:
        return reached
    seen(world, pairs, now, watch, np.empty((0, POSE)))
    reached = settled(world, now, watch)
    if reached < ATTACHED or not observes or now.scalars[STAND_VELOCITY] != 0.0 or not counted(world, now, watch):
        return reached
    observed(world, now, lend(links))
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
    world, pairs, now, watch = opened(fixed_numbers, fixed_indices, fixed_marks, numbers, indices, marks)
    seen(world, pairs, now, watch, lend(true))


@law
def moved(world: World, now: Motion, watch: Watch, rules: Array, resting: Array) -> int:
    """Steer and move; return `STEERED` or `DRIVEN` as `advance` does, or `SEEN` if contacts can be counted."""
    if not steered(world, now, watch, rules, resting):
        return STEERED
    driven(world, now)
    if not free(world, now, watch):
        return DRIVEN
    drifted(world, now, watch)
    return SEEN


@law
def settled(world: World, now: Motion, watch: Watch) -> int:
    """Judge the contacts and what is captured or fixed; return `SEEN`, `JUDGED` or `ATTACHED` as `advance` does."""
    if not judged(world, now, watch):
        return SEEN
    attached(world, now, watch)
    return JUDGED if now.scalars[BERTHS] != 0.0 else ATTACHED
