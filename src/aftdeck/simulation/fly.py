"""Part of a control step that a run and a rehearsal share: from the operator's inputs to contacts and berths."""

from __future__ import annotations

from aftdeck.errors import SimulationError
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.log import Log
from aftdeck.simulation.motion.stopping import watch_stop
from aftdeck.simulation.operator.holds import hold_position
from aftdeck.simulation.operator.panel import operate
from aftdeck.simulation.payloads.disturbances import disturb
from aftdeck.simulation.payloads.surroundings import surroundings
from aftdeck.simulation.period.period import NOTHING, UNCHANGED
from aftdeck.simulation.period.quick import command_motion, quick_step
from aftdeck.simulation.state import State
from aftdeck.simulation.work import update_worksite
from aftdeck.steering.layout import MOTION_ACTIVE, RATES
from aftdeck.steering.mode import MODES


def fly(flight: Flight, state: State, log: Log, inputs: Inputs) -> None:
    """Make one control step of a rehearsal, from the arm's measured state."""
    operate(flight, state, log, inputs)
    go(flight, state, log, inputs, observes=False)


def go(
    flight: Flight,
    state: State,
    log: Log,
    inputs: Inputs,
    *,
    observes: bool,
    most: int = 1,
    goes_on: bool = False,
) -> int:
    """Steer, limit the motion to what contacts and berths allow, and move the plant and the worksite.

    Args:
        flight: constants of the run.
        state: changed in place; holds the command that the panel has set.
        log: log of the step.
        inputs: the operator's inputs; only those for telescope, orbiter, end effector and latches are used here. The
            sticks and the selected mode are in `state.command`.
        observes: as for `period.period.advance`.
        most: as for `quick_step`; 1 on a plant with masses.
        goes_on: as for `quick_step`; False on a plant with masses.

    Returns:
        How far compiled code has made the last step (`period.period.advance`).
    """
    if state.panel.sequence != "in progress":
        state.command[MOTION_ACTIVE] = 0.0
    hold_position(flight.plant, state)
    if state.plant.bodies is None:
        reached = quick_step(flight, state, inputs, observes=observes, most=most, goes_on=goes_on)
        if goes_on and reached == UNCHANGED:
            return reached
        log = log if most == 1 else state.log(flight.scenario.control_period)
    else:
        reached = NOTHING
    return complete(flight, state, log, inputs, reached, observes=observes)


def complete(flight: Flight, state: State, log: Log, inputs: Inputs, reached: int, *, observes: bool) -> int:
    """Complete a step that compiled code has made as far as `reached`; arguments and result are those of `go`."""
    if reached == NOTHING:
        # steer, as far as contacts, berths and walls allow; move the plant, with what disturbs it
        telescope = command_motion(flight, state, inputs)
        disturb(flight, state, log, inputs)
        move_plant(flight, state, log, inputs, telescope)
        if state.plant.bodies is not None:
            watch_stop(flight, state, log, state.plant.bodies)
    return update_worksite(flight, state, log, inputs, reached, observes=observes)


def move_plant(flight: Flight, state: State, log: Log, inputs: Inputs, telescope: float) -> None:
    """Move the plant. If its model diverges, nothing moves, and a script ends with "fault".

    Raises:
        SimulationError: the model diverged, and an operator supplies the inputs.
    """
    try:
        flight.plant.move(
            state.plant,
            state.steering[RATES : RATES + len(state.plant.angles)],
            telescope,
            surroundings(flight, state, inputs),
            brakes=state.panel.brakes,
            attached=state.script.attached,
            by_angle=MODES[state.panel.mode].by_angle,
        )
    except SimulationError as error:
        if not state.by_script:
            raise
        state.script.ended = "fault"
        log.add("fault", "warning", str(error))
