"""Which planes of the routine separate in a frame: the pairs of clusters whose order no plane of the routine proves.

Cluster a stands before cluster b for a reason: a node's plane between the two, a test of the special priority, or the
places of two entries in a permanent list. A plane proves this order if the eye and a are on one side of it, and b is on
the other side: b then hides no part of a, whatever the direction of view. The maker of a list had no other planes than
those of the fixed clusters' faces, so an order in a list is proved by the plane of a face of one of the two, if this
one is fixed.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array
from aftdeck.mainprior.planes import Plane
from aftdeck.mainprior.shapes import Stage
from aftdeck.mainprior.tables import CLUSTERS, Item, System, Tested, tree_name
from aftdeck.mainprior.trees import Son, Sorted, Split, clusters_in
from aftdeck.visual.planes import TOLERANCE

FIXED: Collection[System] = ("LR", "LS")
"""Systems of the clusters whose faces the maker of a list could use, besides those of the payload in the shuttle's
tree."""


class Unproved(NamedTuple):
    """Order of two clusters that no plane of the routine proves.

    Attributes:
        plane: name of the plane that should separate the two: a node's, or one of D1 to D3; for an order in a list, the
            face of a fixed cluster that comes nearest to separating them (`face 2 of 3`); for a fixed list of clusters
            in a tree, `list`.
        before: cluster with the higher priority.
        behind: cluster with the lower priority.
    """

    plane: str
    before: int
    behind: int


class Prover:
    """Test of the orders of a frame.

    Args:
        stage: the frame.
        planes: the planes of the frame, by name.
        eye: the L vectors.
    """

    def __init__(self, stage: Stage, planes: Mapping[str, Plane], eye: Mapping[System, Array]) -> None:
        self._bodies = stage.bodies
        origin = stage.systems["LR"].origin - eye["LR"]
        self._points = {k: np.vstack([origin, body.points]) for k, body in stage.bodies.items()}
        self._heights: dict[tuple[str, int], Array] = {}
        self._stage, self._planes = stage, planes

    def unproved(
        self, pairs: Iterable[tuple[int, int]], items: Sequence[Item], trees: Mapping[str, Son], mode: int
    ) -> Iterator[Unproved]:
        """Yield the pairs whose order is not proved.

        Args:
            pairs: pairs of clusters, the one with the higher priority first.
            items: the permanent list.
            trees: the trees, by name.
            mode: the task phase.
        """
        entries = [item if isinstance(item, int) else trees[tree_name(item, mode)] for item in items]
        home = {k: n for n, entry in enumerate(entries) for k in clusters_in(entry)}
        faced = {k for k, n in home.items() if _is_shuttle(items[n]) or CLUSTERS[k].system in FIXED}
        for before, behind in pairs:
            if home[before] != home[behind]:
                name = self._failing_face(before, behind, faced)
                if name:
                    yield Unproved(name, before, behind)
                continue
            names = tuple(_between(entries[home[before]], before, behind))
            if not any(self._proves(name, before, behind) for name in names):
                yield Unproved(names[0] if names else "list", before, behind)

    def _proves(self, name: str, before: int, behind: int) -> bool:
        plane = self._planes.get(name)
        if plane is None:
            return False
        return _clear(self._over(name, plane, before), self._over(name, plane, behind)) >= -TOLERANCE

    def _over(self, name: str, plane: Plane, cluster: int) -> Array:
        """Return the heights (1 + n,) of the eye and of a cluster's vertices over a plane."""
        if (name, cluster) not in self._heights:
            self._heights[name, cluster] = plane.heights(self._points[cluster], self._stage.systems)
        return self._heights[name, cluster]

    def _failing_face(self, before: int, behind: int, faced: Collection[int]) -> str:
        """Return the name of the face that comes nearest to a proof; empty if a face proves the order."""
        best, name = -np.inf, "list"
        for cluster in (before, behind):
            if cluster not in faced:
                continue
            for number, face in enumerate(self._bodies[cluster].faces, 1):
                first, second = (self._points[k] @ face[:3] - face[3] for k in (before, behind))
                clear = _clear(first, second)
                if clear >= -TOLERANCE:
                    return ""
                if clear > best:
                    best, name = clear, f"face {number} of {cluster}"
        return name


def _clear(before: Array, behind: Array) -> float:
    """Return by how much a plane has the eye and one cluster on one side, and another cluster on the other side [m].

    Args:
        before: (1 + n,) heights of the eye and of the first cluster's vertices over the plane [m].
        behind: (1 + m,) heights of the eye and of the second cluster's vertices [m].

    Returns:
        The distance of the nearest one from the plane; negative if one is on the wrong side.
    """
    over = min(before.min(), -behind[1:].max())
    under = min(-before.max(), behind[1:].min())
    return float(max(over, under))


def _is_shuttle(item: Item) -> bool:
    return isinstance(item, Tested) and item.kind == "Y"


def _between(son: Son, a: int, b: int) -> Iterator[str]:
    """Yield the names of the planes by which a tree orders two of its clusters; none if they are in a fixed list."""
    if isinstance(son, Split):
        for part in (son.true, son.false):
            own = clusters_in(part)
            if a in own and b in own:
                yield from _between(part, a, b)
                return
        yield son.plane
    elif isinstance(son, Sorted):
        if son.cluster not in (a, b):
            yield from _between(son.tree, a, b)
            return
        other = b if a == son.cluster else a
        yield from (plane for plane, others in son.tests if other in others)
