"""Having every law compiled before a flight, which compiling would hold up for seconds."""

from __future__ import annotations

import contextlib

from aftdeck.errors import AftdeckError
from aftdeck.scenario.model import Scenario
from aftdeck.scenario.target import target_at
from aftdeck.simulation.begin import first_state
from aftdeck.simulation.flight import prepare
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.step import step
from aftdeck.simulation.ways_out import ways_out
from aftdeck.steering.mode import AUTOMATIC_LAWS


def warm_up(scenario: Scenario) -> None:
    """Fly a scratch copy for a few steps, through everything that is compiled at its first use."""
    flight = prepare(scenario)
    state = first_state(flight)
    arm = scenario.arm
    here = target_at(arm.forward(scenario.initial_angles))
    step(flight, state, Inputs())
    for law in AUTOMATIC_LAWS:
        step(flight, state, Inputs(mode="OPR CMD", law=law, target=here, proceed=True))
        step(flight, state, Inputs(stop=True))
    with contextlib.suppress(AftdeckError):  # the first pose may itself be singular
        arm.inverse(here.pose, near=scenario.initial_angles)
    ways_out(flight, state, (1, 0, 0, 0, 0, 0), ("elbow",))
    step(flight, state, Inputs(mode="SINGLE"))
    ways_out(flight, state, (0, 0, 0, 0, 0, 0), ("elbow",))
    step(flight, state, None)
