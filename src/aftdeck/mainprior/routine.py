"""Priority routine of a scenario: for each frame and station point, what MAINPRIOR makes of it.

It is beside `visual`, which draws: it has the report's clusters, lists, trees and planes, and nothing else to decide
by. `proof.py` tells where its planes do not separate.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable
from typing import NamedTuple

import numpy as np

from aftdeck.historical.rms_vs_output import Planes
from aftdeck.mainprior.fit import Fitted, fitted
from aftdeck.mainprior.fixed import FixedBodies
from aftdeck.mainprior.lists import fitted_list, report_list
from aftdeck.mainprior.planes import Plane, planes_of
from aftdeck.mainprior.proof import FIXED, Prover, Unproved
from aftdeck.mainprior.received import planes_in
from aftdeck.mainprior.shapes import Shapes, Stage
from aftdeck.mainprior.stations import links_of, station_of
from aftdeck.mainprior.tables import CLUSTERS, Item, System
from aftdeck.mainprior.trace import Instruction, output_table, traced
from aftdeck.mainprior.vectors import Vectors, vectors
from aftdeck.scenario.model import Scenario
from aftdeck.scene.cameras import SceneCameras
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.payloads.task_phases import ACQUISITION
from aftdeck.simulation.run import Simulation
from aftdeck.visual.lists import hidden
from aftdeck.visual.scene import VisualScene
from aftdeck.visual.store import Polyhedron, store_of


class Priority(NamedTuple):
    """What the routine makes of a frame for a station point.

    Attributes:
        mode: the task phase.
        items: the permanent list.
        vectors: L and P vectors.
        planes: the planes, by name; one of D1 to D3 that was never received is absent.
        clusters: numbers of the clusters, highest priority first.
        table: the priority output table.
        stage: the frame in R.
    """

    mode: int
    items: tuple[Item, ...]
    vectors: Vectors
    planes: dict[str, Plane]
    clusters: tuple[int, ...]
    table: tuple[Instruction, ...]
    stage: Stage


class PriorityRoutine:
    """The report's priority routine for a scenario.

    Attributes:
        shapes: the numbered clusters.
        fit: the trees for their shapes.
    """

    def __init__(self, scenario: Scenario, scene: VisualScene) -> None:
        """Make the trees.

        Raises:
            InputError: the routine does not know the scenario's arm or one of its parts.
        """
        self.shapes = Shapes(scenario, scene)
        self._scenario, self._cameras = scenario, SceneCameras(scenario)
        self._first = Simulation(scenario).look()
        self._start = self.shapes.stage(self._first)
        self.fit: Fitted = fitted(FixedBodies(scenario, self.shapes, self._start))
        self._lists: dict[str, tuple[Item, ...]] = {}

    def items(self, station: str) -> tuple[Item, ...]:
        """Return the permanent list of a station point, for the shapes of the scenario.

        Raises:
            InputError: the camera is not a station point, or its list would be a circle.
        """
        if station not in self._lists:
            at = station_of(self._scenario, self._cameras, self._first, station, self._start)
            eye = vectors(at, links_of(self._scenario, self._first, self._start), self._first.work.task).eye
            self._lists[station] = fitted_list(station, -eye["LR"], self._fixed(), self.fit.trees)
        return self._lists[station]

    def report_items(self, station: str) -> tuple[Item, ...]:
        """Return TABLE VII's own list of a station point; errors as for `items`."""
        self.items(station)  # raises an error if the camera is not a station point
        return report_list(station, self._fixed())

    def priority(
        self, frame: Frame, station: str, received: Planes | None = None, items: tuple[Item, ...] | None = None
    ) -> Priority:
        """Return what the routine makes of a frame.

        Args:
            frame: the frame.
            station: camera A to I.
            received: D1 to D3, as the scene program has them; None to compute them from the frame.
            items: the permanent list; None for the one for the shapes of the scenario.

        Raises:
            InputError: the camera is not a station point.
        """
        stage, mode = self.shapes.stage(frame), frame.work.task
        at = vectors(
            station_of(self._scenario, self._cameras, frame, station, stage),
            links_of(self._scenario, frame, stage),
            mode,
        )
        planes = planes_of(
            self.fit.planes,
            stage.systems,
            planes_in(stage, mode != ACQUISITION) if received is None else received,
        )

        def on_true_side(name: str, system: System) -> bool:
            plane = planes.get(name)
            return plane is not None and plane.height(at.eye[system]) > 0.0

        items = self.items(station) if items is None else items
        clusters = tuple(traced(items, self.fit.trees, mode, on_true_side))
        table = output_table(clusters, {number: own.system for number, own in CLUSTERS.items()})
        return Priority(mode, items, at, planes, clusters, table, stage)

    def unproved(self, found: Priority, shown: Collection[int]) -> tuple[Unproved, ...]:
        """Return the orders that no plane of the routine proves, among the numbers `shown` of clusters in a picture.

        A pair of which neither can hide the other from the eye, in any direction of view, needs no order.
        """
        clusters = [k for k in found.clusters if k in shown]
        bodies = self._polyhedra(found.stage, clusters)
        hides = hidden(store_of([bodies[k] for k in clusters]), np.arange(len(clusters)), -found.vectors.eye["LR"])
        pairs = [(clusters[a], clusters[b]) for a, b in np.argwhere(np.triu(hides | hides.T)).tolist()]
        prover = Prover(found.stage, found.planes, found.vectors.eye)
        return tuple(prover.unproved(pairs, found.items, self.fit.trees, found.mode))

    def _fixed(self) -> dict[int, Polyhedron]:
        """Return the clusters in R at the start; a CAE in ``space`` is among them."""
        return self._polyhedra(self._start, (k for k in self._start.bodies if CLUSTERS[k].system in FIXED))

    def _polyhedra(self, stage: Stage, numbers: Iterable[int]) -> dict[int, Polyhedron]:
        """Return clusters of a frame in R, by number."""
        clusters, index = self.shapes.scene.clusters.clusters, self.shapes.index
        return {
            k: Polyhedron(stage.bodies[k].points, stage.bodies[k].faces, clusters[index[k]].body.loops) for k in numbers
        }
