"""Changes of a scenario's file, each written as KEY=VALUE."""

from __future__ import annotations

import json
import re
import tomllib
from datetime import date, time

from aftdeck.errors import InputError
from aftdeck.files import Where, place

_KEY = re.compile(r"[A-Za-z_][A-Za-z0-9_]*(\[\d+\])*(\.[A-Za-z_][A-Za-z0-9_]*(\[\d+\])*)*")


def parse_change(text: str) -> tuple[Where, object]:
    """Return the location in a scenario's file and the new value from the text ``KEY=VALUE``.

    The value is read as TOML if it is valid TOML (``0.5``, ``true``, ``[1, 2]``), otherwise as text (``0.5 ft/s``).

    Raises:
        InputError: the text is not ``KEY=VALUE``.
    """
    key, equals, value = text.partition("=")
    key = key.strip()
    if not equals or not _KEY.fullmatch(key):
        raise InputError(
            f"a change must be KEY=VALUE with a key of the scenario's file, such as command_delay=0.5, "
            f"limits.por.translation='1 ft/s' or phase[0].rate=vernier; got {text!r}"
        )
    where = tuple(int(i) if i else name for name, i in re.findall(r"([A-Za-z_][A-Za-z0-9_]*)|\[(\d+)\]", key))
    return where, value_of(value.strip())


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
    return read["value"] if len(read) == 1 else value


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
