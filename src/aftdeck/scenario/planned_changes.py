"""Changes in flight that a scenario plans, from its tables ``[[event]]``."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

from aftdeck.errors import InputError
from aftdeck.files import place
from aftdeck.scenario.changes import as_toml, parse_key
from aftdeck.scenario.problems import Problems
from aftdeck.scenario.schema import ScenarioFile

_ROUNDING = 1e-6
"""Share of a control period by which a time may be late because of rounding [1]."""


class PlannedChange(NamedTuple):
    """Changes in flight that a scenario plans for one step.

    Attributes:
        number: place of the table in the file, from 0.
        tick: number of the step in which they act, from 1.
        changes: values, as texts of TOML or plain texts, by their keys.
    """

    number: int
    tick: int
    changes: dict[str, str]


def planned_changes(problems: Problems, spec: ScenarioFile) -> tuple[PlannedChange, ...]:
    """Return the changes that a scenario plans, in the order of their times; those that are wrong are reported."""
    found = []
    for i, event in enumerate(spec.event):
        if not 0.0 <= event.at < spec.duration:
            problems.add(
                ("event", i, "at"), f"has to be from 0 to the duration, {spec.duration:g} s, got {event.at:g} s"
            )
            continue
        try:
            given = list(_flat(event.set, ""))
        except InputError as error:
            problems.add(("event", i, "set"), str(error))
            continue
        if len(changes := dict(given)) < len(given):
            problems.add(("event", i, "set"), "gives a value twice")
        if not changes:
            problems.add(("event", i, "set"), "has no key: give at least one value")
        tick = math.ceil(event.at / spec.control_period - _ROUNDING) + 1
        if tick > round(spec.duration / spec.control_period):
            problems.add(("event", i, "at"), f"is after the last control step begins, got {event.at:g} s")
        found.append(PlannedChange(i, tick, changes))
    return tuple(sorted(found, key=lambda planned: planned.tick))


def _flat(values: Mapping[str, Any], before: str) -> Iterator[tuple[str, str]]:
    """Yield the values of tables within tables by their whole keys.

    Raises:
        InputError: a key is not one of a file.
    """
    for name, value in values.items():
        key = f"{before}{name}"
        if isinstance(value, dict):
            yield from _flat(value, f"{key}.")
        else:
            yield place(parse_key(key)), value if isinstance(value, str) else as_toml(value)
