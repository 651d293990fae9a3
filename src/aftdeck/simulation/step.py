"""Control step of the simulation. The station, a run, a study and a policy all call the function of this module."""

from __future__ import annotations

from aftdeck.simulation.begin import initialise
from aftdeck.simulation.command_check.cmd_ck import check
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.fly import complete, go
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.observe.arm_events import log_arm_events
from aftdeck.simulation.operator.command_delay import delayed
from aftdeck.simulation.operator.held import acts_once, is_idle, only_sticks
from aftdeck.simulation.operator.panel import operate, order
from aftdeck.simulation.operator.script import end_if_time_is_up, hand_over, phase_name, play
from aftdeck.simulation.operator.sequence import finish
from aftdeck.simulation.payloads.alignment import count
from aftdeck.simulation.period.period import COUNTED, OBSERVED, UNCHANGED
from aftdeck.simulation.period.quick import give, take
from aftdeck.simulation.row.scalars import MADE
from aftdeck.simulation.state import State
from aftdeck.worksite.watch.contacts import UNINHIBITED


def step(flight: Flight, state: State, inputs: Inputs | None, most: int = 1) -> Inputs:
    """Advance `state` by one control period; `simulation.observe.look` then returns the frame of this step.

    Several periods with the same inputs are one call, if nothing happens in them but motion: the state is then as after
    as many calls.

    Args:
        flight: constants of the run.
        state: everything that the step depends on; changed in place.
        inputs: the operator's sticks and switches; if None, the scenario's script supplies them. Changes in flight are
            in `flight` already.
        most: greatest number of control periods; `state.tick` tells how many there were.

    Returns:
        The inputs that acted: the script's, or the operator's after the command delay.
    """
    state.tick += 1
    state.events = []
    log = state.log(flight.scenario.control_period)

    # inputs of the script, or of the operator after the command delay
    source, state.by_script, state.phase = state.by_script, inputs is None or inputs.script, ""
    if inputs is None or inputs.script:
        inputs = play(flight, state)
        state.phase = phase_name(flight.scenario.phases, state.script)
    else:
        hand_over(flight, state)
        inputs = delayed(state, inputs)

    # only the sticks are to be written if nothing else has moved since the last step
    sticks_only, arrived = only_sticks(inputs), False
    went_on, state.row.goes_on = state.row.goes_on, False  # also if an error ends this step
    goes_on = went_on and sticks_only and state.by_script == source and not state.events
    if goes_on and state.panel.sequence == "in progress":
        arrived = finish(flight, state, log)
    if goes_on and not arrived:
        order(flight, state, log, inputs)
    else:
        goes_on = False
        if inputs.initialise is not None:
            initialise(flight, state, inputs.initialise)
        operate(flight, state, log, inputs, finished=arrived)

        # continue CMD CK; after PROCEED, a GOOD verdict starts the motion
        check(flight, state, log)

    # steering commands the joint rates; contacts and berths limit these rates; the plant and the worksite move
    if most > 1 and not acts_once(state, inputs):
        most = 1
    reached = go(flight, state, log, inputs, observes=True, most=most, goes_on=goes_on)
    settle(flight, state, inputs, reached)
    state.row.goes_on = sticks_only and reached == UNCHANGED and is_idle(state)
    return inputs


def take_over(flight: Flight, state: State, inputs: Inputs, made: int, reached: int) -> None:
    """Take over control periods that compiled code has made in a state's row (`Batch`), and complete the last of them.

    Args:
        flight: constants of the run.
        state: changed in place; its row was current before these periods (`make_row_current`).
        inputs: inputs of the last period.
        made: number of the periods, 1 or more.
        reached: how far compiled code has made the last one (`period.period.advance`).
    """
    state.tick += 1
    state.events, state.row.scalars[MADE] = [], made
    take(flight, state, reached)
    if made > 1 or reached == UNCHANGED:  # in the step before this one, or in this one, no contact has changed
        state.worksite.contacts.inhibit = UNINHIBITED
    log = state.log(flight.scenario.control_period)
    if reached != UNCHANGED or inputs.effector is not None:
        reached = complete(flight, state, log, inputs, reached, observes=True)
    settle(flight, state, inputs, reached)
    state.row.goes_on = reached == UNCHANGED and is_idle(state)


def make_row_current(flight: Flight, state: State) -> bool:
    """Write into a state's row what the next step with the sticks alone needs, so that it goes on from there.

    Return whether it can: whether nothing else has to be done in that step.
    """
    if not state.row.goes_on and state.tick > 0 and is_idle(state, logged=False):
        give(flight, state, Inputs())
        state.row.goes_on = True
    return state.row.goes_on


def settle(flight: Flight, state: State, inputs: Inputs, reached: int) -> None:
    """Do in a step what follows the motion; `reached`: how far it has come (`period.period.advance`)."""
    log = state.log(flight.scenario.control_period)
    if inputs.camera is not None:
        state.views = flight.cameras.driven(state.views, inputs.camera, flight.scenario.control_period)
        state.panel.camera = inputs.camera.camera

    # select the pairs that count for the minimum clearance of the next step
    if reached < COUNTED:
        count(flight, state)

    # log the events of the arm; end a script whose time is up
    log_arm_events(flight, state, log, complete=reached >= OBSERVED)
    if state.by_script:
        end_if_time_is_up(flight, state)
