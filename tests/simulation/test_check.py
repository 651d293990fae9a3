"""CMD CK: verdict before the start of a motion, and its cause."""

from __future__ import annotations

import copy
import math
import re
from typing import cast

import msgspec
import numpy as np
import pytest

import aftdeck
from aftdeck.arrays import Array
from aftdeck.errors import AftdeckError
from aftdeck.frames import Pose
from aftdeck.scenario.target import target_at
from aftdeck.simulation.command_check import rehearsal
from aftdeck.simulation.command_check.cmd_ck import STEPS
from aftdeck.simulation.frame import Check
from aftdeck.simulation.operator.sequence import begin
from aftdeck.tuples import Six
from tests.each import each, number, seeds
from tests.steering.flying import BAY, checked, disturbed, finished, fly, joint_target, scenario, speed, target

OPR = 'mode = "OPR CMD"\n'


def six(angles: Array) -> Six:
    return cast("Six", tuple(angles.tolist()))


laws = pytest.mark.parametrize("law", ["position", "closed loop", "open loop"])


def verdict_on(start: tuple[float, ...], law: str, goal: aftdeck.Target, more: str = "") -> Check:
    """Return CMD CK's verdict on a target; check that the arm rests, and that READY and PROCEED follow the verdict."""
    sim = aftdeck.Simulation(scenario(start, f'{OPR}law = "{law}"\n{more}'))
    frames = checked(sim, aftdeck.Inputs(target=goal))
    verdict = frames[-1].check
    assert verdict is not None and {f.sequence for f in frames[:-1]} <= {"checking"}
    assert frames[-1].sequence == ("ready" if verdict.good else "idle")
    assert verdict.good == (verdict.cause == "")
    assert frames[-1].angles == tuple(sim.scenario.initial_angles.tolist())
    after = sim.step(aftdeck.Inputs(proceed=True))
    assert after.sequence == ("in progress" if verdict.good else "idle")
    assert [e.kind for e in after.events] == (["proceed"] if verdict.good else ["refused"])
    return verdict


@laws
def test_check_fails_for_pose_out_of_reach_with_distance(law: str) -> None:
    pose = aftdeck.load_arm("srms").forward(np.radians(BAY))
    far = target_at(Pose(pose.position + np.array([30.0, 0.0, 0.0]), pose.rotation))
    verdict = verdict_on(BAY, law, far)
    assert verdict.cause == "reach" and re.search(r"\d+\.\d+ m\b", verdict.text)


@laws
@pytest.mark.parametrize(
    ("joint", "angle", "name"), [(3, -118.0, "wrist pitch"), (2, -159.0, "elbow pitch"), (4, 118.0, "wrist yaw")]
)
def test_check_fails_for_target_past_soft_stop_and_names_joint(law: str, joint: int, angle: float, name: str) -> None:
    start = [-31.0, 79.0, -140.0, -100.0, 100.0, -128.0]
    end = list(start)
    end[joint] = angle
    verdict = verdict_on(tuple(start), law, joint_target(aftdeck.load_arm("srms"), end))
    assert verdict.cause == "limit" and name in verdict.text and "soft stop" in verdict.text
    assert verdict.seconds > 1.0


def test_check_of_wrist_past_90_deg_fails_in_line_and_is_good_by_joints() -> None:
    start, end = (0.0, 60.0, -80.0, 20.0, 75.0, 0.0), (0.0, 60.0, -80.0, 20.0, 105.0, 0.0)
    goal = joint_target(aftdeck.load_arm("srms"), end)
    by_joints = verdict_on(start, "position", goal)
    assert by_joints.good and by_joints.joints == pytest.approx(np.radians(end))
    for law in ("closed loop", "open loop"):
        verdict = verdict_on(start, law, goal)
        assert verdict.cause == "limit" and "wrist singularity" in verdict.text
        assert f" {by_joints.seconds:.0f} s" in verdict.text


def test_check_fails_for_target_below_bay_floor_with_contact_and_time() -> None:
    sim = aftdeck.Simulation(scenario(BAY, f'{OPR}worksite = "orbiter"\n'))
    tip = sim.scenario.arm.forward(np.radians(BAY))
    x, y, z = sim.scenario.arm.model.mount.to("panel", tip).position
    low = sim.scenario.arm.model.mount.from_("panel", Pose(np.array([x, y, z + 9.0]), np.eye(3)))
    verdict = checked(sim, aftdeck.Inputs(target=target_at(Pose(low.position, tip.rotation))))[-1].check
    assert verdict is not None and verdict.cause == "contact", verdict
    assert re.search(r"X -?\d+, Y -?\d+, Z -?\d+ in", verdict.text) and f" {verdict.seconds:.0f} s" in verdict.text


@pytest.mark.parametrize("switch", ["brakes", "safing"])
@laws
def test_check_fails_under_a_switch_and_repeats_after_it(law: str, switch: str) -> None:
    sim = aftdeck.Simulation(scenario(BAY, f'{OPR}law = "{law}"'))
    goal = joint_target(sim.scenario.arm, [q + 5.0 for q in BAY])
    frame = sim.step(msgspec.structs.replace(aftdeck.Inputs(target=goal), **{switch: True}))
    assert frame.check is not None and (frame.check.cause, frame.sequence) == ("switch", "idle")
    sim.step(msgspec.structs.replace(aftdeck.Inputs(), **{switch: False}))
    assert finished(sim, aftdeck.Inputs(proceed=True), 200.0)[-1].check.good  # type: ignore[union-attr]
    assert sim.frame is not None and sim.frame.goal is not None and sim.frame.goal.distance < 1e-3


def test_check_repeats_after_the_orbiter_has_moved() -> None:
    """Previously GOOD remained after the orbiter moved, and the arm penetrated the port's element by 0.04 inches."""
    script = aftdeck.run("concept-1972-script")
    aside, port = (next(f for f in reversed(script.frames) if f.phase == phase) for phase in ("aside", "to the port"))
    sim = aftdeck.Simulation("concept-1972")
    sim.step(aftdeck.Inputs(initialise="manoeuvring"))
    there = aftdeck.Target(aside.position, aside.orientation)
    finished(sim, aftdeck.Inputs(mode="OPR CMD", target=there, proceed=True), 200.0)
    first = checked(sim, aftdeck.Inputs(target=aftdeck.Target(port.position, port.orientation)))[-1].check
    assert first is not None and first.good
    fly(sim, 10.0, aftdeck.Inputs(orbiter=(1.0, 0.0, 0.0)))
    for _ in range(500):
        sim.step(aftdeck.Inputs())
    frames = [sim.step(aftdeck.Inputs(proceed=True))]
    assert frames[0].sequence == "checking"
    while frames[-1].sequence in ("checking", "in progress"):
        frames.append(sim.step(aftdeck.Inputs()))
        assert len(frames) < 5000
    verdict = frames[-1].check
    assert verdict is not None and verdict.good == (frames[-1].goal is not None and frames[-1].goal.distance < 1e-3)
    assert not (verdict.good and any(frame.work.arm_inhibit for frame in frames))


def test_check_fails_for_arm_in_contact_with_parts_and_position() -> None:
    sim = aftdeck.Simulation(scenario(BAY, 'worksite = "orbiter"\n'))
    frame = sim.step(aftdeck.Inputs())
    while not frame.work.arm_inhibit:
        frame = sim.step(aftdeck.Inputs((0.0, 0.0, 1.0)))
        assert frame.time_s < 200.0
    contact = frame.work.contacts[0]
    tip = sim.scenario.arm.forward(np.array(frame.angles))
    down = sim.scenario.arm.model.mount.rotation.T @ np.array([0.0, 0.0, 0.5])
    goal = target_at(Pose(tip.position + down, tip.rotation))
    for law in ("position", "closed loop", "open loop"):
        verdict = checked(sim, aftdeck.Inputs(mode="OPR CMD", law=law, target=goal))[-1].check
        assert verdict is not None and verdict.cause == "contact"
        assert contact.a in verdict.text and contact.b in verdict.text and re.search(r"X -?\d+, Y -?\d+", verdict.text)


def fastest_branch_s(arm: aftdeck.Arm, start: Array, goal: aftdeck.Target) -> float:
    """Return the shortest time of a motion in mode 1 [s], from one run for each branch inside the soft stops."""
    low, high = arm.limits.soft.T
    times = []
    for angles in arm.inverse(goal.pose, near=np.radians(start)):
        if ((angles >= low) & (angles <= high)).all():
            sim = aftdeck.Simulation(scenario(start.tolist(), f'{OPR}law = "position"'))
            frames = finished(sim, aftdeck.Inputs(target=target_at(goal.pose, six(angles)), proceed=True), 400.0)
            if frames[-1].goal is not None and frames[-1].goal.distance < 1e-6:
                times.append(sum(f.sequence == "in progress" for f in frames) * 0.02)
    return min(times)


@each("seed", seeds(3, 20))
def test_mode_1_selects_the_quickest_branch_inside_soft_stops(seed: int) -> None:
    rng, arm = np.random.default_rng(seed), aftdeck.load_arm("srms")
    start = np.array([0.0, 60.0, -80.0, 20.0, 70.0, 0.0]) + rng.uniform(-8.0, 8.0, 6)
    end = np.array([0.0, 60.0, -80.0, 20.0, 105.0, 0.0]) + rng.uniform(-8.0, 8.0, 6)
    goal = target_at(arm.forward(np.radians(end)))
    sim = aftdeck.Simulation(scenario(start.tolist(), f'{OPR}law = "position"'))
    verdict = checked(sim, aftdeck.Inputs(target=goal))[-1].check
    assert verdict is not None and verdict.good
    assert verdict.seconds == pytest.approx(fastest_branch_s(arm, start, goal), abs=0.05)


def inside_soft_stops(arm: aftdeck.Arm, goal: aftdeck.Target, start: Array) -> bool:
    """Return whether joint angles inside the soft stops put the tip at a target."""
    try:
        found = arm.inverse(goal.pose, near=np.radians(start))
    except AftdeckError:
        return False
    low, high = arm.limits.soft.T
    return bool(((found >= low) & (found <= high)).all(axis=1).any())


def check_predicts_motion(start: Array, goal: aftdeck.Target, law: str, more: str = "") -> None:
    """Compare the verdict, time and cause of a check with those of the motion, which is made even after a FAIL."""
    sim = aftdeck.Simulation(scenario(start.tolist(), f'{OPR}law = "{law}"\n{more}'))
    frame = checked(sim, aftdeck.Inputs(target=goal))[-1]
    verdict = frame.check
    assert verdict is not None
    if verdict.cause == "reach":
        assert not inside_soft_stops(sim.scenario.arm, goal, start), verdict
        return
    begin(sim._state, goal, verdict.joints)
    frames = []
    while sim._state.panel.sequence == "in progress":
        frames.append(sim.step(aftdeck.Inputs()))
        if verdict.cause == "contact" and frames[-1].work.arm_inhibit:
            break
    took = (len(frames) - 1) * sim.scenario.control_period
    ending = sim._state.panel.ending
    where = f"{start.tolist()}, {verdict}, {ending}, {took:.2f} s"
    assert took == pytest.approx(verdict.seconds, abs=1.0), where
    if verdict.good:
        assert ending == "reached", where
    elif verdict.cause == "contact":
        assert frames[-1].work.arm_inhibit or "contact" in {limit.kind for limit in frames[-1].limits}, where
    else:
        assert ending == {"limit": "given up", "miss": "missed"}[verdict.cause], where
        kinds_now = {limit.kind for limit in frames[-2].limits}  # in the last step the arm rests already
        assert verdict.cause != "limit" or kinds_now & {"soft stop", "singularity", "joint rate"}, where


def random_target(rng: np.random.Generator, arm: aftdeck.Arm) -> tuple[Array, aftdeck.Target]:
    """Return a start inside the soft stops, and a target that may be near, far or out of reach."""
    low, high = np.degrees(arm.limits.soft).T
    start = np.array(BAY) + rng.uniform(-15.0, 15.0, 6)
    end = np.clip(start + rng.choice([5.0, 25.0, 80.0]) * rng.uniform(-1.0, 1.0, 6), low, high)
    tip = arm.forward(np.radians(end))
    if rng.random() < 0.1:
        tip = Pose(tip.position + rng.uniform(-8.0, 8.0, 3), tip.rotation)
    return start, target_at(tip)


@pytest.mark.slow
@laws
def test_verdict_time_and_cause_equal_those_of_the_motion(law: str) -> None:
    rng, arm = np.random.default_rng(5), aftdeck.load_arm("srms")
    for k in range(8):
        start, goal = random_target(rng, arm)
        check_predicts_motion(start, goal, law, 'worksite = "orbiter"\n' if k % 2 else "")


@pytest.mark.slow
@laws
def test_many_verdicts_times_and_causes_equal_those_of_the_motion(law: str) -> None:
    rng, arm = np.random.default_rng(7), aftdeck.load_arm("srms")
    for k in range(number(10, 1000)):
        start, goal = random_target(rng, arm)
        check_predicts_motion(start, goal, law, 'worksite = "orbiter"\n' if k % 2 else "")


def test_sts_400_check_is_good_with_the_time_of_the_motion() -> None:
    for name in ("sts-400-closed", "sts-400-open", "sts-400-position"):
        done = aftdeck.run(name)
        check = next(f.check for f in done.frames if f.check is not None)
        (began,) = (e.time_s for e in done.summary.events if e.kind == "proceed")
        assert check.good and check.seconds == pytest.approx(done.summary.time_s - began, abs=0.1)


def test_good_verdict_names_a_near_singularity() -> None:
    start, end = (0.0, 60.0, -80.0, 20.0, 70.0, 0.0), (0.0, 60.0, -80.0, 20.0, 80.0, 0.0)
    verdict = verdict_on(start, "closed loop", joint_target(aftdeck.load_arm("srms"), end))
    found = re.search(r"wrist singularity .*(\d\.\d\d)", verdict.text)
    assert verdict.good and found, verdict
    assert float(found[1]) == pytest.approx(np.cos(np.radians(80.0)), abs=0.02)


def test_proceed_repeats_check_from_present_position() -> None:
    sim = aftdeck.Simulation(scenario(BAY, OPR))
    goal = target(sim.scenario.arm, (BAY[0] + 20.0, *BAY[1:]))
    first = checked(sim, aftdeck.Inputs(target=goal))[-1]
    assert first.check is not None
    disturbed(sim, {0: BAY[0] + 18.0})
    frame = checked(sim, aftdeck.Inputs(proceed=True))[-1]
    assert frame.check is not None and frame.check.good and frame.sequence == "in progress"
    assert frame.check.seconds < first.check.seconds - 3.0


def test_check_does_not_change_the_motion() -> None:
    """The motion after a check equals the motion without it, bit for bit."""
    ends = []
    for keyed in (True, False):
        sim = aftdeck.Simulation(scenario(BAY))
        fly(sim, 2.0, aftdeck.Inputs(translation=(0.3, 0.1, -0.4), rotation=(0.1, 0.0, 0.2)))
        sim.step(aftdeck.Inputs(mode="OPR CMD"))
        goal = target(sim.scenario.arm, (BAY[0] + 20.0, *BAY[1:]))
        sim.step(aftdeck.Inputs(target=goal if keyed else None))
        ends.append(fly(sim, 3.0, aftdeck.Inputs())[-1].angles)
    assert ends[0] == ends[1]


def test_law_and_target_are_rejected_during_a_motion() -> None:
    sim = aftdeck.Simulation(scenario(BAY, OPR))
    goal = target(sim.scenario.arm, (BAY[0] + 20.0, *BAY[1:]))
    fly(sim, 2.0, aftdeck.Inputs(target=goal, proceed=True))
    frame = sim.step(aftdeck.Inputs(law="position"))
    assert frame.law == 2 and [event.kind for event in frame.events] == ["refused"]
    frame = sim.step(aftdeck.Inputs(target=target(sim.scenario.arm, BAY)))
    assert [event.kind for event in frame.events] == ["refused"]
    assert frame.sequence == "in progress" and frame.goal is not None and frame.goal.position == goal.position


def test_manual_mode_has_no_check() -> None:
    sim = aftdeck.Simulation(scenario(BAY, OPR))
    sim.step(aftdeck.Inputs(target=target(sim.scenario.arm, (BAY[0] + 20.0, *BAY[1:]))))
    frame = sim.step(aftdeck.Inputs(mode="ORB UNL"))
    assert frame.check is None and frame.sequence == "idle"
    back = checked(sim, aftdeck.Inputs(mode="OPR CMD"))[-1]
    assert back.check is not None and back.check.good and back.sequence == "ready"


@laws
def test_check_at_speed_waits_for_rest_and_predicts_the_time(law: str) -> None:
    rng = np.random.default_rng(211)
    for mode in ("ORB UNL", "SINGLE"):
        sim = aftdeck.Simulation(scenario(BAY, f'law = "{law}"'))
        push = rng.uniform(-1.0, 1.0, 3).tolist()
        fly(sim, 4.0, aftdeck.Inputs((push[0], push[1], push[2]), drive=1.0, mode=mode))
        end = np.array(BAY) + rng.uniform(-20.0, 20.0, 6)
        goal = joint_target(sim.scenario.arm, end.tolist())
        frames = finished(sim, aftdeck.Inputs(mode="OPR CMD", target=goal, proceed=True), 120.0)
        began = next(f for f in frames if f.sequence == "in progress")
        assert speed(frames[0]) > 0.01 and began.check is not None and frames[-1].goal is not None
        assert began.check.seconds == pytest.approx(frames[-1].time_s - began.time_s, abs=0.05)
        assert frames[-1].goal.distance < 1e-3 and frames[-1].goal.angle < math.radians(0.02)


@laws
def test_stop_cancels_proceed_that_waits_for_check(law: str) -> None:
    sim = aftdeck.Simulation(scenario(BAY, f'law = "{law}"'))
    fly(sim, 5.0, aftdeck.Inputs((0.0, 0.0, -1.0)))
    goal = target(sim.scenario.arm, (BAY[0] + 20.0, *BAY[1:]))
    waiting = fly(sim, 1.0, aftdeck.Inputs(mode="OPR CMD", target=goal, proceed=True))
    assert {f.sequence for f in waiting} == {"checking"} and speed(waiting[-1]) > 0.1
    stopped = fly(sim, 8.0, aftdeck.Inputs(stop=True))
    assert stopped[-1].sequence == "ready" and stopped[-1].rates_commanded == (0.0,) * 6
    assert stopped[-1].goal is not None and stopped[-1].goal.distance > 1.0
    last = finished(sim, aftdeck.Inputs(proceed=True), 90.0)[-1].events[-1]
    assert (last.kind, last.level) == ("arrived", "info")


def test_restored_check_ends_with_same_verdict_in_same_step() -> None:
    sim = aftdeck.Simulation(scenario(BAY, f'{OPR}law = "closed loop"\nworksite = "orbiter"\n'))
    goal = target(sim.scenario.arm, (BAY[0] + 60.0, *BAY[1:]))
    frames = fly(sim, 0.2, aftdeck.Inputs(target=goal, proceed=True))
    assert frames[-1].sequence == "checking"
    saved = sim.save()
    other = aftdeck.Simulation(sim.scenario)
    other.restore(msgspec.json.decode(msgspec.json.encode(saved), type=type(saved)))
    for _ in range(200):
        assert sim.step(aftdeck.Inputs()) == other.step(aftdeck.Inputs())
    assert sim.frame is not None and sim.frame.sequence == "in progress"


def test_check_rehearses_a_limited_number_of_steps_per_step() -> None:
    sim = aftdeck.Simulation("sts-400-closed")
    rehearsed = []
    while sim.frame is None or sim.frame.sequence != "in progress":
        before = sim._state.checking is not None
        sim.step()
        if before and sim._state.checking is not None:
            rehearsed.append(sim._state.checking.steps)
    assert len(rehearsed) > 20 and max(np.diff(rehearsed)) <= STEPS


def test_sequence_entered_at_speed_ends_at_its_point() -> None:
    point = f"[[sequence]]\nslot = 1\n[[sequence.point]]\ntarget = {{ joints = {[f'{q} deg' for q in BAY]} }}\n"
    for law in ("position", "open loop"):
        sim = aftdeck.Simulation(scenario(BAY, f'law = "{law}"\n{point}'))
        fly(sim, 5.0, aftdeck.Inputs((0.0, 0.0, -1.0)))
        frames = finished(sim, aftdeck.Inputs(mode="AUTO 1", proceed=True), 90.0)
        assert frames[-1].events[-1].kind == "sequence" and frames[-1].goal is None
        assert np.degrees(frames[-1].angles) == pytest.approx(BAY, abs=0.05)


def test_open_loop_check_fails_with_final_error_where_mode_2_is_good() -> None:
    start = (0.0, 60.0, -80.0, 20.0, 90.0, 0.0)  # at the wrist singularity, where the motion leaves the line
    goal = target(aftdeck.load_arm("srms"), (5.0, 50.0, -100.0, 35.0, 75.0, 10.0))
    verdict = verdict_on(start, "open loop", goal)
    found = re.search(r"(\d+\.?\d*) mm, (\d\.\d\d)°", verdict.text)
    assert verdict.cause == "miss" and found and (float(found[1]) > 1.0 or float(found[2]) > 0.02), verdict
    assert verdict_on(start, "closed loop", goal).good


@laws
def test_motion_may_take_twice_its_estimate_but_no_longer_than_a_run(law: str, monkeypatch: pytest.MonkeyPatch) -> None:
    goal = joint_target(aftdeck.load_arm("srms"), (-31.0, 89.0, -118.0, -77.0, 17.0, -128.0))
    strict = "strict = true\n"
    plain = verdict_on(BAY, law, goal, strict)
    assert plain.good and plain.seconds > 5.0
    monkeypatch.setattr(rehearsal, "LONG", 1.0)  # shorter than the motion, whose estimate counts then
    assert verdict_on(BAY, law, goal, strict) == plain
    monkeypatch.setattr(rehearsal, "DAY", 3.0)
    failed = verdict_on(BAY, law, goal, strict)
    assert (failed.good, failed.cause) == (False, "time")
    assert failed.seconds == pytest.approx(3.0, abs=0.1)


def test_restored_check_of_a_long_motion_has_the_same_verdict(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(rehearsal, "LONG", 1.0)
    goal = joint_target(aftdeck.load_arm("srms"), (-31.0, 89.0, -118.0, -77.0, 17.0, -128.0))
    sim = aftdeck.Simulation(scenario(BAY, f'{OPR}law = "closed loop"\n'))
    sim.step(aftdeck.Inputs(target=goal))
    for _ in range(3):
        sim.step(aftdeck.Inputs())
    other = copy.deepcopy(sim)
    frames = [[one.step(aftdeck.Inputs()) for _ in range(60)][-1] for one in (sim, other)]
    assert frames[0].check is not None and frames[0].check == frames[1].check
