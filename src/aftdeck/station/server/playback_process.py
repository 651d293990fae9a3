"""Playback of a recording in a process of its own, so that reading and verifying it delays no control step."""

from __future__ import annotations

import asyncio
import contextlib
from pathlib import Path

from aftdeck.errors import RecordingError
from aftdeck.processes import BACKGROUND, Child
from aftdeck.station.playback.child import play


class PlaybackProcess:
    """Process that reads one recording, verifies it and answers pages."""

    def __init__(self, path: Path) -> None:
        """Start the process; it begins to read `path`."""
        self._child = Child(play, path, nice=BACKGROUND)
        self._lock = asyncio.Lock()

    @property
    def pid(self) -> int:
        """Number of the process in the operating system."""
        return self._child.process.pid

    @property
    def ended(self) -> bool:
        """Whether the process has ended."""
        return self._child.process.poll() is not None

    async def ready(self) -> None:
        """Wait until the recording is read.

        Raises:
            RecordingError: it cannot be read, or the process has ended.
        """
        async with self._lock:
            await self._receive()

    async def ask(self, request: str) -> bytes:
        """Return the answer to a request (`playback/answers.py`).

        Raises:
            IndexError: the block does not exist.
            RecordingError: the process has ended.
        """
        async with self._lock:
            with contextlib.suppress(OSError):  # the process has ended: `_receive` reports it
                self._child.pipe.send(request)
            return await self._receive()

    async def _receive(self) -> bytes:
        try:
            answer: bytes | RecordingError | IndexError = await asyncio.to_thread(self._child.pipe.recv)
        except (EOFError, OSError):
            raise RecordingError("the recording was closed; open it again") from None
        if isinstance(answer, bytes):
            return answer
        raise answer

    async def close(self) -> None:
        """End the process."""
        self._child.process.kill()
        async with self._lock:  # no thread reads from the pipe
            self._child.kill()
