"""Pairs that count for CLEARANCE: all monitored pairs except those that touch, or will touch, as the task needs it.

Otherwise every capture, docking and berthing would raise an alarm. If the end effector is aligned with a payload, their
clearance does not count; only the conditions of capture apply. A probe or trunnions are aligned if a straight motion
over the remaining distance would bring them into contact in the relative position that their relation permits
(`payloads.relations`). Their contacts are still monitored, and a contact that inhibits the arm counts.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import hypot, inf

import numpy as np

from aftdeck.arrays import Array, Mask
from aftdeck.bodies.pair import CONTACT
from aftdeck.bodies.pose import pose_of
from aftdeck.frames import oriend
from aftdeck.simulation.constants.berths import Berth
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.constants.hand import Bar, Snares
from aftdeck.simulation.constants.site import Meeting, Site
from aftdeck.simulation.payloads.grasp import NEAR, fixture_in_hand
from aftdeck.simulation.payloads.seating import approached
from aftdeck.simulation.state import State
from aftdeck.worksite.capture.acquisition import AWAY, FIXED, FOUND, PALM, PRONG, acquire
from aftdeck.worksite.model import Relation
from aftdeck.worksite.seats.berthing import over
from aftdeck.worksite.seats.docking import BEFORE, DISTANCE, INSIDE
from aftdeck.worksite.watch.clearance_monitor import ClearanceMonitor
from aftdeck.worksite.watch.contacts import FRAMES, Contacts
from aftdeck.worksite.watch.found import CLEARANCE

WIDER, WIDEST = 2.0, 2.4
"""Factors on the capture envelope's radius and angles [1]: alignment begins inside the first and ends outside the
second (assumed)."""


def count(flight: Flight, state: State) -> None:
    """Update the pairs that count for the minimum clearance of the next step, after all motion of this step."""
    worksite = state.worksite
    worksite.watch.counts[:], worksite.aligned_with = alarm_pairs(
        flight, worksite.held, worksite.watch, worksite.frames, worksite.aligned_with, worksite.nearest,
        worksite.contacts, worksite.permitted, flight.within,
    )  # fmt: skip


def alarm_pairs(
    flight: Flight,
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
        flight: constants of the run.
        held: the payload in the grasp; None if the grasp is empty.
        watch: clearances that were measured at `frames`.
        frames: (F, 12) poses of all frames in L.
        before: the payload with which the end effector was aligned before this step; None if there was none.
        nearest: the pair with the minimum clearance before this step; -1 if there was none.
        contacts: contacts of the last step; if end effector and payload inhibit the arm, their pairs count after all.
        permitted: (g,) pairs of the task, except those that touch where their relation does not permit a contact.
        travel: greatest distance by which two parts can approach before the next minimum is found [m].

    Returns:
        (g,) 1 for pairs that should not touch, except those of the end effector and the payload with which it is
        aligned. Then that payload; None if there is none.
    """
    site = flight.site
    counts = site.detrimental.copy()
    for group in _outside_relation(site, watch, frames, nearest, permitted, travel):
        counts[group] = 1
    k = None
    if held is None and site.bar is not None:
        k = _about_bar(site.bar, watch.placed)
    elif held is None and site.snares is not None:
        k = _before_snares(site, site.snares, frames, before)
    if k is None or (contacts.inhibit.arm and _inhibited(contacts, site.held[k])):
        return counts, k
    return counts & (1 - site.held[k]), k


def _inhibited(contacts: Contacts, among: Mask) -> bool:
    """Return whether a contact of one of the pairs `among` (g,) inhibits the arm."""
    return bool(np.any((contacts.count == FRAMES) & (contacts.essential == 0) & (contacts.arm != 0) & (among != 0)))


def _outside_relation(
    site: Site, watch: ClearanceMonitor, frames: Array, nearest: int, permitted: Mask, travel: float
) -> Iterator[int]:
    """Yield the pairs of the task that touch, or would touch, where their relation does not permit a contact.

    Pairs too far apart to be aligned, or to have the minimum clearance, are also yielded. Arguments as for
    `alarm_pairs`.
    """
    known: dict[tuple[int, Relation], bool] = {}
    farthest = NEAR  # parts farther apart are not aligned
    if nearest >= 0 and site.detrimental[nearest]:  # a pair farther apart cannot have the minimum clearance
        farthest = min(farthest, watch.found[nearest, CLEARANCE] + travel)
    for meeting in site.meetings:
        g, key = meeting.group, (meeting.cargo, meeting.relation)
        if not watch.active[g]:
            continue
        if watch.found[g, CLEARANCE] <= CONTACT:
            if not permitted[g]:
                yield g
        elif watch.bound[g] >= farthest:  # lower bound of the clearance
            yield g
        else:
            if key not in known:
                reported = any(
                    other.group == nearest for other in site.meetings if (other.cargo, other.relation) == key
                )
                known[key] = _is_aligned(site, frames, meeting, reported=reported)
            if not known[key]:
                yield g


def _is_aligned(site: Site, frames: Array, meeting: Meeting, *, reported: bool) -> bool:
    """Return whether two parts would touch, after a straight approach, in the position that their relation permits.

    If the minimum clearance was of this payload and relation (`reported`), they have to touch inside the relation's
    tolerances by the permitted depth, so that the lamp does not flicker. The caller finds alignment of the end
    effector.
    """
    k, depth = meeting.cargo, meeting.depth
    inside = depth if reported else 0.0
    match meeting.relation:
        case "docking":
            ports = (berth for berth in site.berths[k] if berth.port is not None)
            return any(_before_port(site, frames, k, berth, depth, inside) for berth in ports)
        case "guides":
            guided = (berth for berth in site.berths[k] if berth.guides is not None)
            return any(_over_guides(site, frames, k, berth, depth, inside) for berth in guided)
        case "acquisition" | "capture":
            return False


def _before_port(site: Site, frames: Array, k: int, berth: Berth, depth: float, inside: float) -> bool:
    """Return whether the probe is before the port's face, and inside docking's tolerances after a straight approach."""
    row = site.cargo_row(k)
    found = approached(berth, frames, row)
    if found[BEFORE] < -depth or found[DISTANCE] > NEAR:
        return False
    assert berth.port is not None
    inward = frames[berth.row, 3:].reshape(3, 3) @ berth.port[3:].reshape(3, 3) @ berth.seat.envelope[0, :3]
    there = frames.copy()
    there[row, :3] += found[BEFORE] * inward
    found = approached(berth, there, row)
    return bool(found[INSIDE] >= inside and found[DISTANCE] <= berth.docking.distance - inside)


def _over_guides(site: Site, frames: Array, k: int, berth: Berth, depth: float, inside: float) -> bool:
    """Return whether every trunnion is over the mouth of its own V-guide, or in that mouth."""
    assert berth.guides is not None
    guides = berth.guides
    places = guides.seats, guides.axes, guides.opening, guides.throat, guides.height, guides.play
    least, most, room = over(frames[berth.row], frames[site.cargo_row(k)], site.cargo[k].trunnions, *places)
    return least >= -depth and most <= NEAR and room >= inside


def _about_bar(bar: Bar, placed: Array) -> int | None:
    """Return the payload whose bar is before the palm and between the fingers; None if there is none."""
    found = np.empty(FOUND)
    for k, which in enumerate(bar.which):
        if which is None:
            continue
        acquire(placed, which, bar.packed, found)
        if found[AWAY] < NEAR and min(found[PALM], found[FIXED], found[PRONG]) >= 0.0:
            return k
    return None


def _before_snares(site: Site, snares: Snares, frames: Array, before: int | None) -> int | None:
    """Return the payload whose pin is aligned with the end effector in position and attitude; None if none is."""
    envelope = snares.envelope
    for k in range(len(snares.fixtures)):
        if (fixture := fixture_in_hand(site, frames, k)) is None:
            continue
        wide = WIDEST if k == before else WIDER
        out, y, z = fixture[:3].tolist()
        if hypot(y, z) > wide * envelope.radial or abs(out) > NEAR:
            continue
        roll, pitch, yaw = (abs(angle) for angle in oriend(pose_of(fixture).rotation))
        if roll <= wide * envelope.roll and pitch <= wide * envelope.pitch and yaw <= wide * envelope.yaw:
            return k
    return None
