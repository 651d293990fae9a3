"""Modes 4 and 5: direction and speed of the tip for each axis of the hand controllers."""

from __future__ import annotations

import math
from collections.abc import Sequence

import msgspec
import numpy as np
import pytest

import aftdeck
from aftdeck.arrays import Array
from aftdeck.simulation.frame import Frame
from tests.kinematics.poses import turned
from tests.steering.flying import (
    BAY,
    BODY_FROM_L,
    FOOT,
    QUICK,
    at_rate,
    fly,
    heavy_por,
    kinds,
    scenario,
    speed,
    turning,
)

LEVEL = (0.0, 60.0, -90.0, 30.0, 0.0, 0.0)
"""Joint angles [deg] at which the end effector points aft; its axes point aft, to port and down."""
AXES = {"+1": (1.0, 0.0, 0.0), "-1": (-1.0, 0.0, 0.0), "+2": (0.0, 1.0, 0.0), "-2": (0.0, -1.0, 0.0)}
AXES |= {"+3": (0.0, 0.0, 1.0), "-3": (0.0, 0.0, -1.0), "askew": (0.5, -0.7, 0.4)}
axes = pytest.mark.parametrize("stick", AXES.values(), ids=AXES.keys())

A_MILLIMETRE = 1e-3
A_HUNDREDTH_OF_A_DEGREE = math.radians(0.01)


def moved(frames: Sequence[Frame]) -> tuple[Array, Array]:
    """Return displacement [m] and rotation [rad] of the tip in a run, in orbiter body axes; rotations up to 90 deg."""
    first, last = frames[0], frames[-1]
    displacement = BODY_FROM_L @ (np.array(last.position) - np.array(first.position))
    sine = turned(np.array(last.orientation), np.array(first.orientation))
    size = float(np.linalg.norm(sine))
    return displacement, BODY_FROM_L @ sine * (math.asin(min(size, 1.0)) / size if size else 1.0)


def e_axes(frame: Frame) -> Array:
    """Return the end effector's own axes in orbiter body axes."""
    c, s = math.cos(math.radians(19.48)), math.sin(math.radians(19.48))
    return np.asarray(BODY_FROM_L @ np.array(frame.orientation) @ np.array([[1, 0, 0], [0, c, s], [0, -s, c]]))


@axes
def test_mode_4_translates_along_orbiter_axes_without_rotation(stick: tuple[float, float, float]) -> None:
    frames = fly(aftdeck.Simulation(scenario()), 5.0, aftdeck.Inputs(translation=stick, mode="ORB UNL"))
    displacement, turn = moved(frames)
    along = displacement @ stick / np.linalg.norm(stick)
    assert along > 0.5
    assert np.linalg.norm(displacement - along * np.array(stick) / np.linalg.norm(stick)) < A_MILLIMETRE
    assert np.linalg.norm(turn) < A_HUNDREDTH_OF_A_DEGREE


@axes
def test_mode_4_rotates_about_orbiter_axes_without_translation(
    stick: tuple[float, float, float],
) -> None:
    frames = fly(aftdeck.Simulation(scenario()), 5.0, aftdeck.Inputs(rotation=stick, mode="ORB UNL"))
    displacement, turn = moved(frames)
    along = turn @ stick / np.linalg.norm(stick)
    assert along > math.radians(5.0)
    assert np.linalg.norm(turn - along * np.array(stick) / np.linalg.norm(stick)) < A_HUNDREDTH_OF_A_DEGREE
    assert np.linalg.norm(displacement) < A_MILLIMETRE


@axes
@pytest.mark.parametrize("start", [BAY, LEVEL], ids=["bay", "level"])
def test_mode_5_translates_along_end_effector_axes(start: tuple[float, ...], stick: tuple[float, float, float]) -> None:
    frames = fly(aftdeck.Simulation(scenario(start)), 5.0, aftdeck.Inputs(translation=stick, mode="END EFF"))
    displacement, turn = moved(frames)
    wanted = e_axes(frames[0]) @ stick / np.linalg.norm(stick)
    along = displacement @ wanted
    assert along > 0.5
    assert np.linalg.norm(displacement - along * wanted) < A_MILLIMETRE
    assert np.linalg.norm(turn) < A_HUNDREDTH_OF_A_DEGREE


@axes
@pytest.mark.parametrize("start", [BAY, LEVEL], ids=["bay", "level"])
def test_mode_5_rotates_about_end_effector_axes(start: tuple[float, ...], stick: tuple[float, float, float]) -> None:
    frames = fly(aftdeck.Simulation(scenario(start)), 5.0, aftdeck.Inputs(rotation=stick, mode="END EFF"))
    displacement, turn = moved(frames)
    wanted = e_axes(frames[0]) @ stick / np.linalg.norm(stick)
    along = turn @ wanted
    assert along > math.radians(5.0)
    assert np.linalg.norm(turn - along * wanted) < A_HUNDREDTH_OF_A_DEGREE
    assert np.linalg.norm(displacement) < A_MILLIMETRE


def test_mode_5_at_level_end_effector_moves_aft_port_and_down() -> None:
    for stick, body in (((1.0, 0, 0), (-1.0, 0, 0)), ((0, 1.0, 0), (0, -1.0, 0)), ((0, 0, 1.0), (0, 0, 1.0))):
        frames = fly(aftdeck.Simulation(scenario(LEVEL)), 3.0, aftdeck.Inputs(translation=stick, mode="END EFF"))
        displacement, _ = moved(frames)
        assert displacement / np.linalg.norm(displacement) == pytest.approx(body, abs=2e-3)


def test_strict_mode_5_moves_along_frame_7() -> None:
    flight = aftdeck.Simulation(scenario(LEVEL, "strict = true"))
    frames = fly(flight, 3.0, aftdeck.Inputs(translation=(0.0, 0.0, 1.0), mode="END EFF"))
    displacement, _ = moved(frames)
    lean = math.radians(19.48)
    # with a level end effector, axis 3 of frame 7 is parallel to axis 3 of L, which points down and leans to starboard
    assert displacement / np.linalg.norm(displacement) == pytest.approx((0.0, math.sin(lean), math.cos(lean)), abs=2e-2)


@pytest.mark.slow
@pytest.mark.parametrize("mode", ["ORB UNL", "END EFF"])
@pytest.mark.parametrize(("rate", "most", "most_turn"), [("coarse", 2.0 * FOOT, 4.76), ("vernier", 0.61 * FOOT, 1.59)])
def test_full_deflection_reaches_the_por_limits(mode: str, rate: str, most: float, most_turn: float) -> None:
    for stick in AXES.values():
        for part, limit in (("translation", most), ("rotation", math.radians(most_turn))):
            size = math.hypot(*stick)
            unit = (stick[0] / size, stick[1] / size, stick[2] / size)
            push = aftdeck.Inputs(translation=unit) if part == "translation" else aftdeck.Inputs(rotation=unit)
            switched = msgspec.structs.replace(push, mode=mode, rate="coarse" if rate == "coarse" else "vernier")
            frames = fly(aftdeck.Simulation(scenario(BAY, QUICK)), 4.5, switched)
            reached = [speed(f) if part == "translation" else turning(f) for f in frames]
            assert max(reached) <= limit * (1 + 1e-9)
            assert reached[-1] == pytest.approx(limit)
            place = 3 if part == "translation" else 0
            assert math.hypot(*frames[-1].twist[place : place + 3]) == pytest.approx(limit, abs=1e-3)


def test_speed_is_at_its_limit_or_a_joint_is_at_its_rate_limit() -> None:
    slower = 0
    for stick in AXES.values():
        size = math.hypot(*stick)
        push = aftdeck.Inputs(translation=(stick[0] / size, stick[1] / size, stick[2] / size), mode="ORB UNL")
        end = fly(aftdeck.Simulation(scenario()), 4.5, push)[-1]
        assert speed(end) == pytest.approx(2.0 * FOOT) or at_rate(end)
        slower += at_rate(end)
    assert slower


def test_joint_rate_limit_names_only_a_joint_at_its_limit() -> None:
    for stick in AXES.values():
        for frame in fly(aftdeck.Simulation(scenario()), 4.5, aftdeck.Inputs(translation=stick, mode="ORB UNL")):
            for limit in frame.limits:
                if limit.kind == "joint rate":
                    most = frame.rate_limits[limit.joint]
                    assert abs(frame.rates_commanded[limit.joint]) == pytest.approx(most, rel=1e-3), frame.time_s


def test_coarse_speed_is_reached_and_lost_in_4_s() -> None:
    sim = aftdeck.Simulation(scenario(BAY, QUICK))
    up = fly(sim, 6.0, aftdeck.Inputs(translation=(1.0, 0.0, 0.0), mode="ORB UNL"))
    assert [f.time_s for f in up if "POR acceleration" in kinds(f)][-1] == pytest.approx(4.0, abs=0.03)
    assert speed(up[99]) == pytest.approx(FOOT, rel=1e-9)  # half the speed in half the time
    assert speed(up[-1]) == pytest.approx(2.0 * FOOT)
    down = fly(sim, 6.0, aftdeck.Inputs())
    assert next(k for k, f in enumerate(down, 1) if speed(f) < 1e-12) * 0.02 == pytest.approx(4.0, abs=0.03)


def test_half_deflection_gives_half_the_speed() -> None:
    frames = fly(aftdeck.Simulation(scenario()), 4.0, aftdeck.Inputs(translation=(0.5, 0, 0), mode="ORB UNL"))
    assert speed(frames[-1]) == pytest.approx(FOOT)


def test_vernier_at_speed_slows_within_acceleration_limit() -> None:
    sim = aftdeck.Simulation(scenario())
    before = fly(sim, 4.5, aftdeck.Inputs(translation=(1.0, 0.0, 0.0), mode="ORB UNL"))[-1]
    for frame in fly(sim, 4.0, aftdeck.Inputs(translation=(1.0, 0.0, 0.0), rate="vernier")):
        assert speed(before) - speed(frame) <= 2 * FOOT / 4 * 0.02 * (1 + 1e-9)
        before = frame
    assert speed(before) == pytest.approx(0.61 * FOOT)


def test_payload_reduces_the_por_speed() -> None:
    held = scenario(BAY, '[payload]\nmass = "32000 lb"')
    frames = fly(aftdeck.Simulation(held), 20.0, aftdeck.Inputs(translation=(1.0, 0.0, 0.0), mode="ORB UNL"))
    assert speed(frames[-1]) == pytest.approx(heavy_por().translation[0])
    assert speed(frames[-1]) == frames[-1].por_limits[0]
