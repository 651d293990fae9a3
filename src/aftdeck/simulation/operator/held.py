"""Inputs that only move sticks, and states in which nothing else has to be done: then Python has little to do."""

from __future__ import annotations

from msgspec.structs import replace

from aftdeck.simulation.inputs import NO_OTHERS, STICKS, Inputs, others
from aftdeck.simulation.state import State
from aftdeck.steering.mode import MODES

_NOTHING = Inputs()
_ONCE = ("mode", "joint", "rate", "payload_axes", "stop", "effector", "effector_mode", "rigid", "latch")
"""Switches that act in the first step. In later steps they matter only where the compiled call ends anyway."""
_AT_REST = {name: getattr(_NOTHING, name) for name in (*STICKS, *_ONCE)}


def only_sticks(inputs: Inputs) -> bool:
    """Return whether inputs contain nothing but the sticks of the arm."""
    return others(inputs) == NO_OTHERS and not inputs.changes and not any(inputs.orbiter)


def is_idle(state: State, *, logged: bool = True) -> bool:
    """Return whether nothing was logged in this step, and Python has nothing to do in each step.

    During an automatic motion it has to look for the motion's end (`sequence.finish`). `logged`: whether lines of the
    log count.
    """
    panel, inhibit = state.panel, state.worksite.contacts.inhibit
    return not (
        (logged and state.events)
        or state.plant.bodies is not None
        or state.checking is not None
        or panel.proceeding
        or panel.position_hold
        or inhibit.arm
        or inhibit.finger
        or state.worksite.orbiter_rejected
        or MODES[panel.mode].kind == "master"
    )


def acts_once(state: State, inputs: Inputs) -> bool:
    """Return whether inputs that have acted in this step change nothing but the motion in the steps that follow.

    They are then the same for the panel as inputs that leave all switches alone.
    """
    if not is_idle(state) or state.by_script or state.delayed_inputs or inputs.mode not in (None, state.panel.mode):
        return False
    if state.panel.sequence == "in progress":  # `sequence.finish` looks for its end in each step
        return False
    return replace(inputs, **_AT_REST) == _NOTHING
