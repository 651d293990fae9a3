"""Keys of a scenario and of the files that it names: ``arm.…`` and ``worksite.…`` are keys of those files."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from functools import lru_cache
from typing import Any, NamedTuple

from aftdeck.arms.model import ArmFile
from aftdeck.arms.shapes import ShapesFile
from aftdeck.errors import AftdeckError
from aftdeck.files import Text, Where, place, put, raw_contents
from aftdeck.scenario.changes import parse_key
from aftdeck.scenario.schema import ScenarioFile
from aftdeck.schema_check import problems_of, unreadable
from aftdeck.worksite.file.schema import WorksiteFile

SCENARIO, ARM, SHAPES, WORKSITE = "scenario", "arm", "shapes", "worksite"
"""Kinds of keys, by the file that has them: a scenario, its arm, the arm's shapes, and its worksite."""
FILES: dict[str, type[Any]] = {
    SCENARIO: ScenarioFile,
    ARM: ArmFile,
    SHAPES: ShapesFile,
    WORKSITE: WorksiteFile,
}
"""Types of the files."""
PREFIXES: dict[str, Where] = {SHAPES: ("arm", "shapes"), ARM: ("arm",), WORKSITE: ("worksite",)}
"""What a key begins with if it is in a file that another file names; the first that fits counts."""
_LINE = re.compile(r"^.*?\.toml(:\d+)?: ")


class Key(NamedTuple):
    """A place in one of the files, or in a table of a study."""

    kind: str
    """File or table of the place."""
    where: Where

    @property
    def text(self) -> str:
        """The key as it is written, such as ``arm.joint[0].hard``."""
        return place((*self.prefix, *self.where))

    @property
    def prefix(self) -> Where:
        """What the key begins with."""
        return () if self.kind == SCENARIO else PREFIXES.get(self.kind, (self.kind,))


class Change(NamedTuple):
    """A new value for a key."""

    key: Key
    value: object


def key_at(where: Where, prefixes: Mapping[str, Where] = PREFIXES) -> Key:
    """Return the key of a place; ``arm`` and ``worksite`` alone are keys of the scenario's file."""
    for kind, prefix in prefixes.items():
        if where[: len(prefix)] == prefix and len(where) > len(prefix):
            return Key(kind, where[len(prefix) :])
    return Key(SCENARIO, where)


def key_of(text: str) -> Key:
    """Return the key that a text names.

    Raises:
        InputError: the text is not a key of a file.
    """
    return key_at(parse_key(text))


def of_kind(changes: Iterable[Change], kind: str) -> dict[Where, object]:
    """Return the new values for one file or table, by their places in it."""
    return {change.key.where: change.value for change in changes if change.key.kind == kind}


def problem_in(text: Text, change: Change) -> str:
    """Return why a change of a file cannot be made; "" if the types of the file allow it."""
    key, value = change
    try:
        around = _copy(contents_of(text), key.where)
        put(around, key.where, value)
    except AftdeckError as error:
        return _LINE.sub("", str(error).splitlines()[0])
    at = _alone(around, key.where)
    return wrong(key, at, [*unreadable(value, at), *problems_of(around, FILES[key.kind])])


@lru_cache(maxsize=64)
def contents_of(text: Text) -> dict[str, Any]:
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


def wrong(key: Key, at: Where, problems: Iterable[tuple[Where, str]]) -> str:
    """Return the first problem at a place, which is that of a key."""
    return next((f"{key.text}: {what}" for where, what in problems if _same(where, at)), "")


def _same(found: Where, changed: Where) -> bool:
    """Return whether a problem's place contains the changed place, or is inside it."""
    shorter = min(len(found), len(changed))
    return len(found) > 0 and found[:shorter] == changed[:shorter]
