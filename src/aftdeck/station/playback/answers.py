"""Answers to a page that plays a recording: its index, its blocks of frames, and the verdict, each as JSON.

The process that draws pictures asks for single steps.
"""

from __future__ import annotations

from pathlib import Path
from threading import Thread

import msgspec

from aftdeck.station.playback.lit import encoded
from aftdeck.station.playback.store import PlaybackStore
from aftdeck.station.playback.verdict import CHECKING, verdict

INDEX, VERDICT = "index", "verdict"
"""Requests for the data of the whole run, and for the result of the re-simulation."""
LIT = "lit "
"""Beginning of a request for a step in its light; the step's number follows."""


class Answers:
    """Recording that is read, verified in a thread of its own, and asked by pages."""

    def __init__(self, store: PlaybackStore, path: Path) -> None:
        """Answer from `store`, which has read the file `path`."""
        self._store, self._path = store, path
        self._verdict = CHECKING
        self._encode = msgspec.json.Encoder().encode

    def check(self) -> None:
        """Start the verification of the recording in a daemon thread, which does not delay the end of the program."""
        Thread(target=self._check, name="verification", daemon=True).start()

    def _check(self) -> None:
        self._verdict = verdict(self._path)

    def answer(self, request: str) -> bytes:
        """Return the JSON text of `INDEX`, of `VERDICT`, or of the block whose number is given in decimal digits.

        The answer to `LIT` is msgpack (`lit.py`).

        May be called from any thread.

        Raises:
            IndexError: the block or the step does not exist.
        """
        if request == INDEX:
            return self._encode(self._store.index(self._verdict))
        if request == VERDICT:
            return self._encode(self._verdict)
        if request.startswith(LIT):
            return encoded(self._store.lit(int(request.removeprefix(LIT))))
        return self._encode(self._store.block(int(request)))
