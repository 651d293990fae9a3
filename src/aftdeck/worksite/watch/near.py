"""Pairs of solids that are near each other: only these can touch before the next measurement."""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array, Indices, Mask
from aftdeck.bodies.hexahedron import VERTICES
from aftdeck.bodies.pair import CONTACT, PAIR
from aftdeck.bodies.repeated_test import measure
from aftdeck.bodies.vector import dot, minus, vector_at
from aftdeck.law import law
from aftdeck.worksite.watch.found import CLEARANCE
from aftdeck.worksite.watch.groups import CENTRE, RADIUS

_ROUNDING = 1e-6
"""Margin by which two boxes may be apart although their solids are in contact [m]: more than rounding errors."""


@law
def _boxes_near(a: Array, b: Array, within: float) -> bool:
    """Return whether the bounding boxes of two packed solids (52,) are nearer than `within` along each axis [m]."""
    near = True
    for axis in range(3):
        begin = axis * VERTICES
        low_a = high_a = a[begin]
        low_b = high_b = b[begin]
        for v in range(begin + 1, begin + VERTICES):
            low_a, high_a = min(low_a, a[v]), max(high_a, a[v])
            low_b, high_b = min(low_b, b[v]), max(high_b, b[v])
        near = near and low_a - high_b < within and low_b - high_a < within
    return near


@law
def near_pairs(
    active: Mask, found: Array, within: float, begins: Indices, pairs: Indices, placed: Array, near: Indices
) -> int:
    """Find the pairs of solids that are nearer than `within`, in all groups.

    Args:
        active: (g,) 1 for groups that are monitored.
        found: (g, 15) measurements, rows as in `worksite.watch.found`.
        within: distance [m].
        begins: (g + 1,) as `Layout.begins`.
        pairs: (m, 2) as `Layout.pairs`.
        placed: (n, 52) the solids in L.
        near: (p, 3) output: the group and the two solids of each pair, as far as there is room.

    Returns:
        Number of pairs found, which can be greater than p.
    """
    count, pair = 0, np.zeros(PAIR)
    for g in range(len(active)):
        if active[g] == 0 or found[g, CLEARANCE] >= within:
            continue
        for k in range(begins[g], begins[g + 1]):
            a, b = placed[pairs[k, 0]], placed[pairs[k, 1]]
            away, reach = minus(vector_at(b, CENTRE), vector_at(a, CENTRE)), within + a[RADIUS] + b[RADIUS]
            if dot(away, away) > reach * reach or not _boxes_near(a, b, within):
                continue
            if measure(a, b, pair) >= within:
                continue
            if count < len(near):
                near[count, 0], near[count, 1], near[count, 2] = g, pairs[k, 0], pairs[k, 1]
            count += 1
    return count


@law
def touch(a: Array, b: Array, pair: Array) -> bool:
    """Return whether two solids are in contact.

    Args:
        a: (52,) the first solid, in L.
        b: (52,) the second solid, in L.
        pair: workspace of `measure`.
    """
    return _boxes_near(a, b, _ROUNDING) and measure(a, b, pair) <= CONTACT
