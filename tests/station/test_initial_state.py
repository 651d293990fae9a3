"""Log of a scenario whose initial state is unusual: it raises no alarm."""

from __future__ import annotations

import pytest

from aftdeck.scenario.load import built_in
from aftdeck.station.session.session import Session
from tests.loaded import scenario
from tests.station.flying import shown, steps


@pytest.mark.parametrize("name", built_in())
def test_no_scenario_opens_with_an_alarm(name: str) -> None:
    session = Session(scenario(name))
    steps(session, 20)
    assert not [event for event in session.log.since(0) if event.level != "info"]
    assert all(lamp.standing for lamp in shown(session).display.lamps if lamp.level != "info")
    session.close()


def test_the_initial_state_is_told() -> None:
    session = Session(scenario("uncradle"))
    steps(session, 1)
    texts = [event.text for event in session.log.since(0)]
    assert any(text.startswith("from the start: ") and "soft stop" in text for text in texts)
    session.close()
