"""Files that appear only when they are complete: written beside their place, then moved to it.

After an error, such as that of a full disk, the place is as it was before. A recording is not written in this way: what
was recorded before the error is of use (`recording/sink.py`).
"""

from __future__ import annotations

import os
import secrets
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import BinaryIO

from aftdeck.encodable import encodable
from aftdeck.errors import InputError
from aftdeck.files import check_new


@contextmanager
def whole_file(path: Path) -> Iterator[BinaryIO]:
    """Yield a file that takes the place of `path` at the end of the `with` block, unless an error is raised.

    Missing folders are created. A device or a pipe, such as ``/dev/stdout``, is written directly.

    Raises:
        InputError: the file cannot be written.
    """
    try:
        place = _place(path)
        if place.exists() and not place.is_file():
            with place.open("wb") as file:
                yield file
            return
        place.parent.mkdir(parents=True, exist_ok=True)
        aside = place.with_name(f".aftdeck-{secrets.token_hex(8)}")  # any name of the place is short enough for it
        try:
            with aside.open("xb") as file:
                yield file
            aside.replace(place)
        finally:
            aside.unlink(missing_ok=True)
    except OSError as error:
        raise InputError(f"{path}: cannot be written: {error.strerror or error}") from None


def _place(path: Path) -> Path:
    """Return where a path leads, so that a link stays a link."""
    try:
        return Path(os.path.realpath(path))
    except ValueError as error:  # a zero byte
        raise InputError(f"{str(path)!r}: cannot be written: {error}") from None


@contextmanager
def new_file(path: Path) -> Iterator[BinaryIO]:
    """Yield a file as `whole_file` does, for a path that nothing has yet.

    Raises:
        InputError: as for `whole_file` and `files.check_new`.
    """
    check_new(path)
    with whole_file(path) as file:
        yield file
        check_new(path)  # another process may have made it meanwhile


def write_whole(path: Path, content: bytes | str) -> None:
    """Write a file, or replace it.

    Raises:
        InputError: the file cannot be written.
    """
    with whole_file(path) as file:
        file.write(as_bytes(content))


def write_new(path: Path, content: bytes | str) -> None:
    """Write a file that does not exist yet.

    Raises:
        InputError: the file exists already or cannot be written.
    """
    with new_file(path) as file:
        file.write(as_bytes(content))


def as_bytes(content: bytes | str) -> bytes:
    """Return bytes unchanged, and text in UTF-8."""
    return content if isinstance(content, bytes) else encodable(content).encode()
