"""Driver: the thread that steps a session in real time."""

from __future__ import annotations

import threading
import time
from pathlib import Path

import pytest

from aftdeck.errors import CommandError
from aftdeck.law_change import Laws
from aftdeck.recording.reader import Recording
from aftdeck.recording.records import FrameRecord
from aftdeck.recording.replay import verify
from aftdeck.station.core.page_inputs import MAX_WAITING
from aftdeck.station.core.step import PUNCTUAL, Delay
from aftdeck.station.messages import from_page
from aftdeck.station.session.driver import Driver, Phase
from aftdeck.station.session.pace import MAX_CATCH_UP
from aftdeck.station.session.session import Session
from tests.loaded import scenario
from tests.station.flying import driven, shown
from tests.station.pages import STILL, in_time, until
from tests.waits import WAIT_S


def test_driver_goes_from_ready_to_flying_to_closed() -> None:
    driver = Driver(Session(scenario()))
    phases = [driver.phase]
    driver.start(lambda: None)
    phases.append(driver.phase)
    driver.close()
    phases.append(driver.phase)
    assert phases == [Phase.READY, Phase.FLYING, Phase.CLOSED]
    newest = driver.session.newest
    time.sleep(0.05)
    assert driver.session.newest is newest


def test_steps_keep_the_control_period_and_gain_no_more_than_the_delay() -> None:
    def second_of_steps_is_in_time(session: Session) -> bool:
        begun = time.monotonic()
        first = shown(session).tick
        until(lambda: shown(session).tick >= first + 50, "50 steps")
        last = shown(session).tick
        assert (last - first) * 0.02 < time.monotonic() - begun + MAX_CATCH_UP + 0.05
        return in_time(begun, 50)

    with driven() as driver:
        until(lambda: second_of_steps_is_in_time(driver.session), "50 steps in a second")


def test_commands_from_many_threads_are_all_executed_or_rejected() -> None:
    with driven() as driver:
        session, rejected = driver.session, set[str]()

        def send_many() -> None:
            for seq in range(2000):
                session.accept(from_page.Sticks(seq, STILL, STILL, 0.0))
                try:
                    session.accept(from_page.SelectRate(seq, "vernier"))
                except CommandError as error:
                    rejected.add(str(error))

        threads = [threading.Thread(target=send_many) for _ in range(3)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join(WAIT_S)
        until(lambda: shown(session).rate == "vernier", "a command is executed")
    assert all(str(MAX_WAITING) in text for text in rejected)


def test_recorded_wall_time_is_real_and_simulated_time_follows_it(tmp_path: Path) -> None:
    begun = time.perf_counter()
    with driven(record=tmp_path) as driver:
        until(lambda: shown(driver.session).tick > 40, "40 steps")
    took = time.perf_counter() - begun
    (path,) = tmp_path.glob("*.mcap")
    frames = [m for m in Recording(path).messages() if isinstance(m, FrameRecord)]
    walls = [frame.wall_s for frame in frames]
    assert walls == sorted(walls)
    wall, simulated = walls[-1] - walls[0], frames[-1].time_s - frames[0].time_s
    assert simulated - MAX_CATCH_UP - 0.05 < wall < took


def test_failing_step_is_reported_with_its_time_and_the_recording_is_kept(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("threading.excepthook", lambda _: None)
    notified = threading.Event()
    driver = Driver(Session(scenario(), record=tmp_path))
    driver.start(lambda: notified.set() if driver.failure else None)
    until(lambda: driver.session.newest != b"" and shown(driver.session).tick > 5, "steps")
    driver.session._sim._state.plant.angles[:] = float("nan")
    assert notified.wait(WAIT_S) and driver.phase is Phase.FAILED
    assert f"{driver.session.time_s:.2f} s" in driver.failure
    driver.close()
    (path,) = tmp_path.glob("*.mcap")
    recording = Recording(path)
    list(recording.messages())
    assert verify(path).equal and recording.ended == "stopped"


def _goes_on(driver: Driver) -> bool:
    return driver.session.newest != b"" and shown(driver.session).tick > 1


def test_run_waits_for_the_first_pictures_of_a_page_and_loses_no_time() -> None:
    driver = Driver(Session(scenario()), for_page=True)
    driver.start(lambda: None)
    until(lambda: driver.waits_for == "page", "the run waits")
    time.sleep(0.5)
    assert shown(driver.session).tick == 1, "the page has a frame to draw"
    driver.drawn()
    until(lambda: _goes_on(driver) and driver.waits_for == "", "the run goes on")
    driver.close()
    assert driver.session.delays.lost_s == 0.0


def test_run_without_a_page_begins_in_time_and_says_why(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("aftdeck.station.session.driver.PAGE_WITHIN", 0.3)
    driver = Driver(Session(scenario()), for_page=True)
    driver.start(lambda: None)
    until(lambda: _goes_on(driver), "the run begins")
    driver.close()
    assert [event.kind for event in driver.session.log.since(0)] == ["page"]


def test_closing_ends_the_wait_for_a_page() -> None:
    driver = Driver(Session(scenario()), for_page=True)
    driver.start(lambda: None)
    until(lambda: driver.waits_for == "page", "the run waits")
    start = time.monotonic()
    driver.close()
    assert time.monotonic() - start < 1.0 and driver.phase is Phase.CLOSED


class _SlowLaws(Laws):
    """Laws that are compiled when the test says so."""

    def __init__(self) -> None:
        super().__init__()
        self.compiled = threading.Event()

    def wait(self, timeout: float) -> bool:
        return self.compiled.wait(timeout)


@pytest.mark.parametrize("busy", ["work", "sleep"])
def test_run_waits_for_compiled_laws_if_its_own_work_is_too_slow(busy: str, monkeypatch: pytest.MonkeyPatch) -> None:
    laws = _SlowLaws()
    session = Session(scenario(), laws=laws)
    step = session.step_to_frame

    def slow(delay: Delay = PUNCTUAL) -> bool:
        if not laws.compiled.is_set():
            if busy == "work":
                until_work = time.thread_time() + 0.05
                while time.thread_time() < until_work:
                    pass
            else:
                time.sleep(0.05)
        return step(delay)

    monkeypatch.setattr(session, "step_to_frame", slow)
    driver = Driver(session)
    driver.start(lambda: None)
    if busy == "sleep":  # a busy machine is no reason to wait
        until(lambda: session.delays.lost_s > 0.0, "time is lost")
        assert driver.waits_for == ""
        driver.close()
        return
    until(lambda: driver.waits_for == "laws", "the run waits")
    before = shown(session).tick
    time.sleep(0.3)
    assert shown(session).tick == before
    laws.compiled.set()
    until(lambda: shown(session).tick > before, "the run goes on")
    driver.close()
    assert session.delays.lost_s == 0.0
