"""Trees for the shapes of a scenario: the planes of Figure 19's nodes, and new nodes where no plane divides theirs.

A node of Figure 19 stays if a plane of a face, fixed in the system of TABLE VIII, has the clusters of one son on one
side and those of the other son on the other side. Only clusters that are fixed in this system can be tested so; those
that move are tested in each frame (`proof.py`). If no plane divides a node of the shuttle's tree, its clusters get new
nodes: at each of them, the plane that cuts nothing and divides them most evenly. Clusters that no plane divides stay a
fixed list.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array
from aftdeck.errors import InputError
from aftdeck.mainprior.fixed import FixedBodies
from aftdeck.mainprior.planes import Plane
from aftdeck.mainprior.tables import BESIDE, BISECTING, RECEIVED, TREES, System, system_of
from aftdeck.mainprior.trees import Son, Sorted, Split, clusters_in, nodes_in, pruned
from aftdeck.visual.cutting import ON

FIRST_NEW = 23
"""Number of the first new plane."""


class Fitted(NamedTuple):
    """Trees for the shapes of a scenario.

    Attributes:
        trees: the trees, by name.
        planes: the planes that are fixed in their systems, by name.
        replaced: planes of Figure 19 that do not divide these shapes, and are not in the trees.
    """

    trees: Mapping[str, Son]
    planes: Mapping[str, Plane]
    replaced: tuple[str, ...]


def fitted(bodies: FixedBodies) -> Fitted:
    """Return the trees of Figure 19 for the shapes of a scenario.

    Raises:
        InputError: no plane divides two clusters of the arm or of the payload.
    """
    fit = _Fit(bodies)
    trees = {name: fit.tree(pruned(_extended(tree), bodies.present)) for name, tree in TREES.items()}
    used = {node.plane for tree in trees.values() for node in nodes_in(tree) if isinstance(node, Split)}
    named = [node.plane for tree in TREES.values() for node in nodes_in(tree) if isinstance(node, Split)]
    return Fitted(trees, fit.planes, tuple(dict.fromkeys(name for name in named if name not in used)))


def _extended(son: Son) -> Son:
    """Return a tree with our clusters beside those of the report whose place they share."""
    if isinstance(son, int):
        return BESIDE.get(son, son)
    if isinstance(son, Split):
        return Split(son.plane, _extended(son.true), _extended(son.false))
    if isinstance(son, Sorted):
        return Sorted(_extended(son.tree), son.cluster, son.tests)
    return tuple(k for own in son for k in BESIDE.get(own, (own,)))


class _Fit:
    """Work of `fitted`: the planes found so far."""

    def __init__(self, bodies: FixedBodies) -> None:
        self._bodies = bodies
        self.planes: dict[str, Plane] = {}

    def tree(self, son: Son) -> Son:
        """Return a tree whose planes are found."""
        if isinstance(son, int):
            return son
        if isinstance(son, Sorted):
            for plane, others in son.tests:
                self._find(plane, (son.cluster,), others)
            return Sorted(self.tree(son.tree), son.cluster, son.tests)
        if isinstance(son, tuple):
            return self._divided([*son])
        if self._find(son.plane, clusters_in(son.true), clusters_in(son.false)):
            return Split(son.plane, self.tree(son.true), self.tree(son.false))
        return self._divided(list(_atoms(son)))

    def _find(self, name: str, true: Sequence[int], false: Sequence[int]) -> bool:
        """Find the plane of a node, unless it is known or not fixed; return whether it divides the node's sons."""
        if name in BISECTING or name in RECEIVED:
            return True
        system = system_of(name)
        above, below = self._points(system, true), self._points(system, false)
        if name in self.planes:
            return _gap(self.planes[name], above, below) >= -ON
        best = max(
            (_between(system, face, above, below) for face in self._faces(system, (*true, *false))),
            key=lambda plane: _gap(plane, above, below),
        )
        if _gap(best, above, below) < -ON:
            if system != "LR":
                raise InputError(f"plane {name}: no plane of a face divides clusters {true} from {false} in {system}")
            return False
        self.planes[name] = best
        return True

    def _divided(self, atoms: list[Son]) -> Son:
        """Return a tree in R of clusters and of subtrees in other systems."""
        if len(atoms) == 1:
            return self.tree(atoms[0]) if isinstance(atoms[0], Split) else atoms[0]
        spaces = [self._points("LR", clusters_in(atom)) for atom in atoms]
        best: tuple[int, Plane, list[bool]] | None = None
        for face in self._faces("LR", [k for atom in atoms for k in clusters_in(atom)]):
            sides = [_side(face, points) for points in spaces]
            uneven = abs(sum(sides))
            if 0 in sides or uneven == len(sides) or (best is not None and uneven >= best[0]):
                continue
            above = np.concatenate([points for points, side in zip(spaces, sides, strict=True) if side > 0])
            below = np.concatenate([points for points, side in zip(spaces, sides, strict=True) if side < 0])
            best = uneven, _between("LR", face, above, below), [side > 0 for side in sides]
        if best is None:
            return tuple(k for atom in atoms for k in clusters_in(atom))
        _, plane, over = best
        return Split(
            self._named(plane),
            self._divided([atom for atom, side in zip(atoms, over, strict=True) if side]),
            self._divided([atom for atom, side in zip(atoms, over, strict=True) if not side]),
        )

    def _named(self, plane: Plane) -> str:
        """Return the name of a new plane."""
        for name, known in self.planes.items():
            if known.system == plane.system and np.allclose(
                [*known.normal, known.distance], [*plane.normal, plane.distance], rtol=0.0, atol=ON
            ):
                return name
        name = str(FIRST_NEW + sum(int(name) >= FIRST_NEW for name in self.planes))
        self.planes[name] = plane
        return name

    def _points(self, system: System, numbers: Iterable[int]) -> Array:
        found = [body.points for body in self._bodies.within(system, numbers)]
        return np.concatenate([np.empty((0, 3)), *found])

    def _faces(self, system: System, numbers: Iterable[int]) -> Array:
        """Return the faces (f, 4) of clusters that are fixed in a system, each with both directions of its normal."""
        found = np.concatenate([np.empty((0, 4)), *(body.faces for body in self._bodies.within(system, numbers))])
        return np.concatenate([found, -found])


def _atoms(son: Son) -> Iterable[Son]:
    """Yield the clusters of a tree in R, and its subtrees in other systems."""
    if isinstance(son, Split) and system_of(son.plane) == "LR":
        yield from _atoms(son.true)
        yield from _atoms(son.false)
    elif isinstance(son, Split | int):
        yield son
    else:
        yield from clusters_in(son)


def _between(system: System, face: Array, above: Array, below: Array) -> Plane:
    """Return the plane along a face's normal that is halfway between two sets of points (n, 3)."""
    high, low = float((above @ face[:3]).min()), float((below @ face[:3]).max())
    return Plane(system, face[:3].copy(), 0.5 * (high + low))


def _gap(plane: Plane, above: Array, below: Array) -> float:
    """Return twice the distance from a plane of the nearer one of two sets of points; negative if it cuts one [m]."""
    up, down = (above @ plane.normal).min() - plane.distance, plane.distance - (below @ plane.normal).max()
    return 2.0 * float(min(up, down))


def _side(face: Array, points: Array) -> int:
    """Return 1 if points (n, 3) are above the plane of a face, -1 if below, 0 if it cuts them."""
    heights = points @ face[:3] - face[3]
    return int(heights.min() >= -ON) - int(heights.max() <= ON)
