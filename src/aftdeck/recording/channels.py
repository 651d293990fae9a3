"""The channels of a recording in a context of foxglove-sdk: our own, and those of Foxglove's known schemas."""

from __future__ import annotations

import foxglove
from foxglove import channels

from aftdeck.recording.codec import encode
from aftdeck.recording.message import Message
from aftdeck.recording.records import CHANNELS
from aftdeck.recording.schema import schema

FIXED, SCENE = "/tf_static", "/scene"
"""What tells all at once and then is silent."""


class Channels:
    """All channels of a context; they outlive a run where viewers are attached to them.

    Attributes:
        context: what they belong to.
        tf: transforms between what moves.
        tf_static: those that stay.
        scene: how the bodies look.
        measured: joint angles and rates.
        commanded: the same as commanded.
        tip: the tip's pose.
        lines: the log.
    """

    def __init__(self) -> None:
        self.context = foxglove.Context()
        self._own = {
            topic: foxglove.Channel(topic, schema=schema(kind), message_encoding="json", context=self.context)
            for topic, (kind, _) in CHANNELS.items()
        }
        self.tf = channels.FrameTransformsChannel("/tf", context=self.context)
        self.tf_static = channels.FrameTransformsChannel(FIXED, context=self.context)
        self.scene = channels.SceneUpdateChannel(SCENE, context=self.context)
        self.measured = channels.JointStatesChannel("/joints", context=self.context)
        self.commanded = channels.JointStatesChannel("/joints/commanded", context=self.context)
        self.tip = channels.PoseInFrameChannel("/tip", context=self.context)
        self.lines = channels.LogChannel("/log", context=self.context)

    def log(self, topic: str, message: Message, time_ns: int) -> None:
        """Write one of our own messages at a time since 1970 [ns]."""
        self._own[topic].log(encode(message), log_time=time_ns)
