"""Several recordings read at the same time, each by a process."""

from __future__ import annotations

import multiprocessing
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from multiprocessing.connection import Connection
from pathlib import Path
from pkgutil import resolve_name
from typing import Any

from aftdeck.errors import AftdeckError
from aftdeck.law import compiled_before
from aftdeck.processes import cores, obey_parent, one_thread

ENOUGH = 2_000_000
"""Size of recordings from which on it takes less time to start processes than to read them here [bytes]."""


def read_all(files: Sequence[Path], read: str, meanwhile: Callable[[], object] = lambda: None) -> Iterator[Any]:
    """Yield what a function makes of each recording, in order, or the error of a recording that cannot be read.

    Args:
        files: paths of the recordings.
        read: name of a function of a `Recording`, as ``package.module:function``; what it returns is sent from process
            to process. It is a name, because to import the module before the processes start would delay them.
        meanwhile: called while the processes read, or after the first recording that was read here; what it raises ends
            the reading.
    """
    if cores() == 1 or sum(map(_size, files)) < ENOUGH or not compiled_before():
        yield from _one_after_the_other(files, read, meanwhile)
        return
    waiting, readers = deque(files), deque[_Reader]()
    try:
        _start(waiting, readers, read)
        meanwhile()
        while readers:
            found = readers[0].result()
            readers.popleft().end()
            _start(waiting, readers, read)
            yield found
    finally:
        for reader in readers:
            reader.end()


def _start(waiting: deque[Path], readers: deque[_Reader], read: str) -> None:
    """Start a process for each core, as long as files wait."""
    while waiting and len(readers) < cores():
        readers.append(_Reader(waiting.popleft(), read))


class _Reader:
    """Process that reads one recording."""

    def __init__(self, file: Path, read: str) -> None:
        context = multiprocessing.get_context("spawn")
        self._file = file
        self._pipe, theirs = context.Pipe(duplex=False)
        self._process = context.Process(target=_send, args=(theirs, file, read), daemon=True)
        with one_thread():
            self._process.start()
        theirs.close()

    def result(self) -> Any:
        """Wait for the result, and return it."""
        try:
            return self._pipe.recv()
        except (EOFError, OSError):
            return AftdeckError(f"{self._file}: the process that read it has ended; is the memory full?")

    def end(self) -> None:
        """End the process."""
        self._process.kill()
        self._process.join()
        self._pipe.close()


def _send(pipe: Connection, file: Path, read: str) -> None:
    """Read a recording and send the result; what a process runs."""
    obey_parent()
    with suppress(BrokenPipeError):
        pipe.send(_read(file, read))


def _one_after_the_other(files: Sequence[Path], read: str, meanwhile: Callable[[], object]) -> Iterator[Any]:
    prepared = False
    for file in files:
        found = _read(file, read)
        if not prepared and not isinstance(found, AftdeckError):
            meanwhile()
            prepared = True
        yield found


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
