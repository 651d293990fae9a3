"""Modes 4, 6 and 7 about the payload's point of resolution: ORB LD and PL."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Literal

import numpy as np
import pytest

import aftdeck
from aftdeck.arrays import Array
from aftdeck.simulation.frame import Frame
from tests.kinematics.poses import turned
from tests.reference.tables import table
from tests.steering.flying import (
    BAY,
    BODY_FROM_L,
    PAYLOAD,
    fly,
    heavy_por,
    kinds,
    log_of,
    scenario,
    speed,
    turning,
)

Stick = tuple[float, float, float]
ZERO = (0.0, 0.0, 0.0)
LIGHT = PAYLOAD.format(mass="10 lb")
HEAVY = PAYLOAD.format(mass="32000 lb")
UNIT: dict[str, Stick] = {"1": (1.0, 0.0, 0.0), "-2": (0.0, -1.0, 0.0), "3": (0.0, 0.0, 1.0), "askew": (0.5, -0.7, 0.4)}
sticks = pytest.mark.parametrize("stick", UNIT.values(), ids=UNIT.keys())
MODES = pytest.mark.parametrize(("mode", "mixed"), [("ORB LD", False), ("ORB LD", True), ("PL", False)])
# turned by 30 deg about axis 3, then 19.48 deg about axis 1 (ENDORI: azimuth first)
C, S = math.cos(math.radians(30.0)), math.sin(math.radians(30.0))
D, E = math.cos(math.radians(19.48)), math.sin(math.radians(19.48))
T_78 = np.array([[C, -S, 0.0], [S, C, 0.0], [0.0, 0.0, 1.0]]) @ np.array([[1.0, 0.0, 0.0], [0.0, D, -E], [0.0, E, D]])
FROM_TIP = np.array([0.5 + 0.3, 0.2 - 0.4, 2.6 + 0.1])
"""Vector from the tip to the point of resolution, in payload axes [m]."""


REST: Stick = (0.0, 0.0, 0.0)


def axes(frame: Frame) -> Array:
    """Return the payload's axes as columns, in L, computed from frame 7."""
    return np.asarray(np.array(frame.orientation) @ T_78)


def point(frame: Frame) -> Array:
    """Return the payload's point of resolution, in L, computed from the pose of frame 7."""
    return np.asarray(np.array(frame.position) + axes(frame) @ FROM_TIP)


def flown(
    mode: str, mixed: bool, extra: str, seconds: float, translation: Stick = ZERO, rotation: Stick = ZERO
) -> list[Frame]:
    sim = aftdeck.Simulation(scenario(BAY, extra))
    return fly(sim, seconds, aftdeck.Inputs(translation, rotation, mode=mode, payload_axes=mixed))


@MODES
def test_por_and_payload_pose_follow_from_frame_7(mode: str, mixed: bool) -> None:
    for frame in flown(mode, mixed, LIGHT, 2.0, rotation=(1.0, 0.3, -0.4), translation=(0.2, 0.4, 0.0))[::20]:
        assert frame.resolution == pytest.approx(point(frame), abs=1e-12)
        assert frame.payload is not None
        assert np.array(frame.payload[1]) == pytest.approx(axes(frame), abs=1e-12)
        assert frame.payload[0] == pytest.approx(point(frame) - axes(frame) @ [0.3, -0.4, 0.1], abs=1e-12)
        assert frame.law == (6 if mode == "PL" else 7 if mixed else 4)


@sticks
@MODES
def test_thc_translates_the_por_without_rotation(mode: str, mixed: bool, stick: Stick) -> None:
    frames = flown(mode, mixed, LIGHT, 5.0, translation=stick)
    way = point(frames[-1]) - point(frames[0])
    along = axes(frames[0]) if mode == "PL" else BODY_FROM_L.T
    wanted = along @ stick / np.linalg.norm(stick)
    assert way @ wanted > 0.4
    assert np.linalg.norm(way - (way @ wanted) * wanted) < 1e-3
    assert np.linalg.norm(turned(axes(frames[-1]), axes(frames[0]))) < math.radians(0.01)


@sticks
@MODES
def test_rhc_rotates_about_the_por(mode: str, mixed: bool, stick: Stick) -> None:
    frames = flown(mode, mixed, LIGHT, 5.0, rotation=stick)
    turn = turned(axes(frames[-1]), axes(frames[0]))
    about = axes(frames[0]) if mode == "PL" or mixed else BODY_FROM_L.T
    wanted = about @ stick / np.linalg.norm(stick)
    assert turn @ wanted > math.radians(4.0)
    assert np.linalg.norm(turn - (turn @ wanted) * wanted) < math.radians(0.01)
    assert max(np.linalg.norm(point(f) - point(frames[0])) for f in frames) < 1e-3
    assert np.linalg.norm(np.array(frames[-1].position) - frames[0].position) > 0.1  # the tip moves around the POR


@MODES
def test_strict_rotates_about_the_tip(mode: str, mixed: bool) -> None:
    frames = flown(mode, mixed, f"strict = true\n{LIGHT}", 5.0, rotation=(0.0, 1.0, 0.0))
    assert max(math.dist(f.position, frames[0].position) for f in frames) < 5e-3
    assert np.linalg.norm(point(frames[-1]) - point(frames[0])) > 0.1


@MODES
def test_heavy_payload_reaches_por_limits_within_acceleration(mode: str, mixed: bool) -> None:
    most, most_turn = heavy_por().translation[0], heavy_por().rotation[0]
    time = most / heavy_por().acceleration
    push, turn = {"translation": UNIT["-2"]}, {"rotation": UNIT["3"]}
    for stick, reached, limit in ((push, speed, most), (turn, turning, most_turn)):
        frames = flown(mode, mixed, f"control_period = 0.05\n{HEAVY}", time + 1.0, **stick)
        assert frames[-1].por_limits == pytest.approx((most, most_turn))
        values = np.array([reached(f) for f in frames])
        assert values[-1] == pytest.approx(limit) and values.max() <= limit * (1 + 1e-9)
        # the limit is reached at a constant acceleration
        assert np.diff(values, prepend=0.0).max() <= limit / time * 0.05 * (1 + 1e-9)
        assert values[round(0.5 * time / 0.05) - 1] == pytest.approx(0.5 * limit, rel=1e-6)
        assert [f.time_s for f in frames if "POR acceleration" in kinds(f)][-1] == pytest.approx(time, abs=0.06)


@MODES
def test_por_acceleration_keeps_its_limits(mode: str, mixed: bool) -> None:
    rng = np.random.default_rng(200)
    up, turn_up = heavy_por().acceleration, heavy_por().angular_acceleration
    sim = aftdeck.Simulation(scenario(BAY, HEAVY))
    before = sim.step(aftdeck.Inputs(mode=mode, payload_axes=mixed))
    for _ in range(12):
        t, r = (tuple(rng.choice([-1.0, 0.0, 0.5, 1.0], 3).tolist()) for _ in range(2))
        for frame in fly(sim, 2.5, aftdeck.Inputs(t, r)):
            change = np.array(frame.twist_commanded) - before.twist_commanded
            assert np.linalg.norm(change[3:]) <= up * 0.02 * (1 + 1e-6) + 1e-15
            assert np.linalg.norm(change[:3]) <= turn_up * 0.02 * (1 + 1e-6) + 1e-15
            # the POR moves as commanded
            moved = (point(frame) - point(before)) / 0.02
            assert moved == pytest.approx(frame.twist_commanded[3:], abs=1e-6)
            before = frame


def test_change_between_tip_and_por_causes_no_velocity_jump() -> None:
    sim = aftdeck.Simulation(scenario(BAY, HEAVY))
    turn = (0.0, 0.0, 1.0)
    frames = fly(sim, 18.0, aftdeck.Inputs(mode="ORB UNL", rotation=turn))
    positions: tuple[Literal["PL", "ORB UNL", "ORB LD"], ...] = ("PL", "ORB UNL", "ORB LD")
    for mode in positions:
        frames += fly(sim, 10.0, aftdeck.Inputs(mode=mode, rotation=turn))
    rates = np.array([f.rates_commanded for f in frames])
    # the acceleration of the payload, a few metres from the tip, needs joint accelerations of up to 3e-4 rad/s2
    assert np.abs(np.diff(rates, axis=0)).max() < 2e-3 * 0.02


def test_payload_axes_switch_acts_at_once() -> None:
    sim = aftdeck.Simulation(scenario(BAY, f'mode = "ORB LD"\n{LIGHT}'))
    assert (sim.step(aftdeck.Inputs()).law, sim.step(aftdeck.Inputs(payload_axes=True)).law) == (4, 7)
    frame = sim.step(aftdeck.Inputs(payload_axes=False))
    assert (frame.law, frame.payload_axes) == (4, False)


@pytest.mark.parametrize(("number", "position", "law"), [(6, "PL", 6), (7, "ORB LD", 7), (4, "ORB UNL", 4)])
def test_mode_numbers_select_position_and_switch(number: int, position: str, law: int) -> None:
    frame = aftdeck.Simulation(scenario(BAY, f"mode = {number}\n{LIGHT}")).step(aftdeck.Inputs())
    assert (frame.mode, frame.law) == (position, law)


def positions_of(frames: Sequence[Frame]) -> Array:
    return np.array([f.resolution for f in frames])


def test_loaded_scenario_follows_its_phases() -> None:
    done = aftdeck.run("loaded")
    assert done.summary.ended == "completed"
    assert [t for t in log_of(done.frames) if t.startswith("phase")] == [
        f"phase {name!r} begins"
        for name in ("up, orbiter axes", "turn in its own axes", "forward, payload axes", "stop")
    ]
    up = [f for f in done.frames if f.phase == "up, orbiter axes"]
    way = BODY_FROM_L @ (positions_of(up)[-1] - positions_of(up)[0])
    assert way[2] < -0.7 and np.abs(way[:2]).max() < 1e-3
    turn = [f for f in done.frames if f.phase == "turn in its own axes"][900:]
    assert {f.law for f in turn} == {7}
    assert np.linalg.norm(np.ptp(positions_of(turn), axis=0)) < 1e-3
    assert speed(done.frames[-1]) == 0.0 and turning(done.frames[-1]) == 0.0
    limits = table("srms-limits")
    assert np.abs([f.rates_commanded for f in done.frames]).max() <= math.radians(max(limits["servo"]))


def test_orb_unl_moves_the_tip_also_with_a_payload() -> None:
    sim = aftdeck.Simulation(scenario(BAY, LIGHT))
    frames = fly(sim, 5.0, aftdeck.Inputs(mode="ORB UNL", rotation=(0.0, 1.0, 0.0)))
    assert max(math.dist(f.position, frames[0].position) for f in frames) < 1e-3
    assert frames[-1].resolution == frames[-1].position and frames[-1].payload is not None


def test_frame_without_payload_has_por_at_the_tip() -> None:
    frame = aftdeck.Simulation(scenario()).step(aftdeck.Inputs())
    assert frame.payload is None and frame.resolution == frame.position
