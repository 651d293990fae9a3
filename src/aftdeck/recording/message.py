"""Base class of all messages of a recording."""

from __future__ import annotations

import msgspec

Numbers = tuple[float, ...]


class Message(msgspec.Struct, frozen=True):
    """Base class of the messages that the channels carry."""
