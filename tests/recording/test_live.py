"""Server to which viewers attach during a run."""

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
from tests.recording.flights import read, record_random_sticks
from tests.waits import WAIT_S


@pytest.fixture
def live() -> Iterator[Live]:
    server = Live(0)
    yield server
    server.close()


class Viewer:
    """Client of Foxglove's protocol that subscribes to all topics."""

    def __init__(self, socket: ClientConnection) -> None:
        self._socket = socket
        self._topics: dict[int, str] = {}
        self.channels: dict[str, dict[str, Any]] = {}
        self.times: list[int] = []

    def until(self, *topics: str) -> set[str]:
        """Receive messages until there is one on each of `topics`, and return all topics received."""
        received: set[str] = set()
        end = time.monotonic() + WAIT_S
        while not set(topics) <= received:
            message = self._socket.recv(max(0.0, end - time.monotonic()))
            if isinstance(message, bytes):
                op, subscription, time_ns = struct.unpack_from("<BIQ", message)
                assert op == 1
                received.add(self._topics[subscription])
                self.times.append(time_ns)
            else:
                self._subscribe(json.loads(message))
        return received

    def _subscribe(self, message: dict[str, Any]) -> None:
        if message["op"] != "advertise":
            return
        subscriptions = []
        for channel in message["channels"]:
            number = len(self._topics)
            self._topics[number] = channel["topic"]
            self.channels[channel["topic"]] = channel
            subscriptions.append({"id": number, "channelId": channel["id"]})
        self._socket.send(json.dumps({"op": "subscribe", "subscriptions": subscriptions}))


class RunningThread:
    """Thread that steps and records a run until `__exit__`."""

    def __init__(self, live: Live, path: Path | None = None) -> None:
        self._stop = threading.Event()
        self._recorder = Recorder(path, load_scenario("first-flight"), 1, live=live)
        self._thread = threading.Thread(target=self._run)

    def __enter__(self) -> None:
        self._thread.start()

    def __exit__(self, *_: object) -> None:
        self._stop.set()
        self._thread.join(WAIT_S)
        self._recorder.close("stopped")
        assert not self._recorder.failure

    def _run(self) -> None:
        simulation = Simulation(load_scenario("first-flight"))
        while not self._stop.wait(0.01):
            inputs = Inputs(translation=(0.5, 0.0, 0.0))
            self._recorder.step(inputs, simulation.step(inputs))


MOVING = ("/tf", "/joints", "/tip", "/frames", "/inputs")
ONCE = ("/scene", "/tf_static")


def attached(live: Live) -> ClientConnection:
    return connect(live.address, subprotocols=[Subprotocol("foxglove.sdk.v1")], open_timeout=WAIT_S, close_timeout=0.1)


def test_viewer_that_attaches_later_receives_the_scene(live: Live) -> None:
    with RunningThread(live), attached(live) as first, attached(live) as second:
        for socket in (first, second):
            viewer = Viewer(socket)
            assert viewer.until(*MOVING, *ONCE)
            assert viewer.times == sorted(viewer.times)
            assert viewer.channels["/tf"]["schemaName"] == "foxglove.FrameTransforms"
            assert viewer.channels["/frames"]["encoding"] == "json"


def test_viewer_stays_attached_over_a_restart(live: Live) -> None:
    with attached(live) as socket:
        viewer = Viewer(socket)
        for _ in range(3):
            with RunningThread(live):
                viewer.until(*MOVING, *ONCE)


def test_run_is_recorded_and_viewed_simultaneously(live: Live, tmp_path: Path) -> None:
    path = tmp_path / "watched.mcap"
    with attached(live) as socket, RunningThread(live, path):
        Viewer(socket).until(*MOVING, *ONCE)
    topics = read(path)
    assert set(topics) >= {*MOVING, *ONCE, "/opening", "/closing"}


def test_runs_follow_each_other_in_their_own_files(live: Live, tmp_path: Path) -> None:
    for k in range(3):
        record_random_sticks("first-flight", tmp_path / f"{k}.mcap", 10 + k, live)
    for k in range(3):
        topics = read(tmp_path / f"{k}.mcap")
        assert len(topics["/frames"]) == 10 + k
        assert len(topics["/scene"]) == len(topics["/opening"]) == len(topics["/closing"]) == 1


def test_run_without_a_file_writes_nothing(live: Live, tmp_path: Path) -> None:
    assert len(record_random_sticks("first-flight", None, 10, live)) == 10
    assert list(tmp_path.iterdir()) == []


def test_port_in_use_is_rejected(live: Live) -> None:
    port = int(live.address.rpartition(":")[2])
    with pytest.raises(RecordingError, match=rf"127\.0\.0\.1:{port}: .*in use"):
        Live(port)


def test_invalid_port_is_rejected() -> None:
    with pytest.raises(RecordingError, match=r"127\.0\.0\.1:70000: "):
        Live(70_000)
