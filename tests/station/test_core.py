"""The core of a session, in the host that steps it directly."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from aftdeck.errors import SimulationError
from aftdeck.recording.bundle import opening
from aftdeck.recording.reader import Recording
from aftdeck.recording.records import DelayRecord, FrameRecord, Input, Note
from aftdeck.scenario.model import Scenario
from aftdeck.station.core.core import Core
from aftdeck.station.core.direct import Direct, DirectRecording
from aftdeck.station.core.step import Delay, Step
from aftdeck.station.messages import from_page, to_page
from aftdeck.station.messages.frame import Frame
from aftdeck.station.messages.welcome import Welcome
from aftdeck.station.session.session import Session
from tests.commands import Run
from tests.loaded import scenario
from tests.waits import WAIT_S

HEAVY = ("foxglove", "sqlite3", "uvicorn", "starlette", "typer", "pint")
BEGAN_NS = 1_700_000_000_000_000_000

IMPORTS = f"""
import sys
import aftdeck.station.core.direct
print([name for name in {HEAVY!r} if name in sys.modules])
"""
FORBIDDEN = """
import builtins, sys, threading, time
from aftdeck.scenario.load import load_scenario
from aftdeck.recording.bundle import opening
from aftdeck.station.core.core import Core
from aftdeck.station.core.direct import Direct, DirectRecording
from aftdeck.station.messages import from_page

EVENTS = ("open", "socket.", "subprocess.Popen", "os.fork", "os.posix_spawn", "_thread.start", "sqlite3.", "time.sleep")
CLOCKS = ("time", "time_ns", "monotonic", "monotonic_ns", "perf_counter", "perf_counter_ns", "process_time",
          "process_time_ns", "thread_time", "thread_time_ns", "localtime", "gmtime")
found = []

def watched(event, given):
    if watching and event.startswith(EVENTS):
        found.append((event, str(given)[:100]))

def flight(made, start):
    host = Direct(made, recording=DirectRecording(lambda *_: start, 0), demo=True)
    page, observer = host.join(strips=True), host.join(may_fly=False)
    steps = round(made.duration / made.control_period)
    for k in range(steps):
        host.step()
        if k % 50 == 0:
            page.receive(), observer.receive()
        if k == steps // 2:  # the operator takes over, and restarts once
            page.send(from_page.Sticks(k, (0.5, 0.0, 0.0), (0.0, 0.0, 0.0), 0.0))
        if k == steps * 3 // 4:
            page.send(from_page.Restart(k))
    host.close()
    return [len(file.getvalue()) for file in host.recording.files]

watching = False
sys.addaudithook(watched)
made = load_scenario(sys.argv[1])
start = opening(made, made.seed, 0)
first = flight(made, start)  # loads the laws
for name in CLOCKS:
    setattr(time, name, lambda *_, name=name: found.append(("time", name)) or 0.0)
threading.Thread.start = lambda self: found.append(("thread", self.name))
watching = True
second = flight(made, start)
watching = False
assert first == second and len(first) == 2 and min(first) > 50_000, (first, second)
print(found[:20])
"""


def printed(program: str, *given: str) -> str:
    """Return what a program of Python prints."""
    command = [sys.executable, "-c", program, *given]
    done = subprocess.run(command, capture_output=True, text=True, timeout=WAIT_S, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout.strip()


def test_core_imports_nothing_that_needs_a_server_or_a_file() -> None:
    assert printed(IMPORTS) == "[]"


@pytest.mark.slow
def test_running_core_uses_no_thread_process_socket_file_or_clock() -> None:
    assert printed(FORBIDDEN, "uncradle") == "[]"


MESSAGES: dict[int, tuple[from_page.FromPage, ...]] = {
    0: (from_page.Shown(1, 40.0, (("A",), ("B",))), from_page.SelectRate(2, "vernier")),
    5: (from_page.Sticks(3, (0.5, 0.0, 0.0), (0.0, 0.2, 0.0), 0.0),),
    40: (from_page.Sticks(4, (0.0, 0.0, 0.0), (0.0, 0.0, 0.0), 0.0), from_page.SetBrakes(5, True)),
    41: (from_page.SetBrakes(6, False), from_page.Announce(7)),
    60: (from_page.Restart(8),),
    70: (from_page.Sticks(9, (0.0, 0.0, -0.5), (0.0, 0.0, 0.0), 0.0),),
}
STEPS = 100


def direct(made: Scenario) -> list[bytes]:
    """Fly `MESSAGES` in the direct host, and return the recordings of both runs."""
    host = Direct(made, recording=DirectRecording(lambda of, seed: opening(of, seed, BEGAN_NS), BEGAN_NS))
    page = host.join()
    for k in range(STEPS):
        for message in MESSAGES.get(k, ()):
            page.send(message)
        host.step()
    host.close()
    assert host.recording is not None
    return [file.getvalue() for file in host.recording.files]


def on_a_server(made: Scenario, folder: Path) -> list[Path]:
    """Fly `MESSAGES` in the session of a server, and return its recordings of both runs."""
    now = 0.0
    session = Session(made, record=folder, clock=lambda: now)
    session.join("page")
    session.begin()
    for k in range(STEPS):
        for message in MESSAGES.get(k, ()):
            assert session.receive("page", message) == ()
        session.step()
        now += made.control_period
    session.close()
    return sorted(folder.glob("*.mcap"), key=lambda path: (len(path.name), path.name))


def test_direct_recording_is_equal_to_that_of_a_server(tmp_path: Path, run: Run) -> None:
    made = scenario("srms-berth")
    served = on_a_server(made, tmp_path / "server")
    assert len(served) == 2
    for k, (theirs, content) in enumerate(zip(served, direct(made), strict=True)):
        ours = tmp_path / f"direct-{k}.mcap"
        ours.write_bytes(content)
        code, out, err = run("replay", str(ours))
        assert (code, err) == (0, "") and "equal" in out
        both = Recording(theirs), Recording(ours)
        a, b = (list(recording.messages()) for recording in both)
        assert [type(message) for message in a] == [type(message) for message in b]
        assert both[0].frames_sha256 == both[1].frames_sha256 != ""
        assert [m for m in a if isinstance(m, Input)] == [m for m in b if isinstance(m, Input)]
        for kind in (FrameRecord, Note):
            assert [without_wall(m) for m in a if isinstance(m, kind)] == [
                without_wall(m) for m in b if isinstance(m, kind)
            ]


def test_delay_and_lines_before_the_end_of_a_run_are_recorded(tmp_path: Path) -> None:
    host = Direct(scenario(), recording=DirectRecording(lambda of, seed: opening(of, seed, BEGAN_NS), BEGAN_NS))
    page = host.join()
    host.step()
    page.send(from_page.SelectRate(1, "vernier"))
    host.step()
    host.core.note("page", "before the restart")
    page.send(from_page.Restart(2))
    host.step(Delay(0.4, 0.4))
    host.core.note("page", "before the end")
    host.close()
    assert host.recording is not None
    recorded = []
    for k, content in enumerate(host.recording.files):
        (path := tmp_path / f"{k}.mcap").write_bytes(content.getvalue())
        recorded.append(list(Recording(path).messages()))
    delays = [[m.lost_s for m in run if isinstance(m, DelayRecord)] for run in recorded]
    kinds = [[(m.kind, m.text) for m in run if isinstance(m, Note) and m.kind == "page"] for run in recorded]
    assert delays == [[0.4], []]
    assert kinds == [[("page", "before the restart")], [("page", "before the end")]]
    assert {"before the restart", "before the end"} <= {event.text for event in host.core.log.since(0)}


def test_delay_and_lines_of_a_step_that_fails_are_recorded(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(_: object) -> None:
        raise SimulationError("no such step")

    host = Direct(scenario(), recording=DirectRecording(lambda of, seed: opening(of, seed, BEGAN_NS), BEGAN_NS))
    host.step()
    host.core.note("page", "before the failure")
    monkeypatch.setattr(host.core._sim, "step", fail)
    with pytest.raises(SimulationError):
        host.step(Delay(0.4, 0.4))
    host.close()
    assert host.recording is not None
    (path := tmp_path / "run.mcap").write_bytes(host.recording.files[0].getvalue())
    messages = list(Recording(path).messages())
    assert [m.lost_s for m in messages if isinstance(m, DelayRecord)] == [0.4]
    assert "before the failure" in [m.text for m in messages if isinstance(m, Note)]


class _Seen:
    """Observer that counts steps."""

    def __init__(self) -> None:
        self.ticks: list[int] = []

    def see(self, step: Step) -> None:
        self.ticks.append(step.frame.tick)


def test_frame_is_ready_before_observers_see_the_step() -> None:
    seen = _Seen()
    core = Core(scenario(), clock=lambda: 0.0, observers=[seen])
    core.begin()
    core.fly(core.take())
    assert core.newest and not seen.ticks
    core.settle()
    core.settle()
    assert seen.ticks == [1], "each step once"
    core.fly(core.take())
    core.fly(core.take())
    assert seen.ticks == [1, 2], "the next step leaves none out"
    core.close()
    assert seen.ticks == [1, 2, 3]


def without_wall(message: FrameRecord | Note) -> list[object]:
    """Return the fields of a message but for its wall time."""
    return [getattr(message, name) for name in message.__struct_fields__ if name != "wall_s"]


def frames(messages: list[to_page.FromServer]) -> Iterator[Frame]:
    return (message for message in messages if isinstance(message, Frame))


def test_pages_of_a_direct_host_share_one_run() -> None:
    host = Direct(scenario())
    first, second = host.join(), host.join()
    for page in (first, second):
        welcome, role = page.receive()
        assert isinstance(welcome, Welcome) and isinstance(role, to_page.Role)
        assert role.flying == (page is first)
    second.send(from_page.SelectRate(1, "vernier"))
    (refused,) = second.receive()
    assert isinstance(refused, to_page.Refused) and "observes" in refused.text
    first.send(from_page.SelectRate(1, "vernier"))
    host.step()
    assert [frame.rate for page in (first, second) for frame in frames(page.receive())] == ["vernier", "vernier"]
    second.send(from_page.AskSticks(2))
    first.send(from_page.GiveSticks(2))
    host.leave(first)
    [role] = [message for message in second.receive() if isinstance(message, to_page.Role)]
    assert role.flying and role.watchers == 0
