"""Mode 1: all joints start together, stop together, and end at the target angles."""

from __future__ import annotations

import math

import numpy as np
import pytest

import aftdeck
from tests.reference.tables import table
from tests.steering.flying import BAY, checked, disturbed, finished, fly, joint_target, scenario, target

SERVO, COARSE = (np.radians(table("srms-limits")[name]) for name in ("servo", "coarse"))
POSITION = 'mode = "OPR CMD"\nlaw = "position"'
MOVES = [(20.0, -15.0, 12.0, 30.0, -20.0, 60.0), (-3.0, 1.0, 0.5, 0.0, 8.0, -200.0), (0.0, 0.0, 0.0, 0.0, 0.0, 3.0)]


@pytest.mark.parametrize("rotations", MOVES)
@pytest.mark.parametrize("period", [0.02, 0.08])
def test_all_joints_move_in_proportion_to_their_final_angles(rotations: tuple[float, ...], period: float) -> None:
    sim = aftdeck.Simulation(scenario(BAY, f"{POSITION}\ncontrol_period = {period}\nduration = 80"))
    end = [a + b for a, b in zip(BAY, rotations, strict=True)]
    frames = finished(sim, aftdeck.Inputs(target=joint_target(sim.scenario.arm, end), proceed=True), 120.0)
    assert frames[-1].sequence == "idle"
    rates = np.array([f.rates_commanded for f in frames])
    whole = np.radians(rotations)
    share = rates @ whole / (whole @ whole)
    assert rates == pytest.approx(np.outer(share, whole), abs=1e-12)
    moving = np.flatnonzero(share > 0.0)
    began = next(k for k, f in enumerate(frames) if f.sequence == "in progress")
    assert moving[0] == began and (np.diff(moving) == 1).all() and (share >= 0.0).all()
    assert frames[-1].angles == pytest.approx(np.radians(end), abs=1e-12)
    assert frames[-1].rates_commanded == pytest.approx([0.0] * 6, abs=1e-12)
    assert (np.abs(rates).max(axis=0) <= COARSE).all()


@pytest.mark.parametrize(
    ("rotations", "eta", "peak"),
    [
        # 10 s at 1.27 deg/s. Each of the two ramps lasts (2 ft/s) / (0.5 ft/s2) = 4 s, at half the rate on average:
        # together they add 4 s
        ((12.7, 0.0, 0.0, 0.0, 0.0, 0.0), 14.0, 1.27),
        # the slowest joint counts: 17.8 deg of elbow at 1.78 deg/s
        ((-6.0, 8.0, 17.8, -20.0, 5.0, 22.0), 14.0, 1.78),
        # 1.27 deg: 2 s of acceleration at 1.27/4 deg/s2 and 2 s of braking; the rate limit is not reached
        ((-1.27, 0.0, 0.0, 0.0, 0.0, 0.0), 4.0, 1.27 / 2.0),
        # the motion is just long enough for the ramps
        ((0.0, 0.0, 0.0, 4.0 * 2.64, 0.0, 0.0), 8.0, 2.64),
    ],
)
def test_duration_and_peak_rate_agree_with_hand_calculation(
    rotations: tuple[float, ...], eta: float, peak: float
) -> None:
    sim = aftdeck.Simulation(scenario((0, 60, -80, 30, 10, 0), POSITION))
    end = np.degrees(sim.scenario.initial_angles) + rotations
    frames = finished(sim, aftdeck.Inputs(target=joint_target(sim.scenario.arm, end.tolist()), proceed=True), 60.0)
    flown = [f for f in frames if f.sequence == "in progress"]
    assert flown[0].goal is not None and flown[0].goal.remaining_s == pytest.approx(eta, abs=1e-9)
    assert frames[-1].time_s - flown[0].time_s == pytest.approx(eta, abs=0.05)
    rates = np.degrees([np.abs(f.rates_commanded).max() for f in flown])
    slowest = int((np.abs(np.radians(rotations)) / COARSE).argmax())
    assert math.degrees(max(abs(f.rates_commanded[slowest]) for f in frames)) == pytest.approx(peak, rel=0.01)
    assert rates[round(eta / 0.02) // 4] == pytest.approx(rates[round(0.75 * eta / 0.02)], rel=0.03)  # symmetrical


def test_target_angles_can_take_the_long_rotation_and_a_pose_does_not() -> None:
    end = [*BAY[:5], BAY[5] + 310.0]
    by_angles = aftdeck.Simulation(scenario(BAY, POSITION))
    goal = joint_target(by_angles.scenario.arm, end)
    frames = finished(by_angles, aftdeck.Inputs(target=goal, proceed=True), 200.0)
    assert np.degrees(frames[-1].angles) == pytest.approx(end, abs=1e-9)
    by_pose = aftdeck.Simulation(scenario(BAY, POSITION))
    goal = target(by_pose.scenario.arm, end)
    frames = finished(by_pose, aftdeck.Inputs(target=goal, proceed=True), 200.0)
    assert np.degrees(frames[-1].angles) == pytest.approx([*BAY[:5], BAY[5] - 50.0], abs=1e-6)


def test_stop_slows_all_joints_in_proportion() -> None:
    sim = aftdeck.Simulation(scenario(BAY, POSITION))
    end = [BAY[0] + 30.0, BAY[1] + 10.0, *BAY[2:5], BAY[5] - 50.0]
    fly(sim, 6.0, aftdeck.Inputs(target=joint_target(sim.scenario.arm, end), proceed=True))
    stopping = fly(sim, 5.0, aftdeck.Inputs(stop=True))
    assert {f.sequence for f in stopping} == {"ready"}
    rates = np.array([f.rates_commanded for f in stopping])
    assert np.linalg.matrix_rank(rates, tol=1e-9) == 1
    assert (np.diff(np.abs(rates), axis=0) <= 1e-15).all() and (rates[-1] == 0.0).all()
    # a joint rate decreases by at most a quarter of the servo maximum in a second
    assert (np.abs(np.diff(rates, axis=0)) <= SERVO / 4.0 * 0.02 * (1 + 1e-9)).all()
    frames = finished(sim, aftdeck.Inputs(proceed=True), 60.0)
    assert frames[-1].sequence == "idle" and (frames[-1].events[-1].kind, frames[-1].events[-1].level) == (
        "arrived",
        "info",
    )
    assert np.degrees(frames[-1].angles) == pytest.approx(end, abs=1e-9)


def test_motion_to_present_angles_ends_at_once() -> None:
    sim = aftdeck.Simulation(scenario(BAY, POSITION))
    frames = finished(sim, aftdeck.Inputs(target=joint_target(sim.scenario.arm, BAY), proceed=True), 5.0)
    assert frames[-1].sequence == "idle" and len(frames) <= 3
    assert frames[-1].angles == pytest.approx(np.radians(BAY), abs=1e-12)


def test_sts_400_by_joints_takes_the_slowest_joints_time() -> None:
    done = aftdeck.run("sts-400-position")
    assert done.summary.ended == "completed"
    assert np.degrees(done.summary.joints_rad) == pytest.approx([-118.4, 108.9, -107.4, 67.1, -1.1, -6.3], abs=1e-9)
    # shoulder yaw's 118.4 deg at 1.27 deg/s, and 4 s
    (began,) = (e.time_s for e in done.summary.events if e.kind == "proceed")
    assert done.summary.time_s - began == pytest.approx(118.4 / 1.27 + 4.0, abs=0.1)


def test_mode_1_does_not_correct_a_disturbance() -> None:
    sim = aftdeck.Simulation(scenario(BAY, POSITION))
    end = [BAY[0] + 30.0, *BAY[1:]]
    flown = fly(sim, 6.0, aftdeck.Inputs(target=joint_target(sim.scenario.arm, end), proceed=True))
    disturbed(sim, {3: math.degrees(flown[-1].angles[3]) + 1.0})
    frames = finished(sim, aftdeck.Inputs(), 60.0)
    assert np.degrees(frames[-1].angles) - end == pytest.approx([0, 0, 0, 1, 0, 0], abs=1e-9)


def test_joint_target_past_soft_stop_fails_its_check() -> None:
    sim = aftdeck.Simulation(scenario(BAY, POSITION))
    goal = joint_target(sim.scenario.arm, [*BAY[:3], -118.0, *BAY[4:]])
    frame = checked(sim, aftdeck.Inputs(target=goal, proceed=True))[-1]
    assert frame.check is not None and frame.check.cause == "limit"
    assert "wrist pitch" in frame.check.text and "soft stop" in frame.check.text
    assert frame.sequence == "idle"


@pytest.mark.parametrize("before", ["ORB UNL", "SINGLE"])
def test_proceed_at_speed_first_stops_the_joints(before: str) -> None:
    sim = aftdeck.Simulation(scenario(BAY))
    flown = fly(sim, 5.0, aftdeck.Inputs((1.0, 0.0, 0.0), drive=1.0, mode=before))
    goal = joint_target(sim.scenario.arm, [BAY[0] + 20.0, *BAY[1:]])
    frames = finished(sim, aftdeck.Inputs(mode="OPR CMD", law="position", target=goal, proceed=True), 60.0)
    rates = np.array([f.rates_commanded for f in [flown[-1], *frames]])
    # the joints are faster than mode 1 allows; they slow down with the ramp of mode 1
    assert (np.abs(np.diff(rates, axis=0)) <= SERVO / 4.0 * 0.02 * (1 + 1e-9)).all()
    assert np.degrees(frames[-1].angles) == pytest.approx([BAY[0] + 20.0, *BAY[1:]], abs=1e-9)


@pytest.mark.slow
def test_mode_1_passes_every_singularity() -> None:
    """One joint at a time moves across a singularity; the first is wrist yaw, from 17 deg to 100 deg."""
    start = np.array([0.0, 60.0, -80.0, 20.0, 17.0, 0.0])
    for joint, angle in ((4, 100.0), (2, -0.5), (1, 140.0)):
        sim = aftdeck.Simulation(scenario(start.tolist(), POSITION))
        end = start.copy()
        end[joint] = angle
        before = np.array(sim.scenario.arm.singularities(np.radians(start)))
        after = np.array(sim.scenario.arm.singularities(np.radians(end)))
        frames = finished(sim, aftdeck.Inputs(target=joint_target(sim.scenario.arm, end.tolist()), proceed=True), 200.0)
        assert frames[-1].angles == pytest.approx(np.radians(end), abs=1e-12), (joint, frames[-1].check)
        assert (before * after < 0.0).any() or np.abs(after).min() < 0.05, "the motion crosses no singularity"
        assert any(f.singular for f in frames)  # SINGULAR is lit nevertheless


@pytest.mark.slow
@pytest.mark.parametrize("mass", ["0 lb", "5000 lb", "65000 lb"])
@pytest.mark.parametrize("rate", ["coarse", "vernier"])
def test_mode_1_keeps_limits_of_load_and_rate_setting(mass: str, rate: str) -> None:
    held = "" if mass == "0 lb" else f'[payload]\nmass = "{mass}"'
    sim = aftdeck.Simulation(scenario(BAY, f"rate = {rate!r}\n{POSITION}\n{held}"))
    end = [BAY[0] + 4.0, BAY[1] - 3.0, BAY[2] + 2.0, *BAY[3:]]
    frames = finished(sim, aftdeck.Inputs(target=joint_target(sim.scenario.arm, end), proceed=True), 600.0)
    assert np.degrees(frames[-1].angles) == pytest.approx(end, abs=1e-9)
    por = sim.scenario.arm.model.por_limits(float(mass.split(maxsplit=1)[0]) * 0.45359237)
    which = 0 if rate == "coarse" else 1
    share = por.translation[0] / (2.0 * 0.3048)
    own = np.radians(table("srms-limits")[rate]) * share
    rates = np.array([f.rates_commanded for f in frames])
    assert (np.abs(rates).max(axis=0) <= own * (1 + 1e-9)).all()
    speeds = [np.linalg.norm(b) * 50.0 for b in np.diff([f.position for f in frames], axis=0)]
    assert max(speeds) <= por.translation[which] * (1 + 1e-3)
    turns = [np.linalg.norm(f.twist[:3]) for f in frames]
    assert max(turns) <= por.rotation[which] * (1 + 1e-3)
    changes = np.diff([f.twist_commanded for f in frames], axis=0) * 50.0
    assert np.linalg.norm(changes[:, 3:], axis=1).max() <= por.acceleration * (1 + 1e-6)
    assert np.linalg.norm(changes[:, :3], axis=1).max() <= por.angular_acceleration * (1 + 1e-6)


def test_vernier_is_slower_than_coarse() -> None:
    took = {}
    for rate in ("coarse", "vernier"):
        sim = aftdeck.Simulation(scenario(BAY, f"rate = {rate!r}\n{POSITION}"))
        end = [BAY[0] + 10.0, *BAY[1:]]
        took[rate] = finished(sim, aftdeck.Inputs(target=joint_target(sim.scenario.arm, end), proceed=True), 200.0)[
            -1
        ].time_s
    assert took["vernier"] > 2.0 * took["coarse"]  # 1.27 instead of 0.42 deg/s, except in the ramps


def test_strict_mode_1_uses_servo_maxima() -> None:
    sim = aftdeck.Simulation(scenario(BAY, f"strict = true\n{POSITION}"))
    end = [BAY[0] + 45.8, *BAY[1:]]
    frames = finished(sim, aftdeck.Inputs(target=joint_target(sim.scenario.arm, end), proceed=True), 100.0)
    assert max(f.rates_commanded[0] for f in frames) == pytest.approx(SERVO[0])
