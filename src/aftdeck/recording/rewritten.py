"""Error for a valid MCAP file in which another program left out, moved or added messages of a recording."""

from __future__ import annotations

from itertools import islice
from pathlib import Path

from mcap.records import Channel, DataEnd, Message

from aftdeck.errors import RecordingError
from aftdeck.recording.damage import DamageError
from aftdeck.recording.mcap_records import records

NEEDED = ("/opening", "/inputs", "/frames")
"""Channels without which a run cannot be simulated again."""
LEAST_BYTES = 16
"""Least length of a file for each of its records [bytes]; a recording has about 200.

A file that has more records is not read to its end, because that could take long.
"""


def rewritten(path: Path, why: str) -> RecordingError | None:
    """Return the error for a file that has other messages than a recorder writes, or in another order.

    Args:
        path: the file.
        why: the message that is missing or not in order.

    Returns:
        The error; None if the file is itself damaged or cut short, which is then the cause.
    """
    topics = _topics(path)
    if topics is None:
        return None
    missing = [topic for topic in NEEDED if topic not in topics]
    if missing:
        what, whole = f"left out {' and '.join(missing)}", "that has all channels"
    else:
        what, whole = f"left out, moved or added messages ({why})", "that has all messages in their order"
    return RecordingError(f"{path}: is a valid MCAP file, but another program {what}; use a copy {whole}", "rewritten")


def _topics(path: Path) -> set[str] | None:
    """Return the topics that have messages; None if the file is damaged or cut short."""
    names: dict[int, str] = {}
    topics: set[str] = set()
    try:
        with path.open("rb") as file:
            for record in islice(records(file), path.stat().st_size // LEAST_BYTES):
                if isinstance(record, Channel):
                    names[record.id] = record.topic
                elif isinstance(record, Message):
                    topics.add(names.get(record.channel_id, ""))
                elif isinstance(record, DataEnd):
                    return topics
    except (DamageError, OSError):
        pass
    return None
