"""Hash chain over the messages of a recording: whether a file still has the messages that its writer wrote.

The chain is a SHA-256 over the declaration of each channel and over topic, times and bytes of each message, in the
order of the file. Its head is in the footer. A changed, missing, additional or moved message gives another head. The
chain is no signature: a person who rewrites a whole file can also compute a new head.
"""

from __future__ import annotations

import hashlib
import struct
from typing import NamedTuple

_LENGTHS = struct.Struct("<QQQ")


class Declared(NamedTuple):
    """Declaration of a channel: everything that tells a reader how to decode its messages."""

    topic: str
    encoding: str
    """Encoding of the messages: ``json`` or ``protobuf``."""
    schema: str
    """Name of the schema."""
    schema_encoding: str
    schema_data: bytes
    metadata: str = ""
    """JSON of the channel's metadata; empty without metadata, as in every recording of Aftdeck."""


class Chain:
    """Hash chain of one file, to which messages are added in their order."""

    def __init__(self) -> None:
        self._hash = hashlib.sha256()
        self._topics: dict[Declared, bytes] = {}

    def add(self, channel: Declared, log_time: int, publish_time: int, data: bytes) -> None:
        """Add a message; its channel is added with the channel's first message.

        Args:
            channel: the channel of the message.
            log_time: log time of the message since 1970 [ns].
            publish_time: publish time of the message since 1970 [ns].
            data: content of the message.
        """
        topic = self._topics.get(channel)
        if topic is None:
            texts = [part.encode() if isinstance(part, str) else part for part in channel]
            self._hash.update(b"".join(struct.pack("<Q", len(text)) + text for text in texts))
            topic = self._topics[channel] = struct.pack("<Q", len(texts[0])) + texts[0]
        self._hash.update(topic + _LENGTHS.pack(log_time, publish_time, len(data)))
        self._hash.update(data)

    def head(self) -> str:
        """Return the head: the SHA-256 over everything that was added, as hexadecimal digits."""
        return self._hash.hexdigest()


def without_head(footer: bytes, head: str) -> bytes:
    """Return a footer as it is added to the chain: the footer contains the head, which the chain does not."""
    return footer.replace(f'"{head}"'.encode(), b'""', 1) if head else footer
