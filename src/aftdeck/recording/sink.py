"""Unbuffered file for the MCAP writer; its methods raise no exceptions.

If the program is killed, no bytes are lost in a buffer. The writer's library logs an error instead of raising it.
Therefore, once this file is open, its methods do not raise errors; it stores the first error that occurs.
"""

from __future__ import annotations

import os
from pathlib import Path

from aftdeck.errors import RecordingError


class Sink:
    """File that writes bytes until its first error, and discards all later bytes.

    Attributes:
        error: text of the first error; empty if no error has occurred.
    """

    def __init__(self, path: Path) -> None:
        self.error = ""
        self._at = self._end = 0
        try:
            path.parent.mkdir(parents=True, exist_ok=True)
            self._file = path.open("xb", buffering=0)
        except OSError as error:
            if os.path.lexists(path):
                raise RecordingError(
                    f"{path}: exists already and is not overwritten; choose another name", "exists"
                ) from None
            raise RecordingError(f"{path}: cannot be written: {error.strerror or error}", "unwritable") from None

    def write(self, data: bytes | bytearray) -> int:
        """Write `data` at the present position, or nothing after an error; always return the length of `data`."""
        view = memoryview(data)
        try:
            while view and not self.error:
                view = view[self._file.write(view) or 0 :]
        except OSError as error:
            self.error = error.strerror or str(error)
        self._at += len(data)
        self._end = max(self._end, self._at)
        return len(data)

    def seek(self, offset: int, whence: int = 0) -> int:
        """Move to an offset and return the new position, even after an error; the library needs this value."""
        self._at = offset + (0, self._at, self._end)[whence]
        try:
            if not self.error:
                self._file.seek(self._at)
        except OSError as error:
            self.error = error.strerror or str(error)
        return self._at

    def flush(self) -> None:
        """Do nothing: no bytes are buffered."""

    def close(self) -> None:
        """Write the file's content to the disk (fsync), and close the file."""
        try:
            os.fsync(self._file.fileno())
            self._file.close()
        except OSError as error:
            self.error = self.error or error.strerror or str(error)
