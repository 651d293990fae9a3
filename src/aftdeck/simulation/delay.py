"""The command delay: a person's inputs take a number of steps to arrive."""

from __future__ import annotations

from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.state import State


def delayed(state: State, inputs: Inputs) -> Inputs:
    """The inputs that arrive in this step; those given now join the ones under way."""
    if not state.under_way:
        return inputs
    state.under_way.append(inputs)
    return state.under_way.pop(0)
