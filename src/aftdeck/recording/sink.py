"""The file below the MCAP writer: unbuffered, so that what was written outlives the program; it never raises.

The writer's own library logs what goes wrong instead of raising it, so the first error is kept here for its user.
"""

from __future__ import annotations

import os
from pathlib import Path

from aftdeck.errors import RecordingError


class Sink:
    """A file that takes bytes until its first error and drops what comes after it.

    Attributes:
        error: what went wrong, in words; empty while nothing has.
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
                    f"{path}: exists already, and no recording is written over; give another name"
                ) from None
            raise RecordingError(f"{path}: cannot be written: {error.strerror or error}") from None

    def write(self, data: bytes | bytearray) -> int:
        """Append all of `data`, unless something went wrong before."""
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
        """As of a file that took everything: the library breaks down where it is told of another place."""
        self._at = offset + (0, self._at, self._end)[whence]
        try:
            if not self.error:
                self._file.seek(self._at)
        except OSError as error:
            self.error = error.strerror or str(error)
        return self._at

    def flush(self) -> None:
        """Nothing is held back."""

    def close(self) -> None:
        """Close the file, and see that it is on the disk."""
        try:
            os.fsync(self._file.fileno())
            self._file.close()
        except OSError as error:
            self.error = self.error or error.strerror or str(error)
