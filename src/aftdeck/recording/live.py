"""Server to which Foxglove, or another viewer of its protocol, can attach during a run."""

from __future__ import annotations

from queue import SimpleQueue

import foxglove
from foxglove.websocket import ChannelView, Client, ServerListener

from aftdeck.errors import RecordingError
from aftdeck.recording.channels import Channels


class Live:
    """Server for viewers; the recorders of successive runs use its channels.

    Some topics are sent only at the start of a run. A viewer that attaches later receives them when it subscribes.

    Attributes:
        channels: channels for viewers, for all runs. With new channels for each run, messages would be lost, because
            a viewer may subscribe to a channel before the server has registered the channel.
        address: address for viewers, such as ``ws://127.0.0.1:8765``.
    """

    def __init__(self, port: int, host: str = "127.0.0.1") -> None:
        """Start the server.

        Args:
            port: port to listen on; 0 selects a free port.
            host: address of this machine to listen on.

        Raises:
            RecordingError: the port is in use or not available.
        """
        self.channels = Channels()
        self._listener = _Listener()
        try:
            self._server = foxglove.start_server(
                name="Aftdeck", host=host, port=port, context=self.channels.context, server_listener=self._listener
            )
        except (RuntimeError, OverflowError) as error:
            why = str(error).removeprefix("FoxgloveError: ")
            raise RecordingError(f"cannot listen for viewers on {host}:{port}: {why}; choose another port") from None
        self.address = f"ws://{host}:{self._server.port}"

    def requested_topics(self) -> list[str]:
        """Return the topics to which viewers have subscribed since the last call."""
        topics = []
        while not self._listener.topics.empty():
            topics.append(self._listener.topics.get())
        return list(dict.fromkeys(topics))

    def close(self) -> None:
        """Stop serving."""
        self._server.stop()


class _Listener(ServerListener):
    """Collector of the topics to which viewers subscribe."""

    def __init__(self) -> None:
        self.topics: SimpleQueue[str] = SimpleQueue()

    def on_subscribe(self, client: Client, channel: ChannelView) -> None:
        """Store a topic to which a viewer subscribes; the server's thread calls this method."""
        del client
        self.topics.put(channel.topic)
