"""Safe state of the panel while the controls are unattended."""

from __future__ import annotations

import msgspec

from aftdeck.simulation.frame import Frame
from aftdeck.simulation.inputs import Inputs

CAUSES = {
    "page hidden": "the operator's page is hidden",
    "device lost": "a hand controller is disconnected",
    "page gone": "the operator's page has left",
    "page gone, another flies": "the operator's page has left; another page is in control",
    "page narrow": "the operator's page is too narrow",
    "page narrow, another flies": "the operator's page is too narrow; another page is in control",
    "another scenario": "another scenario is being prepared",
    "sticks silent": "the operator's page sends no sticks",
    "handed over": "the sticks are given to another page",
}
"""Causes of unattended controls, with their texts in the log."""


def safe_inputs(inputs: Inputs, frame: Frame | None, cause: str, *, cancelling: bool) -> tuple[Inputs, str]:
    """Return inputs that cancel RATE HOLD and set POSITION HOLD, and the text for the log.

    The inputs also stop a sequence if no page is in control, or if another scenario is being prepared.

    Args:
        inputs: inputs of this step.
        frame: frame of the step before; None before the first step.
        cause: one of `CAUSES`.
        cancelling: whether RATE HOLD was cancelled so recently that a frame can still show it as on.

    Returns:
        The inputs, and the text; the text is empty if the panel is in the safe state already.
    """
    if frame is None:
        return inputs, ""
    changed = False
    if frame.rate_hold and not cancelling:
        inputs = msgspec.structs.replace(inputs, rate_hold=True)  # pressing RATE HOLD again cancels it
        changed = True
    if not frame.position_hold:
        inputs = msgspec.structs.replace(inputs, position_hold=True)
        changed = True
    if cause in ("page gone", "page narrow", "another scenario") and frame.sequence in ("checking", "in progress"):
        inputs = msgspec.structs.replace(inputs, stop=True)
        changed = True
    return inputs, f"{CAUSES[cause]}: sticks centred" if changed else ""
