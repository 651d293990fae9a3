"""Late steps and lost time: counted by the pace, and told by the log, the lamp, the recording and the replay."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from aftdeck.recording.delays import Delays
from aftdeck.recording.index import Index
from aftdeck.recording.reader import Recording
from aftdeck.recording.replay import verify
from aftdeck.recording.writer import Recorder
from aftdeck.report.lamps import NEW_LOSS_S, TIME_LOST
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from aftdeck.station.core.lost_time import LOGGED_EVERY
from aftdeck.station.core.step import Delay
from aftdeck.station.messages import from_page
from aftdeck.station.playback.store import PlaybackStore
from aftdeck.station.playback.verdict import CHECKING
from aftdeck.station.session.driver import Driver
from aftdeck.station.session.pace import MAX_CATCH_UP, Pace
from aftdeck.station.session.session import Session
from tests.commands import Run
from tests.loaded import scenario
from tests.station.flying import flying, shown, steps
from tests.station.pages import until

PERIOD = 0.02


class Clock:
    """Clock that shows `now` [s]."""

    def __init__(self) -> None:
        self.now = 100.0

    def __call__(self) -> float:
        return self.now


@given(st.lists(st.floats(0.0, 1.0), min_size=1, max_size=60))
def test_simulated_and_lost_time_add_up_to_the_time_that_has_passed(stalls: list[float]) -> None:
    clock = Clock()
    pace = Pace(PERIOD, clock)
    begun, delays = clock.now, []
    for stall in stalls:
        delays.append(pace.step())
        clock.now += stall  # how long the step takes
        clock.now += pace.wait()
    last = pace.step()
    lost = sum(delay.lost_s for delay in (*delays, last))
    assert begun + len(stalls) * PERIOD + lost + last.late_s - last.lost_s == pytest.approx(clock.now)
    for delay in (*delays, last):
        assert delay.lost_s == (delay.late_s if delay.late_s > MAX_CATCH_UP else 0.0)


def test_steps_in_time_are_neither_late_nor_lost() -> None:
    clock = Clock()
    pace = Pace(PERIOD, clock)
    for _ in range(1000):
        assert pace.step() == pytest.approx((0.0, 0.0), abs=1e-9)
        clock.now += 0.001
        clock.now += pace.wait()


def test_a_new_run_begins_without_delay() -> None:
    clock = Clock()
    pace = Pace(PERIOD, clock)
    pace.step()
    clock.now += 30.0
    pace.begin()
    assert pace.step() == (0.0, 0.0)


def test_driver_counts_steps_that_the_clock_makes_late(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    clock, session = Clock(), Session(scenario(), record=tmp_path)
    step, stalls = session.step_to_frame, iter([0.0, 0.09, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.5, 0.0, 0.0, 0.0])

    def stalled(delay: Delay) -> bool:
        clock.now += next(stalls, 0.0)
        return step(delay)

    monkeypatch.setattr(session, "step_to_frame", stalled)
    driver = Driver(session, clock)
    monkeypatch.setattr(driver._stop, "wait", lambda seconds: setattr(clock, "now", clock.now + seconds))
    driver.start(lambda: None)
    until(lambda: driver.session.newest != b"" and shown(session).tick > 15, "all stalls are over")
    driver.close()
    # after the stall of 0.09 s, three steps begin more than a period late: by 0.07, 0.05 and 0.03 s
    assert session.delays.late_steps == 4
    assert session.delays.worst_s == pytest.approx(1.48)
    assert session.delays.lost_s == pytest.approx(1.48)
    (path,) = tmp_path.glob("*.mcap")
    recording = Recording(path)
    list(recording.messages())
    assert recording.delays is not None
    assert recording.delays.late_steps == session.delays.late_steps
    assert recording.delays.lost_s == pytest.approx(session.delays.lost_s, abs=1e-5)


def test_small_delays_are_no_late_steps() -> None:
    with flying() as session:
        session.step(Delay(PERIOD, 0.0))
        assert session.delays == Delays()


def give_command(session: Session) -> None:
    """Give a command, after which lost time disturbs an operator."""
    session.accept(from_page.SelectRate(0, "vernier"))
    steps(session, 1)


def test_time_lost_before_the_first_command_is_a_number_and_no_caution(tmp_path: Path) -> None:
    with flying(record=tmp_path) as session:
        session.step(Delay(0.5, 0.5))
        (lamp,) = (lamp for lamp in shown(session).display.lamps if lamp.name == TIME_LOST)
        assert lamp.level == "info" and "0.50 s" in lamp.text
        give_command(session)
        steps(session, 5)
        assert not [event for event in session.log.since(0) if event.level != "info"]
        assert session.delays.lost_s == 0.5
    (path,) = tmp_path.glob("*.mcap")
    assert verify(path).delays == session.delays == Delays(1, 0.5, 0.5, None)


def test_lost_time_is_logged_at_most_once_in_ten_seconds_with_its_sum() -> None:
    with flying() as session:
        give_command(session)
        for _ in range(100):
            session.step(Delay(0.5, 0.5))
        logged = [event for event in session.log.since(0) if event.kind == "time lost"]
        assert len(logged) == 1 and logged[0].level == "caution"
        steps(session, round(LOGGED_EVERY / PERIOD))
        logged = [event for event in session.log.since(0) if event.kind == "time lost"]
        assert len(logged) == 2 and "50.00 s" in logged[1].text


def test_lamp_is_lit_from_a_loss_to_the_end_of_the_run() -> None:
    def level(session: Session) -> str:
        return next((lamp.level for lamp in shown(session).display.lamps if lamp.name == TIME_LOST), "")

    with flying() as session:
        give_command(session)
        session.step(Delay(0.1, 0.0))
        assert level(session) == ""
        session.step(Delay(0.5, 0.5))
        assert level(session) == "caution"
        steps(session, round(NEW_LOSS_S / PERIOD) + 1)
        assert level(session) == "info"
        session.accept(from_page.Restart(0))
        steps(session, 1)
        assert level(session) == "" and session.delays == Delays()


@pytest.fixture(scope="module")
def slow_run(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Recording with 3 late steps, of which one lost 0.5 s."""
    folder = tmp_path_factory.mktemp("slow")
    with flying(record=folder) as session:
        steps(session, 49)
        give_command(session)
        for delay in (Delay(0.1, 0.0), Delay(0.03, 0.0), Delay(0.5, 0.5)):
            session.step(delay)
        steps(session, 20)
    (path,) = folder.glob("*.mcap")
    return path


def test_recording_its_footer_and_the_list_tell_the_delays(slow_run: Path) -> None:
    recording = Recording(slow_run)
    closing = list(recording.messages())[-1]
    assert recording.delays == Delays(3, 0.5, 0.5, shown_at(50))
    assert getattr(closing, "delays") == recording.delays  # noqa: B009
    entry = next(entry for entry in Index().entries() if entry.path == str(slow_run))
    assert (entry.late_steps, entry.worst_s, entry.lost_s) == (3, 0.5, 0.5)


def shown_at(tick: int) -> float:
    """Return the simulated time at which the step after `tick` + 2 late steps begins [s]."""
    return round((tick + 3) * PERIOD, 9)


def test_replay_tells_the_delays_and_can_reject_the_run(slow_run: Path, run: Run) -> None:
    assert verify(slow_run).delays == Delays(3, 0.5, 0.5, shown_at(50))
    assert run.json("replay", str(slow_run))["delays"]["lost_s"] == 0.5
    assert run("replay", str(slow_run), "--max-lost", "0.5")[0] == 0
    code, _, err = run("replay", str(slow_run), "--max-lost", "0.4")
    assert code == 1 and "0.50 s" in err


def test_playback_shows_the_delays(slow_run: Path) -> None:
    with PlaybackStore(slow_run) as store:
        index, block = store.index(CHECKING), store.block(0)
    (figure,) = [measure for measure in index.measures if measure.name == "Time lost"]
    assert figure.level == "caution" and figure.value == 0.5 and "3 late steps" in figure.about
    lit = [any(lamp.name == TIME_LOST for lamp in moment.frame.display.lamps) for moment in block]
    assert lit == [False] * 53 + [True] * (len(block) - 53)


def test_run_that_was_not_in_real_time_tells_no_delays(tmp_path: Path, run: Run) -> None:
    path = tmp_path / "headless.mcap"
    simulation = Simulation(scenario())
    recorder = Recorder(path, simulation.scenario, 0)
    for _ in range(10):
        recorder.step(Inputs(), simulation.step(Inputs()))
    recorder.close("stopped")
    assert verify(path).delays is None
    assert run("replay", str(path), "--max-lost", "1")[0] == 1
    with PlaybackStore(path) as store:
        assert all(measure.name != "Time lost" for measure in store.index(CHECKING).measures)
