"""Command delay: an operator's inputs act some steps later; the scenario sets the number of these steps."""

from __future__ import annotations

from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.state import State


def delayed(state: State, inputs: Inputs) -> Inputs:
    """Return the inputs that act in this step, and add the operator's present inputs to the queue."""
    if not state.delayed_inputs:
        return inputs
    state.delayed_inputs.append(inputs)
    return state.delayed_inputs.pop(0)
