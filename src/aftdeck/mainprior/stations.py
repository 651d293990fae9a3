"""Station points A to I in a frame: the eye, the display plane, and what V.B's equations need besides."""

from __future__ import annotations

import math

import numpy as np

from aftdeck.errors import InputError
from aftdeck.kinematics.linkage import L2, L3
from aftdeck.mainprior.shapes import Stage
from aftdeck.mainprior.systems import ARMS, Placed
from aftdeck.mainprior.tables import LISTS, System
from aftdeck.mainprior.vectors import Links, Station
from aftdeck.matrices import product
from aftdeck.scenario.model import Scenario
from aftdeck.scene.cameras import SceneCameras
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.payloads.task_phases import ACQUISITION


def station_of(scenario: Scenario, cameras: SceneCameras, frame: Frame, name: str, stage: Stage) -> Station:
    """Return a station point: in system 0 or 1 if ARM 0 or ARM 1 carries it, otherwise in R.

    Raises:
        InputError: the camera is not one of the report's station points, or the scenario does not have it.
    """
    if name not in LISTS:
        raise InputError(f"camera {name}: the report has a permanent list for each of the cameras {', '.join(LISTS)}")
    view = cameras.seen(frame, cameras.bodies_at(frame), name).view
    ahead, up = np.array(view.boresight), np.array(view.up)
    axes = np.array([ahead / math.tan(0.5 * view.field_of_view), -up, np.cross(ahead, up)])
    point, body = np.array(view.position), cameras.camera(name).body
    links = scenario.arm.model.linkage.frames
    carriers: tuple[System, ...] = ("L0", "L1")
    for system in carriers:
        if links[ARMS[system]] == body:
            return Station(system, point, axes)
    pose = stage.frames[body]
    return Station("LR", pose.outside(point), product(axes, pose.axes.T))


def links_of(scenario: Scenario, frame: Frame, stage: Stage) -> Links:
    """Return the angles and the vectors between the systems of a frame."""
    lengths, systems = scenario.arm.model.links, stage.systems
    payload = systems.get("LP")
    if payload is not None and frame.work.task != ACQUISITION:
        hand = systems["L2"]
        payload = Placed(hand.within(payload.origin), product(hand.axes.T, payload.axes))
    return Links(
        frame.angles,
        np.array([0.0, 0.0, -float(frame.work.stand or 0.0)]),
        np.array([float(lengths[L2]), 0.0, 0.0]),
        np.array([float(lengths[L3]), 0.0, 0.0]),
        payload,
        systems["LS"].origin if "LS" in systems else np.zeros(3),
    )
