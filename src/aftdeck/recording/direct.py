"""Recorder that writes at once, into any sink of bytes: without thread, clock, disk or foxglove-sdk.

Its file has only the channels with Aftdeck's schemas, which contain the whole run. `writer.Recorder` also writes those
for viewers.
"""

from __future__ import annotations

from typing import IO

import msgspec
from mcap.writer import CompressionType, Writer

from aftdeck.recording.content import Content, Ended, Entry
from aftdeck.recording.declared import OWN
from aftdeck.recording.records import PROFILE, Opening
from aftdeck.simulation.summary import Summary
from aftdeck.version import __version__

CHUNK = 2**18
"""Size from which a chunk is closed [bytes]: about a second of a run with 50 steps a second."""


class DirectRecorder:
    """Recorder of one run.

    Attributes:
        content: the messages of the run.
    """

    def __init__(self, sink: IO[bytes], start: Opening, began_ns: int) -> None:
        """Begin the recording.

        Args:
            sink: receives the bytes of the file; it is not closed.
            start: header of the recording.
            began_ns: wall time at which the run begins, since 1970 [ns].
        """
        self._file = Writer(sink, chunk_size=CHUNK, compression=CompressionType.ZSTD, enable_data_crcs=True)
        self._file.start(profile=PROFILE, library=f"aftdeck {__version__}")
        self._channels: dict[str, int] = {}
        self.content = Content(self._write, OWN, msgspec.structs.replace(start, viewed=False), began_ns)

    def put(self, entry: Entry) -> None:
        """Record an entry."""
        self.content.add(entry)

    def finish(self, ended: Ended, summary: Summary | None = None) -> None:
        """End the run, and write the end of the file."""
        self.content.close(ended, summary)
        self._file.finish()  # type: ignore[no-untyped-call]

    def _write(self, topic: str, data: bytes, time_ns: int) -> None:
        channel = self._channels.get(topic)
        if channel is None:
            own = OWN[topic]
            schema = self._file.register_schema(own.schema, own.schema_encoding, own.schema_data)
            channel = self._channels[topic] = self._file.register_channel(topic, own.encoding, schema)
        self._file.add_message(channel, log_time=time_ns, data=data, publish_time=time_ns)
