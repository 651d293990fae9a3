"""Settings that a scenario gives to its cameras for the start."""

from __future__ import annotations

import math
import re
from pathlib import Path

import pytest

from aftdeck.bodies.cameras import Camera, setting
from aftdeck.errors import ScenarioError
from aftdeck.scenario.all_cameras import cameras_of, first_setting
from aftdeck.scenario.load import load_scenario, parse_scenario
from aftdeck.scenario.model import Scenario

HEAD = 'title = "t"\n[initial]\njoints = [0, 1, -1, 0, 0, 0]\n[cameras]\n'


def scenario(text: str) -> Scenario:
    return parse_scenario(HEAD + text, "a", "a.toml", Path())


def camera(aimed: Scenario, name: str) -> Camera:
    (found,) = (camera for camera in cameras_of(aimed) if camera.name == name)
    return found


def test_given_angles_replace_those_of_the_camera() -> None:
    aimed = scenario('B = { pan = "10 deg", tilt = -0.1, zoom = "40 deg" }')
    pan, tilt, zoom = first_setting(aimed, camera(aimed, "B"))
    assert tilt == -0.1
    assert (pan, zoom) == pytest.approx((math.radians(10.0), math.radians(40.0)), abs=1e-15)


def test_an_angle_that_is_not_given_is_the_camera_s_own() -> None:
    aimed = scenario('B.tilt = 0.25\nKEEL.zoom = "77 deg"')
    own = setting(camera(aimed, "B"))
    assert first_setting(aimed, camera(aimed, "B")) == own._replace(tilt=0.25)
    for name in ("A", "C", "ELB", "WR", "ENG", "AFT P"):
        assert first_setting(aimed, camera(aimed, name)) == setting(camera(aimed, name))


def test_an_angle_at_the_end_of_the_drive_is_accepted() -> None:
    aimed = scenario('B = { pan = "170 deg", tilt = "-170 deg", zoom = "9 deg" }')
    drive = camera(aimed, "B").drive
    assert drive is not None and drive.pan is not None and drive.tilt is not None and drive.zoom is not None
    assert first_setting(aimed, camera(aimed, "B")) == (drive.pan.greatest, drive.tilt.least, drive.zoom.least)


def test_a_change_aims_a_camera_that_the_file_does_not_aim() -> None:
    aimed = load_scenario("uncradle", {"cameras.B.tilt": "30 deg"})
    assert aimed.camera_settings["B"].tilt == pytest.approx(math.radians(30.0))
    assert not load_scenario("uncradle").camera_settings


@pytest.mark.parametrize(
    ("text", "pattern"),
    [
        ("Q.pan = 0", r"cameras\.Q: no camera 'Q': cameras with a drive are A, B, C, D, KEEL, ELB, WR$"),
        ("ENG.zoom = 1", r"cameras\.ENG: camera 'ENG' has no drive: cameras with a drive are A, B, .* WR$"),
        ("KEEL.pan = 0", r"cameras\.KEEL\.pan: this camera's drive has no pan, only zoom$"),
        ('B.tilt = "171 deg"', r"cameras\.B\.tilt: got 171 deg, expected -170 to 170 deg, the range of .* drive$"),
        ('B.zoom = "8 deg"', r"cameras\.B\.zoom: got 8 deg, expected 9 to 77 deg, the range of this camera's drive$"),
        ('B.pan = "3 ft"', r"cameras\.B\.pan: '3 ft' is not an angle"),
        ("B.roll = 1", r"cameras\.B\.roll: unknown field; allowed here: pan, tilt, zoom$"),
        ("B.pan = 100", r"cameras\.B\.pan: got 100 rad; expected -62\.84 to 62\.84 rad"),
        ("B = {}", r"cameras\.B: give at least one of pan, tilt, zoom$"),
        ("B = 3", r"cameras\.B: expected a table, got 3$"),
    ],
)
def test_a_wrong_setting_is_rejected_with_its_line_and_what_is_allowed(text: str, pattern: str) -> None:
    with pytest.raises(ScenarioError) as caught:
        scenario(text)
    (problem,) = caught.value.problems
    assert problem.startswith("a.toml:5: ")
    assert re.search(pattern, problem)


def test_all_wrong_settings_are_reported_together() -> None:
    with pytest.raises(ScenarioError) as caught:
        scenario('B = { pan = 3, tilt = "up" }\nQ.pan = 0')
    assert len(caught.value.problems) == 3


def test_a_payload_s_camera_cannot_be_aimed_without_the_payload() -> None:
    with pytest.raises(ScenarioError, match="no camera 'P1'"):
        load_scenario("free-flyer", {"cameras.P1.pan": 0.1})
    assert load_scenario("concept-1972", {"cameras.P1.pan": 0.1}).camera_settings["P1"].pan == 0.1
