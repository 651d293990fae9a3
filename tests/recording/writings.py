"""Copies of a recording, as other programs write them: two libraries with their settings."""

from __future__ import annotations

import itertools
import random
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

import foxglove
from foxglove.mcap import MCAPCompression, MCAPWriteOptions
from mcap.writer import CompressionType, IndexType, Writer

from aftdeck.recording.decompress import MAX_UNPACKED
from tests.recording.flown import raw_messages

SETTINGS: dict[str, tuple[Any, ...]] = {
    "compression": tuple(CompressionType),
    "use_chunking": (True, False),
    "chunk_size": (1, 5_000, 2**20, 2**30),
    "enable_crcs": (True, False),
    "enable_data_crcs": (True, False),
    "index_types": (
        IndexType.ALL,
        IndexType.NONE,
        IndexType.CHUNK,
        IndexType.MESSAGE,
        IndexType.CHUNK | IndexType.MESSAGE,
    ),
    "repeat_channels": (True, False),
    "repeat_schemas": (True, False),
    "use_statistics": (True, False),
    "use_summary_offsets": (True, False),
}
"""Settings of the library `mcap`, each with its values; the first value is the library's default or common."""
SDKS: dict[str, dict[str, Any]] = {
    "lz4": {"compression": MCAPCompression.Lz4},
    "zstd, level 19": {"compression": MCAPCompression.Zstd, "compression_level": 19, "chunk_size": None},
    "not compressed": {"compression": None},
    "no chunks": {"use_chunks": False},
    "no chunks, no CRC": {"use_chunks": False, "calculate_data_section_crc": False},
    "no CRCs": {
        "calculate_chunk_crcs": False,
        "calculate_data_section_crc": False,
        "calculate_summary_section_crc": False,
    },
    "no indexes": {"emit_message_indexes": False, "emit_chunk_indexes": False},
    "no index of messages": {"emit_message_indexes": False},
    "no summary": {
        "emit_statistics": False,
        "emit_summary_offsets": False,
        "emit_chunk_indexes": False,
        "repeat_channels": False,
        "repeat_schemas": False,
    },
    "not seekable": {"disable_seeking": True},
}
"""Settings of the library `foxglove-sdk`."""


def each_setting() -> Iterable[dict[str, Any]]:
    """Yield settings of the library `mcap`: each value of each setting, in chunks and without chunks."""
    yield {}
    for name, values in SETTINGS.items():
        for value, chunked in itertools.product(values[1:], (True, False)):
            yield {"use_chunking": chunked, name: value}


def random_settings(seed: int) -> dict[str, Any]:
    """Return a random combination of settings of the library `mcap`."""
    rng = random.Random(seed)
    return {name: rng.choice(values) for name, values in SETTINGS.items()}


def written(
    source: Path,
    out: Path,
    settings: dict[str, Any],
    profile: str = "aftdeck",
    extras: bool = False,
    halfway: Callable[[Writer], None] = lambda _: None,
) -> Path:
    """Copy a recording with the library `mcap`; with `extras`, add a long attachment and metadata to it.

    `halfway` changes the writer after half of the messages, as no writer does.
    """
    with out.open("wb") as file:
        writer = Writer(file, **settings)
        writer.start(profile, "another program")
        channels: dict[str, int] = {}
        found = list(raw_messages(source))
        for number, (channel, time_ns, data) in enumerate(found):
            if number == len(found) // 2:
                halfway(writer)
            if channel.topic not in channels:
                schema = writer.register_schema(channel.schema, channel.schema_encoding, channel.schema_data)
                channels[channel.topic] = writer.register_channel(channel.topic, channel.encoding, schema)
            writer.add_message(channels[channel.topic], time_ns, data, time_ns, number)
            if extras and number == 10:
                writer.add_attachment(time_ns, time_ns, "photo.tiff", "image/tiff", bytes(MAX_UNPACKED + 1))
                writer.add_metadata("study", {"place": "Houston", "operator": ""})
        finish: Callable[[], None] = writer.finish  # the library has no types
        finish()
    return out


def written_by_sdk(source: Path, out: Path, settings: dict[str, Any]) -> Path:
    """Copy a recording with the library `foxglove-sdk`."""
    context = foxglove.Context()
    channels: dict[str, foxglove.Channel] = {}
    options = MCAPWriteOptions(profile="aftdeck", compression_threads=0, **settings)
    with foxglove.open_mcap(out, context=context, writer_options=options):
        for channel, time_ns, data in raw_messages(source):
            if channel.topic not in channels:
                schema = foxglove.Schema(
                    name=channel.schema, encoding=channel.schema_encoding, data=channel.schema_data
                )
                channels[channel.topic] = foxglove.Channel(
                    channel.topic, schema=schema, message_encoding=channel.encoding, context=context
                )
            channels[channel.topic].log(data, log_time=time_ns)
    return out
