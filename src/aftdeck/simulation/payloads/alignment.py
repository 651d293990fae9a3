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
from functools import lru_cache
from math import inf

import numpy as np

from aftdeck.arrays import Array, Indices, Mask
from aftdeck.bodies.pair import CONTACT
from aftdeck.bodies.pose import HERE
from aftdeck.law import law
from aftdeck.matrices import product
from aftdeck.simulation.constants.site import Site
from aftdeck.simulation.parts.worksite_state import WorksiteState
from aftdeck.simulation.payloads.grasp import NEAR
from aftdeck.worksite.relation import Meeting, Relation
from aftdeck.worksite.watch.clearance_monitor import ClearanceMonitor
from aftdeck.worksite.watch.contacts import FRAMES, Contacts
from aftdeck.worksite.watch.found import CLEARANCE
from aftdeck.worksite.watch.places import nearest_place

ASIDE = 0.3
"""Greatest distance of a payload from the line on which it enters a berth, up to which it is about to enter [m]
(assumed)."""
TILTED = math.radians(5.0)
"""Greatest angle between a payload and its attitude in a berth, up to which it is about to enter [rad] (assumed)."""
STEP = 0.1
"""Distance of the positions on the way into a berth at which clearances are known [m] (assumed)."""
INNER = 0.8
"""Factor on `ASIDE` and `TILTED` [1] (assumed) while a pair of payload and berth has the minimum clearance; without it,
the lamp could flicker."""

UNDECIDED = 2
"""Mark of a pair that counts unless its parts are aligned."""


def count(site: Site, worksite: WorksiteState, travel: float) -> None:
    """Update the pairs that count for the minimum clearance of the next step, after all motion of this step.

    `travel` is the greatest distance by which two parts can approach in the next step [m] (`Flight.within`).
    """
    worksite.watch.counts[:], worksite.aligned_with = alarm_pairs(
        site, worksite.held, worksite.watch, worksite.frames, worksite.aligned_with, worksite.nearest,
        worksite.contacts, worksite.permitted, travel,
    )  # fmt: skip


def alarm_pairs(
    site: Site,
    held: int | None,
    watch: ClearanceMonitor,
    frames: Array,
    before: int | None,
    nearest: int,
    contacts: Contacts,
    permitted: Mask,
    travel: float = inf,
) -> tuple[Mask, int | None]:
    """Return the pairs that count for the minimum clearance, and the payload with which the end effector is aligned.

    Args:
        site: constants of the worksite.
        held: the payload in the grasp; None if the grasp is empty.
        watch: clearances that were measured at `frames`.
        frames: (F, 12) poses of all frames in L.
        before: the payload with which the end effector was aligned before this step; None if it was aligned with none.
        nearest: the pair with the minimum clearance before this step; -1 if there was none.
        contacts: contacts of the last step. If a contact of the end effector with the payload inhibits the arm, the
            pairs of these two are not excepted.
        permitted: (g,) result of `relations.permitted`: 1 for pairs of the task, except those in a contact that the
            task does not permit.
        travel: greatest distance by which two parts can approach before the next minimum is found [m].

    Returns:
        A mask (g,), 1 for the pairs that count for CLEARANCE; and the payload with which the end effector is aligned,
        or None.
    """
    counts = site.detrimental.copy()
    if held is not None:
        _except_berth(site, held, watch, frames, nearest, counts)
    if site.meetings:
        undecided = mark_task_pairs(
            site.meeting_groups, site.meeting_aligns, watch.active, watch.found, watch.bound, permitted, nearest, NEAR,
            travel, counts,
        )  # fmt: skip
        if undecided:
            _decide(site, frames, nearest, counts)
    k = None
    if held is None and site.capture is not None:
        k = site.capture.aligned_with(frames, watch.placed, NEAR, before)
    if k is None or (contacts.inhibit.arm and _inhibited(contacts, site.held[k])):
        return counts, k
    return counts & site.not_held[k], k


def _except_berth(site: Site, k: int, watch: ClearanceMonitor, frames: Array, nearest: int, counts: Mask) -> None:
    """Write a 0 into `counts` for pairs of the held payload k and the berth that it is about to enter or has just left.

    Pairs of the task and pairs in contact keep their marks. So do pairs that are nearer to each other than on the
    straight way into the berth, by more than the berth's tolerance or by half.
    """
    row = site.payload_rows[k]
    number = nearest_place(frames, row, site.berth_rows[k], site.berth_places[k], NEAR)
    if number < 0:
        return
    fit = site.fits[k][number]
    pairs = site.seated[k, fit.berth.name]
    factor = INNER if nearest >= 0 and pairs[nearest] else 1.0
    along, aside, tilt = fit.on_way(frames, row)
    if aside > factor * ASIDE or tilt > factor * TILTED:
        return
    before = min(max(0, int(along / STEP)), int(NEAR / STEP))
    watch.except_far(pairs & site.detrimental, least_on_way(site, k, number)[before], counts)


@lru_cache(maxsize=8)
def least_on_way(site: Site, k: int, number: int) -> Array:
    """Return the clearances (n, g) up to which pairs of `clearances_on_way` count [m].

    Row i is for a payload between `i * STEP` and the next step before its final position.
    """
    on_way, tolerance = clearances_on_way(site, k, number), site.fits[k][number].berth.distance
    nearest = np.minimum(on_way[:-1], on_way[1:])
    return np.asarray(np.maximum(np.maximum(nearest - tolerance, 0.5 * nearest), CONTACT))


def clearances_on_way(site: Site, k: int, number: int) -> Array:
    """Return the clearances (n, g) of a payload on its way into a berth and of the parts in the berth's frame [m].

    Row i is for a payload with its attitude in the berth, `i * STEP` before its final position. Pairs of other parts
    have the clearance inf.
    """
    fit = site.fits[k][number]
    frames, row = np.tile(HERE, (len(site.layout.frames), 1)), site.payload_rows[k]
    frames[row] = fit.place
    step = STEP * product(fit.place[3:].reshape(3, 3), fit.way_out)
    watch = ClearanceMonitor(site.layout)
    watch.active[:] = site.seated[k, fit.berth.name]
    found = np.empty((math.ceil(NEAR / STEP) + 2, len(watch.active)))
    for i in range(len(found)):
        frames[row, :3] = fit.place[:3] + i * step
        watch.update(frames, frames, 1.0)
        found[i] = watch.found[:, CLEARANCE]
    return found


@law
def mark_task_pairs(
    groups: Indices,
    aligns: Mask,
    active: Mask,
    found: Array,
    bound: Array,
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
        found: (g, 15) measurements, rows as in `worksite.watch.found`.
        bound: (g,) lower bound of each pair's clearance [m].
        permitted: (g,) result of `relations.permitted`, as for `alarm_pairs`.
        nearest: the pair with the minimum clearance before this step; -1 if there was none.
        farthest: distance beyond which two parts do not count as aligned [m].
        travel: greatest distance by which two parts can approach before the next minimum is found [m].
        counts: (g,) on entry, 1 for the pairs that do not belong to the task; on return, also the marks.

    Returns:
        Whether a pair is marked as `UNDECIDED`.
    """
    if nearest >= 0 and counts[nearest] != 0:  # a pair beyond the new `farthest` cannot have the minimum clearance
        farthest = min(farthest, found[nearest, CLEARANCE] + travel)
    undecided = False
    for m in range(len(groups)):
        g = groups[m]
        if active[g] == 0:
            continue
        if found[g, CLEARANCE] <= CONTACT:
            counts[g] = 1 - permitted[g]
        elif aligns[m] == 0 or bound[g] >= farthest:
            counts[g] = 1
        else:
            counts[g], undecided = UNDECIDED, True
    return undecided


def _decide(site: Site, frames: Array, nearest: int, counts: Mask) -> None:
    """Replace each mark `UNDECIDED`: 0 for a pair whose parts are aligned, 1 for any other pair."""
    known: dict[tuple[int, Relation], bool] = {}
    for meeting in site.meetings:
        if counts[meeting.group] != UNDECIDED:
            continue
        key = meeting.payload, meeting.relation
        if key not in known:
            reported = any(other.group == nearest for other in site.meetings if (other.payload, other.relation) == key)
            known[key] = _is_aligned(site, frames, meeting, reported=reported)
        counts[meeting.group] = not known[key]


def _inhibited(contacts: Contacts, among: Mask) -> bool:
    """Return whether any of the pairs `among` (g,) has a contact that inhibits the arm."""
    return bool(np.any((contacts.count == FRAMES) & (contacts.essential == 0) & (contacts.arm != 0) & (among != 0)))


def _is_aligned(site: Site, frames: Array, meeting: Meeting, *, reported: bool) -> bool:
    """Return whether two parts would touch in a permitted relative position after a straight approach.

    `reported` is True if the pair with the last minimum clearance has the payload and the relation of `meeting`. If so,
    the parts count as aligned only if they are inside the tolerances by at least the permitted depth. This margin keeps
    the lamp from flickering. Only relations of berths are tested here; the end effector is tested in `alarm_pairs`.
    """
    k, depth = meeting.payload, meeting.depth
    inside = depth if reported else 0.0
    fits = (fit for fit in site.fits[k] if fit.relation == meeting.relation)
    return any(fit.is_aligned(frames, site.payload_rows[k], depth, NEAR, inside) for fit in fits)
