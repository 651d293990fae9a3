"""Files that are small on the disk and large in memory or time are rejected quickly, or read within their own size."""

from __future__ import annotations

import functools
import json
import random
import struct
import subprocess
import sys
import tracemalloc
import zlib
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import lz4.frame
import msgspec
import pytest
import zstandard
from mcap.records import Message

import aftdeck
from aftdeck.errors import RecordingError
from aftdeck.recording.bundle import opening
from aftdeck.recording.codec import encode
from aftdeck.recording.convert import frame_record, input_record
from aftdeck.recording.damage import DamageError
from aftdeck.recording.decompress import MAX_RATIO, MAX_UNPACKED, SMALL
from aftdeck.recording.mcap_index import IndexCheck
from aftdeck.recording.mcap_records import MAGIC, MAX_DECLARED, records
from aftdeck.recording.reader import MAX_MESSAGE, MAX_TEXTS, MAX_WITHOUT_STEP, Recording
from aftdeck.recording.records import Opening
from aftdeck.recording.run import record as record_run
from aftdeck.simulation.inputs import Inputs

SECONDS, MEGABYTES = 4.0, 300.0
"""Limits of the processor time and of the memory of a process that reads a file.

The requirement is 2 s on an idle machine; twice this time allows for a slow one.
"""
_READ = """
import json, re, sys, time
from pathlib import Path
from aftdeck.errors import AftdeckError
from aftdeck.recording.bundle import scenario_of
from aftdeck.recording.reader import Recording
for path in sys.argv[1:]:
    began, error = time.process_time(), ""
    try:
        recording = Recording(path)
        for _ in recording.messages():
            pass
        scenario_of(recording.opening)
    except AftdeckError as caught:
        error = str(caught)
    seconds = time.process_time() - began
    megabytes = int(re.search(r"VmHWM:\\s+(\\d+) kB", Path("/proc/self/status").read_text())[1]) / 1024
    print(json.dumps([seconds, megabytes, error]))
"""


class Read(NamedTuple):
    seconds: float
    megabytes: float
    error: str


def read(paths: list[Path]) -> list[Read]:
    """Read files one after the other in a process of its own."""
    done = subprocess.run(
        [sys.executable, "-c", _READ, *map(str, paths)], capture_output=True, text=True, check=True, timeout=300
    )
    return [Read(*json.loads(line)) for line in done.stdout.splitlines()]


def prefixed(text: bytes) -> bytes:
    return struct.pack("<I", len(text)) + text


def record(kind: int, content: bytes) -> bytes:
    return struct.pack("<BQ", kind, len(content)) + content


def chunk(packed: bytes, size: int, crc: int, compression: bytes = b"zstd") -> bytes:
    head = struct.pack("<QQQI", 0, 0, size, crc) + prefixed(compression) + struct.pack("<Q", len(packed))
    return record(6, head + packed)


def packed(data: bytes, level: int = 19) -> bytes:
    return zstandard.ZstdCompressor(level=level).compress(data)


def whole_chunk(data: bytes) -> bytes:
    """Return a valid chunk, with so much noise that no limit of the compression applies."""
    noise = message(random.Random(1).randbytes(len(data) // MAX_RATIO + 1), 65535)
    data = declared("/noise", 65535) + noise + data
    return chunk(packed(data, 3), len(data), zlib.crc32(data))


def declared(topic: str, number: int = 1) -> bytes:
    channel = struct.pack("<HH", number, number) + prefixed(topic.encode()) + prefixed(b"json") + struct.pack("<I", 0)
    return record(3, struct.pack("<H", number) + prefixed(b"s") + prefixed(b"jsonschema") + prefixed(b"{}")) + record(
        4, channel
    )


def message(data: bytes, number: int = 1) -> bytes:
    return record(5, struct.pack("<HIQQ", number, 0, 0, 0) + data)


def file(*records: bytes) -> bytes:
    return MAGIC + record(1, prefixed(b"aftdeck") + prefixed(b"")) + b"".join(records)


def header(**changes: object) -> bytes:
    """Return the start of a file: the chunk with the header."""
    return first(encode(msgspec.structs.replace(_opening(), **changes)))


def first(data: bytes) -> bytes:
    """Return the chunk with a header as JSON."""
    content = declared("/opening") + message(data)
    return chunk(content, len(content), 0, b"")


@functools.cache
def _opening() -> Opening:
    return opening(aftdeck.load_scenario("first-flight"), 0, 0)


GIB = 2**30


@functools.cache
def _zeros(size: int) -> bytes:
    """Return the compressed form of zeros, made without the zeros."""
    compressor = zstandard.ZstdCompressor(level=1).compressobj()
    block = bytes(2**22)
    return b"".join(compressor.compress(block) for _ in range(size // len(block))) + compressor.flush()


@functools.cache
def _lz4_zeros(size: int) -> bytes:
    """Return zeros, compressed with lz4, made without the zeros."""
    compressor, block = lz4.frame.LZ4FrameCompressor(), bytes(2**22)
    parts = [compressor.begin(), *(compressor.compress(block) for _ in range(size // len(block))), compressor.flush()]
    return b"".join(parts)


def _lz4(data: bytes) -> bytes:
    """Return a valid chunk, compressed with lz4."""
    return chunk(lz4.frame.compress(data), len(data), zlib.crc32(data), b"lz4")


def _frames(data: bytes) -> bytes:
    return whole_chunk(declared("/frames", 2) + message(data, 2))


SMALL_ONES = declared("/tf", 2) + message(b"", 2) * 400_000
"""Small messages, as they are in a chunk and as they stand alone."""


def _many_small() -> bytes:
    return whole_chunk(SMALL_ONES)


def _steps_between_small_ones() -> bytes:
    """Return valid steps, each after as many small messages as are allowed, in chunks without an index."""
    sim = aftdeck.Simulation(aftdeck.load_scenario("first-flight"))
    small = message(b"", 2) * (MAX_WITHOUT_STEP - 10)
    chunks = [whole_chunk(declared("/tf", 2) + declared("/inputs", 3) + declared("/frames", 4))]
    for tick in range(1, 40):
        step = encode(input_record(tick, None)), encode(frame_record(sim.step(), 0.0, None))
        chunks.append(whole_chunk(small + message(step[0], 3) + message(step[1], 4)))
    return b"".join(chunks)


BOMBS: dict[str, Callable[[], bytes]] = {
    "stated size is believed": lambda: file(chunk(_zeros(GIB), GIB, 0)),
    "stated size is small": lambda: file(chunk(_zeros(GIB), 1000, 0)),
    "stated size is the limit": lambda: file(chunk(_zeros(2**26), 2**26, 0)),
    "many chunks at the limit": lambda: file(header(), *[chunk(_zeros(2**22), 2**22, 0)] * 100),
    "many chunks of one channel": lambda: file(header(), *[_many_small()] * 20),
    "stated record is long": lambda: file() + struct.pack("<BQ", 6, 2**62) + bytes(1000),
    "lz4: stated size is believed": lambda: file(chunk(_lz4_zeros(GIB), GIB, 0, b"lz4")),
    "lz4: stated size is small": lambda: file(chunk(_lz4_zeros(GIB), 1000, 0, b"lz4")),
    "lz4: stated size is the limit": lambda: file(chunk(_lz4_zeros(2**26), 2**26, 0, b"lz4")),
    "lz4: many chunks at the limit": lambda: file(header(), *[chunk(_lz4_zeros(2**22), 2**22, 0, b"lz4")] * 100),
    "lz4: small messages": lambda: file(header(), *[_lz4(SMALL_ONES)] * 20),
    "alone: small messages": lambda: file(header(), SMALL_ONES),
    "alone: many channels": lambda: file(header(), *(declared(f"/t{i}", 2 + i) for i in range(60_000))),
    "alone: one channel declared again": lambda: file(header(), declared("/tf", 2) * 300_000),
    "alone: stated message is long": lambda: file() + struct.pack("<BQ", 5, 2**62) + bytes(1000),
    "alone: long message": lambda: file(header(), declared("/frames", 2), message(b"[" + b"[]," * 1_500_000, 2)),
    "no header, many small messages": lambda: file(*[_many_small()] * 20),
    "small messages between steps": lambda: file(header(), _steps_between_small_ones(), b"\x99" + bytes(8)),
    "small messages": lambda: file(header(), _many_small()),
    "many channels": lambda: file(header(), whole_chunk(b"".join(declared(f"/t{i}", 2 + i) for i in range(60_000)))),
    "one channel declared again": lambda: file(header(), whole_chunk(declared("/tf", 2) * 300_000)),
    "long message": lambda: file(header(), _frames(b"[" + b"[]," * 1_500_000 + b"[]]")),
    "header of empty lists": lambda: file(first(b'{"format":2,"x":[' + b"[]," * 4_000_000 + b"[]]}")),
    "header of empty joints": lambda: file(
        first(encode(_opening()).replace(b'"joints":[', b'"joints":[' + b'"",' * 4_000_000))
    ),
    "deep message": lambda: file(header(), _frames(b"[" * 500_000)),
    "deep header": lambda: file(first(b'{"format":2,"x":' + b"[" * 500_000)),
    "long number": lambda: file(header(), _frames(b'{"tick":' + b"1" * 500_000 + b"}")),
    "long seed": lambda: file(first(encode(_opening()).replace(b'"seed":0', b'"seed":' + b"9" * 300))),
    "TOML of a long key": lambda: file(header(scenario_text="a." * 200_000 + "a = 1")),
    "TOML of a long quoted key": lambda: file(header(arm_text='"a" . ' * 100_000 + "a = 1")),
    "TOML of deep lists": lambda: file(header(arm_text="a = " + "[" * 100_000)),
    "TOML of many tables": lambda: file(header(scenario_text="[[phase]]\n" * 4_900)),
    "TOML of a list": lambda: file(header(scenario_text="seed = [" + "1," * 59_000 + "]")),
    "TOML of a long list": lambda: file(header(scenario_text="seed = [" + "1," * 490_000 + "]")),
    "TOML of many keys": lambda: file(header(scenario_text="".join(f"a{i} = 1\n" for i in range(59_000)))),
    "TOML that is too long": lambda: file(header(worksite_text="# \n" * 3_000_000)),
    "TOML of a long number": lambda: file(header(scenario_text="seed = " + "9" * 1_000_000)),
}


@pytest.mark.slow
@pytest.mark.skipif(not Path("/proc/self/status").exists(), reason="the test reads its memory in Linux's /proc")
def test_bombs_are_rejected_quickly_and_in_little_memory(tmp_path: Path) -> None:
    paths = [tmp_path / f"{name}.mcap" for name in BOMBS]
    for path, bomb in zip(paths, BOMBS.values(), strict=True):
        path.write_bytes(bomb())
    for name, found in zip(BOMBS, read(paths), strict=True):
        assert found.error and len(found.error) < 100_000, name
        assert found.seconds < SECONDS and found.megabytes < MEGABYTES, name


def test_check_of_an_index_forgets_the_messages_of_earlier_chunks() -> None:
    check = IndexCheck()
    tracemalloc.start()
    for number in range(40):
        check.add_chunk(number, 1)
        for at in range(1000):
            check.add(Message(1, at, b"", at, 0), at)
    kept, _ = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert kept < 500_000


@pytest.mark.parametrize("beyond", [0, 1])
def test_a_file_may_have_as_many_schemas_and_channels_as_the_limit_says(tmp_path: Path, beyond: int) -> None:
    path = tmp_path / "declared.mcap"
    more = b"".join(declared(f"/t{number}", number) for number in range(1, MAX_DECLARED // 2)) + declared("/t", 60_000)
    schema = record(3, struct.pack("<H", 60_001) + prefixed(b"s") + prefixed(b"jsonschema") + prefixed(b"{}"))
    path.write_bytes(file(*(chunk(data, len(data), 0, b"") for data in (more, schema * beyond))))
    with path.open("rb") as opened:
        found: list[object] = []
        try:
            found.extend(records(opened))
        except DamageError:
            assert beyond
        else:
            assert not beyond
        assert len(found) == 1 + MAX_DECLARED  # the file's header first


@pytest.mark.parametrize("compression", ["", "zstd", "lz4"])
def test_a_chunk_that_is_too_large_to_be_read_is_no_damage(tmp_path: Path, compression: str) -> None:
    noise = random.Random(1).randbytes(2**20)
    content = noise + bytes(MAX_UNPACKED + 1 - len(noise))
    packed = {"": bytes, "zstd": zstandard.compress, "lz4": lz4.frame.compress}[compression](content)
    path = tmp_path / "large.mcap"
    path.write_bytes(file(chunk(packed, len(content), 0, compression.encode())))
    with pytest.raises(RecordingError) as caught:
        list(Recording(path).entries())
    assert caught.value.fault == "rewritten"


def test_limits_leave_room_for_a_run_of_a_resting_arm(tmp_path: Path) -> None:
    path, steps = tmp_path / "rest.mcap", 1500
    record_run(
        "concept-1972", path, inputs=lambda sim: Inputs() if sim.frame is None or sim.frame.tick < steps else None
    )
    data, at = path.read_bytes(), len(MAGIC)
    ratios = []
    while at + 9 <= len(data):
        kind, length = struct.unpack_from("<BQ", data, at)
        if kind == 6:
            (size,) = struct.unpack_from("<Q", data, at + 25)
            (compressed,) = struct.unpack_from("<Q", data, at + 9 + 32 + 4)
            ratios.append((size - SMALL) / compressed)
            assert size < MAX_UNPACKED / 10
        at += 9 + length
    assert 10 < max(ratios) < MAX_RATIO / 4
    for entry in Recording(path).entries():
        assert len(entry.data) < (MAX_TEXTS if entry.channel.topic in ("/opening", "/closing") else MAX_MESSAGE) / 4
