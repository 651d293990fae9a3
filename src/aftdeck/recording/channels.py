"""Channels of a recording, in a context of foxglove-sdk: channels with Aftdeck's and with Foxglove's schemas."""

from __future__ import annotations

import foxglove
from foxglove import channels

from aftdeck.recording.codec import encode
from aftdeck.recording.message import Message
from aftdeck.recording.records import CHANNELS
from aftdeck.recording.schema import schema

FIXED, SCENE = "/tf_static", "/scene"
"""Topics that are sent at the start of a run, and again when a viewer subscribes later."""


class Channels:
    """All channels of a context; a server for viewers uses the same channels for several runs.

    Attributes:
        context: context of the channels.
        tf: transforms of moving coordinate frames.
        tf_static: transforms that do not change.
        scene: shapes and colours of the bodies.
        measured: measured joint angles and rates.
        commanded: commanded joint angles and rates.
        tip: pose of the tip in L.
        lines: events, as lines of the log.
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
        """Write a message of one of Aftdeck's own channels; `time_ns` is the time since 1970 [ns]."""
        self._own[topic].log(encode(message), log_time=time_ns)
