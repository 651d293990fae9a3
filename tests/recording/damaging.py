"""Damage to recordings: cut files and flipped bits give the unchanged messages before an error."""

from __future__ import annotations

import random
from pathlib import Path

from aftdeck.recording.message import Message
from tests.recording.flown import chunks, messages, read_until_error


def check_prefix(found: list[Message], all_of_it: list[Message]) -> None:
    assert found == all_of_it[: len(found)]


def flips(data: bytes, count: int, seed: int) -> list[int]:
    """Return numbers of bits to flip: one half anywhere, the other half at the beginnings of records."""
    rng = random.Random(seed)
    starts = [at + d for at, _, _ in chunks(data) for d in range(60) if at + d < len(data)]
    return [8 * rng.randrange(len(data)) + rng.randrange(8) for _ in range(count // 2)] + [
        8 * rng.choice(starts) + rng.randrange(8) for _ in range(count - count // 2)
    ]


def check_flips(source: Path, path: Path, bits: list[int]) -> None:
    data, everything = source.read_bytes(), messages(source)
    wrong = 0
    for bit in bits:
        path.write_bytes(flipped(data, bit))
        found, error = read_until_error(path)
        check_prefix(found, everything)
        if error:
            wrong += 1
            text = str(error)
            assert text.startswith(f"{path}: ") and "\n" not in text and len(text) < 400
        else:
            assert found == everything, f"bit {bit} removes messages without an error"
    assert wrong > len(bits) / 2


def flipped(data: bytes, bit: int) -> bytes:
    """Return a file with one bit flipped."""
    changed = bytearray(data)
    changed[bit // 8] ^= 1 << bit % 8
    return bytes(changed)
