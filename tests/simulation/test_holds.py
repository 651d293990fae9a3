"""RATE HOLD keeps the stick command; POSITION HOLD keeps the pose and removes disturbances."""

from __future__ import annotations

import math

import numpy as np
import pytest

import aftdeck
from tests.steering.flying import BAY, FOOT, PAYLOAD, disturbed, fly, scenario, speed, turning

PUSH = aftdeck.Inputs(translation=(0.5, 0.0, -0.3), rotation=(0.0, 0.2, 0.0))
HOLD = aftdeck.Inputs(PUSH.translation, PUSH.rotation, rate_hold=True)


def held() -> aftdeck.Simulation:
    sim = aftdeck.Simulation(scenario())
    fly(sim, 1.0, PUSH)
    sim.step(HOLD)
    return sim


def test_rate_hold_equals_sticks_that_stay_deflected() -> None:
    by_hand = aftdeck.Simulation(scenario())
    fly(by_hand, 1.02, PUSH)
    pushed = fly(by_hand, 5.0, PUSH)
    centred = fly(held(), 5.0, aftdeck.Inputs())
    assert [f.angles for f in centred] == [f.angles for f in pushed]
    assert all(f.rate_hold for f in centred) and centred[-1].translation == PUSH.translation


@pytest.mark.parametrize(
    ("ends", "kinds"),
    [
        (aftdeck.Inputs(rate_hold=True), ["rate hold"]),
        (aftdeck.Inputs(stop=True), []),
        (aftdeck.Inputs(mode="END EFF"), ["mode"]),
    ],
)
def test_rate_hold_ends_and_arm_ramps_to_rest(ends: aftdeck.Inputs, kinds: list[str]) -> None:
    sim = held()
    before = fly(sim, 4.0, aftdeck.Inputs())[-1]
    frames = fly(sim, 6.0, ends)
    assert not any(f.rate_hold for f in frames)
    assert [event.kind for event in frames[0].events if event.kind != "limit"] == kinds
    for frame in frames:
        assert speed(before) - speed(frame) <= 2 * FOOT / 4 * 0.02 * (1 + 1e-9)
        before = frame
    assert speed(frames[-1]) == 0.0 and turning(frames[-1]) == 0.0


def test_rate_hold_is_rejected_with_centred_sticks_or_other_modes() -> None:
    sim = aftdeck.Simulation(scenario())
    frame = sim.step(aftdeck.Inputs(rate_hold=True))
    assert not frame.rate_hold
    assert [event.kind for event in frame.events] == ["refused"]
    for mode in ("SINGLE", "OPR CMD", "DIRECT", "TEST"):
        frame = sim.step(aftdeck.Inputs((1.0, 0.0, 0.0), mode=mode, rate_hold=True))
        assert not frame.rate_hold
        assert frame.events[-1].kind == "refused" and mode in frame.events[-1].text


def tip_error(frame: aftdeck.Frame, kept: aftdeck.Frame) -> tuple[float, float]:
    """Return distance [m] and angle [rad] between the tips of two frames."""
    turn = np.array(frame.orientation).T @ np.array(kept.orientation)
    skew = [turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]]
    return math.dist(frame.position, kept.position), math.asin(min(0.5 * math.hypot(*skew), 1.0))


@pytest.mark.parametrize("mode", ["ORB UNL", "END EFF", "ORB LD", "PL"])
@pytest.mark.parametrize("period", [0.02, 0.08])
def test_position_hold_removes_a_disturbance(mode: str, period: float) -> None:
    extra = f"position_hold = true\ncontrol_period = {period}\nduration = 80\n{PAYLOAD.format(mass='10 lb')}"
    sim = aftdeck.Simulation(scenario(BAY, extra))
    kept = fly(sim, 1.0, aftdeck.Inputs(mode=mode))[-1]
    disturbed(sim, {0: BAY[0] + 1.0, 2: BAY[2] - 1.5, 4: BAY[4] + 2.0})
    frames = fly(sim, 15.0, aftdeck.Inputs())
    assert tip_error(frames[0], kept)[0] > 0.1
    way, turn = tip_error(frames[-1], kept)
    assert way < 1e-4 and turn < 2e-5
    assert speed(frames[-1]) < 1e-3 and {f.sequence for f in frames} == {"idle"} and frames[-1].position_hold


def test_disturbance_stays_without_position_hold() -> None:
    sim = aftdeck.Simulation(scenario())
    kept = fly(sim, 1.0, aftdeck.Inputs())[-1]
    disturbed(sim, {0: BAY[0] + 1.0})
    assert tip_error(fly(sim, 10.0, aftdeck.Inputs())[-1], kept)[0] > 0.1


def test_sticks_override_position_hold_and_new_pose_is_kept() -> None:
    plain, hold = (aftdeck.Simulation(scenario(extra=f"position_hold = {on}")) for on in ("false", "true"))
    moved = [fly(sim, 3.0, PUSH) for sim in (plain, hold)]
    assert moved[0][-1].angles == pytest.approx(moved[1][-1].angles, abs=1e-12)
    kept = fly(hold, 8.0, aftdeck.Inputs())[-1]
    assert tip_error(kept, moved[1][-1])[0] > 0.05  # the arm ramped to rest, and was not pulled back
    disturbed(hold, {0: math.degrees(kept.angles[0]) - 1.0})
    assert tip_error(fly(hold, 12.0, aftdeck.Inputs())[-1], kept) < (1e-4, 2e-5)


def test_position_hold_switch_acts_during_a_run() -> None:
    sim = aftdeck.Simulation(scenario())
    assert not sim.step(aftdeck.Inputs()).position_hold
    assert sim.step(aftdeck.Inputs(position_hold=True)).position_hold
    fly(sim, 1.0, aftdeck.Inputs())
    assert not sim.step(aftdeck.Inputs(position_hold=False)).position_hold
    disturbed(sim, {0: BAY[0] + 1.0})
    assert fly(sim, 5.0, aftdeck.Inputs())[-1].angles[0] == pytest.approx(math.radians(BAY[0] + 1.0), abs=1e-12)


def test_position_hold_keeps_the_arm_still() -> None:
    sim = aftdeck.Simulation(scenario(extra="position_hold = true"))
    frames = fly(sim, 20.0, aftdeck.Inputs())
    assert np.abs(np.array(frames[-1].angles) - sim.scenario.initial_angles).max() < 1e-9
