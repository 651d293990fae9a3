"""Inputs that stay as they are over several control steps."""

from __future__ import annotations

from msgspec.structs import replace

from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.state import State
from aftdeck.steering.mode import MODES

_NO_STICKS = {
    "translation": (0.0, 0.0, 0.0), "rotation": (0.0, 0.0, 0.0), "orbiter": (0.0, 0.0, 0.0), "drive": 0.0,
    "telescope": 0.0,
}  # fmt: skip
_KEPT = {
    "mode": None, "joint": None, "rate": None, "payload_axes": None, "stop": False, "effector": None,
    "effector_mode": None, "rigid": None, "latch": None,
}  # fmt: skip
"""Values of the sticks and of the switches whose positions act once."""


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
    return replace(inputs, **_NO_STICKS, **_KEPT) == _NOTHING


_NOTHING = Inputs()
