"""JSC-12628's phase inputs in a script: velocities in physical units, and the limits and payload of each phase."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import pytest

import aftdeck
from aftdeck.arrays import Array
from aftdeck.errors import ScenarioError
from aftdeck.simulation.frame import Frame
from tests.steering.flying import BAY, BODY_FROM_L, FOOT, PAYLOAD, fly, heavy_por, scenario

CONCEPT = (10.0, 50.0, -80.0, 15.0, 20.0, -10.0)
V, W = np.array([0.1, -0.2, 0.05]), np.array([0.3, 0.6, -0.5])
"""V_C' [ft/s] and omega_C' [deg/s], below every limit."""
SLOW_JOINTS = """
[phase.limits]
coarse = ["0.6 deg/s", "0.6 deg/s", "0.6 deg/s", "0.6 deg/s", "0.6 deg/s", "0.6 deg/s"]
vernier = ["0.1 deg/s", "0.1 deg/s", "0.1 deg/s", "0.1 deg/s", "0.1 deg/s", "0.1 deg/s"]
"""
SLOWER = """
[phase.limits]
por = { translation = "0.3 ft/s", vernier_translation = "0.1 ft/s", acceleration = "0.02 ft/s/s" }
"""


def flown(made: aftdeck.Scenario) -> list[Frame]:
    """Return the frames of a script, except the last frame, in which the script has ended."""
    sim = aftdeck.Simulation(made)
    frames = [sim.step()]
    while not sim.ended:
        frames.append(sim.step())
    return frames[:-1]


def by_script(joints: Sequence[float], *phases: str, head: str = "") -> list[Frame]:
    """Return the frames of a script with these phases."""
    return flown(
        scenario(joints, f"control_period = 0.08\n{head}\n" + "".join(f"[[phase]]\n{phase}\n" for phase in phases))
    )


def velocities(v: Array, w: Array) -> str:
    return (
        f"velocity = {[f'{x!r} ft/s' for x in v.tolist()]}\nangular_velocity = {[f'{x!r} deg/s' for x in w.tolist()]}\n"
    )


@pytest.mark.parametrize("mode", ["ORB UNL", "END EFF"])
@pytest.mark.parametrize(("arm", "joints"), [("srms", BAY), ("concept-1972", CONCEPT)])
def test_phase_velocities_are_in_the_frame_of_the_mode(arm: str, joints: Sequence[float], mode: str) -> None:
    frames = by_script(joints, f'mode = "{mode}"\nduration = 10\n{velocities(V, W)}', head=f'arm = "{arm}"')
    last, model = frames[-1], aftdeck.load_arm(arm).model
    turn = model.mount.rotation.T if mode == "ORB UNL" else np.array(last.orientation)
    if mode == "END EFF":
        roll = model.end_effector_roll
        turn = turn @ np.array([[1, 0, 0], [0, math.cos(roll), -math.sin(roll)], [0, math.sin(roll), math.cos(roll)]])
    np.testing.assert_allclose(last.twist_commanded[3:], turn @ V * FOOT, atol=2e-4)
    np.testing.assert_allclose(last.twist_commanded[:3], turn @ np.radians(W), atol=2e-4)


def test_phase_velocity_beyond_limit_keeps_its_direction() -> None:
    most = '[phase.limits]\npor = { translation = "0.4 ft/s", vernier_translation = "0.1 ft/s" }\n'
    frames = by_script(BAY, f'mode = "ORB UNL"\nduration = 12\n{velocities(100.0 * V, 0.0 * W)}{most}')
    moved = BODY_FROM_L @ np.array(frames[-1].twist_commanded[3:])
    np.testing.assert_allclose(moved / FOOT, 0.4 * V / np.linalg.norm(V), atol=1e-9)


@pytest.mark.parametrize("rate", ["coarse", "vernier"])
@pytest.mark.parametrize("mode", ["SINGLE", "DIRECT"])
def test_phase_joint_rate_is_in_physical_units(mode: str, rate: str) -> None:
    drive = f'mode = "{mode}"\njoint = "wrist_yaw"\njoint_rate = "-0.02 deg/s"\nrate = "{rate}"\nduration = 4'
    assert by_script(BAY, drive)[-1].rates[4] == pytest.approx(math.radians(-0.02), abs=1e-12)


def test_phase_limits_apply_only_during_the_phase() -> None:
    push = 'mode = "ORB UNL"\nduration = 20\ntranslation = [1.0, 0.0, 0.0]\n'
    turn = 'mode = "SINGLE"\njoint = "wrist_roll"\ndrive = 1.0\nduration = 10\n'
    frames = by_script(BAY, push + SLOWER, turn + SLOW_JOINTS, turn, push)
    speeds = np.array([np.linalg.norm(f.twist_commanded[3:]) for f in frames[:250]]) / FOOT
    assert speeds.max() == pytest.approx(0.3) and np.diff(speeds).max() <= 0.02 * 0.08 + 1e-12
    assert frames[249].por_limits[0] == pytest.approx(0.3 * FOOT)
    own = aftdeck.load_arm("srms").model.rates.coarse[5]
    assert frames[370].rates[5] == pytest.approx(math.radians(0.6)) and frames[490].rates[5] == pytest.approx(own)
    assert frames[-1].por_limits[0] == pytest.approx(2.0 * FOOT)


def test_manual_inputs_restore_the_scenarios_limits() -> None:
    made = scenario(BAY, f'control_period = 0.08\n[[phase]]\nmode = "ORB UNL"\nduration = 20\n{SLOWER}')
    sim = aftdeck.Simulation(made)
    assert sim.step().por_limits[0] == pytest.approx(0.3 * FOOT)
    assert fly(sim, 20.0, aftdeck.Inputs((1.0, 0.0, 0.0)))[-1].por_limits[0] == pytest.approx(2.0 * FOOT)


@pytest.mark.parametrize("law", ["position", "closed loop", "open loop"])
@pytest.mark.parametrize("strict", ["false", "true"])
def test_automatic_phase_keeps_its_limits_also_after_restore(law: str, strict: str) -> None:
    there = '{ joints = ["-25 deg", "70 deg", "-95 deg", "-70 deg", "10 deg", "-120 deg"] }'
    phase = f'[[phase]]\nmode = "OPR CMD"\nlaw = "{law}"\ntarget = {there}\n{SLOWER}'
    sim = aftdeck.Simulation(scenario(BAY, f"control_period = 0.08\nstrict = {strict}\n{phase}"))
    frames: list[Frame] = []
    saved = None
    while not (frames and sim.ended):
        if len(frames) == 100:
            saved = sim.save()
        frames.append(sim.step())
    assert sim.ended == "completed"
    if not (law == "position" and strict == "true"):  # mode 1 of the report has no POR limit
        assert max(np.linalg.norm(f.twist_commanded[3:]) for f in frames) <= 0.3 * FOOT + 1e-9
    assert saved is not None
    sim.restore(saved)
    assert [sim.step().sha256 for _ in frames[100:]] == [f.sha256 for f in frames[100:]]


def test_payload_attached_by_phase_equals_payload_held_from_start() -> None:
    payload = PAYLOAD.format(mass="1000 lb")
    turn = 'mode = "PL"\nrotation = [0.0, 1.0, 0.0]\nduration = 20\n'
    still = 'mode = "ORB UNL"\nduration = 0.08\n'
    held = flown(scenario(BAY, f"control_period = 0.08\n{payload}\n[[phase]]\n{still}\n[[phase]]\n{turn}"))
    attached = by_script(BAY, still, turn + payload.replace("[payload]", "[phase.payload]"))
    assert held[0].payload is not None and attached[0].payload is None
    for a, b in zip(held[1:], attached[1:], strict=True):
        assert a.angles == b.angles and a.payload == b.payload and a.twist_commanded == b.twist_commanded
    assert attached[-1].work.hand.flags == held[-1].work.hand.flags


def test_phase_detaches_the_payload() -> None:
    payload = PAYLOAD.format(mass="32000 lb").replace("[payload]", "[phase.payload]")
    push = 'mode = "ORB UNL"\ntranslation = [0.2, 0.0, 0.0]\nduration = 8\n'
    frames = by_script(BAY, push + payload, push, push + "detached = true\n")
    assert [frames[k].payload is None for k in (99, 199, 299)] == [False, False, True]
    assert frames[199].por_limits[0] == pytest.approx(heavy_por().translation[0])
    assert frames[299].por_limits[0] == pytest.approx(2.0 * FOOT)
    assert "CAPTURE" in frames[199].work.hand.flags and "CAPTURE" not in frames[299].work.hand.flags


@pytest.mark.parametrize(("place", "joints"), [('worksite = "orbiter"', BAY), ('arm = "concept-1972"', CONCEPT)])
def test_end_effector_is_blocked_while_phase_attaches_a_payload(place: str, joints: Sequence[float]) -> None:
    payload = PAYLOAD.format(mass="1000 lb").replace("[payload]", "[phase.payload]")
    still = 'mode = "ORB UNL"\nduration = 1\n'
    phases = "".join(f"[[phase]]\n{phase}\n" for phase in (still, still + payload, still + "detached = true\n"))
    for phase, attached in enumerate((0, 1, 0)):
        sim = aftdeck.Simulation(scenario(joints, f"{place}\ncontrol_period = 0.08\n{phases}"))
        while (frame := sim.step()).phase != f"ORB UNL, phase[{phase}]":
            assert not sim.ended
        before, after = frame, sim.step(aftdeck.Inputs(effector="close"))
        assert before.attached == after.attached == attached
        assert any(event.kind == "refused" for event in after.events) == bool(attached)
        for _ in range(4):
            after = sim.step(aftdeck.Inputs())
        assert (after.work.hand.opening != before.work.hand.opening) == (not attached)


@pytest.mark.parametrize(
    ("phase", "named"),
    [
        ('mode = "ORB UNL"\nduration = 1\ntranslation = [1.0, 0.0, 0.0]\nvelocity = [1.0, 0.0, 0.0]', "velocity"),
        ('mode = "ORB UNL"\nduration = 1\njoint_rate = "1 deg/s"', "joint_rate"),
        ('mode = "SINGLE"\njoint = "wrist_yaw"\njoint_rate = "1 deg/s"\njoint_at = "3 deg"', "joint_rate"),
        ('mode = "PL"\nduration = 1', "payload"),
        ('mode = "ORB UNL"\nduration = 1\ndetached = true', "attached"),
        ('mode = "ORB UNL"\nduration = 1\npayload = { mass = "0 lb" }', "mass"),
        ('mode = "ORB UNL"\nduration = 1\nlimits = { por = { translation = "-1 ft/s" } }', "translation"),
        ('mode = "ORB UNL"\nduration = 1\nlimits = { hard = [] }', "hard"),
        ('mode = "ORB UNL"\nduration = 1\nvelocity = ["1 deg/s", 0.0, 0.0]', "velocity"),
    ],
)
def test_invalid_phase_inputs_are_rejected_with_their_line(phase: str, named: str) -> None:
    with pytest.raises(ScenarioError) as caught:
        scenario(BAY, f"[[phase]]\n{phase}")
    (problem,) = caught.value.problems
    assert named in problem and "test.toml:" in problem and "phase[0]" in problem
