"""Recordings for the tests, and a server that plays a recording."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from threading import Thread

import msgspec

from aftdeck.recording.reader import Recording
from aftdeck.recording.records import ControllerRecord, ControllersRecord, Note, Shown
from aftdeck.recording.trial import NO_TRIAL, Trial
from aftdeck.recording.writer import Recorder
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from aftdeck.station.playback.store import PlaybackStore
from aftdeck.station.server.playback_server import replay_app
from aftdeck.station.server.serve import listen, make_server
from tests.loaded import scenario
from tests.simulation.flights import srms
from tests.station.pages import until
from tests.waits import WAIT_S

CONTROLLERS = (
    ControllerRecord("keyboard", "Keyboard", 0.0, 0.0, ("KeyW +X", "KeyS -X"), ()),
    ControllerRecord("thc joystick", "Test stick", 0.08, 0.3, ("a1 -X", "a0 +Y"), (0.0, 0.1)),
)
NOTE = Note(0.5, "page", "caution", "log line of the station", 0.5)


def files(folder: Path) -> list[Path]:
    """Return the recordings in a folder, in the order in which they began."""
    return sorted(folder.glob("*.mcap"), key=lambda path: Recording(path).opening.began)


def ended(path: Path) -> str:
    """Return the reason for the end of a recorded run."""
    recording = Recording(path)
    list(recording.messages())
    return recording.ended


def record_run(path: Path, steps: int = 600, *, script: bool = True, trial: Trial = NO_TRIAL) -> list[Frame]:
    """Record a run and return its frames: manual translation, then also rotation, then the script, if `script`."""
    simulation = Simulation(scenario())
    recorder = Recorder(path, simulation.scenario, 0, trial=trial)
    recorder.put(ControllersRecord(0.0, CONTROLLERS, 0.0))
    frames = []
    for i in range(steps):
        rotates = i > steps // 2
        manual = Inputs(
            translation=(0.5, 0.0, 0.0),
            rotation=(0.0, 0.4 if rotates else 0.0, 0.0),
            rate="vernier" if i == steps // 4 else None,
        )
        flown = manual if i < steps * 3 // 4 or not script else None
        frames.append(simulation.step(flown))
        recorder.step(flown, frames[-1], latency_ms=40.0 if rotates else None)
        if i == 0:
            recorder.put(Shown(frames[-1].time_s, ("C",), ("WR",)))
        if i == steps // 2:
            recorder.put(NOTE)
            recorder.put(Shown(frames[-1].time_s, ("A", "B"), ("ELB",)))
    recorder.close("stopped")
    assert not recorder.failure
    return frames


def record_capture(path: Path) -> list[Frame]:
    """Record a capture (error of 1 inch and 3 deg), brakes, camera changes and a release; return the frames.

    After the release, the end effector approaches the payload beside the grapple pin, and retreats.
    """
    simulation = Simulation(srms(4.0, 1.0, turned=(0.0, 3.0, 0.0)))
    recorder = Recorder(path, simulation.scenario, 0)
    recorder.put(ControllersRecord(0.0, CONTROLLERS, 0.0))
    frames: list[Frame] = []

    def fly(steps: int, inputs: Inputs, first: Inputs | None = None) -> None:
        for k in range(steps):
            given = first if first is not None and k == 0 else inputs
            frames.append(simulation.step(given))
            recorder.step(given, frames[-1], latency_ms=None)

    creep = Inputs(translation=(0.0, 0.05, 0.2))
    fly(1, Inputs(), Inputs(rate="vernier"))
    recorder.put(Shown(frames[-1].time_s, ("C",), ("WR",)))
    fly(250, creep, msgspec.structs.replace(creep, effector="close"))
    recorder.put(Shown(frames[-1].time_s, ("A",), ("WR",)))
    fly(20, Inputs(), Inputs(brakes=True))
    fly(360, Inputs(), Inputs(brakes=False, effector="open"))
    recorder.put(Shown(frames[-1].time_s, (), ()))  # the page is reloaded
    fly(10, Inputs())
    recorder.put(Shown(frames[-1].time_s, ("A",), ("WR",)))
    fly(60, Inputs(translation=(0.0, 0.0, -0.4)), Inputs(rate="coarse"))
    fly(50, Inputs())
    fly(120, Inputs(translation=(0.5, 0.0, 0.0)))
    fly(60, Inputs())
    fly(105, Inputs(translation=(0.0, 0.0, 0.3)))
    fly(200, Inputs(translation=(0.0, 0.0, -0.8)))
    recorder.close("stopped")
    assert not recorder.failure
    return frames


@contextmanager
def playing(path: Path) -> Iterator[str]:
    """Serve a recording, and yield its address."""
    listener = listen("127.0.0.1", 0)
    with PlaybackStore(path) as store:
        server = make_server(replay_app(store, path))
        thread = Thread(target=server.run, kwargs={"sockets": [listener]}, daemon=True)
        thread.start()
        try:
            until(lambda: server.started or not thread.is_alive(), "the server starts")
            yield f"http://127.0.0.1:{listener.getsockname()[1]}/"
        finally:
            server.should_exit = True
            thread.join(WAIT_S)
            assert not thread.is_alive(), "the server does not end"
