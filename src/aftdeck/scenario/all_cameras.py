"""Cameras of a scenario's worksite and arm, in the order in which the station lists them."""

from __future__ import annotations

from functools import lru_cache

from aftdeck.arms.load import ArmModel
from aftdeck.arms.shapes import shapes_of
from aftdeck.bodies.cameras import KINDS, Camera, Setting, setting
from aftdeck.scenario.model import Scenario
from aftdeck.worksite.file.check import ARM
from aftdeck.worksite.model import Worksite
from aftdeck.worksite.payload import Payload


def cameras_of(scenario: Scenario) -> tuple[Camera, ...]:
    """Return a scenario's cameras: television cameras first, then windows, then views for engineers only."""
    return present_cameras(scenario.arm.model, scenario.worksite, scenario.payloads)


def first_setting(scenario: Scenario, camera: Camera) -> Setting:
    """Return the setting of a camera's drive at the start of a scenario."""
    return scenario.camera_settings.get(camera.name) or setting(camera)


def present_cameras(model: ArmModel, worksite: Worksite, payloads: tuple[Payload, ...]) -> tuple[Camera, ...]:
    """Return the cameras of an arm and a worksite with these payloads, in the order of `cameras_of`.

    A camera on a payload of the worksite is included if the payload is present. A camera on a frame of the arm is
    included if the arm has that frame.
    """
    absent = {payload.name for payload in worksite.payloads} - {payload.name for payload in payloads}
    cameras = worksite.cameras + _on_the_arm(model)
    present = [
        camera
        for camera in cameras
        if camera.body not in absent and (not camera.body.startswith(ARM) or camera.body in model.frames)
    ]
    return tuple(sorted(present, key=lambda camera: KINDS.index(camera.kind)))


@lru_cache(maxsize=8)
def _on_the_arm(model: ArmModel) -> tuple[Camera, ...]:
    """Return the arm's cameras.

    The result is cached, because every re-initialisation needs the cameras, and reading the arm's shapes is slow.
    """
    return shapes_of(model).cameras
