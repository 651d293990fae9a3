"""What an operator may hand in, what is refused, and what the switches do."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import aftdeck
from aftdeck.errors import InputError
from tests.steering.flying import BAY, PAYLOAD, fly, joint_target, log_of, scenario, speed, target

POSITIONS = "OPR CMD, AUTO 1, AUTO 2, AUTO 3, AUTO 4, TEST, ORB UNL, END EFF, ORB LD, PL, SINGLE, DIRECT, MASTER"
LEVEL = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


Target: Any = aftdeck.Target
"""As a caller without a type checker sees it."""


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"translation": (1.0001, 0.0, 0.0)}, r"sticks lie in \[-1, 1\], got translation \(1.0001"),
        ({"rotation": (0.0, -2.0, 0.0)}, r"sticks lie in \[-1, 1\]"),
        ({"drive": 1.5}, r"sticks lie in \[-1, 1\].*drive 1.5"),
        ({"drive": math.nan}, r"sticks lie in \[-1, 1\]"),
        ({"translation": (math.inf, 0.0, 0.0)}, r"sticks lie in \[-1, 1\]"),
        ({"translation": (0.0, 0.0)}, "sticks"),
        ({"translation": (0.0, 0.0), "rotation": (0.0, 0.0, 0.0, 0.0)}, "sticks"),
        ({"joint": 6}, "joints are numbered 0 to 5, got 6"),
        ({"joint": -1}, "joints are numbered 0 to 5, got -1"),
        ({"joint": 1.5}, "joints are numbered 0 to 5, got 1.5"),
        ({"rate": "fast"}, "the rate switch stands at coarse or vernier, got 'fast'"),
        ({"effector": "shut"}, "the effector switch stands at stop, close or open, got 'shut'"),
        ({"effector_mode": "q"}, "the effector mode switch stands at auto or manual, got 'q'"),
        ({"rigid": "z"}, "the rigid switch stands at off, rigid or derigid, got 'z'"),
        ({"latch": "x"}, "the latch switch stands at latch or unlatch, got 'x'"),
        ({"initialise": "all"}, "the initialise switch stands at full problem, acquisition, .* got 'all'"),
        ({"brakes": "on"}, "the brakes switch stands at True or False, got 'on'"),
        ({"mode": 3}, "a panel position, a text, got 3"),
        ({"joint": 2.0}, "joints are numbered 0 to 5, got 2.0"),
        ({"translation": "abc"}, "sticks"),
        ({"translation": "111"}, "sticks"),
        ({"telescope": None}, "sticks"),
        ({"orbiter": None}, "sticks"),
        ({"master": "abcdef"}, "a master arm has six finite joint angles, got abcdef"),
        ({"camera": "A"}, "a camera is turned by a CameraDrive, got 'A'"),
        ({"target": aftdeck.Target((math.nan, 0.0, 0.0), LEVEL)}, "a target has finite numbers"),
        ({"law": "feedback"}, "the law switch stands at position, closed loop or open loop, got 'feedback'"),
        ({"target": aftdeck.Target((0.0, 0.0, 0.0), LEVEL, (math.nan,) * 6)}, "a target has finite numbers"),
        ({"target": Target((0.0, 0.0), LEVEL)}, r"a target has a position \(3\), a rotation \(3, 3\)"),
        ({"target": Target((0.0, 0.0, 0.0), LEVEL[:2])}, r"a target has a position \(3\), a rotation \(3, 3\)"),
        ({"target": Target((0.0, 0.0, 0.0), LEVEL, (0.0,))}, "six joint angles or none"),
        ({"target": Target((0.0, 0.0, 0.0), LEVEL, ())}, "six joint angles or none"),
        ({"target": aftdeck.Target((0.0, 0.0, 0.0), ((math.inf, 0.0, 0.0), *LEVEL[1:]))}, "a target has finite"),
    ],
)
def test_what_no_hand_controller_can_give_is_refused_and_changes_nothing(given: dict[str, Any], message: str) -> None:
    sim = aftdeck.Simulation(scenario())
    fly(sim, 0.2, aftdeck.Inputs(translation=(1.0, 0.0, 0.0)))
    before = sim.save()
    with pytest.raises(InputError, match=message):
        sim.step(aftdeck.Inputs(**given))
    assert sim.save() == before


def test_hands_off_holds_the_arm_where_it_is() -> None:
    sim = aftdeck.Simulation(scenario())
    frames = fly(sim, 2.0, aftdeck.Inputs())
    assert all(f.angles == tuple(sim.scenario.initial_angles.tolist()) for f in frames)
    assert {f.by for f in frames} == {"hand"} and sim.ended == ""


def test_a_switch_keeps_its_place_until_it_is_moved() -> None:
    sim = aftdeck.Simulation(scenario())
    frame = sim.step(aftdeck.Inputs(mode="SINGLE", joint=4, rate="vernier"))
    assert (frame.mode, frame.joint, frame.rate) == ("SINGLE", 4, "vernier")
    frame = sim.step(aftdeck.Inputs())
    assert (frame.mode, frame.joint, frame.rate) == ("SINGLE", 4, "vernier")


@pytest.mark.parametrize(
    ("mode", "said"),
    [
        ("PL", "PL refused: it moves a payload, and none is in the grasp"),
        ("ORB LD", "ORB LD refused: it moves a payload, and none is in the grasp"),
        ("AUTO 1", "AUTO 1 refused: no points are stored for it in this scenario"),
        ("AUTO 4", "AUTO 4 refused: no points are stored for it in this scenario"),
        ("AUTO 9", f"no mode 'AUTO 9': there are {POSITIONS}"),
        ("", f"no mode '': there are {POSITIONS}"),
        ("orb unl", f"no mode 'orb unl': there are {POSITIONS}"),
    ],
)
def test_a_mode_that_cannot_be_entered_is_refused_in_the_log_and_the_mode_stays(mode: str, said: str) -> None:
    sim = aftdeck.Simulation(scenario())
    frame = sim.step(aftdeck.Inputs(mode=mode))
    assert frame.mode == "ORB UNL"
    assert [(event.kind, event.text) for event in frame.events] == [("refused", said)]


def test_entering_a_mode_is_logged_once() -> None:
    sim = aftdeck.Simulation(scenario())
    texts = [e.text for f in fly(sim, 0.2, aftdeck.Inputs(mode="END EFF")) for e in f.events]
    assert len(texts) == 1 and texts[0].startswith("END EFF entered")
    assert sim.step(aftdeck.Inputs(mode="END EFF")).events == ()


def test_leaving_an_automatic_mode_under_way_stops_the_arm_and_coming_back_does_not_start_it() -> None:
    sim = aftdeck.Simulation(scenario(BAY, 'mode = "OPR CMD"'))
    goal = target(sim.scenario.arm, (BAY[0] + 20, *BAY[1:]))
    assert speed(fly(sim, 3.0, aftdeck.Inputs(target=goal, proceed=True))[-1]) > 0.1
    assert speed(fly(sim, 5.0, aftdeck.Inputs(mode="ORB UNL"))[-1]) == 0.0
    back = fly(sim, 1.0, aftdeck.Inputs(mode="OPR CMD"))[-1]
    assert back.sequence == "ready" and speed(back) == 0.0


def test_sticks_do_nothing_in_an_automatic_mode_and_the_drive_switch_nothing_in_a_manual_one() -> None:
    for mode, inputs in (
        ("OPR CMD", aftdeck.Inputs((1.0, 1.0, 1.0), (1.0, 1.0, 1.0), 1.0)),
        ("ORB UNL", aftdeck.Inputs(drive=1.0)),
        ("SINGLE", aftdeck.Inputs((1.0, 1.0, 1.0), (1.0, 1.0, 1.0))),
    ):
        sim = aftdeck.Simulation(scenario(BAY, f"mode = {mode!r}"))
        assert fly(sim, 1.0, inputs)[-1].angles == tuple(sim.scenario.initial_angles.tolist())


def test_passing_a_reach_limit_a_soft_stop_and_a_hard_stop_is_logged_in_turn() -> None:
    sim = aftdeck.Simulation(scenario((0, 60, -80, 110, 10, 0)))
    frames = fly(sim, 15.0, aftdeck.Inputs(mode="SINGLE", joint=3, drive=1.0))
    texts = [e.text for f in frames for e in f.events if e.kind == "limit"]
    assert texts == [
        "wrist pitch past its reach limit",
        "wrist pitch past its soft stop",
        "wrist pitch at its hard stop",
    ]
    # 114.4, 116.4 and 121.4 deg
    first = {z: math.degrees(next(f.angles[3] for f in frames if f.zones[3] == z)) for z in (1, 2)}
    assert first[1] == pytest.approx(114.4, abs=0.06) and first[2] == pytest.approx(116.4, abs=0.06)


def test_the_singular_lamp_and_the_log_follow_the_wrist_through_ninety_degrees() -> None:
    sim = aftdeck.Simulation(scenario((0, 60, -80, 10, 70, 0)))
    frames = fly(sim, 18.0, aftdeck.Inputs(mode="SINGLE", joint=4, drive=1.0))
    for frame in frames:
        assert ("wrist" in frame.singular) == (abs(math.cos(frame.angles[4])) < 0.2)
    texts = [e.text for f in frames for e in f.events if e.kind == "singular"]
    assert texts[0].startswith("wrist singularity near") and texts[-1] == "wrist singularity left behind"


def test_a_target_whose_joint_angles_contradict_its_pose_is_refused_by_how_much_and_nothing_changes() -> None:
    sim = aftdeck.Simulation(scenario(BAY, 'mode = "OPR CMD"'))
    sim.step(aftdeck.Inputs())
    before = sim.save()
    honest = joint_target(sim.scenario.arm, BAY)
    assert honest.joints is not None
    x, y, z = honest.position
    turned = joint_target(sim.scenario.arm, [*BAY[:5], BAY[5] + 2.0]).joints
    contradictions = {
        r"these 0\.5 m and \S+ deg beside it; 0\.001 m and 0\.01 deg are allowed": aftdeck.Target(
            (x, y, z + 0.5), honest.rotation, honest.joints
        ),
        r"these \S+ m and 2 deg beside it": aftdeck.Target(honest.position, honest.rotation, turned),
        r"these \S+e\+308 m and": aftdeck.Target((1e308, 1e308, -1e308), honest.rotation, honest.joints),
        r"these nan m and": aftdeck.Target(honest.position, honest.rotation, (1e300,) * 6),
        r"these \S+ m and 180 deg beside it": aftdeck.Target(honest.position, ((1e308,) * 3,) * 3, honest.joints),
    }
    for message, goal in contradictions.items():
        with pytest.raises(InputError, match=message):
            sim.step(aftdeck.Inputs(target=goal))
        assert sim.save() == before


@pytest.mark.parametrize("turns", [0.0, 1.0, -1.0])
def test_angles_rounded_to_a_thousandth_of_a_degree_agree_with_their_pose_in_any_revolution(turns: float) -> None:
    rng = np.random.default_rng(230)
    sim = aftdeck.Simulation(scenario(BAY, 'mode = "OPR CMD"'))
    for _ in range(30):
        joints = rng.uniform(-90.0, 90.0, 6)
        pose = target(sim.scenario.arm, joints.tolist())
        joints[5] += 360.0 * turns
        a, b, c, d, e, f = (math.radians(round(q, 3)) for q in joints.tolist())
        goal = aftdeck.Target(pose.position, pose.rotation, (a, b, c, d, e, f))
        frame = sim.step(aftdeck.Inputs(target=goal))
        assert frame.goal is not None and frame.goal.position == pose.position


def test_turning_the_switch_for_payload_axes_is_logged_once_each_way() -> None:
    sim = aftdeck.Simulation(scenario(BAY, PAYLOAD.format(mass="100 lb")))
    sim.step(aftdeck.Inputs(mode="ORB LD"))
    for on, said in ((True, "payload axes (mode 7)"), (False, "the orbiter's axes (mode 4)")):
        assert log_of([sim.step(aftdeck.Inputs(payload_axes=on))]) == [f"ORB LD rotates in {said}"]
        assert log_of([sim.step(aftdeck.Inputs(payload_axes=on))]) == []
