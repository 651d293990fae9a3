"""The cameras of a scenario, its worksite's and its arm's, in the order in which the station lists them."""

from __future__ import annotations

from functools import lru_cache

from aftdeck.arms.load import ArmModel
from aftdeck.arms.shapes import shapes_of
from aftdeck.bodies.cameras import KINDS, Camera
from aftdeck.scenario.model import Scenario
from aftdeck.worksite.check import ARM


def cameras_of(scenario: Scenario) -> tuple[Camera, ...]:
    """Television cameras first, then windows, then what only an engineer sees.

    A worksite's cameras on a cargo are there where the cargo is, those on a frame of the arm's where the arm has it.
    """
    model = scenario.arm.model
    absent = {cargo.name for cargo in scenario.worksite.cargoes} - {cargo.name for cargo in scenario.cargo}
    cameras = scenario.worksite.cameras + _on_the_arm(model)
    there = [
        camera
        for camera in cameras
        if camera.body not in absent and (not camera.body.startswith(ARM) or camera.body in model.frames)
    ]
    return tuple(sorted(there, key=lambda camera: KINDS.index(camera.kind)))


@lru_cache(maxsize=8)
def _on_the_arm(model: ArmModel) -> tuple[Camera, ...]:
    """Kept, since a state is made anew with each part of a problem, and reading a file of shapes takes long."""
    return shapes_of(model).cameras
