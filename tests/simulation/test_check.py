"""CMD CK: GOOD or FAIL before the start, and why."""

from __future__ import annotations

import re

import numpy as np
import pytest

import aftdeck
from aftdeck.frames import Pose
from aftdeck.scenario.target import target_at
from tests.steering.flying import BAY, disturbed, finished, fly, joint_target, log_of, scenario, speed, target

OPR = 'mode = "OPR CMD"\n'
laws = pytest.mark.parametrize("law", ["position", "closed loop", "open loop"])


def seconds(text: str) -> float:
    found = re.match(r"GOOD: (\d+) s", text)
    assert found, text
    return float(found[1])


def checked(start: tuple[float, ...], law: str, goal: aftdeck.Target) -> str:
    """What CMD CK says of a target; nothing moves, and READY is lit for GOOD alone."""
    sim = aftdeck.Simulation(scenario(start, OPR))
    frame = sim.step(aftdeck.Inputs(target=goal, law="closed loop" if law == "closed loop" else None))
    if law != "closed loop":
        frame = sim.step(aftdeck.Inputs(law="position" if law == "position" else "open loop"))
    assert frame.check is not None
    assert frame.sequence == ("ready" if frame.check.good else "idle")
    assert frame.check.good == frame.check.text.startswith("GOOD: ") != frame.check.text.startswith("FAIL: ")
    assert frame.angles == tuple(sim.scenario.initial_angles.tolist())
    refused = sim.step(aftdeck.Inputs(proceed=True))
    if frame.check.good:
        assert refused.sequence == "in progress"
    else:
        assert refused.sequence == "idle"
        assert [e.text for e in refused.events if e.kind == "refused"] == [
            f"PROCEED refused: CMD CK {frame.check.text}"
        ]
    return frame.check.text


@laws
def test_a_pose_out_of_reach_fails_by_how_much(law: str) -> None:
    pose = aftdeck.load_arm("srms").forward(np.radians(BAY))
    far = target_at(Pose(pose.position + np.array([30.0, 0.0, 0.0]), pose.rotation))
    assert re.match(
        r"FAIL: the arm cannot reach this pose: its wrist is \d+\.\d+ m too far out", checked(BAY, law, far)
    )


@laws
@pytest.mark.parametrize(
    ("joint", "angle", "name"), [(3, -118.0, "wrist pitch"), (2, -159.0, "elbow pitch"), (4, 118.0, "wrist yaw")]
)
def test_a_target_behind_a_soft_stop_fails_and_names_the_joint(law: str, joint: int, angle: float, name: str) -> None:
    start = [-31.0, 79.0, -140.0, -100.0, 100.0, -128.0]
    end = list(start)
    end[joint] = angle
    said = checked(tuple(start), law, joint_target(aftdeck.load_arm("srms"), end))
    assert re.fullmatch(rf"FAIL: {name} meets its soft stop \d+ s from here", said)


def test_a_wrist_turned_through_ninety_degrees_fails_by_velocity_and_is_good_by_angles() -> None:
    start, end = (0.0, 60.0, -80.0, 20.0, 75.0, 0.0), (0.0, 60.0, -80.0, 20.0, 105.0, 0.0)
    goal = joint_target(aftdeck.load_arm("srms"), end)
    for law in ("closed loop", "open loop"):
        assert re.fullmatch(r"FAIL: the wrist singularity lies in the way, \d+ s from here", checked(start, law, goal))
    # the position mode, too, comes to rest before a singularity
    assert "wrist singularity" in checked(start, "position", goal)


@laws
def test_a_good_target_is_reached_in_the_time_foretold(law: str) -> None:
    rng = np.random.default_rng(210)
    for _ in range(6):
        end = np.array(BAY) + rng.uniform(-20.0, 20.0, 6)
        sim = aftdeck.Simulation(scenario(BAY, f'{OPR}law = "{law}"'))
        frame = sim.step(aftdeck.Inputs(target=joint_target(sim.scenario.arm, end.tolist())))
        assert frame.check is not None and frame.check.good, frame.check
        frames = finished(sim, aftdeck.Inputs(proceed=True), 120.0)
        took = frames[-1].time_s - frame.time_s
        assert seconds(frame.check.text) == pytest.approx(took, rel=0.03, abs=0.6)  # told in whole seconds


def test_the_sts_400_move_is_good_in_every_law_and_its_time_is_within_three_per_cent() -> None:
    for name in ("sts-400-closed", "sts-400-open", "sts-400-position"):
        done = aftdeck.run(name, keep_frames=False)
        said = next(e.text for e in done.summary.events if e.kind == "check").removeprefix("CMD CK ")
        assert seconds(said) == pytest.approx(done.summary.time_s, rel=0.03)


def test_passing_near_a_singularity_is_good_with_a_warning() -> None:
    start, end = (0.0, 60.0, -80.0, 20.0, 70.0, 0.0), (0.0, 60.0, -80.0, 20.0, 80.0, 0.0)
    said = checked(start, "closed loop", joint_target(aftdeck.load_arm("srms"), end))
    found = re.fullmatch(r"GOOD: \d+ s, passing the wrist singularity at (\d\.\d\d)", said)
    assert found, said
    assert float(found[1]) == pytest.approx(np.cos(np.radians(80.0)), abs=0.02)


def test_proceed_checks_again_from_where_the_arm_then_is() -> None:
    sim = aftdeck.Simulation(scenario(BAY, OPR))
    goal = target(sim.scenario.arm, (BAY[0] + 20.0, *BAY[1:]))
    first = sim.step(aftdeck.Inputs(target=goal))
    assert first.check is not None
    disturbed(sim, {0: BAY[0] + 18.0})
    frame = sim.step(aftdeck.Inputs(proceed=True))
    assert frame.check is not None and frame.check.good
    assert seconds(frame.check.text) < seconds(first.check.text) - 3.0


def test_a_check_changes_nothing_but_what_it_says() -> None:
    """The flight after a check is the flight without it, bit for bit."""
    ends = []
    for keyed in (True, False):
        sim = aftdeck.Simulation(scenario(BAY))
        fly(sim, 2.0, aftdeck.Inputs(translation=(0.3, 0.1, -0.4), rotation=(0.1, 0.0, 0.2)))
        sim.step(aftdeck.Inputs(mode="OPR CMD"))
        goal = target(sim.scenario.arm, (BAY[0] + 20.0, *BAY[1:]))
        sim.step(aftdeck.Inputs(target=goal if keyed else None))
        ends.append(fly(sim, 3.0, aftdeck.Inputs())[-1].angles)
    assert ends[0] == ends[1]


def test_the_law_cannot_be_changed_in_flight_and_a_new_target_neither() -> None:
    sim = aftdeck.Simulation(scenario(BAY, OPR))
    goal = target(sim.scenario.arm, (BAY[0] + 20.0, *BAY[1:]))
    fly(sim, 2.0, aftdeck.Inputs(target=goal, proceed=True))
    frame = sim.step(aftdeck.Inputs(law="position"))
    assert frame.law == 2 and log_of([frame]) == ["the law cannot be changed while a motion is in progress: STOP first"]
    frame = sim.step(aftdeck.Inputs(target=target(sim.scenario.arm, BAY)))
    assert log_of([frame]) == ["no target can be keyed in while a motion is in progress: STOP first"]
    assert frame.sequence == "in progress" and frame.goal is not None and frame.goal.position == goal.position


def test_a_manual_mode_has_no_check() -> None:
    sim = aftdeck.Simulation(scenario(BAY, OPR))
    sim.step(aftdeck.Inputs(target=target(sim.scenario.arm, (BAY[0] + 20.0, *BAY[1:]))))
    frame = sim.step(aftdeck.Inputs(mode="ORB UNL"))
    assert frame.check is None and frame.sequence == "idle"
    back = sim.step(aftdeck.Inputs(mode="OPR CMD"))
    assert back.check is not None and back.check.good and back.sequence == "ready"


@laws
def test_a_check_at_speed_foretells_the_way_from_rest_and_the_flight_takes_as_long(law: str) -> None:
    rng = np.random.default_rng(211)
    for mode in ("ORB UNL", "SINGLE"):
        sim = aftdeck.Simulation(scenario(BAY, f'law = "{law}"'))
        push = rng.uniform(-1.0, 1.0, 3).tolist()
        fly(sim, 4.0, aftdeck.Inputs((push[0], push[1], push[2]), drive=1.0, mode=mode))
        end = np.array(BAY) + rng.uniform(-20.0, 20.0, 6)
        goal = joint_target(sim.scenario.arm, end.tolist())
        frames = finished(sim, aftdeck.Inputs(mode="OPR CMD", target=goal, proceed=True), 120.0)
        first, last = frames[0], frames[-1]
        assert first.check is not None and last.goal is not None
        assert seconds(first.check.text) == pytest.approx(last.time_s - first.time_s, rel=0.03, abs=0.6)
        assert last.goal.distance < 0.01 and last.goal.angle < 1e-3


@pytest.mark.parametrize("law", ["position", "open loop"])
def test_stop_ends_a_motion_that_waits_for_the_arm_to_stand(law: str) -> None:
    sim = aftdeck.Simulation(scenario(BAY, f'law = "{law}"'))
    fly(sim, 5.0, aftdeck.Inputs((0.0, 0.0, -1.0)))
    goal = target(sim.scenario.arm, (BAY[0] + 20.0, *BAY[1:]))
    waiting = fly(sim, 1.0, aftdeck.Inputs(mode="OPR CMD", target=goal, proceed=True))
    assert log_of(waiting)[-1] == "PROCEED: the arm comes to rest, then flies to its target"
    assert {f.sequence for f in waiting} == {"in progress"} and speed(waiting[-1]) > 0.1
    stopped = fly(sim, 8.0, aftdeck.Inputs(stop=True))
    assert {f.sequence for f in stopped} == {"ready"} and stopped[-1].rates_commanded == (0.0,) * 6
    assert stopped[-1].goal is not None and stopped[-1].goal.distance > 1.0
    assert log_of(finished(sim, aftdeck.Inputs(proceed=True), 90.0))[-1] == "target reached"


@pytest.mark.parametrize("law", ["position", "open loop"])
def test_strict_plans_from_full_speed_as_if_at_rest(law: str) -> None:
    sim = aftdeck.Simulation(scenario(BAY, f'law = "{law}"\nstrict = true'))
    fly(sim, 5.0, aftdeck.Inputs((0.0, 0.0, -1.0)))
    goal = target(sim.scenario.arm, (BAY[0] + 20.0, *BAY[1:]))
    frame = sim.step(aftdeck.Inputs(mode="OPR CMD", target=goal, proceed=True))
    assert frame.goal is not None and frame.goal.remaining_s > 1.0
    assert "PROCEED: the arm flies to its target" in log_of([frame])


def test_a_sequence_entered_at_speed_waits_too_and_ends_at_its_point() -> None:
    point = f"[[sequence]]\nslot = 1\n[[sequence.point]]\ntarget = {{ joints = {[f'{q} deg' for q in BAY]} }}\n"
    for law in ("position", "open loop"):
        sim = aftdeck.Simulation(scenario(BAY, f'law = "{law}"\n{point}'))
        fly(sim, 5.0, aftdeck.Inputs((0.0, 0.0, -1.0)))
        frames = finished(sim, aftdeck.Inputs(mode="AUTO 1", proceed=True), 90.0)
        assert log_of(frames)[-1] == "AUTO 1 complete"
        assert np.degrees(frames[-1].angles) == pytest.approx(BAY, abs=0.05)


def test_an_open_loop_motion_that_would_end_beside_its_target_fails_by_how_much_and_mode_2_may_fly_it() -> None:
    start = (0.0, 60.0, -80.0, 20.0, 90.0, 0.0)  # at the wrist singularity, where the motion bends towards the way out
    goal = target(aftdeck.load_arm("srms"), (5.0, 50.0, -100.0, 35.0, 75.0, 10.0))
    said = checked(start, "open loop", goal)
    found = re.fullmatch(
        r"FAIL: ends (\d+) mm, \d\.\d\d° beside the target, passing the wrist singularity at 0.00", said
    )
    assert found and float(found[1]) > 25.0, said
    assert checked(start, "closed loop", goal).startswith("GOOD")
