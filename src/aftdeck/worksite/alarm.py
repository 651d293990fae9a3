"""What a clearance calls for: nothing, a caution or a warning."""

from __future__ import annotations

from typing import Literal

Level = Literal["info", "caution", "warning"]

CLEAR: Level = "info"
"""A clearance that calls for nothing."""
HYSTERESIS = 0.03
"""A level is left only when its threshold is passed by this part, so that no lamp flickers [1]; assumed."""


def level_of(clearance: float, caution: float, warning: float, before: Level = CLEAR) -> Level:
    """What a clearance calls for.

    Args:
        clearance: negative where the two overlap [m].
        caution: below this a caution is due [m].
        warning: below this a warning is due [m].
        before: what the clearance called for until now.
    """

    def under(threshold: float, was: bool) -> bool:
        return clearance < threshold * (1.0 + HYSTERESIS if was else 1.0)

    if under(warning, before == "warning"):
        return "warning"
    return "caution" if under(caution, before != "info") else "info"
