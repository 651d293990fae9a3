"""Safe state of the panel while the controls are unattended, as a careful operator would set it before leaving."""

from __future__ import annotations

import msgspec

from aftdeck.simulation.frame import Frame
from aftdeck.simulation.inputs import Inputs

CAUSES = {
    "page hidden": "the page that flies is hidden",
    "device lost": "a hand controller is gone",
    "page gone": "the page that flew is gone",
    "page gone, another flies": "the page that flew is gone; another has the sticks",
    "page narrow": "the page that flew is too narrow now",
    "page narrow, another flies": "the page that flew is too narrow now; another has the sticks",
    "another scenario": "another scenario is made ready",
    "sticks silent": "the page that flies is silent",
    "handed over": "the sticks are handed over",
}
"""Causes for which the controls are unattended, and their texts in the log."""


def safe_inputs(inputs: Inputs, frame: Frame | None, cause: str, *, under_way: bool) -> tuple[Inputs, str]:
    """Return inputs that cancel RATE HOLD and set POSITION HOLD, and the text for the log.

    A sequence is stopped too, if there is no page in control that could stop it. The text is empty if nothing changes.

    Args:
        inputs: inputs of this step without these changes.
        frame: frame of the step before; None if there was none.
        cause: one of `CAUSES`.
        under_way: whether a command to cancel RATE HOLD was sent already and is still in the command delay.
    """
    if frame is None:
        return inputs, ""
    changed = False
    if frame.rate_hold and not under_way:
        inputs = msgspec.structs.replace(inputs, rate_hold=True)  # a second press cancels it
        changed = True
    if not frame.position_hold:
        inputs = msgspec.structs.replace(inputs, position_hold=True)
        changed = True
    if cause in ("page gone", "page narrow", "another scenario") and frame.sequence in ("checking", "in progress"):
        inputs = msgspec.structs.replace(inputs, stop=True)
        changed = True
    return inputs, f"{CAUSES[cause]}: sticks at zero" if changed else ""
