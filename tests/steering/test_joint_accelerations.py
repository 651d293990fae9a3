"""Joint accelerations in random runs of both arms: every excess is named, and sticks cause few.

The witness is the difference between the joint rates that two successive frames command.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import NamedTuple

import numpy as np
import pytest

import aftdeck
from aftdeck import Inputs
from aftdeck.arrays import Array
from aftdeck.simulation.frame import Frame
from tests.each import each, number, seeds
from tests.simulation.flights import random_inputs
from tests.steering.flying import PAYLOAD, kinds, scenario
from tests.steering.random_runs import inputs

ARMS = ("srms", "concept-1972")
STOPPED = {"seat", "contact", "switch"}
"""Kinds of limits that stop all joints at once; the frame then names nothing else."""
ROUNDING = 1e-6
"""Share of a limit that counts as rounding."""


class Changed(NamedTuple):
    """Frame, and the change of each joint's commanded rate, divided by the greatest change in a step (6,)."""

    frame: Frame
    share: Array


def random_start(arm: aftdeck.Arm, rng: np.random.Generator) -> list[float]:
    """Return joint angles inside the soft stops [deg]."""
    low, high = np.clip(arm.limits.soft, -np.pi, np.pi).T
    return list(np.degrees(rng.uniform(low, high)).tolist())


def simulation(seed: int, extra: str = "") -> aftdeck.Simulation:
    """Return a simulation in empty space from a random start; the arm, the period and the payload follow the seed."""
    name, period = ARMS[seed % 2], (0.02, 0.08)[seed // 2 % 2]
    start = random_start(aftdeck.load_arm(name), np.random.default_rng(seed))
    payload = PAYLOAD.format(mass="32000 lb") if seed % 3 == 0 else ""
    lines = f'arm = "{name}"\ncontrol_period = {period}\nduration = "3600 s"\n{extra}{payload}'
    return aftdeck.Simulation(scenario(start, lines))


def changes(sim: aftdeck.Simulation, given: Iterable[Inputs]) -> Iterator[Changed]:
    """Yield each frame of a run, with the changes of its commanded joint rates."""
    greatest = sim.scenario.arm.model.rates.acceleration * sim.scenario.control_period
    before = np.zeros(6)
    for one in given:
        frame = sim.step(one)
        now = np.array(frame.rates_commanded)
        yield Changed(frame, np.abs(now - before) / greatest)
        before = now


def check_names(sim: aftdeck.Simulation, given: Iterable[Inputs]) -> None:
    """Check that each frame names every joint whose acceleration exceeds its limit."""
    for frame, share in changes(sim, given):
        if kinds(frame) & STOPPED:
            continue
        named = {limit.joint for limit in frame.limits if limit.kind == "joint acceleration"}
        beyond = set(np.flatnonzero(share > 1.0 + ROUNDING).tolist())
        assert beyond <= named, f"{frame.time_s} s, {frame.mode}, law {frame.law}: {share}, {frame.limits}"


def stick_inputs(rng: np.random.Generator, steps: int) -> Iterator[Inputs]:
    """Yield random stick deflections in ORB UNL and END EFF that change every half second."""
    held = Inputs()
    for k in range(steps):
        if k % 25:
            yield held
            continue
        t, r = rng.uniform(-1.0, 1.0, (2, 3)) * (rng.random((2, 3)) < 0.6)
        if rng.random() < 0.3:
            t, r = np.sign(t), np.sign(r)
        (t1, t2, t3), (r1, r2, r3) = t.tolist(), r.tolist()
        held = Inputs((t1, t2, t3), (r1, r2, r3))
        yield Inputs((t1, t2, t3), (r1, r2, r3), mode=("ORB UNL", "END EFF")[rng.integers(2)])


@each("seed", seeds(6, 200))
def test_excess_of_an_acceleration_by_sticks_is_named(seed: int) -> None:
    check_names(simulation(seed), random_inputs(np.random.default_rng(seed), 600))


@each("seed", seeds(5, 200))
def test_excess_of_an_acceleration_in_any_mode_is_named(seed: int) -> None:
    sim = simulation(seed)
    operator = inputs(np.random.default_rng(seed), sim)
    check_names(sim, (next(operator) for _ in range(600)))


@each("seed", seeds(4, 100))
@pytest.mark.parametrize("extra", ["strict = true\n", 'soft_stops = "as-flown"\n'])
def test_excess_of_an_acceleration_with_other_laws_is_named(extra: str, seed: int) -> None:
    check_names(simulation(seed, extra), random_inputs(np.random.default_rng(seed), 600))


def test_sticks_seldom_exceed_an_acceleration() -> None:
    steps = excesses = 0
    for seed in range(number(8, 60)):
        for _, share in changes(simulation(seed), stick_inputs(np.random.default_rng(seed), 1000)):
            steps += 1
            excesses += int((share > 1.0 + ROUNDING).sum())
    assert excesses < 0.01 * steps
