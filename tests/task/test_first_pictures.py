"""Pictures at the start of the built-in scenarios: the work is in them, with room at their edges."""

from __future__ import annotations

import math
from functools import cache

import numpy as np
import pytest

import aftdeck
from aftdeck.arrays import Array
from aftdeck.bodies.cameras import Camera
from aftdeck.scenario.all_cameras import cameras_of
from aftdeck.scenario.load import built_in
from aftdeck.scenario.target import AtBerth
from aftdeck.scene.cameras import SceneCameras, turn
from aftdeck.simulation.frame import Frame
from tests.loaded import scenario

ASPECT = 1.5
"""Width of a picture divided by its height, as in `web/src/scene/drawn.ts`; narrower pictures show more."""
ROOM = 0.85
"""Greatest distance of the work from a picture's centre, as a fraction of half the picture."""
FLOWN_M = 1.0
"""Distance that a newcomer flies upwards in `first-flight`, at least [m]."""


@cache
def start(name: str) -> Frame:
    return aftdeck.Simulation(scenario(name)).step(aftdeck.Inputs())


def edge(cameras: SceneCameras, frame: Frame, camera: str, point: Array) -> float:
    """Return how far a point (3,) of the scene is from a picture's centre: 1 at the picture's edge; inf behind it."""
    seen = cameras.seen(frame, cameras.bodies_at(frame), camera)
    right, down, ahead = (seen.axes @ (point - seen.position)).tolist()
    half = math.tan(0.5 * seen.view.field_of_view)
    return math.inf if ahead <= 0.0 else max(abs(right), ASPECT * abs(down)) / (half * ahead)


def tip(cameras: SceneCameras, frame: Frame) -> Array:
    return np.array(cameras.poses.point(frame.position))


def television(name: str) -> list[Camera]:
    """Return the television cameras that do not move with the arm."""
    flown = scenario(name)
    moved = {*flown.arm.model.frames, *(cargo.name for cargo in flown.payloads)}
    return [camera for camera in cameras_of(flown) if camera.kind == "camera" and camera.body not in moved]


@pytest.mark.parametrize("name", built_in())
def test_two_pictures_show_the_tip_at_the_start(name: str) -> None:
    """They are pictures of cameras that do not move with the arm, if there are any: a run in free space has none."""
    cameras, frame = SceneCameras(scenario(name)), start(name)
    distances = [edge(cameras, frame, camera.name, tip(cameras, frame)) for camera in television(name)]
    assert not distances or sorted(distances)[1] < ROOM


@pytest.mark.parametrize("name", ["concept-1972", "free-flyer", "srms-deploy"])
def test_cameras_of_a_step_show_the_berth_of_its_target(name: str) -> None:
    """All steps that name cameras move a payload to, or out of, a berth; one of the two pictures shows the berth."""
    flown, cameras, frame = scenario(name), SceneCameras(scenario(name)), start(name)
    seats = {seat.name: seat for seat in flown.worksite.berths}
    steps = [step for step in flown.steps if step.cameras]
    assert steps
    for step in steps:
        assert isinstance(step.target, AtBerth)
        berth = seats[step.target.berth].pose.position  # in the orbiter's frame or in space: at the start, the scene's
        assert min(edge(cameras, frame, camera, berth) for camera in step.cameras) < ROOM, step.title


def test_only_these_scenarios_have_steps_that_name_cameras() -> None:
    named = {name for name in built_in() if any(step.cameras for step in scenario(name).steps)}
    assert named == {"concept-1972", "free-flyer", "srms-deploy"}


@pytest.mark.parametrize("camera", ["B", "C"])
def test_first_flight_shows_the_wrist_after_a_metre_upwards(camera: str) -> None:
    sim, cameras = aftdeck.Simulation(scenario("first-flight")), SceneCameras(scenario("first-flight"))
    frame = first = sim.step(aftdeck.Inputs())
    for _ in range(1000):
        frame = sim.step(aftdeck.Inputs(translation=(0.0, 0.0, -1.0)))
        if tip(cameras, frame)[2] >= tip(cameras, first)[2] + FLOWN_M:
            break
    assert tip(cameras, frame)[2] >= tip(cameras, first)[2] + FLOWN_M
    bodies = cameras.bodies_at(frame)
    points = [tip(cameras, frame), *(pose[:3] for body, pose in bodies.items() if body.startswith("arm."))]
    assert max(edge(cameras, frame, camera, point) for point in points) < ROOM


@pytest.mark.parametrize("camera", ["B", "C", "KEEL"])
def test_singular_shows_the_tip_away_from_the_edge(camera: str) -> None:
    cameras, frame = SceneCameras(scenario("singular")), start("singular")
    assert edge(cameras, frame, camera, tip(cameras, frame)) < 0.75


@pytest.mark.parametrize("camera", ["H", "CAE2", "C", "W"])
def test_free_flyer_shows_tip_and_flyer(camera: str) -> None:
    cameras, frame = SceneCameras(scenario("free-flyer")), start("free-flyer")
    flyer = cameras.bodies_at(frame)["free flyer"][:3]
    assert max(edge(cameras, frame, camera, point) for point in (tip(cameras, frame), flyer)) < 0.95


@pytest.mark.parametrize("ahead_ft", [0.0, 0.5, 1.5])
def test_the_payload_s_camera_shows_its_probe_and_the_place_ahead_of_it(ahead_ft: float) -> None:
    """In the step before docking, the port is 1.5 ft ahead of the probe."""
    flown, cameras, frame = scenario("concept-1972"), SceneCameras(scenario("concept-1972")), start("concept-1972")
    (cargo,) = flown.payloads
    assert cargo.probe is not None
    body = cameras.bodies_at(frame)[cargo.name]
    point = cargo.probe.position - np.array([0.3048 * ahead_ft, 0.0, 0.0])
    assert edge(cameras, frame, "P1", turn(body) @ point + body[:3]) < ROOM
