"""A joint that its hard stop holds is named among the acting limits, in every mode, with and without `strict`."""

from __future__ import annotations

from typing import Literal

import numpy as np
import pytest

import aftdeck
from aftdeck.steering.mode import MODES
from tests import loaded
from tests.each import each, seeds
from tests.steering.flying import scenario

STEPS = 40
MANUAL = [name for name, mode in MODES.items() if mode.kind in ("manual", "single") and not mode.loaded]
"""Positions of the rotary in which sticks or switches drive the empty arm."""


@each("seed", seeds(6, 60))
@pytest.mark.parametrize("strict", [True, False])
@pytest.mark.parametrize("arm", ["srms", "concept-1972"])
@pytest.mark.parametrize("mode", MANUAL)
def test_joint_held_by_its_hard_stop_is_named(mode: str, arm: Literal["srms"], strict: bool, seed: int) -> None:
    rng = np.random.default_rng(seed)
    low, high = np.degrees(loaded.arm(arm).limits.hard).T
    joints = rng.uniform(np.maximum(low, -150), np.minimum(high, 150))
    at_stop = rng.integers(6)
    joints[at_stop] = rng.choice([low[at_stop] + 1e-9, high[at_stop] - 1e-9])  # inside, whatever the rounding
    head = f'arm = "{arm}"\nmode = "{mode}"\nstrict = {str(strict).lower()}\n'
    sim = aftdeck.Simulation(scenario(joints.tolist(), head))
    sticks = aftdeck.Inputs(
        tuple(rng.uniform(-1, 1, 3)), tuple(rng.uniform(-1, 1, 3)), drive=rng.choice([-1.0, 1.0]), joint=int(at_stop)
    )
    for _ in range(STEPS):
        frame = sim.step(sticks)
        named = {limit.joint for limit in frame.limits if limit.kind == "hard stop"}
        middle = sim.scenario.arm.limits.hard.mean(axis=1)
        for joint in named:
            assert frame.rates_commanded[joint] * (frame.angles[joint] - middle[joint]) >= 0.0
        less = np.abs(np.subtract(frame.rates, frame.rates_commanded)) > 1e-9
        assert set(np.flatnonzero(less).tolist()) <= named, (frame.limits, frame.rates, frame.rates_commanded)
