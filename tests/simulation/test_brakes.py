"""BRAKES and SAFING: on the kinematic plant the joints stop at once, and move again when the switch is off."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import aftdeck
from aftdeck import Inputs
from aftdeck.simulation.frame import Frame
from tests.simulation.flights import random_inputs
from tests.steering.flying import BAY, fly, scenario, target

SWITCHES = ("brakes", "safing")

FULL = Inputs(translation=(1.0, -0.4, 0.2), rotation=(0.3, 0.0, -1.0), drive=1.0, telescope=1.0)
AUTOMATIC = 'mode = "OPR CMD"'


def put(switch: str, on: bool, inputs: Inputs = FULL) -> Inputs:
    """Return the inputs with an additional switch command."""
    brakes = on if switch == "brakes" else None
    safing = on if switch == "safing" else None
    return Inputs(
        translation=inputs.translation,
        rotation=inputs.rotation,
        drive=inputs.drive,
        telescope=inputs.telescope,
        brakes=brakes,
        safing=safing,
    )


def events(frame: Frame) -> list[tuple[str, str]]:
    """Return kind and level of a frame's log lines."""
    return [(event.kind, event.level) for event in frame.events]


@pytest.mark.parametrize("switch", SWITCHES)
@pytest.mark.parametrize("mode", ["ORB UNL", "END EFF", "SINGLE", "DIRECT", "MASTER"])
def test_joints_stop_in_the_step_of_the_switch_in_every_mode(mode: str, switch: str) -> None:
    sim = aftdeck.Simulation(scenario(BAY))
    sim.step(Inputs(mode=mode, master=(0.0,) * 6))
    before = fly(sim, 1.0, FULL)[-1]
    assert any(before.rates)
    frame = sim.step(put(switch, on=True))
    assert frame.rates == frame.rates_commanded == (0.0,) * 6 and frame.twist == pytest.approx((0.0,) * 6, abs=0.0)
    assert frame.angles == before.angles and frame.work.stand == before.work.stand
    assert (switch, "caution") in events(frame)
    assert all(later.angles == before.angles for later in fly(sim, 1.0, FULL))
    free = sim.step(put(switch, on=False))
    assert events(free) == [(switch, "info")]
    assert fly(sim, 1.0, FULL)[-1].angles != before.angles


@pytest.mark.slow
@given(seed=st.integers(0, 2**32 - 1), switch=st.sampled_from(SWITCHES))
def test_no_input_moves_a_stopped_joint(seed: int, switch: str) -> None:
    sim = aftdeck.Simulation("concept-1972")
    rng = np.random.default_rng(seed)
    for inputs in random_inputs(rng, 40):
        sim.advance(inputs)
    stood = sim.step(put(switch, on=True))
    for inputs in random_inputs(rng, 80, without=("initialise",)):
        frame = sim.step(inputs)
        assert frame.angles == stood.angles and frame.rates == (0.0,) * 6
        assert frame.work.stand == stood.work.stand


@pytest.mark.parametrize("switch", SWITCHES)
def test_switch_stops_automatic_motion_and_rejects_proceed(switch: str) -> None:
    sim = aftdeck.Simulation(scenario(BAY, AUTOMATIC))
    goal = target(sim.scenario.arm, (BAY[0] + 6.0, *BAY[1:]))
    sim.step(Inputs(target=goal))
    sim.step(Inputs(proceed=True))
    assert fly(sim, 1.0, Inputs())[-1].sequence == "in progress"
    frame = sim.step(put(switch, on=True, inputs=Inputs()))
    assert frame.sequence == "ready" and ("stop", "info") in events(frame)
    (rejection,) = sim.step(Inputs(proceed=True)).events
    assert rejection.kind == "refused" and switch.upper() in rejection.text
    sim.step(put(switch, on=False, inputs=Inputs()))
    sim.step(Inputs(proceed=True))
    flown = fly(sim, 40.0, Inputs())
    assert flown[-1].sequence == "idle" and flown[-1].goal is not None and flown[-1].goal.distance < 0.01


@pytest.mark.parametrize("switch", SWITCHES)
def test_switch_cancels_rate_hold(switch: str) -> None:
    sim = aftdeck.Simulation(scenario(BAY))
    sim.step(Inputs(translation=(0.5, 0.0, 0.0), rate_hold=True))
    assert fly(sim, 0.5, Inputs())[-1].rate_hold
    sim.step(put(switch, on=True, inputs=Inputs()))
    still = sim.step(put(switch, on=False, inputs=Inputs()))
    assert not still.rate_hold
    assert fly(sim, 0.5, Inputs())[-1].angles == still.angles


def test_brakes_off_leaves_safing_on() -> None:
    sim = aftdeck.Simulation(scenario(BAY))
    sim.step(Inputs(brakes=True, safing=True))
    sim.step(Inputs(brakes=False))
    stood = fly(sim, 0.5, FULL)
    assert stood[0].angles == stood[-1].angles and stood[-1].safing and not stood[-1].brakes
