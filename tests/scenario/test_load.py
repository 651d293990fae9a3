"""Effects of the fields of a scenario file."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import aftdeck
from aftdeck.scenario.limits import por_with
from aftdeck.scenario.load import parse_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.scenario.schema import Rate
from aftdeck.scenario.target import Target
from aftdeck.units import POUND
from tests.kinematics.poses import AXES, BODY, structural
from tests.steering.flying import BAY, fly, kinds, scenario, speed

INCH = 0.0254
MADE_UP = Path(__file__).parents[1] / "arms" / "made-up.toml"


def load(text: str, folder: Path = Path(".")) -> Scenario:
    return parse_scenario('title = "t"\n' + text, "a", "a.toml", folder)


def test_scenario_and_its_arrays_are_read_only() -> None:
    made = scenario()
    with pytest.raises(AttributeError):
        made.seed = 3  # type: ignore[misc]
    for array in (made.initial_angles, made.initial_rates, made.arm.limits.hard, made.arm.rate_limits):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 1.0


def test_joints_accept_units_or_radians() -> None:
    by_units = load('[initial]\njoints = ["0 deg", "60 deg", "-0.25 turn", 0.5, 0, "1 rad"]').initial_angles
    assert by_units == pytest.approx([0, math.pi / 3, -math.pi / 2, 0.5, 0, 1])


def test_mode_accepts_a_number_or_a_panel_position() -> None:
    assert scenario(extra="mode = 5").mode == scenario(extra='mode = "END EFF"').mode == "END EFF"


def test_pose_in_the_panel_frame_has_the_panel_coordinates() -> None:
    made = load(
        '[initial]\nnear = ["-31 deg", "79 deg", "-103 deg", "-77 deg", "17 deg", "-128 deg"]\n'
        '[initial.pose]\nframe = "panel"\nposition = ["-942 in", "10 in", "-560 in"]\npitch = "270 deg"\n'
    )
    pose = made.arm.forward(made.initial_angles)
    assert structural(pose.position) / INCH == pytest.approx([942, 10, 560])
    e_axes = BODY @ AXES @ made.arm.end_effector(pose.rotation)
    # a pitch of 270 deg turns the forward axis straight down
    assert e_axes[:, 0] == pytest.approx([0, 0, 1], abs=1e-12)
    assert e_axes[:, 1] == pytest.approx([0, 1, 0], abs=1e-12)


def test_pose_in_the_orbiter_frame_accepts_endori_angles_or_a_matrix() -> None:
    angles = load('[initial.pose]\nposition = ["5 m", "-1 m", "-6 m"]\nroll = 0.2\npitch = 0.3\nyaw = 2.9\n')
    rotation = Rotation.from_euler("ZYX", [2.9, 0.3, 0.2]).as_matrix()
    rows = [[float(x) for x in row] for row in rotation]
    matrix = load(f"[initial.pose]\nposition = [5, -1, -6]\nmatrix = {rows}\n")
    assert matrix.initial_angles == pytest.approx(angles.initial_angles, abs=1e-9)
    pose = angles.arm.forward(angles.initial_angles)
    assert BODY @ AXES @ pose.rotation == pytest.approx(rotation, abs=1e-9)
    # the orbiter frame's origin: Xo 1097, Yo 0, Zo 375 in
    body = BODY @ (structural(pose.position) - np.array([1097, 0, 375]) * INCH)
    assert body == pytest.approx([5, -1, -6], abs=1e-9)


def test_pose_in_l_uses_the_branch_nearest_to_near() -> None:
    arm = aftdeck.load_arm("srms")
    for q in arm.inverse(arm.forward(np.radians(BAY))):
        pose = arm.forward(q)
        rows, near = pose.rotation.tolist(), q.tolist()
        made = load(
            f"[initial]\nnear = {near}\n[initial.pose]\nframe = 'L'\n"
            f"position = {pose.position.tolist()}\nmatrix = {rows}\n"
        )
        assert made.initial_angles == pytest.approx(q, abs=1e-9)


def test_target_by_joints_is_the_pose_of_those_joints() -> None:
    made = load(
        "[initial]\njoints = [0, 1, -1, 0, 0, 0]\n[[phase]]\nmode = 2\n[phase.target]\njoints = [0.1, 1, -1, 0, 0, 0]"
    )
    target = made.phases[0].target
    assert isinstance(target, Target)
    assert target.position == pytest.approx(made.arm.forward([0.1, 1, -1, 0, 0, 0]).position)


def test_arm_file_is_found_beside_the_scenario() -> None:
    made = load("arm = 'made-up.toml'\n[initial]\njoints = [0, 1, -1, 0, 0, 0]", MADE_UP.parent)
    assert made.arm.name == "made-up"
    frames = fly(aftdeck.Simulation(made), 1.0, aftdeck.Inputs(translation=(0.3, 0.0, 0.0)))
    assert speed(frames[-1]) > 0.1


def test_scenario_hard_limits_stop_the_joint() -> None:
    hard = "[[-3, 3], [0, 2], [-2, 0], [-1.5, 1.5], [-2, 2], [-3, 3]]"
    made = scenario((0, 60, -80, 10, 0, 0), f"[limits]\nhard = {hard}\nsoft = {hard}\nreach = {hard}")
    frames = fly(aftdeck.Simulation(made), 60.0, aftdeck.Inputs(mode="SINGLE", joint=5, drive=1.0))
    fly_on = fly(aftdeck.Simulation(made), 60.0, aftdeck.Inputs(mode="SINGLE", joint=1, drive=1.0))
    assert max(f.angles[1] for f in fly_on) == pytest.approx(2.0, abs=1e-9)
    assert max(f.angles[5] for f in frames) < 3.0


def test_scenario_soft_and_reach_limits_move_the_zones() -> None:
    soft = "[[-3, 3], [0.1, 2], [-2, -0.1], [-1.5, 1.5], [-1, 1], [-3, 3]]"
    reach = "[[-3, 3], [0.1, 2], [-2, -0.1], [-1.5, 1.5], [-0.5, 0.5], [-3, 3]]"
    made = [
        aftdeck.Simulation(scenario((0, 60, -80, 10, yaw, 0), f"[limits]\nsoft = {soft}\nreach = {reach}")).step()
        for yaw in (20, 40, 60)
    ]
    assert [frame.zones[4] for frame in made] == [0, 1, 2]


@pytest.mark.parametrize("which", ["servo", "coarse", "vernier"])
def test_scenario_joint_rates_replace_those_of_the_arm(which: str) -> None:
    own = {"servo": "3 deg/s", "coarse": "1 deg/s", "vernier": "0.1 deg/s"}[which]
    made = scenario(BAY, f"[limits]\n{which} = {[own] * 6}")
    mode = "ORB UNL" if which == "servo" else "SINGLE"
    sim = aftdeck.Simulation(made)
    rate: Rate = "vernier" if which == "vernier" else "coarse"
    frame = fly(sim, 6.0, aftdeck.Inputs(mode=mode, rate=rate, joint=0, drive=1.0))[-1]
    assert np.degrees(frame.rate_limits) == pytest.approx([float(own.split()[0])] * 6)
    if mode == "SINGLE":
        assert math.degrees(frame.rates_commanded[0]) == pytest.approx(float(own.split()[0]))


def test_scenario_por_limits_replace_those_of_the_arm_for_any_payload() -> None:
    por = '[limits.por]\ntranslation = "1 ft/s"\nvernier_translation = "0.1 ft/s"\nrotation = "2 deg/s"\n'
    por += 'vernier_rotation = "0.5 deg/s"\nreached_in = "2 s"\n'
    for payload in ("", "[payload]\nmass = 20000\n"):
        sim = aftdeck.Simulation(scenario(BAY, por + payload))
        frames = fly(sim, 3.0, aftdeck.Inputs(translation=(0.0, 0.0, -1.0)))
        assert frames[-1].por_limits == pytest.approx((0.3048, math.radians(2)))
        assert speed(frames[-1]) == pytest.approx(0.3048)
        assert speed(frames[49]) == pytest.approx(0.1524)
        assert fly(sim, 0.02, aftdeck.Inputs(rate="vernier"))[0].por_limits == pytest.approx(
            (0.03048, math.radians(0.5))
        )


def test_payload_mass_selects_the_por_limits() -> None:
    made = scenario(BAY, '[payload]\nmass = "15000 lb"\nposition = ["3 m", 0, 0]\nyaw = "90 deg"\npor = [0, 1, 0]')
    por = por_with(made.arm.model, made.payload.mass if made.payload else 0.0, made.por)
    assert por.translation == pytest.approx(por_with(made.arm.model, 15_000.0 * POUND, made.por).translation)
    assert por.translation[0] < por_with(made.arm.model, 5_000.0 * POUND, made.por).translation[0]
    assert made.payload is not None and made.payload.centre.tolist() == [3.0, 0.0, 0.0]
    # the payload is rotated by 90 deg about axis 3, so its axis 1 is axis 2 of frame 7
    assert made.payload.rotation[:, 0] == pytest.approx([0.0, 1.0, 0.0])
    assert made.payload.por.tolist() == [0.0, 1.0, 0.0]


def test_initial_rates_apply_in_the_first_step() -> None:
    made = load('[initial]\njoints = [0, 1, -1, 0, 0, 0]\nrates = ["1 deg/s", 0, 0, 0, 0, 0]')
    frame = aftdeck.Simulation(made).step(aftdeck.Inputs())
    assert 0.9 < math.degrees(frame.rates_commanded[0]) <= 1.0


def test_scenario_sets_the_arrival_tolerance() -> None:
    for within in (1e-2, 1e-4):
        text = f"arrive_within = {within}\narrive_within_angle = '1 deg'\n[initial]\njoints = [0.3, 1, -1, 0, 0.1, 0]\n"
        done = aftdeck.run(load(text + "[[phase]]\nmode = 2\ntarget = { joints = [0.4, 1, -1, 0, 0.1, 0] }"))
        assert done.summary.ended == "completed"
        assert done.summary.position_error_m is not None and done.summary.position_error_m <= within


def test_scenario_sets_soft_stop_rule_rate_mode_and_period() -> None:
    made = scenario(BAY, 'soft_stops = "as-flown"\nrate = "vernier"\nmode = 5\ncontrol_period = "80 ms"\nduration = 8')
    assert made.as_flown and not made.strict
    frame = aftdeck.Simulation(made).step()
    assert (frame.rate, frame.mode, frame.time_s) == ("vernier", "END EFF", 0.08)
    assert made.ticks == 100 and not kinds(frame)
