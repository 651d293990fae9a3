"""Several recordings read at the same time, each by a process."""

from __future__ import annotations

import multiprocessing
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
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
        pool.shutdown(wait=False, cancel_futures=True)  # the processes end by themselves


def _read(file: Path, read: str) -> Any:
    """Return what a function makes of a recording, or an error with the same text as its own."""
    from aftdeck.recording.reader import Recording  # noqa: PLC0415  (takes a quarter of a second)

    try:
        return resolve_name(read)(Recording(file))
    except AftdeckError as error:
        return AftdeckError(str(error))
