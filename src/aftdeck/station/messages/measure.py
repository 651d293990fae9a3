"""Figure that describes a whole run, in a replay and at the end of a task."""

from __future__ import annotations

import msgspec

from aftdeck.simulation.readings.quantity import Quantity
from aftdeck.worksite.watch.alarm import Level


class Measure(msgspec.Struct, frozen=True):
    """Number or text that describes the whole run."""

    name: str
    quantity: Quantity
    value: float | None
    text: str
    """Value as text if `quantity` is ``words``; otherwise empty."""
    about: str
    """Explanation of the figure, in a sentence."""
    angle: float | None = None
    """Angle between the two objects whose distance is `value` [rad]; null if not applicable."""
    level: Level = "info"
    """Worst alarm level of this figure during the run."""
