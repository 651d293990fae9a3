"""Mode 3: a plan that is made once and never corrected; each step advances its clock by RATIO control periods."""

from __future__ import annotations

import math
import re
from pathlib import Path

import numpy as np
import pytest

import aftdeck
from aftdeck.scenario.load import load_scenario, parse_scenario
from aftdeck.steering.profiles import OpenProfile, vtopen
from aftdeck.steering.rules import rules_of
from tests import loaded
from tests.reference.tables import table
from tests.steering.flying import BAY, QUICK, disturbed, finished, fly, log_of, scenario, speed, target, turning

STS_400 = table("sts-400")
OPEN = 'mode = "OPR CMD"\nlaw = "open loop"'
V, W = 2.0 * 0.3048, math.radians(4.76)
"""Greatest speed [m/s] and angular rate [rad/s], each reached in 4 s."""


def final_error(frames: list[aftdeck.Frame]) -> tuple[float, float]:
    """Return distance [m] and angle [rad] of the last frame's tip from its target."""
    goal = frames[-1].goal
    assert goal is not None
    return goal.distance, goal.angle


def profile(distance: float, angle: float, *, strict: bool) -> OpenProfile:
    """Return the profile of VTOPEN with the SRMS's coarse limits, unloaded."""
    model = loaded.arm().model
    rules = rules_of(model, model.por_limits(0.0), 0.02, strict=strict)["OPR CMD", "coarse", 3]
    return vtopen(rules, distance, angle)


@pytest.mark.parametrize("strict", [True, False])
@pytest.mark.parametrize(
    ("distance", "angle", "speed_", "turn", "eta", "ramp"),
    [
        # 20 s at 2 ft/s and a ramp of 4 s at both ends
        (20.0 * V, 0.0, V, 0.0, 24.0, 4.0),
        # 2 ft are too short for the ramps: 2 s of acceleration at 0.5 ft/s2, and 2 s of braking
        (V, 0.0, 0.5 * V, 0.0, 4.0, 2.0),
        # alone, the rotation would take 10 + 4 s; here it takes 24 s like the translation, at 10 W / (24 - 4)
        (20.0 * V, 10.0 * W, V, 0.5 * W, 24.0, 4.0),
        (0.0, W, 0.0, 0.5 * W, 4.0, 2.0),
    ],
)
def test_vtopen_agrees_with_hand_calculation(
    distance: float, angle: float, speed_: float, turn: float, eta: float, ramp: float, strict: bool
) -> None:
    found = profile(distance, angle, strict=strict)
    assert (found.speed, found.turn, found.eta) == pytest.approx((speed_, turn, eta))
    for left, time in ((distance, found.t_v1), (angle, found.t_w1)):
        assert time == pytest.approx(ramp) or not left


def test_vtopen_as_published_keeps_the_ramp_of_the_shorter_motion() -> None:
    # alone, the translation would take 4 s; here it takes 14 s like the rotation, at V / (14 - 2)
    assert profile(V, 10.0 * W, strict=True) == pytest.approx((V / 12.0, W, 14.0, 14.0, 2.0, 4.0))


def test_vtopen_gives_the_shorter_motion_the_ramp_of_the_longer() -> None:
    assert profile(V, 10.0 * W, strict=False) == pytest.approx((V / 10.0, W, 14.0, 14.0, 4.0, 4.0))


@pytest.mark.parametrize("strict", [True, False])
def test_vtopen_at_the_target_is_zero(strict: bool) -> None:
    assert set(profile(0.0, 0.0, strict=strict)) == {0.0}


@pytest.mark.parametrize("period", [0.02, 0.08])
def test_tip_follows_the_plan_without_joint_limits(period: float) -> None:
    sim = aftdeck.Simulation(scenario(BAY, f"{OPEN}\ncontrol_period = {period}\nduration = 80\n{QUICK}"))
    here = target(sim.scenario.arm, BAY)
    x, y, z = here.position
    goal = aftdeck.Target((x, y, z - 10.0 * V / 3.0), here.rotation)  # 10/3 s at full speed are too short for the ramps
    frames = finished(sim, aftdeck.Inputs(target=goal, proceed=True), 60.0)
    eta = 2.0 * math.sqrt(4.0 * 10.0 / 3.0)
    flown = [f for f in frames if f.sequence == "in progress"]
    assert flown[0].goal is not None and flown[0].goal.remaining_s == pytest.approx(eta, abs=1e-9)
    assert frames[-1].time_s - flown[0].time_s == pytest.approx(eta, abs=3 * period)
    assert max(speed(f) for f in frames) == pytest.approx(V * eta / 8.0, rel=0.02)
    assert max(turning(f) for f in frames) < 1e-9
    assert final_error(frames)[0] < 5e-3 and final_error(frames)[1] < 1e-4


def test_sts_400_open_loop_ends_within_25_mm() -> None:
    done = aftdeck.run("sts-400-open")
    assert done.summary.ended == "completed"
    assert done.summary.position_error_m is not None and done.summary.position_error_m <= 0.025
    assert done.summary.rotation_error_rad is not None and done.summary.rotation_error_rad <= math.radians(0.1)
    assert [e.level for e in done.events if e.kind == "arrived"] == ["info"]


def test_strict_open_loop_has_the_reference_final_error() -> None:
    text = f"strict = true\n{load_scenario('sts-400-open').text}"
    done = aftdeck.run(parse_scenario(text, "strict", "strict.toml", Path(".")))
    share = STS_400["tolerance"]
    assert done.summary.position_error_m == pytest.approx(STS_400["open_loop_miss"], rel=share)
    assert done.summary.rotation_error_rad == pytest.approx(math.radians(STS_400["open_loop_turn_miss"]), rel=share)
    texts = {e.kind: e.text for e in done.summary.events}
    amount = r"10\.5\d m, 61\.\d°"
    assert re.search(amount, texts["arrived"]) and re.search(rf"GOOD: \d+ s, .*{amount}", texts["check"])


def final_error_after_a_disturbance(law: str) -> tuple[float, float]:
    sim = aftdeck.Simulation(scenario(BAY, f'mode = "OPR CMD"\nlaw = "{law}"'))
    goal = target(sim.scenario.arm, (BAY[0] + 25.0, BAY[1] - 10.0, *BAY[2:]))
    flown = fly(sim, 6.0, aftdeck.Inputs(target=goal, proceed=True))
    disturbed(sim, {1: math.degrees(flown[-1].angles[1]) + 0.5})
    return final_error(finished(sim, aftdeck.Inputs(), 90.0))


def test_mode_2_corrects_a_disturbance_and_mode_3_does_not() -> None:
    assert final_error_after_a_disturbance("closed loop") < (1e-4, 2e-5)
    distance, turn = final_error_after_a_disturbance("open loop")
    # an error of half a degree in shoulder pitch; the shoulder joint is 8 m or more from the tip
    assert 0.05 < distance < 0.2 and turn == pytest.approx(math.radians(0.5), rel=0.2)


def test_proceed_after_stop_makes_a_new_plan() -> None:
    sim = aftdeck.Simulation(scenario(BAY, OPEN))
    goal = target(sim.scenario.arm, (BAY[0] + 25.0, *BAY[1:]))
    fly(sim, 6.0, aftdeck.Inputs(target=goal, proceed=True))
    stopping = fly(sim, 5.0, aftdeck.Inputs(stop=True))
    assert {f.sequence for f in stopping} == {"ready"} and speed(stopping[-1]) == 0.0
    assert stopping[-1].goal is not None and stopping[-1].goal.remaining_s == 0.0
    frames = finished(sim, aftdeck.Inputs(proceed=True), 90.0)
    assert frames[-1].sequence == "idle" and final_error(frames)[0] < 0.01
    assert [e.kind for f in frames for e in f.events if e.kind == "proceed"] == ["proceed"]


def test_limits_slow_the_clock_and_keep_the_path() -> None:
    ends = {}
    for quick in (True, False):
        sim = aftdeck.Simulation(scenario(BAY, f"{OPEN}\n{QUICK if quick else ''}"))
        goal = target(sim.scenario.arm, (BAY[0] + 40.0, BAY[1] - 20.0, *BAY[2:]))
        frames = finished(sim, aftdeck.Inputs(target=goal, proceed=True), 120.0)
        a, b = np.array(frames[0].position), np.array(goal.position)
        along = (b - a) / np.linalg.norm(b - a)
        off = np.array([f.position for f in frames]) - a
        assert np.linalg.norm(off - np.outer(off @ along, along), axis=1).max() < 5e-3
        assert final_error(frames)[0] < 0.01
        ends[quick] = frames[-1].time_s
    assert ends[False] > ends[True] + 1.0


def test_proceed_at_speed_plans_from_rest() -> None:
    sim = aftdeck.Simulation(scenario(BAY))
    fly(sim, 5.0, aftdeck.Inputs((1.0, 0.0, 0.0)))
    goal = target(sim.scenario.arm, (BAY[0] + 20.0, *BAY[1:]))
    frames = finished(sim, aftdeck.Inputs(mode="OPR CMD", law="open loop", target=goal, proceed=True), 90.0)
    assert final_error(frames)[0] < 0.01


def test_missed_target_is_logged_with_final_error() -> None:
    sim = aftdeck.Simulation(scenario(BAY, OPEN))
    flown = fly(sim, 6.0, aftdeck.Inputs(target=target(sim.scenario.arm, (BAY[0] + 25.0, *BAY[1:])), proceed=True))
    disturbed(sim, {1: math.degrees(flown[-1].angles[1]) + 2.0})
    last = finished(sim, aftdeck.Inputs(), 90.0)[-1]
    (text,) = log_of([last])
    found = re.fullmatch(r"target missed: final error (\d+) mm, (\d+\.\d)°", text)
    assert found, text
    assert float(found[1]) == pytest.approx(1e3 * final_error([last])[0], abs=1.0)
    assert float(found[2]) == pytest.approx(math.degrees(final_error([last])[1]), abs=0.06)
    assert [(e.kind, e.level) for e in last.events] == [("arrived", "caution")]


@pytest.mark.parametrize("law", ["open loop", "position"])
def test_small_final_error_counts_as_reached(law: str) -> None:
    sim = aftdeck.Simulation(scenario(BAY, f'mode = "OPR CMD"\nlaw = "{law}"'))
    flown = fly(sim, 6.0, aftdeck.Inputs(target=target(sim.scenario.arm, (BAY[0] + 25.0, *BAY[1:])), proceed=True))
    disturbed(sim, {5: math.degrees(flown[-1].angles[5]) + 0.01})
    last = finished(sim, aftdeck.Inputs(), 90.0)[-1].events[-1]
    assert (last.kind, last.level) == ("arrived", "info")
    wider = aftdeck.Simulation(
        scenario(BAY, f'mode = "OPR CMD"\nlaw = "{law}"\narrive_within = 1.0\narrive_within_angle = "5 deg"')
    )
    flown = fly(wider, 6.0, aftdeck.Inputs(target=target(sim.scenario.arm, (BAY[0] + 25.0, *BAY[1:])), proceed=True))
    disturbed(wider, {1: math.degrees(flown[-1].angles[1]) + 2.0})
    frames = finished(wider, aftdeck.Inputs(), 90.0)
    assert frames[-1].events[-1].level == "info" and final_error(frames)[0] > 0.1
