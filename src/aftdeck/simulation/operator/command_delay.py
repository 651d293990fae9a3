"""Command delay: manual inputs take a number of steps to arrive."""

from __future__ import annotations

from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.state import State


def delayed(state: State, inputs: Inputs) -> Inputs:
    """Return the inputs that arrive in this step, and queue the inputs given now."""
    if not state.under_way:
        return inputs
    state.under_way.append(inputs)
    return state.under_way.pop(0)
