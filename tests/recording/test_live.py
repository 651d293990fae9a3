from __future__ import annotations

import json
import struct
import threading
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from websockets.sync.client import ClientConnection, connect
from websockets.typing import Subprotocol

from aftdeck.errors import RecordingError
from aftdeck.recording.live import Live
from aftdeck.recording.writer import Recorder
from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from tests.recording.flights import fly, read

PATIENCE = 60.0
"""The longest that anything is waited for [s]."""


@pytest.fixture
def live() -> Iterator[Live]:
    server = Live(0)
    yield server
    server.close()


class Viewer:
    """A client of Foxglove's protocol that subscribes to everything."""

    def __init__(self, socket: ClientConnection) -> None:
        self._socket = socket
        self._topics: dict[int, str] = {}
        self.channels: dict[str, dict[str, Any]] = {}
        self.times: list[int] = []

    def until(self, *topics: str) -> set[str]:
        """Take messages until all topics have been heard of, since this call; returns them."""
        heard: set[str] = set()
        end = time.monotonic() + PATIENCE
        while not set(topics) <= heard:
            message = self._socket.recv(max(0.0, end - time.monotonic()))
            if isinstance(message, bytes):
                op, subscription, time_ns = struct.unpack_from("<BIQ", message)
                assert op == 1
                heard.add(self._topics[subscription])
                self.times.append(time_ns)
            else:
                self._told(json.loads(message))
        return heard

    def _told(self, message: dict[str, Any]) -> None:
        if message["op"] != "advertise":
            return
        wanted = []
        for channel in message["channels"]:
            number = len(self._topics)
            self._topics[number] = channel["topic"]
            self.channels[channel["topic"]] = channel
            wanted.append({"id": number, "channelId": channel["id"]})
        self._socket.send(json.dumps({"op": "subscribe", "subscriptions": wanted}))


class Flight:
    """A thread that flies until it is told to stop."""

    def __init__(self, live: Live, path: Path | None = None) -> None:
        self._stop = threading.Event()
        self._recorder = Recorder(path, load_scenario("first-flight"), 1, live=live)
        self._thread = threading.Thread(target=self._fly)

    def __enter__(self) -> None:
        self._thread.start()

    def __exit__(self, *_: object) -> None:
        self._stop.set()
        self._thread.join(PATIENCE)
        self._recorder.close("stopped")
        assert not self._recorder.failure

    def _fly(self) -> None:
        simulation = Simulation(load_scenario("first-flight"))
        while not self._stop.wait(0.01):
            inputs = Inputs(translation=(0.5, 0.0, 0.0))
            self._recorder.step(inputs, simulation.step(inputs))


MOVING = ("/tf", "/joints", "/tip", "/frames", "/inputs")
ONCE = ("/scene", "/tf_static")


def attached(live: Live) -> ClientConnection:
    return connect(
        live.address, subprotocols=[Subprotocol("foxglove.sdk.v1")], open_timeout=PATIENCE, close_timeout=0.1
    )


def test_a_viewer_that_comes_later_gets_the_scene_too(live: Live) -> None:
    with Flight(live), attached(live) as first, attached(live) as second:
        for socket in (first, second):
            viewer = Viewer(socket)
            assert viewer.until(*MOVING, *ONCE)
            assert viewer.times == sorted(viewer.times)
            assert viewer.channels["/tf"]["schemaName"] == "foxglove.FrameTransforms"
            assert viewer.channels["/frames"]["encoding"] == "json"


def test_a_viewer_stays_attached_over_a_restart(live: Live) -> None:
    with attached(live) as socket:
        viewer = Viewer(socket)
        for _ in range(3):
            with Flight(live):
                viewer.until(*MOVING, *ONCE)


def test_a_flight_can_be_watched_and_recorded_at_once(live: Live, tmp_path: Path) -> None:
    path = tmp_path / "watched.mcap"
    with attached(live) as socket, Flight(live, path):
        Viewer(socket).until(*MOVING, *ONCE)
    topics = read(path)
    assert set(topics) >= {*MOVING, *ONCE, "/opening", "/closing"}


def test_runs_follow_each_other_in_their_own_files(live: Live, tmp_path: Path) -> None:
    for k in range(3):
        fly("first-flight", tmp_path / f"{k}.mcap", 10 + k, live)
    for k in range(3):
        topics = read(tmp_path / f"{k}.mcap")
        assert len(topics["/frames"]) == 10 + k
        assert len(topics["/scene"]) == len(topics["/opening"]) == len(topics["/closing"]) == 1


def test_without_a_file_and_without_viewers_nothing_is_written(live: Live, tmp_path: Path) -> None:
    assert len(fly("first-flight", None, 10, live)) == 10
    assert list(tmp_path.iterdir()) == []


def test_a_port_in_use_is_told_in_a_sentence(live: Live) -> None:
    port = int(live.address.rpartition(":")[2])
    with pytest.raises(
        RecordingError, match=rf"viewers cannot attach at 127\.0\.0\.1:{port}: .*in use.*; give another"
    ):
        Live(port)


def test_a_port_that_is_none_is_told_in_a_sentence() -> None:
    with pytest.raises(RecordingError, match=r"viewers cannot attach at 127\.0\.0\.1:70000: "):
        Live(70_000)
