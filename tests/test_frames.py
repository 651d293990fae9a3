"""Angles and coordinate frames: round trips, and known orientations."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

import aftdeck
from aftdeck.frames import (
    FrameName,
    Pose,
    endori,
    oriend,
    panel_attitude,
    panel_rotation,
    quaternion,
    rotation_x,
    rotation_y,
    rotation_z,
)

PROVE = settings(derandomize=True, deadline=None, max_examples=200, database=None)
QUARTER = math.pi / 2
whole = st.floats(-math.pi, math.pi)
half = st.floats(-QUARTER, QUARTER)
INCH = 0.0254


def test_rotations_turn_one_axis_into_the_next() -> None:
    x, y, z = np.eye(3)
    assert rotation_x(QUARTER) @ y == pytest.approx(z)
    assert rotation_y(QUARTER) @ z == pytest.approx(x)
    assert rotation_z(QUARTER) @ x == pytest.approx(y)


@PROVE
@given(whole, half, whole)
def test_endori_is_azimuth_then_elevation_then_roll(roll: float, elevation: float, azimuth: float) -> None:
    theirs = Rotation.from_euler("ZYX", [azimuth, elevation, roll]).as_matrix()
    assert endori(roll, elevation, azimuth) == pytest.approx(theirs, abs=1e-12)


@PROVE
@given(whole, half, whole)
@example(0.7, QUARTER, 0.2)
@example(0.7, -QUARTER, 0.2)
@example(-3.0, QUARTER - 1e-8, 3.0)
@example(-3.0, -QUARTER + 1e-10, 3.0)
def test_oriend_inverts_endori_also_straight_up_and_down(roll: float, elevation: float, azimuth: float) -> None:
    rotation = endori(roll, elevation, azimuth)
    found = oriend(rotation)
    assert endori(*found) == pytest.approx(rotation, abs=3e-9)
    if abs(elevation) < QUARTER - 1e-3:
        assert endori(*found) == pytest.approx(rotation, abs=1e-14)
        assert found[1] == pytest.approx(elevation, abs=1e-12)
    if abs(elevation) == QUARTER:
        assert found[0] == 0.0


@PROVE
@given(whole, half, whole)
@example(0.7, QUARTER, 0.2)
@example(0.7, -QUARTER, 0.2)
@example(0.7, QUARTER - 1e-8, 0.2)
def test_panel_attitude_round_trips_also_at_its_singularity(pitch: float, yaw: float, roll: float) -> None:
    rotation = panel_rotation(pitch, yaw, roll)
    theirs = Rotation.from_euler("YZX", [pitch, yaw, roll]).as_matrix()
    assert rotation == pytest.approx(theirs, abs=1e-12)
    shown = panel_attitude(rotation)
    assert all(0.0 <= angle < math.tau for angle in shown)
    assert panel_rotation(*shown) == pytest.approx(rotation, abs=3e-9)


def test_tiny_negative_attitude_is_not_shown_as_a_full_turn() -> None:
    assert max(panel_attitude(panel_rotation(-1e-18, -1e-18, -1e-18))) < math.tau


@PROVE
@given(st.tuples(*[st.floats(-1, 1)] * 4).filter(lambda q: np.linalg.norm(q) > 1e-2))
@example((0.0, 1.0, 0.0, 0.0))
@example((0.0, 0.0, 1.0, 0.0))
@example((0.0, 0.0, -1.0, 1.0))
@example((1e-9, 0.0, 0.0, -1.0))
def test_quaternion_represents_its_rotation(given: tuple[float, float, float, float]) -> None:
    turn = Rotation.from_quat(given, scalar_first=True)
    w, x, y, z = quaternion(turn.as_matrix())
    assert w >= 0.0
    assert math.hypot(w, x, y, z) == pytest.approx(1.0)
    assert Rotation.from_quat([x, y, z, w]).as_matrix() == pytest.approx(turn.as_matrix(), abs=1e-12)


@pytest.mark.parametrize("frame", ["L", "orbiter", "panel"])
def test_pose_round_trips_through_each_coordinate_frame(frame: FrameName) -> None:
    mount = aftdeck.load_arm("srms").model.mount
    rng = np.random.default_rng(90)
    pose = Pose(rng.normal(size=(20, 3)) * 10, Rotation.random(20, rng=91).as_matrix())
    back = mount.from_(frame, mount.to(frame, pose))
    assert back.position == pytest.approx(pose.position, abs=1e-13)
    assert back.rotation == pytest.approx(pose.rotation, abs=1e-14)


def test_shoulder_is_at_its_drawn_position_in_each_coordinate_frame() -> None:
    mount = aftdeck.load_arm("srms").model.mount
    shoulder = Pose(np.zeros(3), np.eye(3))
    panel = mount.to("panel", shoulder).position / INCH
    assert panel == pytest.approx([-679.5, -103.998, -433.452])
    # the origin of the orbiter frame is at Xo 1097, Yo 0, Zo 375 in; the shoulder is forward, to port and above
    body = mount.to("orbiter", shoulder).position / INCH
    assert body == pytest.approx([1097 - 679.5, -103.998, 375 - 433.452])


def test_l_axes_point_aft_port_and_down_and_lean_to_port() -> None:
    aft, port, down = aftdeck.load_arm("srms").model.mount.rotation.T
    assert aft == pytest.approx([-1, 0, 0])
    # according to the simulator Space Shuttle Vessel, the yaw axis is (0, -0.33348, 0.94276) in structural Xo, Yo, Zo
    assert -down == pytest.approx([0, -0.33348, -0.94276], abs=1e-5)
    assert np.cross(aft, port) == pytest.approx(down)


def test_mount_matrix_is_a_rotation() -> None:
    rotation = aftdeck.load_arm("srms").model.mount.rotation
    assert rotation @ rotation.T == pytest.approx(np.eye(3), abs=1e-15)
    assert np.linalg.det(rotation) == pytest.approx(1.0)
