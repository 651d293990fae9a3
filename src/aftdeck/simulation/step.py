"""One control step of the simulation, whole. The station, a run, a study and a policy all call this function."""

from __future__ import annotations

from aftdeck.simulation.delay import delayed
from aftdeck.simulation.flight import Flight
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.look import look
from aftdeck.simulation.panel import operate
from aftdeck.simulation.script import conclude, phase_name, play
from aftdeck.simulation.state import State
from aftdeck.steering.layout import ANGLES, RATES
from aftdeck.steering.msteer import msteer


def step(flight: Flight, state: State, inputs: Inputs | None) -> Frame:
    """Advance `state` by one control period and look at it.

    Args:
        flight: what never changes.
        state: changed in place; everything that the step depends on is in it.
        inputs: the operator's sticks and switches; None lets the scenario's script fly.

    Returns:
        The frame at the end of the step.
    """
    state.tick += 1
    state.events = []

    # where the arm is, as measured: what plans and checks start from
    state.steering[ANGLES : ANGLES + 6] = state.plant.angles

    # the operator: a person's inputs, after their way through the command delay, or the script's
    by_script = inputs is None
    phase = ""
    if inputs is None:
        inputs = play(flight, state)
        phase = phase_name(flight, state)
    else:
        inputs = delayed(state, inputs)
    operate(flight, state, inputs)

    # steering says how fast each joint should go
    msteer(flight.rules[state.panel.mode, state.panel.rate], state.command, state.steering, state.report)
    rates = state.steering[RATES : RATES + 6]

    # the plant moves
    period = flight.scenario.control_period
    state.plant.move(rates, period)
    state.commanded += rates * period

    # what a reader may know of it
    if by_script:
        conclude(flight, state)
    return look(flight, state, by_script, phase)
