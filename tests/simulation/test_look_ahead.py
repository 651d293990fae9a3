"""Look-ahead: the prediction equals the later motion, and changes no state."""

from __future__ import annotations

import math

import numpy as np
import pytest

import aftdeck
from aftdeck import Inputs
from aftdeck.errors import InputError
from aftdeck.simulation.observe.look_ahead import Axis
from tests.simulation.flights import random_inputs
from tests.steering.flying import BAY, checked, fly, scenario, target

STICKS = [
    pytest.param(Inputs(translation=(0.6, -0.3, 0.1), rotation=(0.2, 0.0, -0.4)), "ORB UNL", id="ORB UNL"),
    pytest.param(Inputs(translation=(0.0, 1.0, 0.0)), "END EFF", id="END EFF"),
    pytest.param(Inputs(drive=-1.0), "SINGLE", id="SINGLE"),
    pytest.param(Inputs(drive=1.0), "DIRECT", id="DIRECT"),
]


@pytest.mark.parametrize("inputs, mode", STICKS)
def test_look_ahead_equals_motion_with_held_sticks(inputs: Inputs, mode: str) -> None:
    sim = aftdeck.Simulation(scenario(BAY))
    sim.step(Inputs(mode=mode))
    fly(sim, 1.0, inputs)
    for seconds in (2.0, 5.0):
        ahead = sim.ahead(seconds)
        later = fly(sim, seconds, inputs)[-1]
        assert ahead.held and ahead.moves
        assert later.angles == pytest.approx(ahead.angles, abs=1e-9)


def test_stopping_distance_equals_motion_after_centring() -> None:
    sim = aftdeck.Simulation(scenario(BAY))
    before = fly(sim, 4.0, Inputs(translation=(1.0, 0.4, 0.0)))[-1]
    stopping = sim.ahead().stopping
    after = fly(sim, 30.0, Inputs())[-1]
    assert stopping == pytest.approx(math.dist(before.position, after.position), abs=1e-6)
    assert stopping > 0.01
    assert sim.ahead().stopping == 0.0 and not sim.ahead().moves and not sim.ahead().held


@pytest.mark.slow
@pytest.mark.parametrize("axis", [*range(6), 6])
@pytest.mark.parametrize("sign", [-1, 1])
def test_look_ahead_deflects_last_axis_when_sticks_are_centred(axis: int, sign: int) -> None:
    mode = "SINGLE" if axis == 6 else "ORB UNL"
    sim = aftdeck.Simulation(scenario(BAY))
    sim.step(Inputs(mode=mode))
    last: Axis = (axis, 1 if sign > 0 else -1)
    ahead = sim.ahead(5.0, last)
    sticks = [0.0] * 7
    sticks[axis] = float(sign)
    full = Inputs(rotation=tuple(sticks[:3]), translation=tuple(sticks[3:6]), drive=sticks[6])  # type: ignore[arg-type]
    assert not ahead.held and ahead.moves
    sim.step(Inputs(position_hold=True))
    kept = sim.ahead(5.0, last)  # a stick overrides POSITION HOLD
    assert kept.angles == pytest.approx(ahead.angles, abs=1e-9)
    assert fly(sim, 5.0, full)[-1].angles == pytest.approx(ahead.angles, abs=1e-9)


def test_look_ahead_follows_automatic_motion_only_after_proceed() -> None:
    sim = aftdeck.Simulation(scenario(BAY, 'mode = "OPR CMD"'))
    frame = checked(sim, Inputs(target=target(sim.scenario.arm, (BAY[0] + 10.0, *BAY[1:]))))[-1]
    assert frame.sequence == "ready" and not sim.ahead().moves
    sim.step(Inputs(proceed=True))
    ahead = sim.ahead(4.0)
    assert fly(sim, 4.0, Inputs())[-1].angles == pytest.approx(ahead.angles, abs=1e-9)
    assert ahead.moves


@pytest.mark.parametrize("switch", [Inputs(brakes=True), Inputs(safing=True)])
def test_look_ahead_shows_no_motion_under_brakes(switch: Inputs) -> None:
    sim = aftdeck.Simulation(scenario(BAY))
    fly(sim, 1.0, Inputs(translation=(1.0, 0.0, 0.0)))
    sim.step(switch)
    sim.step(Inputs(translation=(1.0, 0.0, 0.0)))
    ahead = sim.ahead(5.0, (3, 1))
    assert not ahead.moves and not ahead.held and ahead.stopping == 0.0


def test_look_ahead_clearance_equals_later_measurement() -> None:
    sim = aftdeck.Simulation("concept-1972")
    up = Inputs(translation=(0.3, 0.2, -1.0))
    for _ in range(4):
        fly(sim, 1.0, up)
        ahead, frame = sim.ahead(2.0), fly(sim, 2.0, up)[-1]
        assert ahead.contact_s is None and ahead.nearest is not None and frame.work.nearest is not None
        assert ahead.nearest.clearance == pytest.approx(frame.work.nearest.clearance, abs=1e-9)
        assert {ahead.nearest.a, ahead.nearest.b} == {frame.work.nearest.a, frame.work.nearest.b}


def test_look_ahead_gives_first_contact_to_a_tenth_of_the_time() -> None:
    sim = aftdeck.Simulation("concept-1972")
    down = Inputs(translation=(0.0, 0.0, 1.0))
    for _ in range(30):
        ahead, here = sim.ahead(4.0), sim.save()
        frames = fly(sim, 4.0, down)
        touched = [f.tick for f in frames if f.work.nearest and f.work.nearest.clearance <= 0.0]
        if touched and ahead.held:
            break
        sim.restore(here)
        fly(sim, 1.0, down)
    after = (touched[0] - frames[0].tick + 1) * sim.scenario.control_period
    assert ahead.contact_s is not None and after <= ahead.contact_s + 1e-9 < after + 0.4 + 2e-9


def test_look_ahead_names_joint_nearest_to_its_limit() -> None:
    sim = aftdeck.Simulation(scenario(BAY))
    sim.step(Inputs())
    ahead = sim.ahead()
    reach = sim.scenario.arm.limits.reach
    rooms = np.minimum(np.array(ahead.angles) - reach[:, 0], reach[:, 1] - np.array(ahead.angles))
    assert ahead.joint == int(rooms.argmin()) and ahead.room == pytest.approx(rooms.min(), abs=1e-12)


@pytest.mark.parametrize("name", ["concept-1972", "srms-deploy"])
def test_look_ahead_changes_no_state(name: str) -> None:
    one, other = aftdeck.Simulation(name), aftdeck.Simulation(name)
    for k, inputs in enumerate(random_inputs(np.random.default_rng(2), 60)):
        one.advance(inputs)
        other.advance(inputs)
        if k % 7 == 0:
            one.ahead(2.0 + k / 10.0, (k % 7, 1))
        assert one.seal() == other.seal()


@pytest.mark.parametrize("seconds", [1.9, 20.1, math.nan])
def test_look_ahead_rejects_times_outside_2_to_20_s(seconds: float) -> None:
    sim = aftdeck.Simulation(scenario(BAY))
    with pytest.raises(InputError, match=f"^seconds: got {seconds:g}, .* 2 to 20$"):
        sim.ahead(seconds)


@pytest.mark.parametrize("last", [(7, 1), (-1, 1), (0, 0), (0, 2)])
def test_look_ahead_rejects_invalid_axis(last: Axis) -> None:
    sim = aftdeck.Simulation(scenario(BAY))
    with pytest.raises(InputError, match=rf"^last: got \({last[0]}, {last[1]}\)"):
        sim.ahead(5.0, last)
