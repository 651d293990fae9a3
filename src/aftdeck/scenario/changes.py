"""Changes of a scenario's file, each written as KEY=VALUE."""

from __future__ import annotations

import json
import re
import tomllib
from collections.abc import Mapping
from datetime import date, time
from typing import Any

from aftdeck.errors import InputError
from aftdeck.files import Changes, Where, place
from aftdeck.units import short

GivenChanges = Mapping[Any, object]
"""New values, as a caller gives them: the key is a text as for `parse_key`, or a tuple (`Where`). The type is `Any`,
because a Mapping is invariant in the type of its keys: a `dict[tuple[str], str]` would not fit."""
_KEY = re.compile(r"[A-Za-z_][A-Za-z0-9_]*(\[\d+\])*(\.[A-Za-z_][A-Za-z0-9_]*(\[\d+\])*)*")


def parse_change(text: str) -> tuple[Where, object]:
    """Return the location in a scenario's file and the new value from the text ``KEY=VALUE``.

    The value is read as TOML if it is valid TOML (``0.5``, ``true``, ``[1, 2]``), otherwise as text (``0.5 ft/s``).

    Raises:
        InputError: the text is not ``KEY=VALUE``.
    """
    key, equals, value = text.partition("=")
    if not equals or not _KEY.fullmatch(key.strip()):
        raise InputError(
            f"a change must be KEY=VALUE with a key of the scenario's file, such as command_delay=0.5, "
            f"limits.por.translation='1 ft/s' or phase[0].rate=vernier; got {text!r}"
        )
    return parse_key(key.strip()), value_of(value.strip())


def parse_key(key: str) -> Where:
    """Return the location in a scenario's file from its text, such as ``phase[0].rate``.

    Raises:
        InputError: the text is not a key of a file.
    """
    if not _KEY.fullmatch(key):
        raise InputError(
            f"the key of a change must be one of the scenario's file, such as command_delay, limits.por.translation or "
            f"phase[0].rate; got {key!r}"
        )
    return tuple(int(i) if i else name for name, i in re.findall(r"([A-Za-z_][A-Za-z0-9_]*)|\[(\d+)\]", key))


def located(changes: GivenChanges) -> Changes:
    """Return changes with their locations as tuples.

    Args:
        changes: the new values.

    Raises:
        InputError: a key is neither a text nor a tuple that names a value, or two keys are the same location.
    """
    found: dict[Where, object] = {}
    for key, value in changes.items():
        if isinstance(key, str):
            where = parse_key(key)
        elif not isinstance(key, tuple) or not all(type(part) in (str, int) for part in key):
            raise InputError(
                f"the key of a change must be a text such as 'phase[0].rate', or a tuple; got {short(key)}"
            )
        elif (where := parse_key(place(key))) != key:
            raise InputError(f"the key of a change must be {where} to name {place(where)}; got {key}")
        if where in found:
            raise InputError(f"{place(where)} is changed twice")
        found[where] = value
    return found


def change_text(where: Where, value: object) -> str:
    """Return a change as the text ``KEY=VALUE``, from which `parse_change` returns the same location and value."""
    plain = isinstance(value, str) and value == value.strip() and value_of(value) == value
    return f"{place(where)}={value if plain else as_toml(value)}"


def value_of(value: str) -> object:
    """Return the value that a text states: as TOML if it is valid TOML, otherwise the text."""
    try:
        read = tomllib.loads(f"value = {value}")
    except (ValueError, RecursionError):
        return value
    if len(read) > 1:
        return value
    try:
        as_toml(read["value"])
    except ValueError:  # a number with thousands of digits, which Python does not write
        return value
    return read["value"]


def as_toml(value: object) -> str:
    """Return a plain value as TOML; TOML writes texts and lists as JSON does, and tables with ``=``."""
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{as_toml(str(key))} = {as_toml(item)}" for key, item in value.items()) + " }"
    if isinstance(value, list | tuple):
        return "[" + ", ".join(map(as_toml, value)) + "]"
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007F")
    if isinstance(value, date | time):
        return value.isoformat()
    return str(value).lower() if isinstance(value, bool) else repr(value)
