"""Mode 4 for blocks of arms: agreement with `msteer` and the kinematic plant, bit for bit."""

from __future__ import annotations

import functools

import numpy as np
import pytest

from aftdeck.arrays import Array
from aftdeck.gym.reach.stick_blocks import DEFLECTIONS, STICK_ROWS, STICK_WORK, steer_by_sticks
from aftdeck.plant.kinematic import follow
from aftdeck.steering.blocks import LANES
from aftdeck.steering.layout import COMMAND, LAW, RATES, REPORT, STATE, STICKS
from aftdeck.steering.msteer import measured, msteer
from aftdeck.steering.rules import rules_of
from tests import loaded
from tests.steering.flying import BAY

PERIOD = 0.08


@functools.cache
def rules() -> Array:
    """Return the rules of ORB UNL, unloaded."""
    model = loaded.arm().model
    return rules_of(model, model.por_limits(0.0), PERIOD)["ORB UNL", "coarse", 4]


class Alone:
    """Arms that `msteer` and the kinematic plant move one after the other."""

    def __init__(self, angles: Array) -> None:
        count = len(angles)
        self.angles, self.rates, self.commanded = angles.copy(), np.zeros((count, 6)), angles.copy()
        self._states, self._command, self._report = np.zeros((count, STATE)), np.zeros(COMMAND), np.zeros(REPORT)
        self._command[LAW] = 4.0

    def step(self, sticks: Array) -> None:
        hard = loaded.arm().limits.hard
        for i, state in enumerate(self._states):
            self._command[STICKS : STICKS + 6] = sticks[i]
            measured(self.angles[i], self.rates[i], self.angles[i], 0.0, state)
            msteer(rules(), self._command, state, self._report)
            follow(state[RATES : RATES + 6], PERIOD, hard, self.angles[i], self.rates[i], self.commanded[i])


class Block:
    """The same arms in a block."""

    def __init__(self, angles: Array) -> None:
        self.rows = np.zeros((STICK_ROWS, LANES))
        self.rows[:6] = angles.T
        self._constants = tuple([*rules().tolist(), *loaded.arm().limits.hard.T.ravel().tolist()])
        self._work, self._scratch = np.zeros(STICK_WORK * LANES), np.zeros(STATE)

    def step(self, sticks: Array) -> None:
        self.rows[DEFLECTIONS : DEFLECTIONS + 6] = sticks.T
        steer_by_sticks(self._constants, rules(), self.rows.reshape(-1), self._work, self._scratch)


@pytest.mark.parametrize(("seed", "spread"), [(1, 0.1), (2, 0.6)])
def test_block_equals_msteer_and_the_plant_bit_for_bit(seed: int, spread: float) -> None:
    rng = np.random.default_rng(seed)
    low, high = loaded.arm().limits.soft[:, 0] + 0.01, loaded.arm().limits.soft[:, 1] - 0.01
    angles = np.clip(np.radians(BAY) + rng.uniform(-spread, spread, (LANES, 6)), low, high)
    alone, block = Alone(angles), Block(angles)
    sticks = np.zeros((LANES, 6))
    for step in range(600):
        if step % 20 == 0:
            sticks = rng.uniform(-1.0, 1.0, (LANES, 6))
        if step % 80 == 40:
            sticks = np.sign(sticks)
        if step % 100 == 70:
            sticks = np.zeros((LANES, 6))
        alone.step(sticks)
        block.step(sticks)
        assert (alone.angles == block.rows[:6].T).all(), step
        assert (alone.rates == block.rows[6:12].T).all(), step


def test_arms_of_a_block_come_to_rest_at_soft_stops_and_before_singularities() -> None:
    rng = np.random.default_rng(3)
    block = Block(np.tile(np.radians(BAY), (LANES, 1)))
    block.step(np.sign(rng.uniform(-1.0, 1.0, (LANES, 6))))
    sticks = np.sign(rng.uniform(-1.0, 1.0, (LANES, 6)))
    for _ in range(1500):  # two minutes with full deflection
        block.step(sticks)
    angles = block.rows[:6].T
    assert (angles >= loaded.arm().limits.soft[:, 0] - 1e-9).all()
    assert (angles <= loaded.arm().limits.soft[:, 1] + 1e-9).all()
    assert np.abs(np.stack(loaded.arm().singularities(angles))).min() > 0.01
    assert (np.abs(block.rows[6:12].T) <= loaded.arm().rate_limits).all()
