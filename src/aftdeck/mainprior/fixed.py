"""Clusters as they are fixed in the report's systems: with the whole space that they take up in a system."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from typing import Final

import numpy as np

from aftdeck.arrays import Array
from aftdeck.mainprior.shapes import STAND, TELESCOPE, Body, Shapes, Stage, joined, out_of
from aftdeck.mainprior.systems import Placed
from aftdeck.mainprior.tables import CLUSTERS, System
from aftdeck.matrices import lengths
from aftdeck.scenario.model import Scenario

PRONG = 18
"""Cluster whose vertices the scene program moves along Y of system 2."""
PINS: Final[dict[int, tuple[System, ...]]] = {23: ("L0", "L1"), 24: ("L1", "L2")}
"""Housings about a pin, and the systems of the two links that the pin joins."""
IN_BAY = (20, 11)
"""Clusters that are in the bay while the shuttle's tree contains them."""
_NO_FACES = np.empty((0, 4))
_CUBE: Final = np.array([[x, y, z] for x in (-1.0, 1.0) for y in (-1.0, 1.0) for z in (-1.0, 1.0)])


class FixedBodies:
    """Clusters of a scenario, fixed in the report's systems.

    The telescope and the prong are there at both ends of their travel. A housing about a pin is in the systems of both
    links, as the box around the sphere in which it turns. The payload's body and probe are in R too, as the inside of
    the bay.

    Attributes:
        present: numbers of all clusters of the scenario.
    """

    def __init__(self, scenario: Scenario, shapes: Shapes, start: Stage) -> None:
        """Fix the clusters; `start` is the scenario's start."""
        self.present: Collection[int] = frozenset(start.bodies)
        self._bodies: dict[tuple[System, int], Body] = {}
        for number, body in start.bodies.items():
            system = CLUSTERS[number].system
            self._bodies[system, number] = body.within(start.systems[system])
        for number, ends in _travels(scenario).items():
            surface = shapes.scene.clusters.clusters[shapes.index[number]].body
            body = Body(surface.points, surface.planes)
            moved = [body.moved(Placed(end, np.eye(3))) for end in ends]
            if number == TELESCOPE:
                moved = [out_of(part, start.bodies[STAND]) for part in moved]
            self._bodies[CLUSTERS[number].system, number] = joined(moved)
        for number, systems in PINS.items():
            own = CLUSTERS[number].system
            radius = float(lengths(start.bodies[number].points - start.systems[own].origin).max())
            for system in systems:
                if system != own:
                    pin = start.systems[system].within(start.systems[own].origin)
                    self._bodies[system, number] = Body(pin + radius * _CUBE, _NO_FACES)
        bay = scenario.worksite.bay
        for number in IN_BAY:
            if number in self.present and bay is not None:
                corners = np.where(_CUBE > 0.0, np.array(bay.high), np.array(bay.low))
                self._bodies["LR", number] = Body(start.frames["orbiter"].outside(corners), _NO_FACES)

    def within(self, system: System, numbers: Iterable[int]) -> list[Body]:
        """Return the bodies of clusters that are fixed in a system."""
        return [self._bodies[system, k] for k in numbers if (system, k) in self._bodies]


def _travels(scenario: Scenario) -> dict[int, tuple[Array, Array]]:
    """Return both ends (3,) of the travel of telescope and prong, in the system that carries them [m]."""
    telescope, prong = scenario.arm.model.telescope, scenario.arm.model.prong
    assert telescope is not None and prong is not None  # `shapes` accepts no other arm
    heights, openings = (telescope.least, telescope.greatest), (prong.least, prong.greatest)
    return {
        TELESCOPE: (np.array([0.0, 0.0, -heights[0]]), np.array([0.0, 0.0, -heights[1]])),
        PRONG: (np.array([0.0, openings[0], 0.0]), np.array([0.0, openings[1], 0.0])),
    }
