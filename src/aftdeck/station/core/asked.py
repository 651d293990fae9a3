"""What the pages of a session ask for in one control step."""

from __future__ import annotations

from typing import NamedTuple

from aftdeck.scenario.light import Lighting
from aftdeck.station.core.page_inputs import Taken
from aftdeck.station.messages import kinds


class Asked(NamedTuple):
    """What the pages ask for in one control step.

    Attributes:
        page: inputs of the page in control.
        latency_ms: latency that this page measures [ms]; None if not measured.
        monitors: cameras on its monitors.
        lighting: lighting that it has set.
        announced: who has announced a clearance problem; empty if nobody has.
        changes: changes in flight, typed on the console.
    """

    page: Taken
    latency_ms: float | None
    monitors: tuple[kinds.Monitor, ...]
    lighting: Lighting
    announced: str
    changes: dict[str, str]
