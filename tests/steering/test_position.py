"""Mode 1: all joints start together, stop together, and stand at the angles asked for."""

from __future__ import annotations

import math

import numpy as np
import pytest

import aftdeck
from tests.reference.tables import table
from tests.steering.flying import BAY, disturbed, finished, fly, joint_target, log_of, scenario, target

SERVO = np.radians(table("srms-limits")["servo"])
POSITION = 'mode = "OPR CMD"\nlaw = "position"'
MOVES = [(20.0, -15.0, 12.0, 30.0, -20.0, 60.0), (-3.0, 1.0, 0.5, 0.0, 8.0, -200.0), (0.0, 0.0, 0.0, 0.0, 0.0, 3.0)]


@pytest.mark.parametrize("way", MOVES)
@pytest.mark.parametrize("period", [0.02, 0.08])
def test_all_joints_go_in_proportion_from_the_first_step_to_the_last_and_end_at_the_angles(
    way: tuple[float, ...], period: float
) -> None:
    sim = aftdeck.Simulation(scenario(BAY, f"{POSITION}\ncontrol_period = {period}\nduration = 80"))
    end = [a + b for a, b in zip(BAY, way, strict=True)]
    frames = finished(sim, aftdeck.Inputs(target=joint_target(sim.scenario.arm, end), proceed=True), 120.0)
    assert frames[-1].sequence == "idle"
    rates = np.array([f.rates_commanded for f in frames])
    whole = np.radians(way)
    share = rates @ whole / (whole @ whole)
    assert rates == pytest.approx(np.outer(share, whole), abs=1e-12)
    moving = np.flatnonzero(share > 0.0)
    assert moving[0] == 0 and (np.diff(moving) == 1).all() and (share >= 0.0).all()
    assert frames[-1].angles == pytest.approx(np.radians(end), abs=1e-12)
    assert frames[-1].rates_commanded == pytest.approx([0.0] * 6, abs=1e-12)
    assert (np.abs(rates).max(axis=0) <= SERVO).all()


@pytest.mark.parametrize(
    ("way", "eta", "peak"),
    [
        # 10 s at 2.29 deg/s, and a ramp of 2 ft/s over 0.5 ft/s2 = 4 s at both ends, which costs 4 s in all
        ((22.9, 0.0, 0.0, 0.0, 0.0, 0.0), 14.0, 2.29),
        # the slowest joint counts: 32.1 deg of elbow at 3.21 deg/s
        ((-11.0, 20.0, 32.1, -40.0, 10.0, 45.0), 14.0, 3.21),
        # 2.29 deg: up for 2 s at 2.29/4 deg/s2 and down again, the rate never reached
        ((-2.29, 0.0, 0.0, 0.0, 0.0, 0.0), 4.0, 2.29 / 2.0),
        # just long enough for its ramps
        ((0.0, 0.0, 0.0, 4.0 * 4.76, 0.0, 0.0), 8.0, 4.76),
    ],
)
def test_the_length_and_the_peak_are_those_worked_out_by_hand(way: tuple[float, ...], eta: float, peak: float) -> None:
    sim = aftdeck.Simulation(scenario((0, 60, -80, 30, 10, 0), POSITION))
    end = np.degrees(sim.scenario.initial_angles) + way
    frames = finished(sim, aftdeck.Inputs(target=joint_target(sim.scenario.arm, end.tolist()), proceed=True), 60.0)
    assert frames[0].goal is not None and frames[0].goal.remaining_s == pytest.approx(eta, abs=1e-9)
    assert [e.time_s for f in frames for e in f.events if e.kind == "arrived"] == pytest.approx([eta], abs=0.05)
    rates = np.degrees([np.abs(f.rates_commanded).max() for f in frames])
    slowest = int((np.abs(np.radians(way)) / SERVO).argmax())
    assert math.degrees(max(abs(f.rates_commanded[slowest]) for f in frames)) == pytest.approx(peak, rel=0.01)
    assert rates[round(eta / 0.02) // 4] == pytest.approx(rates[round(0.75 * eta / 0.02)], rel=0.03)  # symmetrical


def test_a_move_by_angles_takes_the_wrist_beyond_half_a_turn_and_one_by_a_pose_takes_the_short_way() -> None:
    end = [*BAY[:5], BAY[5] + 310.0]
    by_angles = aftdeck.Simulation(scenario(BAY, POSITION))
    goal = joint_target(by_angles.scenario.arm, end)
    frames = finished(by_angles, aftdeck.Inputs(target=goal, proceed=True), 200.0)
    assert np.degrees(frames[-1].angles) == pytest.approx(end, abs=1e-9)
    by_pose = aftdeck.Simulation(scenario(BAY, POSITION))
    goal = target(by_pose.scenario.arm, end)
    frames = finished(by_pose, aftdeck.Inputs(target=goal, proceed=True), 200.0)
    assert np.degrees(frames[-1].angles) == pytest.approx([*BAY[:5], BAY[5] - 50.0], abs=1e-6)


def test_stop_slows_all_joints_in_proportion_and_proceed_goes_on_to_the_angles() -> None:
    sim = aftdeck.Simulation(scenario(BAY, POSITION))
    end = [BAY[0] + 30.0, BAY[1] + 10.0, *BAY[2:5], BAY[5] - 50.0]
    fly(sim, 6.0, aftdeck.Inputs(target=joint_target(sim.scenario.arm, end), proceed=True))
    stopping = fly(sim, 5.0, aftdeck.Inputs(stop=True))
    assert {f.sequence for f in stopping} == {"ready"}
    rates = np.array([f.rates_commanded for f in stopping])
    assert np.linalg.matrix_rank(rates, tol=1e-9) == 1
    assert (np.diff(np.abs(rates), axis=0) <= 1e-15).all() and (rates[-1] == 0.0).all()
    # 4 s from full rate: a joint gives up at most a quarter of its rate limit a second
    assert (np.abs(np.diff(rates, axis=0)) <= SERVO / 4.0 * 0.02 * (1 + 1e-9)).all()
    frames = finished(sim, aftdeck.Inputs(proceed=True), 60.0)
    assert frames[-1].sequence == "idle" and "target reached" in log_of(frames)
    assert np.degrees(frames[-1].angles) == pytest.approx(end, abs=1e-9)


def test_where_the_arm_is_already_nothing_moves_and_the_motion_ends_at_once() -> None:
    sim = aftdeck.Simulation(scenario(BAY, POSITION))
    frames = finished(sim, aftdeck.Inputs(target=joint_target(sim.scenario.arm, BAY), proceed=True), 5.0)
    assert frames[-1].sequence == "idle" and len(frames) <= 3
    assert frames[-1].angles == pytest.approx(np.radians(BAY), abs=1e-12)


def test_it_flies_the_sts_400_move_to_its_angles_faster_than_the_straight_line() -> None:
    done = aftdeck.run("sts-400-position")
    assert done.summary.ended == "completed"
    assert np.degrees(done.summary.joints_rad) == pytest.approx([-118.4, 108.9, -107.4, 67.1, -1.1, -6.3], abs=1e-9)
    # shoulder yaw's 118.4 deg at 2.29 deg/s, and 4 s
    assert done.summary.time_s == pytest.approx(118.4 / 2.29 + 4.0, abs=0.1)


def test_what_disturbs_a_joint_on_the_way_is_still_there_at_the_end() -> None:
    sim = aftdeck.Simulation(scenario(BAY, POSITION))
    end = [BAY[0] + 30.0, *BAY[1:]]
    flown = fly(sim, 6.0, aftdeck.Inputs(target=joint_target(sim.scenario.arm, end), proceed=True))
    disturbed(sim, {3: math.degrees(flown[-1].angles[3]) + 1.0})
    frames = finished(sim, aftdeck.Inputs(), 60.0)
    assert np.degrees(frames[-1].angles) - end == pytest.approx([0, 0, 0, 1, 0, 0], abs=1e-9)


def test_a_joint_target_outside_the_soft_stops_fails_its_check() -> None:
    sim = aftdeck.Simulation(scenario(BAY, POSITION))
    goal = joint_target(sim.scenario.arm, [*BAY[:3], -118.0, *BAY[4:]])
    frame = sim.step(aftdeck.Inputs(target=goal, proceed=True))
    assert frame.check is not None and "wrist pitch meets its soft stop" in frame.check.text
    assert frame.sequence == "idle"


@pytest.mark.parametrize("before", ["ORB UNL", "SINGLE"])
def test_proceed_at_speed_brings_the_joints_to_rest_within_their_acceleration_first(before: str) -> None:
    sim = aftdeck.Simulation(scenario(BAY))
    flown = fly(sim, 5.0, aftdeck.Inputs((1.0, 0.0, 0.0), drive=1.0, mode=before))
    goal = joint_target(sim.scenario.arm, [BAY[0] + 20.0, *BAY[1:]])
    frames = finished(sim, aftdeck.Inputs(mode="OPR CMD", law="position", target=goal, proceed=True), 60.0)
    rates = np.array([f.rates_commanded for f in [flown[-1], *frames]])
    assert (np.abs(np.diff(rates, axis=0)) <= SERVO / 4.0 * 0.02 * (1 + 1e-9)).all()
    assert np.degrees(frames[-1].angles) == pytest.approx([BAY[0] + 20.0, *BAY[1:]], abs=1e-9)
