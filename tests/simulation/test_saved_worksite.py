"""States saved while the worksite moves: a run from such a state gives the same frames, bit for bit.

Recordings of runs in which the worksite moves pass verification.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import msgspec
import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import aftdeck
from aftdeck import Inputs
from aftdeck.recording.replay import verify
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.run import SavedSimulation
from tests.recording.flown import record_steps
from tests.simulation.concept import AT_PORT, ON_BAR, scenario, vec3
from tests.simulation.flights import random_inputs, srms

seeds = st.integers(0, 2**32 - 1)
FLYER = """
[[cargo]]
name = "free flyer"
start = { position = ["40 ft", "30 ft", "20 ft"], velocity = ["0.1 ft/s", "0 ft/s", "-0.1 ft/s"] }
"""


def acquiring(rng: np.random.Generator) -> tuple[Scenario, Iterator[Inputs]]:
    """The prong closes around the bar, while a free flyer drifts and the orbiter moves; then random inputs follow."""
    close = Inputs(effector="close", orbiter=(1.0, 0.0, -1.0))

    def given_() -> Iterator[Inputs]:
        yield close
        yield from (Inputs(orbiter=close.orbiter) for _ in range(175))
        yield from random_inputs(rng, 150)

    return scenario(ON_BAR, cargo=f'name = "payload"{FLYER}'), given_()


def docking(rng: np.random.Generator) -> tuple[Scenario, Iterator[Inputs]]:
    """The payload is docked, released and captured in random order."""
    made = scenario(vec3(np.add(AT_PORT, [0.1, 0.0, 0.0])), held=True, cargo=f'name = "payload"{FLYER}')
    return made, random_inputs(rng, 300, 0.2, switches=0.3)


def latching(rng: np.random.Generator) -> tuple[Scenario, Iterator[Inputs]]:
    """The Shuttle's latches close on a payload that the arm holds, while the carriage moves in and out."""
    made = srms(0.5, 0.5, -0.3, (0.1, 0.1, -0.1), held=True)

    def given_() -> Iterator[Inputs]:
        yield Inputs(latch="latch", effector_mode="manual", rigid="derigid")
        yield from random_inputs(rng, 250, 0.3, switches=0.25, without=("effector",))

    return made, given_()


def capturing(rng: np.random.Generator) -> tuple[Scenario, Iterator[Inputs]]:
    """The snares close on a grapple pin that is off centre, and the carriage draws the pin in."""
    made = srms(2.0, 1.0, 1.0, (3.0, -2.0, 3.0))

    def given_() -> Iterator[Inputs]:
        yield Inputs(effector="close", mode="END EFF")
        yield from (Inputs() for _ in range(150))
        yield from random_inputs(rng, 150, 0.3, switches=0.2)

    return made, given_()


FLIGHTS = [acquiring, docking, latching, capturing]


def bits(frames: list[Frame]) -> bytes:
    return msgspec.msgpack.encode(frames)


@pytest.mark.slow
@pytest.mark.parametrize("flight", FLIGHTS, ids=lambda flight: flight.__name__)
@settings(max_examples=2)
@given(seed=seeds)
def test_restored_state_continues_bit_for_bit(flight: object, seed: int) -> None:
    assert callable(flight)
    rng = np.random.default_rng(seed)
    made, operator = flight(rng)
    sim, given_, frames, states = aftdeck.Simulation(made), [], [], []
    for inputs in operator:
        states.append(sim.save())
        given_.append(inputs)
        frames.append(sim.step(inputs))
    for tick in rng.integers(0, len(frames), 4):
        other = aftdeck.Simulation(made)
        other.restore(msgspec.msgpack.decode(msgspec.msgpack.encode(states[tick]), type=SavedSimulation))
        upto = slice(int(tick), int(tick) + 80)
        assert bits([other.step(inputs) for inputs in given_[upto]]) == bits(frames[upto])


@pytest.mark.slow
@pytest.mark.parametrize("flight", FLIGHTS, ids=lambda flight: flight.__name__)
@settings(max_examples=1, suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow])
@given(seed=seeds)
def test_recording_of_moving_worksite_verifies(flight: object, tmp_path: Path, seed: int) -> None:
    assert callable(flight)
    rng = np.random.default_rng(seed)
    made, operator = flight(rng)
    path = tmp_path / "flight.mcap"
    path.unlink(missing_ok=True)
    flown = record_steps(path, made, operator, 1000)
    verdict = verify(path)
    assert verdict.equal and verdict.frames == len(flown)


def test_restored_state_monitors_the_same_pairs() -> None:
    made = scenario((ON_BAR[0], 0.99, ON_BAR[2]), held=True)
    sim, other = aftdeck.Simulation(made), aftdeck.Simulation(made)
    for _ in range(60):
        sim.step(Inputs((0.0, -0.3, 0.0)))
    assert any(near.essential and near.b == "bay wall port" for near in sim.watched())
    other.restore(sim.save())
    assert other.watched() == sim.watched()
