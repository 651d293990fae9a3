"""Command delay: an operator's inputs act some steps later; the scenario sets the number of these steps."""

from __future__ import annotations

from msgspec.structs import replace

from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.state import State


def delayed(state: State, inputs: Inputs) -> Inputs:
    """Return the inputs that act in this step, and add the operator's present inputs to the queue.

    Disturbances and changes in flight are no commands: they act at once.
    """
    if not state.delayed_inputs:
        return inputs
    state.delayed_inputs.append(replace(inputs, changes={}) if inputs.changes else inputs)
    late = state.delayed_inputs.pop(0)
    if not (late.disturbances or inputs.disturbances or inputs.changes):
        return late
    return replace(late, disturbances=inputs.disturbances, changes=inputs.changes)
