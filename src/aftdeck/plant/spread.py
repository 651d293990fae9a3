"""Differences between an automatic motion with masses and its rehearsal without masses."""

from __future__ import annotations

from typing import Literal, NamedTuple

from aftdeck.steering.mode import LawChoice


class Spread(NamedTuple):
    """Greatest differences between a motion and its rehearsal.

    Attributes:
        longer: additional time, as a share of the rehearsed time [1].
        later: further additional time, however short the motion is [s].
        miss: distance of the true tip from the target at the end [m].
    """

    longer: float
    later: float
    miss: float


NO_SPREAD = Spread(0.0, 0.0, 0.0)
"""Spread of a plant without masses."""
_Key = tuple[Literal["rigid", "flexible"], LawChoice, bool]
_SPREADS: dict[_Key, Spread] = {
    ("rigid", "position", False): Spread(0.0, 0.0, 0.051),
    ("flexible", "position", False): Spread(0.0, 0.0, 0.048),
    ("rigid", "position", True): Spread(0.0, 3.0, 0.163),
    ("flexible", "position", True): Spread(0.0, 3.0, 0.141),
    ("rigid", "closed loop", False): Spread(0.0, 3.0, 0.005),
    ("flexible", "closed loop", False): Spread(0.0, 3.0, 0.022),
    ("rigid", "closed loop", True): Spread(0.7, 3.0, 0.003),
    ("flexible", "closed loop", True): Spread(1.23, 3.0, 0.024),
    ("rigid", "open loop", False): Spread(0.0, 3.0, 0.033),
    ("flexible", "open loop", False): Spread(0.0, 3.0, 0.031),
    ("rigid", "open loop", True): Spread(0.0, 0.0, 0.139),
    ("flexible", "open loop", True): Spread(0.0, 0.0, 0.118),
}
"""Greatest values of random motions and built-in scenarios of the Shuttle's arm, without and with payloads up to
65,000 lb; printed by ``python -m benchmarks.spread``. Other arms have no values of their own."""


def spread_of(plant: Literal["rigid", "flexible"], law: LawChoice, *, loaded: bool) -> Spread:
    """Return the spread of a plant with masses for a steering law, without or with a payload."""
    return _SPREADS[plant, law, loaded]
