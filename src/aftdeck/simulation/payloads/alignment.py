"""Pairs that count for CLEARANCE: all monitored pairs, except pairs that are in essential contact or about to be.

Without this exception, every capture, docking and berthing would raise an alarm. If the end effector is aligned with a
payload, the pairs of these two do not count. The same holds for a probe that is aligned with a port, and for trunnions
that are aligned with their guides. A probe or trunnions are aligned if a straight motion over the remaining distance
would bring them into a permitted contact (`payloads.relations`). The held payload and the parts in the frame of
a berth that it is about to enter or has just left do not count either, as long as they are not nearer to each other
than they are on the straight way into the berth.
Excepted pairs are still monitored for contacts, and a pair whose contact inhibits the arm counts.
"""

from __future__ import annotations

import math
from math import inf
from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array, Indices, Mask
from aftdeck.bodies.pair import CONTACT, PAIR
from aftdeck.law import law
from aftdeck.lent import lend
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.payloads.aligned import aligned_payload, is_aligned
from aftdeck.simulation.payloads.relations import berth_near
from aftdeck.simulation.row.aligning import Aligning, aligning_of
from aftdeck.simulation.row.constants import learn_way
from aftdeck.simulation.row.now import Arrays, lent
from aftdeck.simulation.row.on_way import PLACES, STEP
from aftdeck.simulation.row.world import World, pairs_of, world_of
from aftdeck.simulation.state import State
from aftdeck.worksite.berths.on_way import NEAR, on_way
from aftdeck.worksite.watch.clearance_monitor import ClearanceMonitor
from aftdeck.worksite.watch.contacts import FRAMES
from aftdeck.worksite.watch.found import CLEARANCE
from aftdeck.worksite.watch.groups import PackedLayout
from aftdeck.worksite.watch.measured import (
    Measured,
    MeasuredArrays,
    lower_bound,
    measure_group,
    measured_of,
    place_bars,
)

ASIDE = 0.3
"""Greatest distance of a payload from the line on which it enters a berth, up to which it is about to enter [m]
(assumed)."""
TILTED = math.radians(5.0)
"""Greatest angle between a payload and its attitude in a berth, up to which it is about to enter [rad] (assumed)."""
INNER = 0.8
"""Factor on `ASIDE` and `TILTED` [1] (assumed) while a pair of payload and berth has the minimum clearance; without it,
the lamp could flicker."""

UNDECIDED = 2
"""Mark of a pair that counts unless its parts are aligned."""
UNKNOWN = -2
"""Result of `mark` for the first berth; for each further berth one less."""


def count(flight: Flight, state: State) -> None:
    """Update the pairs that count for the minimum clearance of the next step, after all motion of this step."""
    worksite = state.worksite
    worksite.watch.counts[:], worksite.aligned_with = alarm_pairs(
        flight, state, worksite.watch, worksite.frames, worksite.permitted, flight.within
    )


def alarm_pairs(
    flight: Flight, state: State, watch: ClearanceMonitor, frames: Array, permitted: Mask, travel: float = inf
) -> tuple[Mask, int | None]:
    """Return the pairs that count for the minimum clearance, and the payload with which the end effector is aligned.

    Args:
        flight: constants of the run.
        state: state of the run. If a contact of its end effector with a payload inhibits the arm, the pairs of these
            two are not excepted.
        watch: clearances that were measured at `frames`.
        frames: (F, 12) poses of all frames in L.
        permitted: (g,) result of `relations.permitted`: 1 for pairs of the task, except those in a contact that the
            task does not permit.
        travel: greatest distance by which two parts can approach before the next minimum is found [m].

    Returns:
        A mask (g,), 1 for the pairs that count for CLEARANCE; and the payload with which the end effector is aligned,
        or None.
    """
    worksite, counts = state.worksite, np.empty_like(permitted)
    contacts, before, aligned = worksite.contacts, worksite.aligned_with, UNKNOWN
    while aligned <= UNKNOWN:
        aligned = _marked(
            state.row.arrays(flight.packed),
            watch.packed,
            watch.active,
            frames,
            permitted,
            contacts.count,
            contacts.essential,
            contacts.arm,
            -1 if worksite.held is None else worksite.held,
            -1 if before is None else before,
            worksite.nearest,
            contacts.inhibit.arm,
            travel,
            counts,
        )
        if aligned <= UNKNOWN:
            learn_way(flight, UNKNOWN - aligned)
    return counts, None if aligned < 0 else aligned


@law
def _marked(
    arrays: Arrays,
    measured: MeasuredArrays,
    active: Mask,
    frames: Array,
    permitted: Mask,
    frames_touching: Mask,
    essential: Mask,
    arm: Mask,
    held: int,
    before: int,
    nearest: int,
    inhibited: bool,
    travel: float,
    counts: Mask,
) -> int:
    """Mark the pairs that count, as `mark` does."""
    flat = lent(arrays)
    own = measured_of(measured)
    task = Contacting(lend(permitted), lend(frames_touching), lend(essential), lend(arm), inhibited)
    return mark(
        world_of(flat), aligning_of(flat), pairs_of(flat), own, lend(active), lend(frames), task, held, before, nearest,
        travel, lend(counts),
    )  # fmt: skip


class Contacting(NamedTuple):
    """Contacts of the last step, each (g,).

    Attributes:
        permitted: as for `alarm_pairs`.
        frames_touching: `Contacts.count`.
        essential: `Contacts.essential`.
        arm: `Contacts.arm`.
        inhibited: whether a contact inhibits the arm.
    """

    permitted: Mask
    frames_touching: Mask
    essential: Mask
    arm: Mask
    inhibited: bool


@law
def mark(
    world: World,
    aligning: Aligning,
    pairs: PackedLayout,
    own: Measured,
    active: Mask,
    frames: Array,
    task: Contacting,
    held: int,
    before: int,
    nearest: int,
    travel: float,
    counts: Mask,
) -> int:
    """Mark the pairs that count for the minimum clearance.

    Args:
        world: constants of the run.
        aligning: constants of alignment.
        pairs: solids and monitored pairs.
        own: clearances that were measured at `frames`.
        active: (g,) 1 for pairs that are monitored.
        frames: (F, 12) poses of all frames in L.
        task: contacts of the last step.
        held: the payload in the grasp; -1 if the grasp is empty.
        before: the payload with which the end effector was aligned before this step; -1 for none.
        nearest: the pair with the minimum clearance before this step; -1 if there was none.
        travel: greatest distance by which two parts can approach before the next minimum is found [m].
        counts: (g,) output: 1 for the pairs that count.

    Returns:
        The payload with which the end effector is aligned for capture; -1 for none; `UNKNOWN` - b if the clearances on
        the way into berth b are not known yet (`row.constants.learn_way`), and the marks are not complete.
    """
    counts[:] = world.detrimental
    if held >= 0:
        berth = _except_berth(world, aligning, pairs, own, active, frames, held, nearest, counts)
        if berth >= 0:
            return UNKNOWN - berth
    if len(world.meetings) > 0 and mark_task_pairs(
        world.meetings, world.aligns, active, pairs, own, task.permitted, nearest, NEAR, travel, counts
    ):
        _decide(world, aligning, frames, nearest, counts)
    if held >= 0:
        return -1
    place_bars(pairs, own, world.bars)
    k = aligned_payload(world, aligning, own.placed, frames, before)
    if k >= 0 and not (task.inhibited and _inhibited(task, aligning.grasped[k])):
        for g in range(len(counts)):
            if aligning.grasped[k, g] != 0:
                counts[g] = 0
    return k


@law
def _inhibited(task: Contacting, among: Mask) -> bool:
    """Return whether any of the pairs `among` (g,) has a contact that inhibits the arm."""
    for g in range(len(among)):
        if among[g] != 0 and task.frames_touching[g] == FRAMES and task.essential[g] == 0 and task.arm[g] != 0:
            return True
    return False


@law
def _except_berth(
    world: World,
    aligning: Aligning,
    pairs: PackedLayout,
    own: Measured,
    active: Mask,
    frames: Array,
    k: int,
    nearest: int,
    counts: Mask,
) -> int:
    """Write a 0 into `counts` for pairs of the held payload k and the berth that it is about to enter or has just left.

    Pairs of the task and pairs in contact keep their marks. So do pairs that are nearer to each other than on the
    straight way into the berth (`on_way.least_on_way`). A pair whose bound is less is measured; the result therefore
    does not depend on the remembered data.

    Returns:
        -1, or the number of the berth whose clearances on the way are needed and not known.
    """
    row, berth = world.rows[k], berth_near(world, frames, k)
    if berth < 0:
        return -1
    among = aligning.seated[berth]
    factor = INNER if nearest >= 0 and among[nearest] != 0 else 1.0
    way = on_way(frames[world.berths[berth]], world.places[berth], frames[row], aligning.outs[berth])
    if way.aside > factor * ASIDE or way.tilt > factor * TILTED:
        return -1
    least = aligning.on_way[PLACES * berth + min(max(0, int(way.along / STEP)), PLACES - 1)]
    if len(least) > 0 and least[0] != least[0]:  # NaN: not known
        return berth
    measures = np.empty(PAIR)
    for g in range(len(among)):
        if among[g] == 0 or world.detrimental[g] == 0 or active[g] == 0:
            continue
        if lower_bound(pairs, own, g) < least[g]:
            near = own.near[g] != 0  # then it is measured already
            clearance = own.found[g, CLEARANCE] if near else measure_group(pairs, own, g, measures)
            if clearance <= least[g]:
                continue
        counts[g] = 0
    return -1


@law
def mark_task_pairs(
    groups: Indices,
    aligns: Mask,
    active: Mask,
    pairs: PackedLayout,
    own: Measured,
    permitted: Mask,
    nearest: int,
    farthest: float,
    travel: float,
    counts: Mask,
) -> bool:
    """Mark the pairs of the task that count for CLEARANCE, and as `UNDECIDED` those whose alignment has to be tested.

    A pair in contact counts if the contact is not permitted. A pair without contact counts if alignment does not apply
    to its relation, or if its parts are too far apart to be aligned. A pair that is too far apart to have the minimum
    clearance is marked without a test.

    Args:
        groups: (m,) indices of the pairs of the task.
        aligns: (m,) 1 for the pairs with the relation docking or guides; alignment applies only to these two relations.
        active: (g,) 1 for pairs that are monitored.
        pairs: solids and monitored pairs.
        own: the clearances.
        permitted: (g,) result of `relations.permitted`, as for `alarm_pairs`.
        nearest: the pair with the minimum clearance before this step; -1 if there was none.
        farthest: distance beyond which two parts do not count as aligned [m].
        travel: greatest distance by which two parts can approach before the next minimum is found [m].
        counts: (g,) on entry, 1 for the pairs that do not belong to the task; on return, also the marks.

    Returns:
        Whether a pair is marked as `UNDECIDED`.
    """
    if nearest >= 0 and counts[nearest] != 0:  # a pair beyond the new `farthest` cannot have the minimum clearance
        farthest = min(farthest, own.found[nearest, CLEARANCE] + travel)
    undecided = False
    for m in range(len(groups)):
        g = groups[m]
        if active[g] == 0:
            continue
        if own.found[g, CLEARANCE] <= CONTACT:
            counts[g] = 1 - permitted[g]
        elif aligns[m] == 0 or lower_bound(pairs, own, g) >= farthest:
            counts[g] = 1
        else:
            counts[g], undecided = UNDECIDED, True
    return undecided


@law
def _decide(world: World, aligning: Aligning, frames: Array, nearest: int, counts: Mask) -> None:
    """Replace each mark `UNDECIDED`: 0 for a pair whose parts are aligned, 1 for any other pair.

    The pairs of a payload with the same relation are decided together.
    """
    found = np.zeros(len(world.meetings), np.uint8)
    for m in range(len(world.meetings)):
        g = world.meetings[m]
        if counts[g] != UNDECIDED:
            continue
        k, relation = aligning.payloads[m], aligning.relations[m]
        first, reported = m, False
        for other in range(len(world.meetings)):
            if aligning.payloads[other] == k and aligning.relations[other] == relation:
                reported = reported or world.meetings[other] == nearest
                if other < first and found[other] != 0:
                    first = other
        if first < m:
            found[m] = found[first]
        else:
            depth = aligning.depths[m]
            aligned = is_aligned(world, aligning, frames, k, relation, depth, depth if reported else 0.0)
            found[m] = 1 if aligned else 2
        counts[g] = 0 if found[m] == 1 else 1
