"""The operator's task in a session: a page's part in its progress, and the log."""

from __future__ import annotations

from pathlib import Path

from aftdeck.recording.index import Index
from aftdeck.report.metrics.desk import LOST
from aftdeck.scenario.load import load_scenario
from aftdeck.station.core.step import Delay
from aftdeck.station.messages import from_page
from aftdeck.station.messages.frame import TaskNow
from aftdeck.station.session.session import Session
from tests.loaded import scenario
from tests.station.flying import flying, shown, step_until, steps

ONE = """
title = "One step"
mode = "ORB UNL"
initial = { joints = ["-31 deg", "79 deg", "-103 deg", "-77 deg", "17 deg", "-128 deg"] }

[[step]]
title = "Move"
text = "Move."
done = { moved = "0.1 m" }
"""


def task(session: Session) -> TaskNow:
    """Return the progress in the newest frame."""
    now = shown(session).display.task
    assert now is not None
    return now


def turn(session: Session, to: str) -> None:
    session.accept(from_page.TurnStep(0, "next" if to == "next" else "previous"))
    steps(session, 2)


def test_page_turns_the_steps_and_the_result_tells_the_skipped_ones() -> None:
    with flying(made=scenario("uncradle")) as session:
        steps(session, 2)
        assert (task(session).at, task(session).done_s) == (0, (None, None, None))
        turn(session, "next")
        turn(session, "next")
        turn(session, "previous")
        assert (task(session).at, task(session).debrief) == (1, None)
        turn(session, "next")
        turn(session, "next")
        result = task(session).debrief
        assert result is not None
        assert (result.grade, len(result.faults)) == (None, 1)
        turn(session, "previous")
        assert task(session).debrief is None


def test_camera_on_a_monitor_counts_as_looking_around() -> None:
    with flying(made=scenario("tutorial")) as session:
        session.accept(from_page.Shown(1, None, (("A",), ("WR",))))
        steps(session, 3)
        assert task(session).at == 0, "the page only reports its first cameras"
        session.accept(from_page.Shown(2, None, (("B",), ("WR",))))
        steps(session, 3)
        assert task(session).at == 1
        assert any(event.kind == "task" and event.text.endswith("Look around") for event in session.log.since(0))


def test_turning_a_step_does_not_stop_the_script() -> None:
    with flying(made=scenario("uncradle"), demo=True) as session:
        steps(session, 3)
        turn(session, "next")
        assert shown(session).by == "script"


def test_grade_is_in_the_list_of_recordings(tmp_path: Path) -> None:
    file = tmp_path / "one.toml"
    file.write_text(ONE)
    with flying(made=load_scenario(file), record=tmp_path) as session:
        session.accept(from_page.Sticks(1, (0.0, 0.0, -1.0), (0.0, 0.0, 0.0), 0.0))
        step_until(session, lambda frame: frame.display.task is not None and frame.display.task.at == 1, "the end")
        result = task(session).debrief
    with flying(made=load_scenario(file), record=tmp_path) as session:
        steps(session, 2)
    assert result is not None
    assert result.grade == "A"
    assert sorted(entry.grade for entry in Index().entries("one")) == ["", "A"]


def test_result_counts_the_time_that_was_lost(tmp_path: Path) -> None:
    file = tmp_path / "one.toml"
    file.write_text(ONE)
    with flying(made=load_scenario(file)) as session:
        session.accept(from_page.Sticks(1, (0.0, 0.0, -1.0), (0.0, 0.0, 0.0), 0.0))
        session.step(Delay(late_s=0.9, lost_s=0.65))
        step_until(session, lambda frame: frame.display.task is not None and frame.display.task.at == 1, "the end")
        result = task(session).debrief
    assert result is not None
    (lost,) = [figure for figure in result.figures if figure.name == LOST.title]
    assert (lost.value, lost.level, result.grade) == (0.65, "caution", "A")
