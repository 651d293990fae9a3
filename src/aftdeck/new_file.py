"""Check of a file that a command is going to write."""

from __future__ import annotations

from pathlib import Path

from aftdeck.errors import InputError
from aftdeck.files import check_new


def check_new_file(file: Path, endings: tuple[str, ...]) -> None:
    """Check that a file can be written.

    Raises:
        InputError: its name has another ending; or as for `files.check_new`.
    """
    if file.suffix not in endings:
        raise InputError(f"the name has to end with {' or '.join(endings)}, got {file}")
    check_new(file)
