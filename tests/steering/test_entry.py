from __future__ import annotations

import numpy as np
import pytest

import aftdeck
from aftdeck.simulation.parts.carried import steering_setup
from aftdeck.steering.entry import limited_rates
from aftdeck.steering.layout import RATE


def test_limited_rates_keep_the_direction_of_the_twist() -> None:
    scenario = aftdeck.load_scenario("first-flight")
    rules = steering_setup(scenario, scenario.payload).rules["ORB UNL", "coarse", 4]
    limits, random = np.array(rules[RATE : RATE + 6]), np.random.default_rng(3)
    cut = 0
    for size in (1e-3, 1.0) * 50:
        twist = size * random.uniform(-1.0, 1.0, 6)
        angles = scenario.initial_angles + random.uniform(-0.2, 0.2, 6)
        rates = np.empty(6)
        limited_rates(rules, np.concatenate([angles, twist]), rates)
        given = scenario.arm.jacobian(angles) @ rates
        ratio = float(given @ twist / (twist @ twist))
        assert given == pytest.approx(ratio * twist, abs=1e-9)
        share = np.abs(rates) / limits
        assert share.max() <= 1.0 + 1e-15
        if share.max() < 1.0 - 1e-12:
            assert ratio == pytest.approx(1.0, abs=1e-9)
        else:
            cut += 1
    assert 40 <= cut < 100
