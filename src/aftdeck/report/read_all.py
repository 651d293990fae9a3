"""Several recordings read at the same time, each by a process."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from multiprocessing.connection import Connection
from pathlib import Path
from pkgutil import resolve_name
from typing import Any

from aftdeck.errors import AftdeckError
from aftdeck.law_folder import compiled_before
from aftdeck.processes import Child, cores

ENOUGH = 2_000_000
"""Size of recordings from which on it takes less time to start processes than to read them here [bytes].

Measured: equal times at 1.7 MB."""


def read_all(files: Sequence[Path], read: str, meanwhile: Callable[[], object] = lambda: None) -> Iterator[Any]:
    """Yield what a function makes of each recording, in order, or the error of a recording that cannot be read.

    Args:
        files: paths of the recordings.
        read: name of a function of a `Recording`, as ``package.module:function``; what it returns is sent from process
            to process. It is a name, because to import the module before the processes start would delay them.
        meanwhile: called once: while other processes read, or before this one does. What it raises ends the reading.
    """
    if cores() == 1 or sum(map(_size, files)) < ENOUGH or not compiled_before():
        meanwhile()
        yield from (_read(file, read) for file in files)
        return
    waiting, readers = deque(files), deque[_Reader]()
    try:
        _start(waiting, readers, read)
        meanwhile()
        while readers:
            found = readers[0].result()
            readers.popleft().kill()
            _start(waiting, readers, read)
            yield found
    finally:
        for reader in readers:
            reader.kill()


def _start(waiting: deque[Path], readers: deque[_Reader], read: str) -> None:
    """Start a process for each core, as long as files wait."""
    while waiting and len(readers) < cores():
        readers.append(_Reader(waiting.popleft(), read))


class _Reader(Child):
    """Process that reads one recording."""

    def __init__(self, file: Path, read: str) -> None:
        super().__init__(_send, file, read)
        self._file = file

    def result(self) -> Any:
        """Wait for the result, and return it."""
        try:
            return self.pipe.recv()
        except (EOFError, OSError):
            return AftdeckError(f"{self._file}: the process that read it has ended; is the memory full?")


def _send(pipe: Connection, file: Path, read: str) -> None:
    """Read a recording and send the result; what a process runs."""
    with suppress(BrokenPipeError):
        pipe.send(_read(file, read))


def _size(file: Path) -> int:
    """Return the size of a file [bytes]; 0 if it cannot be read, which its reader reports."""
    try:
        return file.stat().st_size
    except OSError:
        return 0


def _read(file: Path, read: str) -> Any:
    """Return what a function makes of a recording, or an error with the same text as its own."""
    from aftdeck.recording.reader import Recording  # noqa: PLC0415  (takes a quarter of a second)

    try:
        return resolve_name(read)(Recording(file))
    except AftdeckError as error:
        return AftdeckError(str(error))
