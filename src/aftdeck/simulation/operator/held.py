"""Inputs that stay as they are over several control steps."""

from __future__ import annotations

from msgspec.structs import replace

from aftdeck.simulation.inputs import STICKS, Inputs
from aftdeck.simulation.state import State
from aftdeck.steering.mode import MODES

_NOTHING = Inputs()
_ONCE = ("mode", "joint", "rate", "payload_axes", "stop", "effector", "effector_mode", "rigid", "latch")
"""Switches whose positions act in the first step, and in later steps at most on what ends a compiled call."""
_AT_REST = {name: getattr(_NOTHING, name) for name in (*STICKS, *_ONCE)}


def acts_once(state: State, inputs: Inputs) -> bool:
    """Return whether inputs that have acted in this step change nothing but the motion in the steps that follow.

    They are then the same for the panel as inputs that leave all switches alone. False if anything is in progress that
    the panel watches in each step, or if this step has written a line into the log.
    """
    panel, inhibit = state.panel, state.worksite.contacts.inhibit
    if (
        state.events
        or state.plant.bodies is not None
        or state.by_script
        or state.delayed_inputs
        or state.checking is not None
        or panel.proceeding
        or panel.position_hold
        or inhibit.arm
        or inhibit.finger
        or MODES[panel.mode].kind not in ("manual", "single")
        or inputs.mode not in (None, panel.mode)
    ):
        return False
    return replace(inputs, **_AT_REST) == _NOTHING
