"""Nobody is at the controls: what the station then does with the panel, as a careful operator would before leaving."""

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
"""Why nobody is there, as the log says it."""


def left_alone(inputs: Inputs, frame: Frame | None, cause: str, *, under_way: bool) -> tuple[Inputs, str]:
    """Inputs that let RATE HOLD go and set POSITION HOLD, and what the log says; no text: nothing had to change.

    Without a page that could stop it, a sequence is stopped, too.

    Args:
        inputs: what is flown in this step otherwise.
        frame: the step before; None: there was none.
        cause: one of `CAUSES`.
        under_way: RATE HOLD was let go already, through the command delay.
    """
    if frame is None:
        return inputs, ""
    changed = False
    if frame.rate_hold and not under_way:
        inputs = msgspec.structs.replace(inputs, rate_hold=True)  # pressed again
        changed = True
    if not frame.position_hold:
        inputs = msgspec.structs.replace(inputs, position_hold=True)
        changed = True
    if cause in ("page gone", "page narrow", "another scenario") and frame.sequence in ("checking", "in progress"):
        inputs = msgspec.structs.replace(inputs, stop=True)
        changed = True
    return inputs, f"{CAUSES[cause]}: sticks at zero" if changed else ""
