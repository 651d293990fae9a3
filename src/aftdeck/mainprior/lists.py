"""Permanent lists for the shapes of a scenario: TABLE VII, changed only where a fixed cluster hides another one.

The order of fixed clusters follows from the position of the eye. A list is TABLE VII's row for the camera, in which an
entry stands behind all entries that hide a part of it. The place of the arm, Z, among the fixed clusters is the
report's. An eye that pan and tilt move has the list of its first position.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping

import numpy as np

from aftdeck.arrays import Array
from aftdeck.errors import InputError
from aftdeck.mainprior.tables import BESIDE, LISTS, Item
from aftdeck.mainprior.trees import Son, clusters_in
from aftdeck.visual.lists import hidden
from aftdeck.visual.store import Polyhedron, store_of


def report_list(station: str, fixed: Collection[int]) -> tuple[Item, ...]:
    """Return TABLE VII's own row of a station point, without the fixed clusters that a scenario does not have.

    Clusters of ours that share the place of one of the report's stand beside each other.
    """
    extended = [
        item for own in LISTS[station] for item in (BESIDE.get(own, (own,)) if isinstance(own, int) else (own,))
    ]
    return tuple(item for item in extended if not isinstance(item, int) or item in fixed)


def fitted_list(
    station: str, eye: Array, bodies: Mapping[int, Polyhedron], trees: Mapping[str, Son]
) -> tuple[Item, ...]:
    """Return the list of a station point for the shapes of a scenario.

    Args:
        station: A to I.
        eye: (3,) position of the eye in R [m].
        bodies: the fixed clusters in R, by number.
        trees: trees for the shapes of the scenario.

    Raises:
        InputError: the entries hide one another in a circle.
    """
    row = report_list(station, bodies)
    members = [_fixed_clusters(item, bodies, trees) for item in row]
    numbers = sorted(bodies)
    hides = hidden(store_of([bodies[k] for k in numbers]), np.arange(len(numbers)), eye)

    def must_precede(a: int, b: int) -> bool:
        """Return whether entry a has to stand before entry b: it hides a part of it, or one of them is Z or Y."""
        if not members[a] or not members[b]:
            return a < b
        return any(hides[numbers.index(p), numbers.index(q)] for p in members[a] for q in members[b])

    left, found = list(range(len(row))), []
    while left:
        free = next((b for b in left if not any(must_precede(a, b) for a in left if a != b)), None)
        if free is None:
            raise InputError(f"camera {station}: entries {', '.join(map(str, left))} hide one another in a circle")
        left.remove(free)
        found.append(row[free])
    return tuple(found)


def _fixed_clusters(item: Item, fixed: Collection[int], trees: Mapping[str, Son]) -> tuple[int, ...]:
    """Return the clusters of an entry; none if they are not all fixed in R."""
    if isinstance(item, int):
        return (item,)
    found = clusters_in(trees[item]) if isinstance(item, str) else ()
    return found if all(k in fixed for k in found) else ()
