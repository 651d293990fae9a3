"""One control step of the simulation, whole. The station, a run, a study and a policy all call this function."""

from __future__ import annotations

from aftdeck.simulation.begin import initialise
from aftdeck.simulation.check import check
from aftdeck.simulation.delay import delayed
from aftdeck.simulation.flight import Flight
from aftdeck.simulation.fly import go
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.lined_up import count
from aftdeck.simulation.notice import notice
from aftdeck.simulation.panel import operate
from aftdeck.simulation.script import conclude, hand_over, phase_name, play
from aftdeck.simulation.state import State


def step(flight: Flight, state: State, inputs: Inputs | None) -> Inputs:
    """Advance `state` by one control period; `simulation.look` tells what a reader may know of it then.

    Args:
        flight: what never changes.
        state: changed in place; everything that the step depends on is in it.
        inputs: the operator's sticks and switches; None lets the scenario's script fly.

    Returns:
        The inputs as they acted: the script's, or a person's after the command delay.
    """
    state.tick += 1
    state.events = []

    # where the arm is, as measured: what plans and checks start from
    state.measure()

    # the operator: a person's inputs, after their way through the command delay, or the script's
    state.by_script, state.phase = inputs is None, ""
    if inputs is None:
        inputs = play(flight, state)
        state.phase = phase_name(flight, state)
    else:
        hand_over(flight, state)
        inputs = delayed(state, inputs)
    if inputs.initialise is not None:
        initialise(flight, state, inputs.initialise)
    operate(flight, state, inputs)

    # CMD CK goes on; once it is GOOD, PROCEED begins the motion
    check(flight, state)

    # steering commands the joint rates, contacts and seats restrain them, the plant and the worksite move
    go(flight, state, inputs)
    if inputs.camera is not None:
        state.views = flight.cameras.driven(state.views, inputs.camera, flight.scenario.control_period)
        state.panel.camera = inputs.camera.camera

    # of which pairs the next step finds the nearest
    count(flight, state)

    # what the log tells of the arm; a script whose time has run out ends
    notice(flight, state)
    if state.by_script:
        conclude(flight, state)
    return inputs
