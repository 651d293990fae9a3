"""Playback of a recording in a process of its own, so that reading and verifying it delays no control step."""

from __future__ import annotations

import asyncio
import contextlib
import os
import sys
from pathlib import Path

from aftdeck.errors import RecordingError
from aftdeck.station.playback import child

NICE = 10
"""Difference between the priorities of the process and of the station: each level is about a fifth of a busy core."""


class PlaybackProcess:
    """Process that reads one recording, verifies it and answers pages."""

    def __init__(self, process: asyncio.subprocess.Process) -> None:
        self._process = process
        self._lock = asyncio.Lock()

    @classmethod
    async def start(cls, path: Path) -> PlaybackProcess:
        """Start the process; it begins to read `path`."""
        process = await asyncio.create_subprocess_exec(
            sys.executable,
            "-m",
            child.__name__,
            str(path),
            stdin=asyncio.subprocess.PIPE,
            stdout=asyncio.subprocess.PIPE,
            # Ctrl+C in the terminal goes to the station alone. In a session of its own the process would also be in a
            # scheduling group of its own, and its priority would not count against the station.
            process_group=0,
        )
        with contextlib.suppress(ProcessLookupError):
            os.setpriority(os.PRIO_PROCESS, process.pid, os.getpriority(os.PRIO_PROCESS, 0) + NICE)
        return cls(process)

    @property
    def pid(self) -> int:
        """Number of the process in the operating system."""
        return self._process.pid

    @property
    def ended(self) -> bool:
        """Whether the process has ended."""
        return self._process.returncode is not None

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
            try:
                assert self._process.stdin is not None
                self._process.stdin.write(f"{request}\n".encode())
                await self._process.stdin.drain()
            except ConnectionError:
                pass  # the process has ended: `_receive` reports it
            return await self._receive()

    async def _receive(self) -> bytes:
        assert self._process.stdout is not None
        try:
            kind, length = child.HEAD.unpack(await self._process.stdout.readexactly(child.HEAD.size))
            body = await self._process.stdout.readexactly(length)
        except asyncio.IncompleteReadError:
            raise RecordingError("the recording was closed; open it again") from None
        if kind == child.Kind.NO_BLOCK:
            raise IndexError(body.decode())
        if kind == child.Kind.UNREADABLE:
            raise RecordingError(body.decode())
        return body

    async def close(self) -> None:
        """End the process."""
        with contextlib.suppress(ProcessLookupError):
            self._process.kill()
        await self._process.wait()
