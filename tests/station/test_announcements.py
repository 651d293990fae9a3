"""Clearance problems that the operator or an observer announces."""

from __future__ import annotations

from pathlib import Path

from aftdeck.recording.reader import Recording
from aftdeck.report.metrics.announcements import ANNOUNCED, COUNT
from aftdeck.report.of_recording import metrics_of
from aftdeck.station.messages import from_page, to_page
from aftdeck.station.session.session import Session
from tests.loaded import scenario
from tests.station.flying import flying, steps
from tests.station.pages import served
from tests.station.test_access import FLY, KEYED, WATCH, page_with


def announced(session: Session) -> list[str]:
    """Return the texts of the announcements in the log."""
    return [event.text for event in session.log.since(0) if event.kind == ANNOUNCED]


def test_announcement_is_logged_recorded_and_counted(tmp_path: Path) -> None:
    with flying(made=scenario("first-flight"), record=tmp_path) as session:
        steps(session, 5)
        session.desk.announce("operator")
        steps(session, 5)
        session.desk.announce("observer")  # too soon after the first
        steps(session, 60)
        session.desk.announce("observer")
        steps(session, 5)
        assert [text.split(":")[0] for text in announced(session)] == [
            "clearance problem announced by the operator",
            "clearance problem announced by the observer",
        ]
        file = session.file
    assert file is not None
    assert metrics_of(Recording(file))[COUNT].number == 2


def test_observer_may_announce_although_it_cannot_fly() -> None:
    session = Session(scenario())
    with (
        served(session, access=KEYED) as station,
        page_with(station, FLY) as operator,
        page_with(station, WATCH) as observer,
    ):
        operator.wait_for(to_page.Role)
        observer.wait_for(to_page.Role)
        observer.send(from_page.Announce(observer.next_seq()))
        events = observer.wait_for(to_page.Events, lambda found: any(e.kind == ANNOUNCED for e in found.events))
        assert any("observer" in event.text for event in events.events if event.kind == ANNOUNCED)
