"""Pictures of a task's steps that are turned against the sticks."""

from __future__ import annotations

import math
import re
from pathlib import Path

import numpy as np
import pytest

from aftdeck.scenario.all_cameras import cameras_of
from aftdeck.scenario.load import built_in, load_scenario
from aftdeck.task.step_cameras import CROSSED, StepCameras, turned_pictures
from tests.loaded import scenario


@pytest.mark.parametrize("name", built_in())
def test_built_in_steps_show_no_picture_that_is_turned_against_the_sticks(name: str) -> None:
    assert not list(turned_pictures(scenario(name)))


def test_the_page_and_the_check_avoid_the_same_angle() -> None:
    rule = Path(__file__).parents[2] / "web" / "src" / "cameras" / "best-pair.ts"
    (degrees,) = re.findall(r"CROSSED = \((\d+) \* Math\.PI\) / 180", rule.read_text(encoding="utf-8"))
    assert math.radians(float(degrees)) == CROSSED


def test_a_turned_picture_is_named_with_its_step_and_its_angle() -> None:
    tutorial = load_scenario("tutorial", {("step", 2, "cameras"): ["A", "WR"]})
    (found,) = turned_pictures(tutorial)
    assert found.where == ("step", 2, "cameras") and "camera A" in found.what
    assert f"{math.degrees(StepCameras(tutorial).turned(tutorial.steps[2], 'A')):.0f}°" in found.what


@pytest.mark.parametrize("name", ["tutorial", "srms-deploy", "srms-berth", "concept-1972"])
def test_an_angle_is_at_most_half_a_turn_and_zero_along_the_wrist_camera(name: str) -> None:
    flown = scenario(name)
    cameras = StepCameras(flown)
    for step in flown.steps:
        angles = {camera.name: cameras.turned(step, camera.name) for camera in cameras_of(flown)}
        assert all(0.0 <= angle <= math.pi for angle in angles.values())
        if step.mode == "END EFF" and "WR" in angles:
            assert angles["WR"] == pytest.approx(0.0, abs=1e-3)


def test_pictures_of_two_fixed_cameras_differ_by_at_most_the_turn_between_them() -> None:
    """The angle from the sticks to a picture is a distance of rotations, so the triangle inequality holds."""
    flown = scenario("srms-deploy")
    cameras = StepCameras(flown)
    step = flown.steps[4]
    seen = {name: cameras._cameras.seen(cameras._start, cameras._bodies, name).axes for name in "ABCD"}
    for a in "ABCD":
        for b in "ABCD":
            between = math.acos(min(1.0, (float(np.trace(seen[a].T @ seen[b])) - 1.0) / 2.0))
            assert cameras.turned(step, a) <= cameras.turned(step, b) + between + 1e-9
    assert math.pi / 2 < CROSSED
