"""Predicted effect of a motion on the contacts: the clearance that it gains, and how far touching parts slide.

Every pair of touching solids counts separately. For a body made of several solids, the deepest pair alone would not
show which direction separates all of them.
"""

from __future__ import annotations

from math import sqrt
from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array, Mask
from aftdeck.bodies import pair as packed
from aftdeck.bodies.pair import CONTACT
from aftdeck.bodies.pair_check import measure
from aftdeck.bodies.pose import turned_back
from aftdeck.bodies.vector import Vector, dot, minus, vector_at
from aftdeck.law import large_law, law
from aftdeck.worksite.watch.clearance_monitor import ClearanceMonitor, copy_pair, way_apart
from aftdeck.worksite.watch.found import CLEARANCE, FOUND, NORMAL, POINT_A, POINT_B
from aftdeck.worksite.watch.groups import LayoutArrays, PackedLayout, layout_from
from aftdeck.worksite.watch.measured import (
    Measured,
    MeasuredArrays,
    apart,
    follow,
    lower_bound,
    measured_of,
    nearest_pair,
    place_solid,
    spheres_apart,
)

STEP = 1.0
"""Distance beyond which two solids cannot come into contact within one step [m]."""


class PredictedContacts(NamedTuple):
    """Effect of a motion on the contacts.

    Attributes:
        worst: lowest (most negative) change of a clearance among the present and new contacts [m]; 0 or more if no
            clearance decreases; inf if there is no contact.
        which: the group with this change; -1 if there is no contact.
        gained: sum of the changes in clearance of all pairs of solids in detrimental contacts [m]; inf if there is no
            detrimental contact.
        slid: greatest distance that a touching point of a detrimental contact moves along the other body [m].
        deeper: greatest increase of the penetration depth of two parts [m]; negative or 0 if no depth increases.
        lessened: decrease of the sum of the depths of all contacts [m].
        made: True if the motion makes a new contact.
    """

    worst: float
    which: int
    gained: float
    slid: float
    deeper: float
    lessened: float
    made: bool


@large_law
def predict_contacts(
    layout: PackedLayout, own: Measured, counts: Mask, harmful: Mask, after: Array
) -> PredictedContacts:
    """Return the effect of a motion on the contacts of the groups that count.

    Args:
        layout: the solids and the groups.
        own: arrays of the monitor before the motion. They have to be `apart`, because they are changed to the values
            after the motion. `memory` is updated, which does not affect the result.
        counts: (g,) 1 for groups whose contacts count; these groups have to be active.
        harmful: (g,) 1 for each of these groups whose contact is detrimental: the motion has to relieve the contact.
        after: (F, 12) poses of the frames after the motion, in L.
    """
    found, begins = own.found, layout.begins
    was, measures = np.full(len(own.memory), np.inf), np.empty(packed.PAIR)
    slid, touching = 0.0, False
    for g in range(len(counts)):
        if counts[g] != 0 and harmful[g] != 0 and found[g, CLEARANCE] <= CONTACT:
            touching = True
            for k in range(begins[g], begins[g + 1]):
                slid = max(slid, _slid(layout, own, after, k, was))
    follow(layout, own, after)
    worst, which, gained, deeper, lessened, made = np.inf, -1, 0.0, -np.inf, 0.0, False
    for g in range(len(counts)):
        if counts[g] == 0:
            continue
        before, limit = found[g, CLEARANCE], np.inf
        if before > CONTACT:
            limit = 2.0 * CONTACT
            if lower_bound(layout, own, g) >= limit:
                continue
        elif harmful[g] != 0:
            changes = _summed_changes(layout, own, begins[g], begins[g + 1], was)
            gained, lessened = gained + changes[0], lessened + changes[1]
        if nearest_pair(layout, own, g, limit, measures) < 0:
            continue
        clearance = measures[packed.CLEARANCE]
        if clearance - before < worst and (before <= CONTACT or clearance <= CONTACT):
            worst, which = clearance - before, g
        made = made or (before > CONTACT and clearance <= CONTACT)
        deeper = max(deeper, min(before, 0.0) - clearance)
        if before > CONTACT or harmful[g] == 0:
            lessened += min(clearance, 0.0) - min(before, 0.0)
    return PredictedContacts(worst, which, gained if touching else np.inf, slid, deeper, lessened, made)


@law
def _summed_changes(layout: PackedLayout, own: Measured, begin: int, end: int, was: Array) -> tuple[float, float]:
    """Return two sums over a group's pairs of solids: changes in clearance, and decreases in depth [m].

    `was` contains the clearance of each pair before the motion; pairs with inf are left out. For a pair that did not
    touch before the motion, both sums contain only the new depth, as a negative value.
    """
    gained, lessened, pair = 0.0, 0.0, np.empty(packed.PAIR)
    for k in range(begin, end):
        if was[k] == np.inf:
            continue
        pair[:] = 0.0
        i, j = layout.pairs[k, 0], layout.pairs[k, 1]
        place_solid(layout, own, i)
        place_solid(layout, own, j)
        now = measure(own.placed[i], own.placed[j], pair)
        gained += now - was[k] if was[k] <= CONTACT else min(now, 0.0)
        lessened += min(now, 0.0) - min(was[k], 0.0)
    return gained, lessened


@law
def _slid(layout: PackedLayout, own: Measured, after: Array, k: int, was: Array) -> float:
    """Return the distance that the touching points of pair k slide along each other [m]; 0 if the pair does not touch.

    The distance is measured perpendicular to the shortest move that separates the solids. Also write the present
    clearance of the pair into was[k]; was[k] remains inf if the bounding spheres are farther apart than `STEP`.
    """
    i, j = layout.pairs[k, 0], layout.pairs[k, 1]
    place_solid(layout, own, i)
    place_solid(layout, own, j)
    a, b = own.placed[i], own.placed[j]
    if spheres_apart(a, b) > STEP:
        return 0.0
    pair = np.zeros(packed.PAIR)
    was[k] = measure(a, b, pair)
    if was[k] > CONTACT:
        return 0.0
    row = np.empty(FOUND)
    copy_pair(pair, row)
    way_apart(a, b, row)
    p = _displacement(own.at[layout.frame[i]], after[layout.frame[i]], vector_at(row, POINT_A))
    q = _displacement(own.at[layout.frame[j]], after[layout.frame[j]], vector_at(row, POINT_B))
    moved = minus(p, q)
    out = dot(moved, vector_at(row, NORMAL))
    return sqrt(max(dot(moved, moved) - out * out, 0.0))


@law
def _displacement(at: Array, after: Array, point: Vector) -> Vector:
    """Return the displacement of a point carried by a frame that moves from one pose (12,) to another [m]."""
    r = minus(point, vector_at(at, 0))
    p = turned_back(at, r)
    return Vector(
        after[0] - at[0] + after[3] * p.x + after[4] * p.y + after[5] * p.z - r.x,
        after[1] - at[1] + after[6] * p.x + after[7] * p.y + after[8] * p.z - r.y,
        after[2] - at[2] + after[9] * p.x + after[10] * p.y + after[11] * p.z - r.z,
    )


@law
def tried(layout: LayoutArrays, own: MeasuredArrays, counts: Mask, harmful: Mask, after: Array) -> PredictedContacts:
    """Return the prediction for a motion that ends at the poses `after` (F, 12)."""
    return predict_contacts(layout_from(layout), apart(measured_of(own)), counts, harmful, after)


def trial_of(watch: ClearanceMonitor, counts: Mask, harmful: Mask, after: Array) -> PredictedContacts:
    """Return the effect of a motion that ends at the poses `after` (F, 12); the other arguments: `predict_contacts`."""
    return tried(watch.layout.arrays, watch.packed, counts & watch.active, harmful, after)
