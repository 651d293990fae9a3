"""Channels with Aftdeck's own schemas, as a recording declares them."""

from __future__ import annotations

import json
from collections.abc import Callable

from aftdeck.recording.chain import Declared
from aftdeck.recording.records import CHANNELS
from aftdeck.recording.schema import schema

Log = Callable[[str, bytes, int], None]
"""Function that writes a message: topic, content, and time since 1970 [ns]."""


def _own(topic: str, kind: type) -> Declared:
    own = schema(kind)
    return Declared(topic, "json", own["title"], "jsonschema", json.dumps(own).encode())


OWN: dict[str, Declared] = {topic: _own(topic, kind) for topic, (kind, _) in CHANNELS.items()}
"""Declaration of each channel with a schema of Aftdeck; every recording has them."""
