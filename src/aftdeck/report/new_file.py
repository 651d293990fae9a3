"""Check of a file that a report is going to write."""

from __future__ import annotations

from pathlib import Path

from aftdeck.errors import InputError

TABLE_ENDINGS = (".csv", ".parquet")
"""Endings of a table's name."""


def check_new(file: Path, endings: tuple[str, ...]) -> None:
    """Check that a file can be written.

    Raises:
        InputError: the file exists already, or its name has another ending.
    """
    if file.suffix not in endings:
        raise InputError(f"the name has to end with {' or '.join(endings)}, got {file}")
    if file.exists():
        raise InputError(f"{file} exists already")
