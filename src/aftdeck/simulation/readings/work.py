"""Readings of the worksite: clearance, contacts, end effector, payloads."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from aftdeck.scenario.model import Scenario
from aftdeck.simulation.readings.reading import XYZ, Known, Reading, Recorded, Strip, pose, shown
from aftdeck.simulation.readings.source import FORMAN
from aftdeck.units import FOOT
from aftdeck.worksite.report import Cargo, Hand, Work

_SWITCH = {"stop": 0.0, "close": 1.0, "open": -1.0}


def _pair(s: Known) -> str:
    near = s.frame.work.nearest
    return "" if near is None else f"{near.a} to {near.b}"


def _clearance_share(s: Known) -> float:
    near = s.frame.work.nearest
    if near is None:
        return 1.0
    distance = max(near.clearance, 0.0)
    return distance / (distance + FOOT)


def _conditions_share(s: Known) -> float:
    found = s.frame.work.conditions
    return sum(condition.holds for condition in found) / len(found) if found else 0.0


CLEARANCE = (
    Reading(
        "clearance",
        "minimum clearance of all monitored pairs",
        lambda s: s.frame.work.nearest and s.frame.work.nearest.clearance,
        quantity="gap",
        strip=Strip(alarms=lambda scenario: (scenario.caution, scenario.warning), shown=True),
        metrics=(
            Recorded(
                "least",
                "min_clearance",
                "Smallest clearance",
                "Minimum clearance of the run, without essential contacts.",
                detail=lambda s, _: f"{_pair(s)}, at {s.frame.time_s:.1f} s",
                level=lambda s: s.frame.work.clearance_level,
            ),
            Recorded("mean", "mean_clearance", "Mean clearance"),
        ),
        source=FORMAN,
        group="clearance",
    ),
    Reading("clearance_pair", "the pair", _pair, (), "words", group="clearance"),
    Reading(
        "clearance_warning",
        "the minimum clearance fell below the threshold of a warning",
        lambda s: s.frame.work.clearance_level == "warning",
        metrics=(Recorded("begun", "clearance_warnings", "Clearance warnings"),),
    ),
)
"""Readings of the minimum clearance."""

WORK = (
    Reading(
        "clearance_share",
        "minimum clearance c of the monitored pairs, as c / (c + 1 ft); 1 without a pair",
        _clearance_share,
        quantity="ratio",
        state="clearance",
    ),
    shown(
        Work,
        "arm_inhibit",
        "arm_inhibit",
        metrics=(
            Recorded("begun", "inhibits", "Inhibits", "Number of times that a contact began to inhibit the arm."),
        ),
        state="arm_inhibit",
    ),
    Reading(
        "conditions",
        "share of the conditions of capture or docking that hold; 0 without one",
        _conditions_share,
        quantity="ratio",
        state="conditions",
    ),
    shown(Cargo, "held", "held", of=lambda s: s.frame.payload is not None, state="held"),
    shown(Hand, "opening", "opening", state="opening"),
    Reading(
        "effector",
        "end effector switch: 1 close, 0 stop, -1 open",
        lambda s: _SWITCH[s.frame.work.hand.switch],
        state="effector",
    ),
)
"""Readings of contacts, conditions and end effector."""


def of_payloads(scenario: Scenario) -> Iterator[Reading]:
    """Yield the readings of each payload of the worksite."""
    for n, payload in enumerate(scenario.payloads):
        name = f"payload_{n + 1}"
        about: dict[str, Any] = {"at": _cargo(n), "owner": payload.name, "group": "payloads"}
        yield from pose(Cargo, name, **about)
        yield shown(Cargo, "velocity", f"{name}_velocity", XYZ, **about)
        yield shown(Cargo, "held", f"{name}_held", **about)


def _cargo(n: int) -> Callable[[Known], Cargo]:
    return lambda s: s.frame.work.cargo[n]
