"""Alarm level of a clearance: none, caution or warning."""

from __future__ import annotations

from typing import Literal

Level = Literal["info", "caution", "warning"]

CLEAR: Level = "info"
"""Level of a clearance that needs no alarm."""
HYSTERESIS = 0.03
"""Fraction of a threshold [1] (assumed). An alarm level ends only when the clearance exceeds the level's threshold by
this fraction. Otherwise a lamp could flicker."""


def level_of(clearance: float, caution: float, warning: float, before: Level = CLEAR) -> Level:
    """Return the alarm level of a clearance.

    Args:
        clearance: negative if the two parts overlap [m].
        caution: below this threshold the level is caution [m].
        warning: below this threshold the level is warning [m].
        before: the level in the step before.
    """
    if clearance < (warning * (1.0 + HYSTERESIS) if before == "warning" else warning):
        return "warning"
    return "caution" if clearance < (caution if before == "info" else caution * (1.0 + HYSTERESIS)) else "info"
