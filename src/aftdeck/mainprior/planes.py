"""Separating planes of a frame: those fixed in a system, SP 11 and SP 12, and D1 to D3 from the collision program."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array
from aftdeck.historical.rms_vs_output import Planes
from aftdeck.mainprior.systems import Placed
from aftdeck.mainprior.tables import BISECTING, RECEIVED, System, system_of
from aftdeck.matrices import length, product


class Plane(NamedTuple):
    """Separating plane: the points P with N . P = D. Its TRUE side is the one to which the normal points.

    Attributes:
        system: system in which it is tested.
        normal: (3,) unit normal N.
        distance: D [m].
    """

    system: System
    normal: Array
    distance: float

    def height(self, away: Array) -> float:
        """Return the height of the eye over the plane [m]; positive on the TRUE side. `away` (3,) is the L vector."""
        return float(product(self.normal, -away)) - self.distance

    def heights(self, points: Array, systems: Mapping[System, Placed]) -> Array:
        """Return the heights (n,) of points (n, 3) of R over the plane [m]."""
        return product(systems[self.system].within(points), self.normal) - self.distance


def planes_of(fixed: Mapping[str, Plane], systems: Mapping[System, Placed], received: Planes) -> dict[str, Plane]:
    """Return all planes of a frame, by name; one of D1 to D3 that was never received is absent.

    Args:
        fixed: the planes that are fixed in their systems.
        systems: the systems in R.
        received: D1 to D3 in R.
    """
    found = dict(fixed)
    for name, (first, second) in zip(BISECTING, (("L0", "L1"), ("L1", "L2")), strict=True):
        found[name] = _bisector(system_of(name), systems[first], systems[second])  # type: ignore[index]
    for name, plane in zip(RECEIVED, received, strict=True):
        if plane is not None:
            found[name] = Plane("LR", np.array(plane.normal), plane.distance)
    return found


def _bisector(system: System, first: Placed, second: Placed) -> Plane:
    """Return the plane through the pin of two links that bisects their angle (Figure 14): N is the sum of their X axes.

    The pin is the origin of the second link's system, in which the plane is tested.
    """
    normal = product(second.axes.T, first.axes[:, 0]) + np.array([1.0, 0.0, 0.0])
    return Plane(system, normal / length(normal.tolist()), 0.0)
