"""Mode 2: translation along a straight line and rotation about one axis, which end together at the target."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import aftdeck
from aftdeck.scenario.load import load_scenario, parse_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Frame
from aftdeck.tuples import Vec3
from tests.reference.tables import table
from tests.steering.flying import (
    BAY,
    FOOT,
    QUICK,
    at_rate,
    disturbed,
    fly,
    scenario,
    speed,
    target,
    turning,
)

STS_400 = table("sts-400")
PERIOD = 0.02


def changed(line: str) -> Scenario:
    """Return sts-400-closed with one more line at its start and a duration of 144 s, a multiple of 0.08 s."""
    text = load_scenario("sts-400-closed").text.replace('duration = "150 s"', 'duration = "144 s"')
    return parse_scenario(f"{line}\n{text}", "sts-400", "sts-400.toml", Path("."))


def off_the_line(start: Sequence[float], frames: Sequence[Frame]) -> float:
    """Return the greatest distance [m] of the tip from the straight line between its start and its target."""
    goal = frames[-1].goal
    assert goal is not None
    a, b = np.array(start), np.array(goal.position)
    along = (b - a) / np.linalg.norm(b - a)
    offset = np.array([f.position for f in frames]) - a
    return float(np.linalg.norm(offset - np.outer(offset @ along, along), axis=1).max())


def off_the_axis(start: np.ndarray, frames: Sequence[Frame]) -> float:
    """Return the greatest deviation [rad] of frame 7 from a rotation about one axis, from start to target."""
    goal = frames[-1].goal
    assert goal is not None
    whole = (Rotation.from_matrix(goal.rotation) * Rotation.from_matrix(start).inv()).as_rotvec()
    axis = whole / np.linalg.norm(whole)
    done = Rotation.from_matrix([f.orientation for f in frames]) * Rotation.from_matrix(start).inv()
    best = np.array([2 * math.atan2(q[:3] @ axis, q[3]) for q in done.as_quat()])
    return float((Rotation.from_rotvec(np.outer(best, axis)).inv() * done).magnitude().max())


def final_errors(frames: Sequence[Frame]) -> tuple[np.ndarray, np.ndarray]:
    """Return distance [m] and angle [rad] of each frame's tip from the target."""
    goal = frames[-1].goal
    assert goal is not None
    offset = np.linalg.norm(np.array([f.position for f in frames]) - goal.position, axis=1)
    turn = Rotation.from_matrix([f.orientation for f in frames]).inv() * Rotation.from_matrix(goal.rotation)
    return offset, np.asarray(turn.magnitude())


def fly_there(sim: aftdeck.Simulation, goal: aftdeck.Target, seconds: float) -> list[Frame]:
    """Return the frames of a motion to a target, and of the second after the motion."""
    period = sim.scenario.control_period
    frames = [sim.step(aftdeck.Inputs(target=goal, proceed=True))]
    while frames[-1].sequence in {"checking", "in progress"} and frames[-1].time_s < seconds:
        frames.append(sim.step(aftdeck.Inputs()))
    return frames + [sim.step(aftdeck.Inputs()) for _ in range(round(1.0 / period))]


def arrival(final_errors: np.ndarray, within: float, period: float) -> float:
    """Return the time [s] from which an error stays within a limit."""
    outside = np.flatnonzero(final_errors > within)
    return float((outside[-1] + 1 if len(outside) else 0) * period)


@pytest.mark.parametrize("period", [0.02, 0.08])
def test_sts_400_move_is_straight_and_ends_together(period: float) -> None:
    done = aftdeck.run(changed(f"control_period = {period}"))
    assert done.summary.ended == "completed"
    start = done.scenario.arm.forward(done.scenario.initial_angles)
    offset, turn = final_errors([done.frames[0], *done.frames])
    assert offset[0] == pytest.approx(STS_400["way"], abs=0.05)
    assert math.degrees(turn[0]) == pytest.approx(STS_400["turn"], abs=0.05)
    assert off_the_line(start.position.tolist(), done.frames) < 5e-3
    assert off_the_axis(start.rotation, done.frames) < math.radians(0.05)
    assert abs(arrival(offset, 1e-4, period) - arrival(turn, 2e-5, period)) <= 0.1
    assert done.summary.position_error_m is not None and done.summary.position_error_m < 1e-6
    assert done.summary.rotation_error_rad is not None and done.summary.rotation_error_rad < 1e-6
    assert offset[-1] == pytest.approx(done.summary.position_error_m, abs=1e-12)
    assert any(at_rate(f) for f in done.frames)  # the rate limit of the shoulder acts during most of the motion


def test_strict_leaves_the_line_by_the_reference_distance() -> None:
    done = aftdeck.run(changed("strict = true"))
    start = done.scenario.arm.forward(done.scenario.initial_angles)
    share = STS_400["tolerance"]
    assert off_the_line(start.position.tolist(), done.frames) == pytest.approx(STS_400["off_the_line"], rel=share)
    offset, turn = final_errors(done.frames)
    assert arrival(offset, 1e-3, PERIOD) == pytest.approx(STS_400["tip_arrives"], rel=share)
    assert arrival(turn, 1e-3, PERIOD) == pytest.approx(STS_400["rotation_arrives"], rel=share)
    assert arrival(offset, 1e-3, PERIOD) > arrival(turn, 1e-3, PERIOD) + 0.5
    assert offset[-1] < 1e-3


def moves(count: int) -> list[tuple[np.ndarray, np.ndarray]]:
    """Return start and end angles [deg] of motions far from stops and singularities.

    The tip moves by a few metres and tens of degrees.
    """
    rng = np.random.default_rng(70)
    found: list[tuple[np.ndarray, np.ndarray]] = []
    while len(found) < count:
        start = np.array(BAY) + rng.uniform(-15, 15, 6)
        end = start + rng.uniform(-12, 12, 6)
        found.append((start, end))
    return found


@pytest.mark.parametrize("period", [0.02, 0.08])
def test_path_is_straight_to_1_mm_without_joint_rate_limits(period: float) -> None:
    for start, end in moves(6):
        sim = aftdeck.Simulation(scenario(start.tolist(), f'control_period = {period}\nmode = "OPR CMD"\n{QUICK}'))
        goal = target(sim.scenario.arm, end.tolist())
        frames = fly_there(sim, goal, 40.0)
        assert not any(at_rate(f) for f in frames)
        first = sim.scenario.arm.forward(np.radians(start))
        assert off_the_line(first.position.tolist(), frames) < 1e-3
        assert off_the_axis(first.rotation, frames) < math.radians(0.01)
        assert frames[-1].sequence == "idle"
        offset, turn = final_errors(frames)
        assert offset[-1] < 1e-4 and turn[-1] < 2e-5
        assert abs(arrival(offset, 1e-4, period) - arrival(turn, 2e-5, period)) <= 0.1 + period


def test_path_is_straight_to_5_mm_with_joint_rate_limits() -> None:
    for start, end in moves(6):
        sim = aftdeck.Simulation(scenario(start.tolist(), 'mode = "OPR CMD"'))
        frames = fly_there(sim, target(sim.scenario.arm, end.tolist()), 60.0)
        first = sim.scenario.arm.forward(np.radians(start))
        assert off_the_line(first.position.tolist(), frames) < 5e-3
        assert frames[-1].sequence == "idle" and speed(frames[-1]) == 0.0


@pytest.mark.parametrize("roll", [180.0, -180.0, 179.99999, 90.0])
def test_rotation_by_180_deg_has_one_axis(roll: float) -> None:
    end = [*BAY[:5], BAY[5] + roll]
    sim = aftdeck.Simulation(scenario(BAY, 'mode = "OPR CMD"'))
    frames = fly(sim, 60.0, aftdeck.Inputs(target=target(sim.scenario.arm, end), proceed=True))
    assert frames[-1].sequence == "idle"
    offset, turn = final_errors(frames)
    assert offset.max() < 1e-3 and turn[-1] < 2e-5
    assert np.degrees(frames[-1].angles[:5]) == pytest.approx(BAY[:5], abs=0.01)
    assert abs(frames[-1].angles[5] - math.radians(BAY[5])) == pytest.approx(math.radians(abs(roll)), abs=1e-4)


def test_pure_translation_and_pure_rotation_reach_the_target() -> None:
    sim = aftdeck.Simulation(scenario(BAY, 'mode = "OPR CMD"'))
    pose = sim.scenario.arm.forward(np.radians(BAY))
    here = target(sim.scenario.arm, BAY)
    x, y, z = pose.position.tolist()
    along = aftdeck.Target((x - 1.0, y + 0.5, z), here.rotation)
    frames = fly(sim, 30.0, aftdeck.Inputs(target=along, proceed=True))
    assert frames[-1].sequence == "idle" and final_errors(frames)[0][-1] < 1e-4
    about = aftdeck.Target(along.position, _turned(here, [0.3, -0.2, 0.1]))
    frames = fly(sim, 30.0, aftdeck.Inputs(target=about, proceed=True))
    assert frames[-1].sequence == "idle" and final_errors(frames)[1][-1] < 2e-5
    frames = fly(sim, 1.0, aftdeck.Inputs(target=about, proceed=True))
    assert frames[-1].sequence == "idle"


def _turned(goal: aftdeck.Target, by: list[float]) -> tuple[Vec3, Vec3, Vec3]:
    rows = (Rotation.from_rotvec(by).as_matrix() @ np.array(goal.rotation)).tolist()
    return (tuple(rows[0]), tuple(rows[1]), tuple(rows[2]))


def test_proceed_after_stop_reaches_the_target() -> None:
    sim = aftdeck.Simulation(scenario(BAY, 'mode = "OPR CMD"'))
    end = (BAY[0] + 20.0, *BAY[1:])
    flying = fly(sim, 5.0, aftdeck.Inputs(target=target(sim.scenario.arm, end), proceed=True))
    assert flying[-1].sequence == "in progress" and speed(flying[-1]) > 0.1
    stopping = fly(sim, 5.0, aftdeck.Inputs(stop=True))
    assert {f.sequence for f in stopping} == {"ready"}
    before = flying[-1]
    for frame in stopping:
        assert speed(before) - speed(frame) <= 2 * FOOT / 4 * PERIOD * (1 + 1e-9)
        before = frame
    assert speed(stopping[-1]) == 0.0 and turning(stopping[-1]) == 0.0
    assert stopping[-1].goal is not None and stopping[-1].goal.distance > 0.5
    still = fly(sim, 2.0, aftdeck.Inputs())
    assert still[-1].angles == stopping[-1].angles
    going = fly(sim, 60.0, aftdeck.Inputs(proceed=True))
    assert going[-1].sequence == "idle"
    assert final_errors(going)[0][-1] < 1e-4 and final_errors(going)[1][-1] < 2e-5
    assert [e.kind for f in flying + stopping + going for e in f.events if e.kind != "limit"] == [
        "target", "check", "proceed", "stop", "check", "proceed", "arrived",
    ]  # fmt: skip


@pytest.mark.parametrize("place", [(40.0, 0.0, 0.0), (-9.0, 9.0, 3.0)])
def test_target_out_of_reach_fails_its_check_and_is_rejected(place: tuple[float, float, float]) -> None:
    sim = aftdeck.Simulation(scenario(BAY, 'mode = "OPR CMD"'))
    start = sim.scenario.initial_angles.tolist()
    far = aftdeck.Target(place, ((1.0, 0, 0), (0, 1.0, 0), (0, 0, 1.0)))
    frames = fly(sim, 1.0, aftdeck.Inputs(target=far, proceed=True))
    last = frames[-1]
    assert last.goal is not None and last.goal.position == place  # kept: the operator can correct it
    assert last.sequence == "idle" and last.check is not None and not last.check.good
    assert last.check.cause == "reach"
    assert list(last.angles) == start
    assert [event.kind for event in frames[0].events] == ["target", "check", "refused"]
    assert last.check.text in frames[0].events[-1].text


def test_rejected_target_does_not_start_the_previous_one() -> None:
    sim = aftdeck.Simulation(scenario(BAY, 'mode = "OPR CMD"'))
    fly(sim, 1.0, aftdeck.Inputs(target=target(sim.scenario.arm, (BAY[0] + 20.0, *BAY[1:]))))
    far = aftdeck.Target((40.0, 0.0, 0.0), ((1.0, 0, 0), (0, 1.0, 0), (0, 0, 1.0)))
    frames = fly(sim, 1.0, aftdeck.Inputs(target=far, proceed=True))
    assert "refused" in [event.kind for event in frames[0].events]
    assert frames[-1].sequence != "in progress"
    assert list(frames[-1].angles) == sim.scenario.initial_angles.tolist()


def test_target_that_is_not_a_pose_fails_its_check() -> None:
    sim = aftdeck.Simulation(scenario(BAY, 'mode = "OPR CMD"'))
    skew = aftdeck.Target((8.0, 1.0, -3.0), ((1.0, 0.5, 0), (0, 1.0, 0), (0, 0, 1.0)))
    frames = fly(sim, 0.1, aftdeck.Inputs(target=skew))
    assert frames[-1].check is not None and frames[-1].check.cause == "reach"
    assert "orthonormal" in frames[-1].check.text
    assert frames[-1].sequence == "idle"


def test_proceed_is_rejected_without_target_or_in_manual_mode() -> None:
    sim = aftdeck.Simulation(scenario(BAY, 'mode = "OPR CMD"'))
    (event,) = sim.step(aftdeck.Inputs(proceed=True)).events
    assert event.kind == "refused" and "target" in event.text
    *_, event = sim.step(aftdeck.Inputs(mode="ORB UNL", proceed=True)).events
    assert event.kind == "refused" and "ORB UNL" in event.text


def test_target_past_soft_stop_fails_its_check_and_is_not_started() -> None:
    # inside the hard stops, outside the soft ones: reachable by SINGLE alone
    start = (0.0, 60.0, -80.0, 110.0, 10.0, 0.0)
    sim = aftdeck.Simulation(scenario(start, 'mode = "OPR CMD"'))
    goal = target(sim.scenario.arm, (0.0, 60.0, -80.0, 119.0, 10.0, 0.0))
    frames = fly(sim, 2.0, aftdeck.Inputs(target=goal, proceed=True))
    assert frames[-1].check is not None and frames[-1].check.cause == "limit"
    assert re.search(r"wrist pitch .*soft stop, .*\d+ s", frames[-1].check.text)
    assert frames[-1].sequence == "idle" and list(frames[-1].angles) == sim.scenario.initial_angles.tolist()


def test_blocked_motion_is_abandoned_after_2_s() -> None:
    sim = aftdeck.Simulation(scenario(BAY, 'mode = "OPR CMD"\nsoft_stops = "as-flown"'))
    fly(sim, 4.0, aftdeck.Inputs(target=target(sim.scenario.arm, (BAY[0] + 20.0, *BAY[1:])), proceed=True))
    disturbed(sim, {3: -117.0})  # past the soft stop: as flown, all joints stop
    frames = fly(sim, 3.0, aftdeck.Inputs())
    assert {limit.kind for limit in frames[0].limits} >= {"soft stop"}
    ended = next(frame for frame in frames if frame.sequence != "in progress")
    assert ended.sequence == "ready" and ended.tick - frames[0].tick == pytest.approx(100, abs=1)
    assert [(event.kind, event.level) for event in ended.events] == [("blocked", "caution")]
    assert speed(frames[-1]) == 0.0
