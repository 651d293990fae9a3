"""A run as it is flown, for Foxglove or another viewer of its protocol to attach to."""

from __future__ import annotations

from queue import SimpleQueue

import foxglove
from foxglove.websocket import ChannelView, Client, ServerListener

from aftdeck.errors import RecordingError
from aftdeck.recording.channels import Channels


class Live:
    """A server that lends its channels to one recorder after another.

    What is told only once, at a run's beginning, a viewer that comes later asks for by subscribing to it.

    Attributes:
        channels: what viewers see, the same ones run after run: a viewer may be told of a channel that comes later
            before the server knows it, and then never gets it.
        address: for a viewer to open: ``ws://127.0.0.1:8765``.
    """

    def __init__(self, port: int, host: str = "127.0.0.1") -> None:
        """Begin to serve.

        Args:
            port: 0 for any that is free.
            host: address of this machine to listen at.

        Raises:
            RecordingError: the port is in use or cannot be had.
        """
        self.channels = Channels()
        self._listener = _Listener()
        try:
            self._server = foxglove.start_server(
                name="Aftdeck", host=host, port=port, context=self.channels.context, server_listener=self._listener
            )
        except (RuntimeError, OverflowError) as error:
            why = str(error).removeprefix("FoxgloveError: ")
            raise RecordingError(f"viewers cannot attach at {host}:{port}: {why}; give another port") from None
        self.address = f"ws://{host}:{self._server.port}"

    def asked(self) -> list[str]:
        """Topics that viewers have subscribed to since the last call; costs nothing where there are none."""
        topics = []
        while not self._listener.topics.empty():
            topics.append(self._listener.topics.get())
        return list(dict.fromkeys(topics))

    def close(self) -> None:
        """Stop serving."""
        self._server.stop()


class _Listener(ServerListener):
    """Keeps the topics that viewers subscribe to."""

    def __init__(self) -> None:
        self.topics: SimpleQueue[str] = SimpleQueue()

    def on_subscribe(self, client: Client, channel: ChannelView) -> None:
        """A viewer wants a topic; called on the server's thread."""
        del client
        self.topics.put(channel.topic)
