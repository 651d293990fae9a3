"""Cameras: what their drives do to the view, and what a file may not say of them."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from aftdeck.bodies.camera_file import CameraFile, DriveFile, TravelFile, cameras_of
from aftdeck.bodies.cameras import Camera, Drive, Setting, Vec3, setting, square, view
from aftdeck.files import Problem
from aftdeck.units import Angle, AngularRate, Length

directions = st.tuples(*[st.floats(-1.0, 1.0)] * 3).filter(lambda v: math.hypot(*v) > 0.1)


def apart(a: Vec3, b: Vec3) -> float:
    """Sine of the angle between two directions."""
    return float(np.linalg.norm(np.cross(a, b))) / math.hypot(*a) / math.hypot(*b)


def camera(boresight: Vec3, up: Vec3, zero: Vec3, lens: float = 0.2) -> Camera:
    drive = Drive(square(zero, up), lens, None, None, None)
    return Camera("T", "Test", "orbiter", (1.0, 2.0, 3.0), boresight, up, 1.0, drive)


@given(boresight=directions, up=directions, zero=directions)
def test_the_setting_at_the_start_gives_the_view_at_the_start(boresight: Vec3, up: Vec3, zero: Vec3) -> None:
    assume(apart(boresight, up) > 1e-3 and apart(zero, up) > 1e-3)
    shot = camera(boresight, up, zero)
    seen = view(shot, setting(shot))
    assert seen.position == pytest.approx(shot.position, abs=1e-12)
    assert seen.boresight == pytest.approx(np.array(boresight) / math.hypot(*boresight), abs=1e-9)


@given(pan=st.floats(-3.1, 3.1), tilt=st.floats(-1.5, 1.5), up=directions, zero=directions)
def test_a_view_is_that_of_its_setting(pan: float, tilt: float, up: Vec3, zero: Vec3) -> None:
    assume(apart(zero, up) > 1e-3)
    shot = camera(zero, up, zero)
    seen = view(shot, Setting(pan, tilt, 0.5))
    assert np.dot(seen.boresight, seen.up) == pytest.approx(0.0, abs=1e-12)
    pivot = np.array(view(shot, setting(shot)).position) - 0.2 * np.array(view(shot, setting(shot)).boresight)
    assert np.array(seen.position) - pivot == pytest.approx(0.2 * np.array(seen.boresight), abs=1e-12)
    drive = Drive(square(zero, up), 0.2, None, None, None)
    again = setting(Camera("T", "Test", "orbiter", seen.position, seen.boresight, up, 0.5, drive))
    assert again == pytest.approx((pan, tilt, 0.5), abs=1e-9)


def test_pan_turns_to_the_right_and_tilt_upwards() -> None:
    ahead = camera((1.0, 0.0, 0.0), (0.0, 0.0, 1.0), (1.0, 0.0, 0.0))
    assert view(ahead, Setting(math.pi / 2, 0.0, 1.0)).boresight == pytest.approx((0.0, -1.0, 0.0), abs=1e-15)
    up = view(ahead, Setting(0.0, math.pi / 2, 1.0))
    assert up.boresight == pytest.approx((0.0, 0.0, 1.0), abs=1e-15)
    assert up.up == pytest.approx((-1.0, 0.0, 0.0), abs=1e-15)


def listed(drive: str | None, boresight: Vec3 = (1.0, 0.0, 0.0)) -> CameraFile:
    place = (Length(0.0), Length(0.0), Length(0.0))
    return CameraFile(
        "T", "Test", "orbiter", place, boresight, (0.0, 0.0, 1.0), Angle(1.0), "assumed", drive, (1, 0, 0)
    )


UNIT = DriveFile("unit", "assumed", pan=TravelFile(Angle(-0.5), Angle(0.5), AngularRate(0.1)))


def test_a_camera_that_starts_outside_of_its_drives_ranges_is_refused() -> None:
    cameras, problems = cameras_of([listed("unit"), listed("unit", (1.0, -1.0, 0.0)), listed("other")], [UNIT])
    assert [setting(one).pan for one in cameras] == [0.0]
    assert problems == [
        Problem(
            ("camera", 1), "camera T starts with a pan of 0.7854 rad; the range of drive 'unit' is -0.5 to 0.5 rad"
        ),
        Problem(("camera", 2), "camera T: no drive 'other'; there are: unit"),
    ]


def test_a_drive_without_a_way_to_go_is_refused() -> None:
    with pytest.raises(ValueError, match="least is 1 and greatest is 1; least has to be less"):
        TravelFile(Angle(1.0), Angle(1.0), AngularRate(0.1))
    with pytest.raises(ValueError, match="rate is 0; it has to be above 0"):
        TravelFile(Angle(0.0), Angle(1.0), AngularRate(0.0))
