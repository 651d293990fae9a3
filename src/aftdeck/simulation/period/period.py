"""Control periods on the kinematic plant, as far as compiled code can take them."""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.pose import POSE
from aftdeck.law import large_law, law
from aftdeck.lent import lend
from aftdeck.simulation.period.attach import attached
from aftdeck.simulation.period.contact import judged, seen
from aftdeck.simulation.period.drive import driven
from aftdeck.simulation.period.observe import counted, observed
from aftdeck.simulation.period.steer import steered
from aftdeck.simulation.row.now import Arrays, Flat, lent, motion_of, watch_of
from aftdeck.simulation.row.scalars import (
    ARM,
    CHANGED,
    FINGER,
    FREELY,
    GREATEST_SAME,
    HINDERED,
    INHIBITED,
    LEAST_SAME,
    MADE,
    NEAREST,
    NEW_LIMITS,
    STAND_VELOCITY,
    STOPPED,
    TASK,
    TELESCOPE,
)
from aftdeck.worksite.watch.found import CLEARANCE

NOTHING, DRIVEN, MOVED, JUDGED, ATTACHED, COUNTED, OBSERVED, UNCHANGED = range(8)
"""How far a control period has come: see `advance`. `NOTHING`: on a plant with masses, before Python code moves its
bodies. No step ends at `MOVED`."""
FARTHEST = 1e300
"""Minimum clearance if no pair counts [m]."""


@law
def advance(
    arrays: Arrays,
    rules: Array,
    resting: Array,
    links: Array,
    sticks: Array,
    observes: bool,
    most: int,
) -> int:
    """Make control steps after the operator's commands, until something happens that Python has to handle.

    Args:
        arrays: constants of the run and row of the state.
        rules: the steering's rules of the present mode, rate and law.
        resting: rules that replace `rules` while no automatic motion is in progress.
        links: as for `observe.observed`.
        sticks: the same.
        observes: whether to mark the pairs that count for CLEARANCE and to observe the arm; a rehearsal does neither.
        most: greatest number of steps, all with the same commands; `MADE` is the number that were made.

    Returns:
        How far the last step has come. `DRIVEN`: something may touch a floating payload; all else has moved.
        `JUDGED`: something may be captured, fixed or released. `ATTACHED`: the step is complete, except for what
        `observes` asks for. `COUNTED`: the telescope has moved the arm, which has to be observed. `OBSERVED`: the step
        is complete. `UNCHANGED`: it has also changed nothing that the log or the panel shows.
    """
    return periods(lent(arrays), lend(rules), lend(resting), lend(links), lend(sticks), observes, most)


@large_law
def periods(flat: Flat, rules: Array, resting: Array, links: Array, sticks: Array, observes: bool, most: int) -> int:
    """Make control steps; the arguments and the result are those of `advance`."""
    v, found, reached = motion_of(flat).scalars, watch_of(flat).found, UNCHANGED
    telescope, task, made = v[TELESCOPE], v[TASK], 0
    while made < most and reached == UNCHANGED:
        v[TELESCOPE] = telescope
        reached = complete(flat, rules, resting, links, sticks, observes)
        made += 1
        if reached == OBSERVED and not shows(v, found, task):
            reached = UNCHANGED
    v[MADE] = made
    return reached


@law
def complete(flat: Flat, rules: Array, resting: Array, links: Array, sticks: Array, observes: bool) -> int:
    """Make a control step, as far as compiled code can; the arguments and the result are those of `advance`."""
    reached = moved(flat, rules, resting)
    if reached < MOVED:
        return reached
    seen(flat, np.empty((0, POSE)))
    reached = settled(flat, False)
    if reached < ATTACHED or not observes:
        return reached
    return noticed(flat, links, sticks)


@law
def followed(arrays: Arrays, true: Array, pressed: bool, links: Array, sticks: Array, observes: bool) -> int:
    """Complete a control step after Python code has moved bodies, as far as compiled code can.

    Args:
        arrays: constants of the run and row of the state.
        true: (f, 12) poses of the arm's frames in L; (0, 12) if they follow from the joint angles.
        pressed: as for `judged`.
        links: as for `observe.observed`.
        sticks: the same.
        observes: as for `advance`.

    Returns:
        How far the step has come, from `JUDGED` to `OBSERVED`.
    """
    flat = lent(arrays)
    seen(flat, lend(true))
    reached = settled(flat, pressed)
    return noticed(flat, lend(links), lend(sticks)) if reached == ATTACHED and observes else reached


@law
def noticed(flat: Flat, links: Array, sticks: Array) -> int:
    """Mark the pairs that count for CLEARANCE, and observe the arm; return `ATTACHED`, `COUNTED` or `OBSERVED`."""
    if not counted(flat):
        return ATTACHED
    if motion_of(flat).scalars[STAND_VELOCITY] != 0.0:
        return COUNTED
    observed(flat, links, sticks)
    return OBSERVED


@law
def shows(v: Array, found: Array, task: float) -> bool:
    """Return whether a complete step has changed something that the log or the panel shows.

    Args:
        v: the row's scalars.
        found: `Watch.found`.
        task: the report's mode before the step.
    """
    if v[CHANGED] != 0.0 or v[ARM] != v[INHIBITED] or v[FINGER] != v[STOPPED] or v[HINDERED] != FREELY:
        return True
    if v[ARM] != 0.0 or v[FINGER] != 0.0 or v[NEW_LIMITS] != 0.0 or v[TASK] != task:
        return True
    clearance = found[int(v[NEAREST]), CLEARANCE] if v[NEAREST] >= 0.0 else FARTHEST
    return bool(clearance < v[LEAST_SAME] or clearance >= v[GREATEST_SAME])


@law
def moved(flat: Flat, rules: Array, resting: Array) -> int:
    """Steer and move; return `DRIVEN` as `advance` does, or `MOVED` if contacts can be counted."""
    steered(flat, rules, resting)
    return MOVED if driven(flat) else DRIVEN


@law
def settled(flat: Flat, pressed: bool) -> int:
    """Judge the contacts and what is captured or fixed; return `JUDGED` or `ATTACHED` as `advance` does."""
    judged(flat, pressed)
    return JUDGED if attached(flat) else ATTACHED
