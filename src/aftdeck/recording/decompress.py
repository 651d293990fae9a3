"""Decompression of the chunks of an MCAP file, within limits.

A file may come from a stranger. A chunk is therefore decompressed only up to the size that it states, and this size is
limited, also in proportion to the compressed bytes.
"""

from __future__ import annotations

import lz4.frame
import zstandard
from mcap.records import Chunk

from aftdeck.recording.damage import DamageError, SizeError

MAX_UNPACKED = 2**26
"""Longest record, and longest chunk after decompression [bytes].

The writer closes a chunk at one megabyte. Only the first chunk may be longer, because the header contains four files of
at most `files.MOST_BYTES` each.
"""
MAX_RATIO, SMALL = 500, 2**16
"""Greatest ratio of a chunk's length to its compressed length; a chunk may always have `SMALL` bytes.

A chunk of the writer has at most about 70 times its compressed length, if the arm rests (measured with every arm).
"""
MAX_WINDOW = 2**26
"""Greatest memory that a decompressor may use for its window [bytes]; the writer's level of compression uses 2**19."""


def decompressed(chunk: Chunk) -> bytes:
    """Return the content of a chunk, which may be compressed as the MCAP specification lists: with zstd, lz4 or not.

    Raises:
        SizeError: the chunk is too large.
        DamageError: the content is not as long as the chunk states or exceeds a limit, or cannot be decompressed.
    """
    stated, packed = chunk.uncompressed_size, len(chunk.data)
    most = min(MAX_UNPACKED, MAX_RATIO * packed + SMALL)
    if MAX_UNPACKED < stated <= MAX_RATIO * packed + SMALL:
        raise SizeError(f"a chunk has {stated} bytes")
    if stated > most:
        raise DamageError(f"a chunk of {packed} bytes states {stated} uncompressed bytes; at most {most} are allowed")
    try:
        data = _up_to(stated + 1, chunk)
    except (zstandard.ZstdError, RuntimeError) as error:  # lz4 raises RuntimeError
        raise DamageError(str(error)) from None
    if len(data) != stated:
        raise DamageError(
            f"a chunk states {stated} uncompressed bytes but has {'more' if len(data) > stated else 'fewer'}"
        )
    return data


def _up_to(most: int, chunk: Chunk) -> bytes:
    """Return the first `most` bytes of a chunk's content."""
    match chunk.compression:
        case "":
            return chunk.data
        case "zstd":
            with zstandard.ZstdDecompressor(max_window_size=MAX_WINDOW).stream_reader(chunk.data) as stream:
                return stream.read(most)
        case "lz4":
            return bytes(lz4.frame.LZ4FrameDecompressor().decompress(chunk.data, max_length=most))
        case _:
            raise DamageError(f"a chunk must be compressed with 'zstd', 'lz4' or not, got {chunk.compression!r}")
