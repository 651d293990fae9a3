"""Operator inputs: allowed and rejected values, and the effect of the switches."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import aftdeck
from aftdeck.errors import InputError
from aftdeck.steering.mode import MODES
from tests.steering.flying import BAY, PAYLOAD, fly, joint_target, scenario, speed, target

LEVEL = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


Target: Any = aftdeck.Target
"""The class without its types, as for a caller without a type checker."""


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"translation": (1.0001, 0.0, 0.0)}, r"^translation: got \(1\.0001"),
        ({"rotation": (0.0, -2.0, 0.0)}, r"^rotation: got \(0\.0, -2\.0"),
        ({"drive": 1.5}, r"^drive: got 1\.5\b"),
        ({"drive": math.nan}, "^drive: got nan"),
        ({"translation": (math.inf, 0.0, 0.0)}, r"^translation: got \(inf"),
        ({"translation": (0.0, 0.0)}, "^translation: "),
        ({"translation": (0.0, 0.0), "rotation": (0.0, 0.0, 0.0, 0.0)}, "^translation: "),
        ({"rotation": (0.0, 0.0, 0.0, 0.0)}, "^rotation: "),
        ({"joint": 6}, "^joint: got 6"),
        ({"joint": -1}, "^joint: got -1"),
        ({"joint": 1.5}, r"^joint: got 1\.5"),
        ({"rate": "fast"}, "^rate: got 'fast', .* coarse or vernier$"),
        ({"effector": "shut"}, "^effector: got 'shut', .* stop, close or open$"),
        ({"effector_mode": "q"}, "^effector_mode: got 'q', .* auto or manual$"),
        ({"rigid": "z"}, "^rigid: got 'z', .* off, rigid or derigid$"),
        ({"latch": "x"}, "^latch: got 'x', .* latch or unlatch$"),
        ({"initialise": "all"}, "^initialise: got 'all', .* full problem, acquisition, "),
        ({"brakes": "on"}, "^brakes: got 'on', .* True or False$"),
        ({"mode": 3}, "^mode: got 3"),
        ({"joint": 2.0}, r"^joint: got 2\.0"),
        ({"translation": "abc"}, "^translation: got 'abc'"),
        ({"translation": "111"}, "^translation: got '111'"),
        ({"telescope": None}, "^telescope: got None"),
        ({"orbiter": None}, "^orbiter: got None"),
        ({"master": "abcdef"}, "^master: got 'abcdef'"),
        ({"camera": "A"}, "^camera: got 'A'.*CameraDrive"),
        ({"target": aftdeck.Target((math.nan, 0.0, 0.0), LEVEL)}, "^target: position: got nan m; "),
        ({"law": "feedback"}, "^law: got 'feedback', .* position, closed loop or open loop$"),
        ({"target": aftdeck.Target((0.0, 0.0, 0.0), LEVEL, (math.nan,) * 6)}, "^target: joints: got nan rad; "),
        ({"target": Target((0.0, 0.0), LEVEL)}, r"^target: .*\(3,\).*\(3, 3\)"),
        ({"target": Target((0.0, 0.0, 0.0), LEVEL[:2])}, r"^target: .*\(3,\).*\(3, 3\)"),
        ({"target": Target((0.0, 0.0, 0.0), LEVEL, (0.0,))}, "^target: joints: got 1 .* expected 6"),
        ({"target": Target((0.0, 0.0, 0.0), LEVEL, (0.0,) * 9)}, r"^target: .*\(3,\).*\(3, 3\)"),
        ({"target": Target((0.0, 0.0, 0.0), LEVEL, ())}, r"^target: .*\(3,\).*\(3, 3\)"),
        (
            {"target": aftdeck.Target((0.0, 0.0, 0.0), ((math.inf, 0.0, 0.0), *LEVEL[1:]))},
            "^target: rotation: got inf; ",
        ),
    ],
)
def test_invalid_inputs_are_rejected_without_effect(given: dict[str, Any], message: str) -> None:
    sim = aftdeck.Simulation(scenario())
    fly(sim, 0.2, aftdeck.Inputs(translation=(1.0, 0.0, 0.0)))
    before = sim.save()
    with pytest.raises(InputError, match=message):
        sim.step(aftdeck.Inputs(**given))
    assert sim.save() == before


def test_centred_sticks_keep_the_arm_still() -> None:
    sim = aftdeck.Simulation(scenario())
    frames = fly(sim, 2.0, aftdeck.Inputs())
    assert all(f.angles == tuple(sim.scenario.initial_angles.tolist()) for f in frames)
    assert {f.by for f in frames} == {"hand"} and sim.ended == ""


def test_switch_keeps_its_position() -> None:
    sim = aftdeck.Simulation(scenario())
    frame = sim.step(aftdeck.Inputs(mode="SINGLE", joint=4, rate="vernier"))
    assert (frame.mode, frame.joint, frame.rate) == ("SINGLE", 4, "vernier")
    frame = sim.step(aftdeck.Inputs())
    assert (frame.mode, frame.joint, frame.rate) == ("SINGLE", 4, "vernier")


@pytest.mark.parametrize("mode", ["PL", "ORB LD", "AUTO 1", "AUTO 4", "AUTO 9", "", "orb unl"])
def test_impossible_mode_is_rejected_and_the_mode_stays(mode: str) -> None:
    sim = aftdeck.Simulation(scenario())
    frame = sim.step(aftdeck.Inputs(mode=mode))
    assert frame.mode == "ORB UNL"
    (event,) = frame.events
    assert event.kind == "refused" and (mode or "''") in event.text
    assert (", ".join(MODES) in event.text) == (mode not in MODES)


def test_entry_of_a_mode_is_logged_once() -> None:
    sim = aftdeck.Simulation(scenario())
    (event,) = (e for f in fly(sim, 0.2, aftdeck.Inputs(mode="END EFF")) for e in f.events)
    assert event.kind == "mode" and "END EFF" in event.text
    assert sim.step(aftdeck.Inputs(mode="END EFF")).events == ()


def test_leaving_automatic_mode_stops_the_arm_for_good() -> None:
    sim = aftdeck.Simulation(scenario(BAY, 'mode = "OPR CMD"'))
    goal = target(sim.scenario.arm, (BAY[0] + 20, *BAY[1:]))
    assert speed(fly(sim, 3.0, aftdeck.Inputs(target=goal, proceed=True))[-1]) > 0.1
    assert speed(fly(sim, 5.0, aftdeck.Inputs(mode="ORB UNL"))[-1]) == 0.0
    back = fly(sim, 1.0, aftdeck.Inputs(mode="OPR CMD"))[-1]
    assert back.sequence == "ready" and speed(back) == 0.0


def test_sticks_and_drive_act_only_in_their_modes() -> None:
    for mode, inputs in (
        ("OPR CMD", aftdeck.Inputs((1.0, 1.0, 1.0), (1.0, 1.0, 1.0), 1.0)),
        ("ORB UNL", aftdeck.Inputs(drive=1.0)),
        ("SINGLE", aftdeck.Inputs((1.0, 1.0, 1.0), (1.0, 1.0, 1.0))),
    ):
        sim = aftdeck.Simulation(scenario(BAY, f"mode = {mode!r}"))
        assert fly(sim, 1.0, inputs)[-1].angles == tuple(sim.scenario.initial_angles.tolist())


def test_limits_of_a_joint_are_logged_in_order() -> None:
    sim = aftdeck.Simulation(scenario((0, 60, -80, 110, 10, 0)))
    frames = fly(sim, 15.0, aftdeck.Inputs(mode="SINGLE", joint=3, drive=1.0))
    logged = [(f.zones[3], e.level) for f in frames for e in f.events if e.kind == "limit" and "wrist pitch" in e.text]
    assert logged == [(1, "caution"), (2, "caution"), (3, "caution")]
    # 114.4, 116.4 and 121.4 deg
    first = {z: math.degrees(next(f.angles[3] for f in frames if f.zones[3] == z)) for z in (1, 2)}
    assert first[1] == pytest.approx(114.4, abs=0.06) and first[2] == pytest.approx(116.4, abs=0.06)


def test_singular_lamp_and_log_follow_the_wrist_through_90_deg() -> None:
    sim = aftdeck.Simulation(scenario((0, 60, -80, 10, 70, 0)))
    frames = fly(sim, 18.0, aftdeck.Inputs(mode="SINGLE", joint=4, drive=1.0))
    for frame in frames:
        assert ("wrist" in frame.singular) == (abs(math.cos(frame.angles[4])) < 0.2)
    events = [e for f in frames for e in f.events if e.kind == "singular"]
    assert all("wrist" in event.text for event in events)
    assert (events[0].level, events[-1].level) == ("caution", "info")


def test_only_the_singularity_that_ends_is_logged_as_left_behind() -> None:
    sim = aftdeck.Simulation(scenario((0, 60, -8, 0, 83, 0)))
    frames = fly(sim, 8.0, aftdeck.Inputs(mode="SINGLE", joint=4, drive=-1.0))
    assert set(frames[0].singular) == {"elbow", "wrist"} and frames[-1].singular == ("elbow",)
    ended = [e.text for f in frames for e in f.events if e.kind == "singular" and e.level == "info"]
    assert ended == ["wrist singularity left behind"]


def test_target_with_contradicting_angles_is_rejected_without_effect() -> None:
    sim = aftdeck.Simulation(scenario(BAY, 'mode = "OPR CMD"'))
    sim.step(aftdeck.Inputs())
    before = sim.save()
    honest = joint_target(sim.scenario.arm, BAY)
    assert honest.joints is not None
    x, y, z = honest.position
    turned = joint_target(sim.scenario.arm, [*BAY[:5], BAY[5] + 2.0]).joints
    contradictions = {
        r"^target: .* 0\.5 m and \S+ deg .* 0\.001 m and 0\.01 deg": aftdeck.Target(
            (x, y, z + 0.5), honest.rotation, honest.joints
        ),
        r"^target: .* m and 2 deg ": aftdeck.Target(honest.position, honest.rotation, turned),
        r"^target: position: got 1e\+308 m; ": aftdeck.Target((1e308, 1e308, -1e308), honest.rotation, honest.joints),
        r"^target: joints: got 1e\+300 rad; ": aftdeck.Target(honest.position, honest.rotation, (1e300,) * 6),
        r"^target: rotation: got 1e\+308; ": aftdeck.Target(honest.position, ((1e308,) * 3,) * 3, honest.joints),
        r"^target: .* m and 154\.4 deg ": aftdeck.Target(honest.position, ((1.0,) * 3,) * 3, honest.joints),
    }
    for message, goal in contradictions.items():
        with pytest.raises(InputError, match=message):
            sim.step(aftdeck.Inputs(target=goal))
        assert sim.save() == before


@pytest.mark.parametrize("turns", [0.0, 1.0, -1.0])
def test_rounded_target_angles_agree_with_pose_in_any_revolution(turns: float) -> None:
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


def test_payload_axes_switch_is_logged_once() -> None:
    sim = aftdeck.Simulation(scenario(BAY, PAYLOAD.format(mass="100 lb")))
    sim.step(aftdeck.Inputs(mode="ORB LD"))
    for on, law in ((True, 7), (False, 4)):
        frame = sim.step(aftdeck.Inputs(payload_axes=on))
        assert [event.kind for event in frame.events] == ["payload axes"] and frame.law == law
        assert sim.step(aftdeck.Inputs(payload_axes=on)).events == ()
