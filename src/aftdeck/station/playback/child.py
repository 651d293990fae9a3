"""Process that reads one recording for a flying station: ``python -m aftdeck.station.playback.child FILE``.

Each line on its standard input is a request (`answers.py`). Each answer on its standard output is a `HEAD` with its
kind and length, then its bytes. The first answer comes without a request, when the recording is read. The process ends
when its standard input is closed, even while it reads.
"""

from __future__ import annotations

import os
import struct
import sys
from enum import IntEnum
from pathlib import Path
from queue import SimpleQueue
from threading import Thread

from aftdeck.errors import AftdeckError
from aftdeck.station.playback.answers import Answers
from aftdeck.station.playback.store import PlaybackStore

HEAD = struct.Struct("!BQ")
"""Kind and length of an answer."""


class Kind(IntEnum):
    """Kind of an answer; except for `DATA`, its bytes are a sentence."""

    DATA = 0
    NO_BLOCK = 1
    UNREADABLE = 2


def main() -> None:
    """Read the recording, then answer requests."""
    answers_fd = os.dup(1)
    os.dup2(2, 1)  # whatever a library prints must not come between the answers
    requests: SimpleQueue[str] = SimpleQueue()
    Thread(target=_receive, args=(requests,), daemon=True).start()
    path = Path(sys.argv[1])
    try:
        store = PlaybackStore(path)
    except (OSError, AftdeckError) as error:
        return _send(answers_fd, Kind.UNREADABLE, str(error).encode())
    answers = Answers(store, path)
    answers.check()
    _send(answers_fd, Kind.DATA, b"")
    while True:
        try:
            kind, body = Kind.DATA, answers.answer(requests.get())
        except IndexError as error:
            kind, body = Kind.NO_BLOCK, str(error).encode()
        _send(answers_fd, kind, body)


def _receive(requests: SimpleQueue[str]) -> None:
    for line in sys.stdin:
        requests.put(line.strip())
    os._exit(0)  # the station has closed the recording, or has ended


def _send(answers_fd: int, kind: Kind, body: bytes) -> None:
    waiting = memoryview(HEAD.pack(kind, len(body)) + body)
    while waiting:
        waiting = waiting[os.write(answers_fd, waiting) :]


if __name__ == "__main__":
    main()
