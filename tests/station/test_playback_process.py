"""Process that plays a recording for a flying station: its answers, its priority and its end."""

from __future__ import annotations

import asyncio
import os
import subprocess
import sys
from pathlib import Path

import msgspec
import pytest

from aftdeck.errors import RecordingError
from aftdeck.processes import BACKGROUND
from aftdeck.station.messages.playback import Block, PlaybackIndex
from aftdeck.station.playback.answers import INDEX, VERDICT, Answers
from aftdeck.station.playback.store import PlaybackStore
from aftdeck.station.server.playback_process import PlaybackProcess
from tests.station.pages import until
from tests.station.recordings import record_run


@pytest.fixture(scope="module")
def recording(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("flights") / "run.mcap"
    record_run(path, 300)
    return path


@pytest.mark.slow
def test_process_answers_like_a_store_and_has_a_lower_priority(recording: Path) -> None:
    async def asked() -> tuple[bytes, bytes, int]:
        process = PlaybackProcess(recording)
        try:
            await process.ready()
            with pytest.raises(IndexError, match="0 to 1, got 7"):
                await process.ask("7")
            return await process.ask(INDEX), await process.ask("1"), os.getpriority(os.PRIO_PROCESS, process.pid)
        finally:
            await process.close()

    index, block, priority = asyncio.run(asked())
    assert priority == os.getpriority(os.PRIO_PROCESS, 0) + BACKGROUND
    with PlaybackStore(recording) as store:
        answers = Answers(store, recording)
        assert answers.answer("1") == block
        here = msgspec.json.decode(answers.answer(INDEX), type=PlaybackIndex)
    there = msgspec.json.decode(index, type=PlaybackIndex)
    assert msgspec.structs.replace(there, verdict=here.verdict) == here
    assert len(msgspec.json.decode(block, type=Block)) == 300 - 256


@pytest.mark.slow
def test_unreadable_recording_and_ended_process_are_errors(tmp_path: Path, recording: Path) -> None:
    broken = tmp_path / "broken.mcap"
    broken.write_bytes(b"no recording")

    async def asked() -> None:
        process = PlaybackProcess(broken)
        with pytest.raises(RecordingError, match="not an MCAP file"):
            await process.ready()
        await process.close()
        process = PlaybackProcess(recording)
        await process.close()
        assert process.ended
        with pytest.raises(RecordingError):
            await process.ask(VERDICT)

    asyncio.run(asked())


def alive(pid: int) -> bool:
    """Return whether a process runs; a process that has ended but is still listed does not."""
    state = subprocess.run(["ps", "-o", "stat=", "-p", str(pid)], capture_output=True, text=True, check=False).stdout
    return bool(state.strip()) and not state.startswith("Z")


@pytest.mark.slow
def test_process_ends_with_a_killed_station_even_while_it_reads(recording: Path) -> None:
    code = (
        "import asyncio, os, sys\n"
        "from pathlib import Path\n"
        "from aftdeck.station.server.playback_process import PlaybackProcess\n"
        "async def main():\n"
        "    process = PlaybackProcess(Path(sys.argv[1]))\n"
        "    print(process.pid, flush=True)\n"
        "    os.kill(os.getpid(), 9)\n"
        "asyncio.run(main())\n"
    )
    ran = subprocess.run([sys.executable, "-c", code, str(recording)], capture_output=True, text=True, check=False)
    pid = int(ran.stdout)
    until(lambda: not alive(pid), "the process has ended")
