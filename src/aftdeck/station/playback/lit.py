"""A recorded frame in its light, as a process that reads a recording hands it on."""

from __future__ import annotations

import msgspec

from aftdeck.recording.records import FrameRecord


class Lit(msgspec.Struct, frozen=True):
    """Recorded frame, and the name of the light condition in it."""

    frame: FrameRecord
    condition: str


def decoded(packed: bytes) -> Lit:
    """Return a frame that `encoded` has packed."""
    return msgspec.msgpack.decode(packed, type=Lit)


def encoded(lit: Lit) -> bytes:
    """Return a frame as msgpack."""
    return msgspec.msgpack.encode(lit)
