"""POSITION HOLD keeps a heavy payload in place in the guides of its berth, on an arm with masses."""

from __future__ import annotations

import numpy as np
import pytest

from aftdeck.operators.pilot import pilot
from aftdeck.operators.spec import spec_of
from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation

STOPS_S = 50.0
"""Time in which 32,000 lb come to rest after a push in fast rates [s]: four time constants of the servos' hold."""
HOLDS_S = 120.0
"""Time after it in which the payload is held [s]."""
MOST_M = 0.003
"""Greatest motion of the payload while it is held [m]; up to 1.5 mm were seen."""


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(2))
def test_payload_pushed_against_its_guides_does_not_creep(seed: int) -> None:
    rng = np.random.default_rng(seed)
    scenario = load_scenario("srms-berth", {("plant",): "rigid"})
    sim = Simulation(scenario)
    fly, frame = pilot(scenario, spec_of("perfect"), 0), sim.step(Inputs())
    between = rng.uniform(-0.75, -0.2)  # height between the tops of the guides and the berth [m]
    while frame.payload is not None and frame.payload[0][2] < between:
        frame = sim.step(fly(sim))
    push = (rng.uniform(-0.4, 0.4), rng.uniform(-0.4, 0.4), rng.uniform(-0.1, 0.3))
    for _ in range(150):
        frame = sim.step(Inputs(translation=push))
    frame = sim.step(Inputs(position_hold=True))
    centres = []
    for _ in range(round((STOPS_S + HOLDS_S) / scenario.control_period)):
        frame = sim.step(Inputs())
        assert frame.position_hold and frame.payload is not None
        centres.append(frame.payload[0])
    held = np.array(centres[round(STOPS_S / scenario.control_period) :])
    assert np.ptp(held, axis=0).max() < MOST_M
