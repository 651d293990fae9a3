"""Command delay: manual inputs act a number of steps after they are given."""

from __future__ import annotations

from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.state import State


def delayed(state: State, inputs: Inputs) -> Inputs:
    """Return the inputs that act in this step, and queue the inputs given now."""
    if not state.delayed_inputs:
        return inputs
    state.delayed_inputs.append(inputs)
    return state.delayed_inputs.pop(0)
