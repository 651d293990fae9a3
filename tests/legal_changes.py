"""Random changes in flight that a scenario allows: values of its files, a little greater or smaller."""

from __future__ import annotations

import random
import re
from collections.abc import Callable
from typing import Any

from aftdeck.errors import InputError
from aftdeck.scenario.key_list import NOT_GIVEN, Entry, key_list
from aftdeck.scenario.model import Scenario

USUAL = {
    "limits.por.translation": "0.3 m/s",
    "limits.por.vernier_translation": "0.02 m/s",
    "limits.por.rotation": "3 deg/s",
    "limits.por.vernier_rotation": "0.3 deg/s",
    "limits.por.reached_in": "1.5 s",
    "arrive_within": "2 mm",
    "arrive_within_angle": "0.1 deg",
    "guards": True,
}
"""Possible values of keys that a file does not give."""
_QUANTITY = re.compile(r"([-+]?[\d.]+(?:[eE][-+]?\d+)?)( .*)")


def changing(scenario: Scenario) -> list[Entry]:
    """Return the keys that can change in flight and have a number, or for which there is a possible value."""
    return [entry for entry in key_list(scenario).values() if entry.changes and _given(entry) is not None]


def random_change(
    rng: random.Random, entries: list[Entry], try_it: Callable[[dict[str, str]], object]
) -> dict[str, str]:
    """Return a random change that is allowed.

    Args:
        rng: source of random numbers.
        entries: result of `changing`.
        try_it: raises `InputError` if a change is not possible.
    """
    for _ in range(200):
        entry = rng.choice(entries)
        change = {entry.text: _text(_scaled(rng, _given(entry)))}
        try:
            try_it(change)
        except InputError:
            continue
        return change
    raise AssertionError("200 random changes were refused")


def texts(changes: dict[str, Any]) -> dict[str, str]:
    """Return changes with their values as texts."""
    return {key: value if isinstance(value, str) else _text(value) for key, value in changes.items()}


def _given(entry: Entry) -> Any:
    """Return the value of a key; None if there is none that can be scaled."""
    for value in (entry.value, entry.default, USUAL.get(entry.text), "5 deg" if entry.unit == "rad" else None):
        if value is not NOT_GIVEN and value is not None:
            return value if _scalable(value) else None
    return None


def _scalable(value: Any) -> bool:
    if isinstance(value, list | tuple):
        return len(value) > 0 and all(map(_scalable, value))
    return isinstance(value, bool | int | float) or (isinstance(value, str) and bool(_QUANTITY.fullmatch(value)))


def _scaled(rng: random.Random, value: Any) -> Any:
    """Return a value with all its numbers a little greater or smaller."""
    factor = rng.uniform(0.9, 1.1)
    if isinstance(value, list | tuple):
        return [_scaled(rng, one) for one in value]
    if isinstance(value, bool):
        return rng.random() < 0.5
    if isinstance(value, str):
        match = _QUANTITY.fullmatch(value)
        assert match is not None, "`_scalable` has checked it"
        return f"{float(match[1]) * factor:.6g}{match[2]}"
    return float(f"{value * factor:.6g}")


def _text(value: Any) -> str:
    """Return a value as it stands after KEY=."""
    if isinstance(value, list):
        return "[" + ", ".join(repr(one) if isinstance(one, str) else _text(one) for one in value) + "]"
    return str(value).lower() if isinstance(value, bool) else str(value)
