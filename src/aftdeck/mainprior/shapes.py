"""The report's numbered clusters as convex bodies of a scenario, in their own systems and in R."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.cameras import housing_of
from aftdeck.errors import InputError
from aftdeck.historical.words_file import check_arm
from aftdeck.mainprior.systems import Placed, in_reference, systems_at
from aftdeck.mainprior.tables import CLUSTERS, System
from aftdeck.matrices import product
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Frame
from aftdeck.visual.scene import VisualScene

STAND, TELESCOPE, BODY, BAR = 12, 26, 20, 19
"""Clusters: the sleeve of the vertical arm, and the tube that slides in it; body and bar of the payload."""


class Body(NamedTuple):
    """Convex body of a cluster.

    Attributes:
        points: (n, 3) vertices [m].
        faces: (f, 4) outward unit normal and distance of each face [m].
    """

    points: Array
    faces: Array

    def moved(self, to: Placed) -> Body:
        """Return the body in the system in which `to` is the pose of its own system."""
        normals = product(self.faces[:, :3], to.axes.T)
        return Body(to.outside(self.points), np.column_stack([normals, self.faces[:, 3] + product(normals, to.origin)]))

    def within(self, system: Placed) -> Body:
        """Return the body of R in a system."""
        normals = product(self.faces[:, :3], system.axes)
        away = self.faces[:, 3] - product(self.faces[:, :3], system.origin)
        return Body(system.within(self.points), np.column_stack([normals, away]))


class Stage(NamedTuple):
    """Everything in a frame, in R.

    Attributes:
        systems: the coordinate systems.
        bodies: the bodies of the clusters, by number.
        frames: all frames of the scene, by name.
    """

    systems: dict[System, Placed]
    bodies: dict[int, Body]
    frames: dict[str, Placed]


class Shapes:
    """Numbered clusters of a scenario.

    Attributes:
        index: for each number that the scenario has, the index of its cluster in the visual scene.
        scene: the visual scene.
        left_out: parts of the visual scene that the routine does not know: the housings of cameras. The report's
            cameras are points.
    """

    def __init__(self, scenario: Scenario, scene: VisualScene) -> None:
        """Number the clusters.

        Raises:
            InputError: the arm is not the report's arm, the scenario has more than one payload, or a part is not one
                of the report's, or is not convex.
        """
        check_arm(scenario)
        name = _payload(scenario)
        parts = {own.part.format(payload=name): number for number, own in CLUSTERS.items()}
        self.index: dict[int, int] = {}
        self.left_out = frozenset(housing_of(camera) for camera in scene.cameras)
        for k, cluster in enumerate(scene.clusters.clusters):
            if cluster.part in self.left_out:
                continue
            number = parts.get(cluster.part)
            if number is None or number in self.index:
                raise InputError(
                    f"{scenario.name}: {cluster.part!r} "
                    + ("is not one convex body" if number is not None else "has no number among the report's clusters")
                    + f"; the report's priority routine knows one convex body for each of {', '.join(parts)}"
                )
            self.index[number] = k
        self._scenario, self.scene = scenario, scene
        if BODY in self.index and (BAR not in self.index or scenario.worksite.bay is None):
            raise InputError(
                f"{scenario.name}: the report's priority routine needs a payload with a bar, in a worksite with a bay"
            )

    @property
    def numbers(self) -> dict[int, int]:
        """Number of each cluster of the visual scene, by its index there."""
        return {k: number for number, k in self.index.items()}

    def part(self, number: int) -> str:
        """Return the name of a cluster's part."""
        return self.scene.clusters.clusters[self.index[number]].part

    def stage(self, frame: Frame) -> Stage:
        """Return all systems and clusters of a frame in R."""
        frames = in_reference(self._scenario, self.scene, frame)
        bodies = {}
        for number, k in self.index.items():
            cluster = self.scene.clusters.clusters[k]
            bodies[number] = Body(cluster.body.points, cluster.body.planes).moved(frames[cluster.frame])
        bodies[TELESCOPE] = out_of(bodies[TELESCOPE], bodies[STAND])
        return Stage(systems_at(self._scenario, frames), bodies, frames)


def _payload(scenario: Scenario) -> str:
    """Return the name of the scenario's payload; a name that no part has if there is none."""
    if scenario.payload is not None or len(scenario.payloads) > 1:
        count = "a fixed one" if scenario.payload is not None else len(scenario.payloads)
        raise InputError(
            f"{scenario.name}: the report's priority routine knows one payload, which the arm acquires; the scenario "
            f"has {count}"
        )
    return scenario.payloads[0].name if scenario.payloads else "no payload"


def out_of(tube: Body, sleeve: Body) -> Body:
    """Return the part of the telescope that is above STAND, in R (Z down)."""
    top = float(sleeve.points[:, 2].min())
    points, faces = tube.points.copy(), tube.faces.copy()
    points[:, 2] = np.minimum(points[:, 2], top)
    faces[faces[:, 2].argmax(), 3] = top  # the lower end
    return Body(points, faces)


def joined(bodies: list[Body]) -> Body:
    """Return the vertices and the faces of several bodies as one; its faces bound no common body."""
    return Body(np.concatenate([b.points for b in bodies]), np.concatenate([b.faces for b in bodies]))
