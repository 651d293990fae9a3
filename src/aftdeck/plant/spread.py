"""Differences between an automatic motion with masses and its rehearsal without masses."""

from __future__ import annotations

from typing import Literal, NamedTuple

from aftdeck.steering.mode import LawChoice


class Spread(NamedTuple):
    """Greatest differences between a motion and its rehearsal.

    Attributes:
        longer: additional time, as a share of the rehearsed time [1].
        miss: distance of the true tip from the target at the end [m].
    """

    longer: float
    miss: float


NO_SPREAD = Spread(0.0, 0.0)
"""Spread of a plant without masses."""
_Key = tuple[Literal["rigid", "flexible"], LawChoice, bool]
_SPREADS: dict[_Key, Spread] = {
    ("rigid", "closed loop", False): Spread(0.0, 0.001),
    ("rigid", "closed loop", True): Spread(0.27, 0.002),
    ("rigid", "open loop", False): Spread(0.0, 0.005),
    ("rigid", "open loop", True): Spread(0.0, 0.076),
    ("rigid", "position", False): Spread(0.0, 0.008),
    ("rigid", "position", True): Spread(0.0, 0.168),
    ("flexible", "closed loop", False): Spread(0.0, 0.011),
    ("flexible", "closed loop", True): Spread(0.41, 0.011),
    ("flexible", "open loop", False): Spread(0.0, 0.013),
    ("flexible", "open loop", True): Spread(0.0, 0.07),
    ("flexible", "position", False): Spread(0.0, 0.004),
    ("flexible", "position", True): Spread(0.0, 0.148),
}
"""Greatest values of the table in docs/dynamics.md, for the Shuttle's arm without and with payloads up to 65,000 lb."""


def spread_of(plant: Literal["rigid", "flexible"], law: LawChoice, *, loaded: bool) -> Spread:
    """Return the spread of a plant with masses for a steering law, without or with a payload."""
    return _SPREADS[plant, law, loaded]
