"""Keys of a study: places in the scenario, in the arm's or the worksite's file, and in the study's own tables."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from functools import lru_cache
from typing import Any, Literal, NamedTuple

from aftdeck.arms.model import ArmFile
from aftdeck.errors import AftdeckError, InputError
from aftdeck.files import Text, Where, place, put, raw_contents
from aftdeck.operators.spec import OperatorSpec
from aftdeck.scenario.changes import parse_change
from aftdeck.scenario.schema import ScenarioFile
from aftdeck.schema_check import problems_of, unreadable
from aftdeck.study.schema import MonitorsSpec
from aftdeck.worksite.file.schema import WorksiteFile

Kind = Literal["scenario", "arm", "worksite", "operator", "monitors"]
_PREFIXES: tuple[Kind, ...] = ("arm", "worksite", "operator", "monitors")
_FILES: dict[Kind, type[Any]] = {
    "scenario": ScenarioFile,
    "arm": ArmFile,
    "worksite": WorksiteFile,
}
_LINE = re.compile(r"^.*?\.toml(:\d+)?: ")


class Key(NamedTuple):
    """A place whose value a study changes."""

    kind: Kind
    """File or table of the place."""
    where: Where

    @property
    def text(self) -> str:
        """The key as it is written in a study file."""
        return place(self.where) if self.kind == "scenario" else f"{self.kind}.{place(self.where)}"


class Change(NamedTuple):
    """A new value for a key."""

    key: Key
    value: object


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
    kind = next((prefix for prefix in _PREFIXES if where[0] == prefix and len(where) > 1), None)
    return Key("scenario", where) if kind is None else Key(kind, where[1:])


def of_kind(changes: Iterable[Change], kind: Kind) -> dict[Where, object]:
    """Return the new values for one file or table, by their places in it."""
    return {change.key.where: change.value for change in changes if change.key.kind == kind}


def problem_of(change: Change, texts: Mapping[Kind, Iterable[Text]], tables: Mapping[Kind, dict[str, Any]]) -> str:
    """Return why a change cannot be made; "" if the types of the file allow it.

    Only the changed place is checked, because a study may have thousands of changes. Values that contradict each other
    are found when the scenario is built.

    Args:
        change: the change.
        texts: texts of the scenario, of all arms and of all worksites; one that allows the change is enough.
        tables: contents of the study's own tables.
    """
    key, value = change
    if isinstance(value, str) and value.startswith("="):
        return ""  # an expression, which is computed when the scenario is built
    if key.kind in tables:
        schema = OperatorSpec if key.kind == "operator" else MonitorsSpec
        return _wrong(key, key.where, problems_of(tables[key.kind] | {str(key.where[0]): value}, schema))
    found = [_problem_in(text, change) for text in texts[key.kind]]
    return found[0] if all(found) else ""


def _problem_in(text: Text, change: Change) -> str:
    """Return why a change of a file cannot be made; "" if the types of the file allow it."""
    key, value = change
    try:
        around = _copy(_contents(text), key.where)
        put(around, key.where, value)
    except AftdeckError as error:
        return _LINE.sub("", str(error).splitlines()[0])
    at = _alone(around, key.where)
    return _wrong(key, at, [*unreadable(value, at), *problems_of(around, _FILES[key.kind])])


@lru_cache(maxsize=64)
def _contents(text: Text) -> dict[str, Any]:
    """Return a file's raw contents, which the caller does not change."""
    return raw_contents(text)


def _copy(contents: dict[str, Any], where: Where) -> dict[str, Any]:
    """Return contents that can be changed at one place only: what does not contain this place is not copied.

    Other outermost tables and lists are left out, because the type of the place depends on plain values at most.
    """
    copy = {name: item for name, item in contents.items() if name == where[0] or not isinstance(item, dict | list)}
    table: Any = copy
    for part in where[:-1]:
        try:
            table[part] = table[part].copy()
        except (AttributeError, LookupError, TypeError):
            break  # no such place: `put` makes it, or tells why not
        table = table[part]
    return copy


def _alone(contents: dict[str, Any], where: Where) -> Where:
    """Remove the other tables from each list of tables that contains a place; return where the place is then."""
    table: Any = contents
    at: list[str | int] = []
    for part in where:
        inner = table[part]
        if isinstance(part, int) and isinstance(inner, dict):
            table[:] = [inner]
            at.append(0)
        else:
            at.append(part)
        table = inner
    return tuple(at)


def _wrong(key: Key, at: Where, problems: Iterable[tuple[Where, str]]) -> str:
    """Return the first problem at a place, which is that of a key."""
    return next((f"{key.text}: {what}" for where, what in problems if _same(where, at)), "")


def _same(found: Where, changed: Where) -> bool:
    """Return whether a problem's place contains the changed place, or is inside it."""
    shorter = min(len(found), len(changed))
    return len(found) > 0 and found[:shorter] == changed[:shorter]
