"""Alarm level of a clearance: none, caution or warning."""

from __future__ import annotations

from math import inf
from typing import Literal

Level = Literal["info", "caution", "warning"]

CLEAR: Level = "info"
"""Level of a clearance that needs no alarm."""
HYSTERESIS = 0.03
"""Fraction of a threshold [1] (assumed). An alarm level ends only when the clearance exceeds the level's threshold by
this fraction. Otherwise a lamp could flicker."""


def unchanged_between(level: Level, caution: float, warning: float) -> tuple[float, float]:
    """Return the limits of the clearances after which a level remains as it is: from the first to below the second [m].

    The arguments are those of `level_of`.
    """
    match level:
        case "warning":
            return -inf, warning * (1.0 + HYSTERESIS)
        case "caution":
            return warning, caution * (1.0 + HYSTERESIS)
        case "info":
            return caution, inf


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
