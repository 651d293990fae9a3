"""Process that reads one recording for a flying station, and answers its requests (`answers.py`)."""

from __future__ import annotations

from multiprocessing.connection import Connection
from pathlib import Path

from aftdeck.errors import AftdeckError, RecordingError
from aftdeck.station.playback.answers import Answers
from aftdeck.station.playback.store import PlaybackStore


def play(pipe: Connection, path: Path) -> None:
    """Read a recording, and send b"" when it is read; then send the answer to each request.

    Instead of an answer, send the `RecordingError` because of which the recording cannot be read, or the `IndexError`
    of a block that does not exist.
    """
    try:
        store = PlaybackStore(path)
    except (OSError, AftdeckError) as error:
        return pipe.send(RecordingError(str(error)))
    answers = Answers(store, path)
    answers.check()
    pipe.send(b"")
    while True:
        request: str = pipe.recv()
        try:
            pipe.send(answers.answer(request))
        except IndexError as error:
            pipe.send(error)
