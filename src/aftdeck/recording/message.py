"""What every type of message is made of."""

from __future__ import annotations

import msgspec

Numbers = tuple[float, ...]


class Message(msgspec.Struct, frozen=True):
    """Base of what the channels carry."""
