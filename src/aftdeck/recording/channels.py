"""Channels of a recording, in a context of foxglove-sdk: channels with Aftdeck's and with Foxglove's schemas."""

from __future__ import annotations

from typing import Any

import foxglove
from foxglove import messages as fox

from aftdeck.recording.chain import Declared
from aftdeck.recording.declared import OWN

MOVING, FIXED, SCENE = "/tf", "/tf_static", "/scene"
"""Topics of the transforms that change, of those that do not, and of the shapes and colours of the bodies.

The last two are sent at the start of a run, and again when a viewer subscribes later.
"""
MEASURED, COMMANDED, TIP, LINES = "/joints", "/joints/commanded", "/tip", "/log"
"""Topics of the joint angles and rates, of the tip's pose in L, and of the events, as lines of the log."""


def _foxgloves(topic: str, kind: Any) -> Declared:
    theirs = kind.get_schema()
    return Declared(topic, "protobuf", theirs.name, theirs.encoding, theirs.data)


VIEWED: dict[str, Any] = {
    MOVING: fox.FrameTransforms,
    FIXED: fox.FrameTransforms,
    SCENE: fox.SceneUpdate,
    MEASURED: fox.JointStates,
    COMMANDED: fox.JointStates,
    TIP: fox.PoseInFrame,
    LINES: fox.Log,
}
"""Channels with Foxglove's schemas, each with the type of its messages."""
DECLARED: dict[str, Declared] = {
    **OWN,
    **{topic: _foxgloves(topic, kind) for topic, kind in VIEWED.items()},
}
"""Declaration of each channel."""


class Channels:
    """All channels of a context; a server for viewers uses the same channels for several runs.

    Attributes:
        context: context of the channels.
    """

    def __init__(self) -> None:
        self.context = foxglove.Context()
        self._channels = {
            topic: foxglove.Channel(
                topic,
                schema=foxglove.Schema(name=own.schema, encoding=own.schema_encoding, data=own.schema_data),
                message_encoding=own.encoding,
                context=self.context,
            )
            for topic, own in DECLARED.items()
        }

    def log(self, topic: str, data: bytes, time_ns: int) -> None:
        """Write a message; `time_ns` is the time since 1970 [ns]."""
        self._channels[topic].log(data, log_time=time_ns)
