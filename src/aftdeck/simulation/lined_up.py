"""A payload that the hand is lined up with: how near the two are is judged by the conditions of capture alone.

Else every capture would be an alarm. Whether they touch is watched as ever, and a touch that inhibits the arm is told.
"""

from __future__ import annotations

from math import hypot

import numpy as np
from numpy.typing import NDArray

from aftdeck.bodies.pose import POSE, compose, pose_of, relative
from aftdeck.frames import oriend
from aftdeck.simulation.flight import Flight
from aftdeck.simulation.grasp import NEAR
from aftdeck.simulation.hand import Bar, Snares
from aftdeck.simulation.site import Site
from aftdeck.worksite.acquisition import AWAY, FIXED, FOUND, PALM, PRONG, acquire
from aftdeck.worksite.contacts import FRAMES, Contacts

Array = NDArray[np.float64]
Mask = NDArray[np.uint8]

WIDER, WIDEST = 2.0, 2.4
"""Lined up is what comes within the envelope's radius and angles, so many times [1], until it leaves them so many
times; assumed."""


def counted(
    flight: Flight,
    held: int | None,
    placed: Array,
    frames: Array,
    before: int | None,
    contacts: Contacts,
    permitted: Mask,
) -> tuple[Mask, int | None]:
    """Of which groups the nearest is told.

    Args:
        flight: what never changes.
        held: the cargo that the hand has; it takes no other.
        placed: (n, 52) solids in L.
        frames: (F, 12) in L.
        before: the cargo that the hand was lined up with until now.
        contacts: as of the step before; where hand and cargo inhibit the arm, the two are told of after all.
        permitted: (g,) groups that the task brings into contact, but those that touch where it does not.

    Returns:
        (g,) those that should not touch, but the hand and the cargo that it is lined up with; and which that is.
    """
    site, counts = flight.site, 1 - permitted
    k = None
    if held is None and site.bar is not None:
        k = _about_the_bar(site.bar, placed)
    elif held is None and site.snares is not None:
        k = _before_the_snares(site, site.snares, frames, before)
    if k is None or (contacts.inhibit.arm and _inhibited(contacts, site.held[k])):
        return counts, k
    return counts & (1 - site.held[k]), k


def _inhibited(contacts: Contacts, among: Mask) -> bool:
    """Whether one of these groups' contacts inhibits the arm."""
    return bool(np.any((contacts.count == FRAMES) & (contacts.essential == 0) & (contacts.arm != 0) & (among != 0)))


def _about_the_bar(bar: Bar, placed: Array) -> int | None:
    """The cargo whose bar lies before the palm and between the fingers."""
    found = np.empty(FOUND)
    for k, which in enumerate(bar.which):
        if which is None:
            continue
        acquire(placed, which, bar.packed, found)
        if found[AWAY] < NEAR and min(found[PALM], found[FIXED], found[PRONG]) >= 0.0:
            return k
    return None


def _before_the_snares(site: Site, snares: Snares, frames: Array, before: int | None) -> int | None:
    """The cargo whose pin stands on the end effector's axis, more or less, and the right way round."""
    envelope, effector, place, found = snares.envelope, np.empty(POSE), np.empty(POSE), np.empty(POSE)
    compose(frames[site.last_joint], site.effector, effector)
    for k, fixture in enumerate(snares.fixtures):
        if fixture is None:
            continue
        compose(frames[site.cargo_row(k)], fixture, place)
        relative(effector, place, found)
        wide = WIDEST if k == before else WIDER
        out, y, z = found[:3].tolist()
        if hypot(y, z) > wide * envelope.radial or abs(out) > NEAR:
            continue
        roll, pitch, yaw = (abs(angle) for angle in oriend(pose_of(found).rotation))
        if roll <= wide * envelope.roll and pitch <= wide * envelope.pitch and yaw <= wide * envelope.yaw:
            return k
    return None
