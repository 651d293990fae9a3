"""Mode 8: one joint moves, ramped, up to its stops; the other joints rest."""

from __future__ import annotations

import math

import numpy as np
import pytest

import aftdeck
from tests.each import each, seeds
from tests.reference.tables import table
from tests.steering.flying import BAY, FOOT, disturbed, fly, heavy_por, kinds, scenario

LIMITS = table("srms-limits")


@pytest.mark.slow
@pytest.mark.parametrize("joint", range(6))
@pytest.mark.parametrize("rate", ["coarse", "vernier"])
@pytest.mark.parametrize("drive", [1.0, -1.0, 0.5])
def test_selected_joint_ramps_and_no_other_moves(joint: int, rate: str, drive: float) -> None:
    sim = aftdeck.Simulation(scenario())
    switch = aftdeck.Inputs(mode="SINGLE", joint=joint, rate="coarse" if rate == "coarse" else "vernier", drive=drive)
    frames = fly(sim, 6.0, switch) + fly(sim, 6.0, aftdeck.Inputs())
    start = np.radians(BAY)
    most = math.radians(LIMITS[rate][joint])
    rates = np.array([f.rates_commanded for f in frames])
    assert (np.delete(np.array([f.angles for f in frames]), joint, 1) == np.delete(start, joint)).all()
    assert (np.delete(rates, joint, 1) == 0.0).all()
    own = rates[:, joint]
    assert own[299] == pytest.approx(drive * most)
    assert own[-1] == 0.0
    # the coarse rate is reached in 4 s, like the POR speed; `change` is the greatest change in a control step
    change = math.radians(LIMITS["coarse"][joint]) / 4.0 * 0.02
    assert np.abs(np.diff(own, prepend=0.0)).max() <= change * (1 + 1e-9)
    ramp = abs(drive) * most / change
    assert np.count_nonzero(np.abs(own[:300]) < abs(drive) * most * (1 - 1e-9)) == pytest.approx(ramp, abs=1.5)


@pytest.mark.parametrize("joint", range(6))
@pytest.mark.parametrize("way", [1.0, -1.0])
def test_driven_joint_stops_at_its_hard_stop(joint: int, way: float) -> None:
    low, high = LIMITS["hard"][joint]
    start = [0.0, 70.0, -80.0, 10.0, 0.0, 0.0]
    start[joint] = high - 8.0 if way > 0 else low + 8.0
    sim = aftdeck.Simulation(scenario(start))
    frames = fly(sim, 25.0, aftdeck.Inputs(mode="SINGLE", joint=joint, drive=way))
    angles = np.degrees([f.angles[joint] for f in frames])
    assert angles.max() <= high + 1e-9 and angles.min() >= low - 1e-9
    assert angles[-1] == pytest.approx(high if way > 0 else low, abs=1e-6)
    assert frames[-1].rates_commanded[joint] == pytest.approx(0.0, abs=1e-12)
    assert frames[-1].zones[joint] == 3
    held = next(f for f in frames if "hard stop" in kinds(f))
    assert [limit.joint for limit in held.limits] == [joint]
    back = fly(sim, 5.0, aftdeck.Inputs(drive=-way))
    assert abs(back[-1].angles[joint] - frames[-1].angles[joint]) > math.radians(1.0)


def test_deselected_joint_returns_to_its_angle() -> None:
    sim = aftdeck.Simulation(scenario())
    angle = fly(sim, 5.0, aftdeck.Inputs(mode="SINGLE", joint=0, drive=1.0))[-1].angles[0]
    frames = fly(sim, 20.0, aftdeck.Inputs(joint=5, drive=1.0))
    rates, angles = np.array([f.rates_commanded for f in frames]), np.array([f.angles[0] for f in frames])
    # the joint slows down from 1.27 deg/s in 4 s, and moves by 2.54 deg in this time
    assert np.degrees(angles.max() - angle) == pytest.approx(2.54, abs=0.02)
    assert angles[-1] == pytest.approx(angle, abs=1e-12) and rates[-1, 0] == pytest.approx(0.0, abs=1e-12)
    assert (np.diff(rates[:, 5]) >= 0.0).all() and rates[-1, 5] == pytest.approx(math.radians(2.64))


@each("seed", seeds(6, 60))
def test_other_joints_return_to_their_angles_at_entry(seed: int) -> None:
    rng = np.random.default_rng(seed)
    sim = aftdeck.Simulation(scenario())
    x, y, z, a, b, c = rng.uniform(-1.0, 1.0, 6).tolist()
    entered = np.array(fly(sim, 4.0, aftdeck.Inputs((x, y, z), (a, b, c)))[-1].angles)
    joint = int(rng.integers(6))
    frames = fly(sim, 25.0, aftdeck.Inputs(mode="SINGLE", joint=joint, drive=0.5))
    others = np.arange(6) != joint
    angles = np.array([f.angles for f in frames])
    assert np.abs(angles[:, others] - entered[others]).max() > math.radians(0.05)  # the joints moved at entry
    assert angles[-1, others] == pytest.approx(entered[others], abs=1e-12)


def test_disturbed_joint_returns() -> None:
    sim = aftdeck.Simulation(scenario())
    entered = fly(sim, 1.0, aftdeck.Inputs(mode="SINGLE", joint=5))[-1].angles
    disturbed(sim, {1: math.degrees(entered[1]) + 0.5, 3: math.degrees(entered[3]) - 0.2})
    assert fly(sim, 15.0, aftdeck.Inputs())[-1].angles == pytest.approx(entered, abs=1e-12)


def test_uncradle_ends_at_pre_cradle() -> None:
    done = aftdeck.run("uncradle")
    assert done.summary.ended == "completed"
    assert np.degrees(done.summary.joints_rad) == pytest.approx([0, 25, -25, 5, 0, 0], abs=1e-4)
    assert np.abs(done.frames[-1].rates).max() < 1e-9
    moving = [np.count_nonzero(f.rates_commanded) for f in done.frames]
    assert max(moving) == 1


def test_joints_are_slower_with_a_payload() -> None:
    sim = aftdeck.Simulation(scenario(BAY, '[payload]\nmass = "32000 lb"'))
    frames = fly(sim, 30.0, aftdeck.Inputs(mode="SINGLE", joint=0, drive=1.0))
    # the rate limit decreases like that of the POR
    share = heavy_por().translation[0] / (2.0 * FOOT)
    assert frames[-1].rates_commanded[0] == pytest.approx(math.radians(1.27) * share)
