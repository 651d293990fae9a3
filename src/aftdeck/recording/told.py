"""What every type of message is made of: the base, and what is told of a field."""

from __future__ import annotations

import msgspec

Numbers = tuple[float, ...]


def told(what: str, unit: str = "", frame: str = "") -> msgspec.Meta:
    """What a field is, with its unit and frame, for the schema and the documentation."""
    return msgspec.Meta(description=what, extra={"unit": unit, "frame": frame})


class Message(msgspec.Struct, frozen=True):
    """Base of what the channels carry."""
