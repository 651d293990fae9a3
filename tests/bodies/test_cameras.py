"""Cameras: the effect of their drives on the view, and the rejection of invalid files."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from aftdeck.bodies.camera_file import CameraFile, DriveFile, TravelFile, cameras_of
from aftdeck.bodies.cameras import Camera, Drive, Setting, setting, square, view
from aftdeck.tuples import Vec3
from aftdeck.units import Angle, AngularRate, Length

directions = st.tuples(*[st.floats(-1.0, 1.0)] * 3).filter(lambda v: math.hypot(*v) > 0.1)


def apart(a: Vec3, b: Vec3) -> float:
    """Return the sine of the angle between two directions."""
    return float(np.linalg.norm(np.cross(a, b))) / math.hypot(*a) / math.hypot(*b)


def camera(boresight: Vec3, up: Vec3, zero: Vec3, lens: float = 0.2) -> Camera:
    drive = Drive(square(zero, up), lens, None, None, None)
    return Camera("T", "Test", "orbiter", (1.0, 2.0, 3.0), boresight, up, 1.0, drive)


@given(boresight=directions, up=directions, zero=directions)
def test_start_setting_gives_the_start_view(boresight: Vec3, up: Vec3, zero: Vec3) -> None:
    assume(apart(boresight, up) > 1e-3 and apart(zero, up) > 1e-3)
    shot = camera(boresight, up, zero)
    seen = view(shot, setting(shot))
    assert seen.position == pytest.approx(shot.position, abs=1e-12)
    assert seen.boresight == pytest.approx(np.array(boresight) / math.hypot(*boresight), abs=1e-9)


@given(wide=st.floats(-4.0, 4.0) | st.sampled_from([0.0, math.pi, math.nan, math.inf]))
def test_a_field_of_view_is_between_0_and_180_degrees(wide: float) -> None:
    if 0.0 < wide < math.pi:
        assert Camera("T", "Test", "orbiter", (0, 0, 0), (1, 0, 0), (0, 0, 1), wide).field_of_view == wide
    else:
        with pytest.raises(ValueError, match="field_of_view"):
            Camera("T", "Test", "orbiter", (0, 0, 0), (1, 0, 0), (0, 0, 1), wide)


@given(pan=st.floats(-3.1, 3.1), tilt=st.floats(-1.5, 1.5), up=directions, zero=directions)
def test_setting_is_recovered_from_its_view(pan: float, tilt: float, up: Vec3, zero: Vec3) -> None:
    assume(apart(zero, up) > 1e-3)
    shot = camera(zero, up, zero)
    seen = view(shot, Setting(pan, tilt, 0.5))
    assert np.dot(seen.boresight, seen.up) == pytest.approx(0.0, abs=1e-12)
    pivot = np.array(view(shot, setting(shot)).position) - 0.2 * np.array(view(shot, setting(shot)).boresight)
    assert np.array(seen.position) - pivot == pytest.approx(0.2 * np.array(seen.boresight), abs=1e-12)
    drive = Drive(square(zero, up), 0.2, None, None, None)
    again = setting(Camera("T", "Test", "orbiter", seen.position, seen.boresight, up, 0.5, drive))
    assert again == pytest.approx((pan, tilt, 0.5), abs=1e-9)


def test_pan_turns_right_and_tilt_turns_up() -> None:
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


def test_camera_that_starts_outside_its_drive_range_is_rejected() -> None:
    cameras, problems = cameras_of([listed("unit"), listed("unit", (1.0, -1.0, 0.0)), listed("other")], [UNIT])
    assert [setting(one).pan for one in cameras] == [0.0]
    outside, unknown = problems
    assert (outside.where, unknown.where) == (("camera", 1), ("camera", 2))
    assert re.search(r"camera T .*pan .*0\.7854 rad.*'unit'.* -0\.5 to 0\.5", outside.what)
    assert re.search("camera T.*'other'.* unit", unknown.what)


def test_drive_without_travel_or_rate_is_rejected() -> None:
    with pytest.raises(ValueError, match="least is 1 and greatest is 1"):
        TravelFile(Angle(1.0), Angle(1.0), AngularRate(0.1))
    with pytest.raises(ValueError, match="rate is 0"):
        TravelFile(Angle(0.0), Angle(1.0), AngularRate(0.0))
