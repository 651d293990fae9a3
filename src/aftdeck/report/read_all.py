"""Several recordings read at the same time, each by a process."""

from __future__ import annotations

import multiprocessing
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from pathlib import Path
from typing import TypeVar

from aftdeck.errors import AftdeckError
from aftdeck.law import compiled_before
from aftdeck.processes import cores, obey_parent, one_thread
from aftdeck.recording.reader import Recording

T = TypeVar("T")
ENOUGH = 2_000_000
"""Size of recordings from which on it takes less time to start processes than to read them here [bytes]."""


def read_all(
    files: Sequence[Path], read: Callable[[Recording], T], meanwhile: Callable[[], object] = lambda: None
) -> Iterator[T | AftdeckError]:
    """Yield what a function makes of each recording, in order, or the error of a recording that cannot be read.

    Args:
        files: paths of the recordings.
        read: function of a module; what it returns is sent from process to process.
        meanwhile: called while the processes read; what it raises ends the reading.
    """
    size = sum(file.stat().st_size for file in files if file.is_file())
    processes = min(len(files), cores())
    if cores() == 1 or size < ENOUGH or not compiled_before():
        meanwhile()
        for file in files:
            yield _read(file, read)
        return
    with one_thread():
        pool = ProcessPoolExecutor(processes, multiprocessing.get_context("spawn"), obey_parent)
        waiting = [pool.submit(_read, file, read) for file in files]
    try:
        meanwhile()
        for file, result in zip(files, waiting, strict=True):
            try:
                yield result.result()
            except BrokenProcessPool:
                yield AftdeckError(f"{file}: the process that read it has ended; is the memory full?")
    finally:
        pool.shutdown(cancel_futures=True)


def _read(file: Path, read: Callable[[Recording], T]) -> T | AftdeckError:
    """Return what a function makes of a recording, or an error with the same text as its own."""
    try:
        return read(Recording(file))
    except AftdeckError as error:
        return AftdeckError(str(error))
