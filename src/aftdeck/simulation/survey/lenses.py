"""Search for lenses that are inside a part at any step of a run, for ``aftdeck check`` and tests."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array, Mask
from aftdeck.bodies.cameras import setting, view
from aftdeck.bodies.hexahedron import NX, D
from aftdeck.files import Problem
from aftdeck.matrices import product
from aftdeck.scenario.all_cameras import cameras_of
from aftdeck.scenario.model import Scenario
from aftdeck.scenario.payload import PART
from aftdeck.simulation.camera_drives import Views
from aftdeck.simulation.constants.site import all_solids, site_of
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from aftdeck.worksite.conditions import quantity_text


class Inside(NamedTuple):
    """Time for which a lens was inside a part.

    Attributes:
        camera: name of the camera.
        part: name of the part.
        seconds: sum of the steps at whose ends the lens was inside the part [s].
        first: end of the first of these steps [s].
        depth: greatest depth below the nearest face of the part's solid [m].
    """

    camera: str
    part: str
    seconds: float
    first: float
    depth: float


class Lenses:
    """Lenses of a scenario's television cameras and eyes behind its windows, among all solids.

    A lens may be inside the part that contains it by design (`Camera.housing`).
    """

    def __init__(self, scenario: Scenario) -> None:
        layout, solids = site_of(scenario).layout, all_solids(scenario)
        self.cameras = tuple(camera for camera in cameras_of(scenario) if camera.kind != "engineering")
        self.parts = tuple(solid.part for solid in solids)
        self._driven = tuple(camera.name for camera in cameras_of(scenario) if camera.drive is not None)
        bodies = {body.name: body for body in scenario.worksite.bodies}
        self._rows, self._mounts = [], []
        for camera in self.cameras:
            body = bodies.get(camera.body)
            self._rows.append(layout.frames.index(body.fixed_to if body else camera.body))
            self._mounts.append(body.pose if body else None)
        own = np.array([[part == camera.housing for part in self.parts] for camera in self.cameras])
        self._others = ~own.reshape(len(self.cameras), len(solids))
        self._attached = np.array([scenario.payload is not None and part == PART for part in self.parts])
        self._frame, self._normals = layout.frame, layout.solids[:, NX:D].reshape(-1, 3, 6)
        self._distances = layout.solids[:, D : D + 6]
        self._seen: tuple[Views, Array] | None = None

    def depths(self, frames: Array, views: Views, *, attached: bool) -> Array:
        """Return the depth (c, s) of each lens in each solid [m]; negative outside, and where it is inside by design.

        Args:
            frames: (F, 12) poses of all frames.
            views: settings of the cameras' drives.
            attached: whether the payload of the scenario itself exists.
        """
        at = frames[self._rows]
        lenses = at[:, :3] + np.einsum("cij,cj->ci", at[:, 3:].reshape(-1, 3, 3), self._positions(views))
        homes = frames[self._frame]
        away = lenses[:, None] - homes[None, :, :3]
        local = np.einsum("csi,sij->csj", away, homes[:, 3:].reshape(-1, 3, 3))
        depths = (self._distances - np.einsum("csj,sjk->csk", local, self._normals)).min(axis=2)
        counted: Mask = self._others if attached else self._others & ~self._attached
        return np.where(counted, depths, -np.inf)

    def _positions(self, views: Views) -> Array:
        """Return the positions (c, 3) of the lenses in the frames that carry the cameras' bodies."""
        if self._seen is None or self._seen[0] is not views:
            found = np.empty((len(self.cameras), 3))
            for row, camera, pose in zip(found, self.cameras, self._mounts, strict=True):
                own = views[self._driven.index(camera.name)] if camera.drive is not None else setting(camera)
                row[:] = view(camera, own).position
                if pose is not None:
                    row[:] = product(pose.rotation, row) + pose.position
            self._seen = views, found
        return self._seen[1]


def lenses_along(sim: Simulation, inputs: Callable[[Simulation], Inputs | None] | None = None) -> tuple[Inside, ...]:
    """Fly a simulation to its end, and return the times for which lenses were inside parts.

    `inputs` returns the inputs of a step, or None to end the flight; without it, the script flies.
    """
    lenses, period = Lenses(sim.scenario), sim.scenario.control_period
    found: dict[tuple[str, str], Inside] = {}
    while not sim.ended:
        given = None if inputs is None else inputs(sim)
        if given is None and inputs is not None:
            break
        frame = sim.step(given)
        depths = lenses.depths(sim._state.worksite.frames, frame.views, attached=frame.attached == 1)
        inside: dict[tuple[str, str], float] = {}
        for c, s in np.argwhere(depths >= 0.0).tolist():
            pair = lenses.cameras[c].name, lenses.parts[s]
            inside[pair] = max(inside.get(pair, 0.0), float(depths[c, s]))
        for pair, depth in inside.items():
            before = found.get(pair, Inside(*pair, 0.0, frame.time_s, depth))
            found[pair] = before._replace(seconds=before.seconds + period, depth=max(before.depth, depth))
    return tuple(found.values())


def lenses_in_script(scenario: Scenario) -> Iterator[Problem]:
    """Yield one problem for each camera and each part that contains its lens while the script runs."""
    if not scenario.phases:
        return
    for inside in lenses_along(Simulation(scenario, digests=False)):
        deep = quantity_text(inside.depth, "m", scenario.arm.model.units)
        what = (
            f"camera {inside.camera} is inside {inside.part} for {inside.seconds:.4g} s of the script, first at "
            f"{inside.first:.4g} s, by up to {deep}"
        )
        yield Problem(("phase",), what)


def without_housing(scenario: Scenario) -> Iterator[Problem]:
    """Yield one problem for each camera and each eye behind a window that no part contains by design."""
    parts = {solid.part for solid in all_solids(scenario)}
    for camera in cameras_of(scenario):
        if camera.kind != "engineering" and camera.housing not in parts:
            what = f"camera {camera.name} has no housing: it is inside no part, and its drive has no housing"
            yield Problem(("worksite",), what)
