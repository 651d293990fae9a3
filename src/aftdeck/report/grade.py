"""Grade of a run after its task: each of three kinds of faults lowers it by one."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal, get_args

from aftdeck.report.catalogue import named
from aftdeck.report.metric import Metric, Value

Grade = Literal["A", "B", "C", "D"]
_GRADES: tuple[Grade, ...] = get_args(Grade)

FAULTS = {
    named("inhibits"): ("contact that inhibited the arm", "contacts that inhibited the arm"),
    named("clearance_warnings"): ("warning by CLEARANCE", "warnings by CLEARANCE"),
    named("hard_stop_events"): ("hard stop", "hard stops"),
}
"""Metrics that count faults, each with its text for one fault and for several."""


def faults(found: Mapping[Metric, Value]) -> tuple[str, ...]:
    """Return each kind of fault that a run's metrics tell, as a text for the operator."""
    counted = ((int(found[metric].number or 0), texts) for metric, texts in FAULTS.items() if metric in found)
    return tuple(f"{count} {one if count == 1 else more}" for count, (one, more) in counted if count)


def grade(kinds: tuple[str, ...]) -> Grade:
    """Return the grade of a run with these kinds of faults: A without faults, then one lower for each kind."""
    return _GRADES[min(len(kinds), len(_GRADES) - 1)]
