"""All keys of a scenario, its arm and its worksite: value, unit, range and source of each.

The list follows the types of the files. It has the keys that the files give and those that they could give in the
tables that they have.
"""

from __future__ import annotations

from collections.abc import Iterator
from copy import deepcopy
from functools import cache, lru_cache
from typing import Annotated, Any, NamedTuple, get_args, get_origin

import msgspec

from aftdeck.arms.constant import Constant
from aftdeck.bounds import Bounds
from aftdeck.errors import InputError
from aftdeck.files import put
from aftdeck.scenario.all_cameras import cameras_of
from aftdeck.scenario.changes import as_toml, parse_change
from aftdeck.scenario.in_flight import changing, obstacle
from aftdeck.scenario.keys import ARM, FILES, SCENARIO, SHAPES, Key, contents_of, key_at
from aftdeck.scenario.load import text_of
from aftdeck.scenario.model import Scenario
from aftdeck.schema_check import fields_of, tagged_kinds, without_none
from aftdeck.units import Quantity

NOT_GIVEN = msgspec.UNSET
"""Value of a key that the files do not give."""
_DEPTH = 2
"""Greatest depth of tables that a file does not give."""


class Entry(NamedTuple):
    """A key with its value.

    Attributes:
        key: the key.
        value: value as in the file, such as ``"2 ft/s"``; `NOT_GIVEN` if no file gives it.
        default: value without it; `NOT_GIVEN` if the type says none.
        unit: SI unit of its numbers; empty for none.
        bounds: plausible range of its numbers; None if there is none.
        source: source of the value; empty if the file does not state it.
    """

    key: Key
    value: Any
    default: Any
    unit: str
    bounds: Bounds | None
    source: str

    @property
    def text(self) -> str:
        """The key as it is written."""
        return self.key.text

    @property
    def changes(self) -> bool:
        """Whether the value can change in flight."""
        return changing(self.key) is not None

    def sentence(self) -> str:
        """Return the value with its unit, range and source, and whether it can change in flight, as a sentence each."""
        given = self.value is not NOT_GIVEN
        value = self.value if given else self.default
        parts = [f"{self.text} = {as_toml(value)}" if value is not NOT_GIVEN and value is not None else self.text]
        if not given:
            usual = ": the arm's own value counts" if self.key.where[0] == "limits" else ""
            parts.append(f"not given{usual}" if value in (NOT_GIVEN, None) else "the usual value")
        if self.unit:
            parts.append(f"a number alone is in {self.unit}")
        if self.bounds is not None:
            parts.append(f"range {self.bounds.least:.6g} to {self.bounds.greatest:.6g} {self.unit}".rstrip())
        if self.source:
            parts.append(f"source: {self.source}")
        row = changing(self.key)
        parts.append(
            f"can change in flight: {row.what}" if row else f"cannot change in flight: it {obstacle(self.key)}"
        )
        return "; ".join(parts)


def key_list(scenario: Scenario, changes: tuple[str, ...] = ()) -> dict[str, Entry]:
    """Return all keys of a scenario by their texts.

    Args:
        scenario: the scenario with which the run began.
        changes: changes in force, each as KEY=VALUE; their values replace those of the files.
    """
    by_file: dict[str, list[str]] = {kind: [] for kind in FILES}
    for change in (*scenario.changes, *changes):
        by_file[key_at(parse_change(change)[0]).kind].append(change)
    found: dict[str, Entry] = {}
    for kind, own in by_file.items():
        found |= _of_file(scenario, kind, tuple(own))
    return found


@lru_cache(maxsize=16)
def _of_file(scenario: Scenario, kind: str, changes: tuple[str, ...]) -> dict[str, Entry]:
    """Return the keys of one of a scenario's files, with the changes in it."""
    if kind == SHAPES and scenario.arm.model.shapes is None:
        return {}
    raw = deepcopy(contents_of(text_of(scenario, kind)))
    changed = []
    for where, value in map(parse_change, changes):
        changed.append(key_at(where).where)
        put(raw, changed[-1], value)
    found = {entry.text: entry for entry in _table(Key(kind, ()), FILES[kind], raw, _sources(kind, raw), 0)}
    if kind == SCENARIO:
        for camera in cameras_of(scenario):
            for part in ("pan", "tilt", "zoom"):
                if camera.drive is not None and getattr(camera.drive, part) is not None:
                    key = Key(SCENARIO, ("cameras", camera.name, part))
                    found.setdefault(key.text, Entry(key, NOT_GIVEN, NOT_GIVEN, "rad", None, ""))
    for text, entry in found.items():
        if any(entry.key.where[: len(where)] == where for where in changed):
            found[text] = entry._replace(source="changed")
    return found


def entry_of(scenario: Scenario, text: str, changes: tuple[str, ...] = ()) -> tuple[Entry, ...]:
    """Return the entry of a key, or those of all keys inside it.

    Raises:
        InputError: there is no such key.
    """
    entries = key_list(scenario, changes)
    if text in entries:
        return (entries[text],)
    inside = tuple(entry for name, entry in entries.items() if name.startswith((f"{text}.", f"{text}[")))
    if not inside:
        near = _nearest(text, entries)
        raise InputError(f"no key {text!r}" + (f"; did you mean {near}?" if near else ""))
    return inside


def _nearest(text: str, entries: dict[str, Entry]) -> str:
    """Return the key that is most like a text: one with the same last name, or with the longest equal beginning."""
    last = text.rsplit(".", 1)[-1]
    same = [name for name in entries if name.rsplit(".", 1)[-1] == last and len(last) > 1]
    if same:
        return same[0]
    for length in range(len(text), 1, -1):
        if found := next((name for name in entries if name.startswith(text[:length])), ""):
            return found
    return ""


def _sources(kind: str, raw: dict[str, Any]) -> dict[str, str]:
    """Return the sources of quantities that an arm's file states once for all joints, by the quantity's name."""
    table = raw.get("sources", {}) if kind == ARM else {}
    return {name: one["source"] for name, one in table.items() if isinstance(one, dict) and "source" in one}


def _table(key: Key, kind: Any, raw: Any, sources: dict[str, str], depth: int, source: str = "") -> Iterator[Entry]:
    """Yield the entries of a table; `raw`: its contents, `NOT_GIVEN` if the file does not give it."""
    contents = raw if isinstance(raw, dict) else {}
    source = _text(contents.get("source")) or source
    struct = get_origin(kind) or kind
    for name, field in fields_of(kind).items():
        default = field.default
        if field.default_factory is not msgspec.NODEFAULT or default is msgspec.NODEFAULT:
            default = NOT_GIVEN
        inner = Key(key.kind, (*key.where, name))
        said = source if issubclass(struct, Constant) else sources.get(name, source)
        yield from _value(inner, field.type, contents.get(name, NOT_GIVEN), default, sources, depth, said)


def _value(
    key: Key, hint: Any, raw: Any, default: Any, sources: dict[str, str], depth: int, source: str
) -> Iterator[Entry]:
    """Yield the entries of a field: its own, or those of the tables in it."""
    kind, bounds = _plain(hint)
    struct = _struct(kind, raw)
    if struct is not None:
        if raw is not NOT_GIVEN or depth < _DEPTH:
            yield from _table(key, struct, raw, sources, depth + (raw is NOT_GIVEN), source)
        return
    arguments = get_args(kind)
    if get_origin(kind) is tuple and arguments[1:] == (Ellipsis,):
        item = _plain(arguments[0])[0]
        if isinstance(raw, list) and any(_struct(item, one) is not None for one in raw):
            for i, one in enumerate(raw):
                inner = Key(key.kind, (*key.where, i))
                yield from _value(inner, arguments[0], one, NOT_GIVEN, sources, depth, source)
            return
        if _struct(item, NOT_GIVEN) is not None or tagged_kinds(item):
            return  # a list of tables that the file does not give
    if get_origin(kind) is dict and isinstance(raw, dict):
        for name, one in raw.items():
            inner = Key(key.kind, (*key.where, name))
            yield from _value(inner, arguments[1], one, NOT_GIVEN, sources, depth, source)
        return
    if get_origin(kind) is not dict:
        leaf, bounds = _leaf(kind, bounds)
        is_quantity = isinstance(leaf, type) and issubclass(leaf, Quantity)
        unit = leaf.unit if is_quantity else bounds.unit if bounds else ""
        yield Entry(key, raw, default, unit, bounds or (leaf.bounds if is_quantity else None), source)


@cache
def _plain(hint: Any) -> tuple[Any, Bounds | None]:
    """Return a type without None and without metadata, and the range that it declares."""
    bounds: Bounds | None = None
    kind, _ = without_none(hint)
    while get_origin(kind) is Annotated:
        inner, *metas = get_args(kind)
        bounds = next((meta for meta in metas if isinstance(meta, Bounds)), bounds)
        kind, _ = without_none(inner)
    return kind, bounds


def _struct(kind: Any, raw: Any) -> Any:
    """Return the type of a table; None if the type is not that of a table, or its tag is not given."""
    origin = get_origin(kind) or kind
    if isinstance(origin, type) and issubclass(origin, msgspec.Struct):
        return kind
    tagged = tagged_kinds(kind)
    given = [raw.get(one.__struct_config__.tag_field) for one in tagged.values()] if isinstance(raw, dict) else []
    return tagged.get(str(given[0])) if given else None


def _leaf(kind: Any, bounds: Bounds | None) -> tuple[Any, Bounds | None]:
    """Return the type of the numbers of a value, and their range."""
    while get_args(kind):
        kind, own = _plain(get_args(kind)[0])
        bounds = own or bounds
    return kind, bounds


def _text(value: object) -> str:
    return value if isinstance(value, str) else ""
