"""Keys of a study: places in the scenario, in the arm's or the worksite's file, and in the study's own tables."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from aftdeck.dimensions import is_formula
from aftdeck.errors import InputError
from aftdeck.files import Text, Where
from aftdeck.operators.spec import OperatorSpec
from aftdeck.scenario.changes import parse_change
from aftdeck.scenario.keys import PREFIXES, Change, Key, key_at, problem_in, wrong
from aftdeck.schema_check import problems_of
from aftdeck.study.schema import MonitorsSpec

OPERATOR, MONITORS = "operator", "monitors"
"""Kinds of the keys of the study's own tables."""
_PREFIXES: dict[str, Where] = PREFIXES | {kind: (kind,) for kind in (OPERATOR, MONITORS)}


def parse_key(text: str) -> Key:
    """Return the place that a key of a study names.

    ``arm.…`` is a key of the arm's file, ``worksite.…`` of the worksite's file; ``operator.…`` and ``monitors.…`` are
    keys of the study's tables. All others, among them ``arm`` and ``worksite`` alone, are keys of the scenario's file.

    Raises:
        InputError: the text is not a key.
    """
    try:
        where, _ = parse_change(f"{text}=0")
    except InputError:
        where = ()
    if not where or "=" in text:
        raise InputError(
            f"expected a key such as command_delay, phase[0].rate, arm.dimensions.boom, "
            f"worksite.dimensions.bay_length, operator.gain or monitors.mon_1, got {text!r}"
        )
    return key_at(where, _PREFIXES)


def problem_of(change: Change, texts: Mapping[str, Iterable[Text]], tables: Mapping[str, dict[str, Any]]) -> str:
    """Return why a change cannot be made; "" if the types of the file allow it.

    Only the changed place is checked, because a study may have thousands of changes. Values that contradict each other
    are found when the scenario is built.

    Args:
        change: the change.
        texts: texts of the scenario, of all arms and of all worksites; one that allows the change is enough.
        tables: contents of the study's own tables.
    """
    key, value = change
    if is_formula(value):
        return ""  # an expression, which is computed when the scenario is built
    if key.kind in tables:
        schema = OperatorSpec if key.kind == OPERATOR else MonitorsSpec
        return wrong(key, key.where, problems_of(tables[key.kind] | {str(key.where[0]): value}, schema))
    found = [problem_in(text, change) for text in texts[key.kind]]
    if not found:
        return f"{key.text}: the arm has no file of shapes"
    return found[0] if all(found) else ""
