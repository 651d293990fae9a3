"""Change from the flight to its replay, and back."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from tests.browser.conftest import OpenPage, running_station
from tests.browser.flight import FLIES, Flight
from tests.browser.layout_checks import collisions

pytestmark = pytest.mark.browser


@pytest.fixture(scope="module")
def station(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """Address of a station that records."""
    with running_station("first-flight", "--record", str(tmp_path_factory.mktemp("flights"))) as address:
        yield address


@pytest.mark.slow
def test_replay_opens_from_the_page_and_returns_to_the_flight(open_page: OpenPage, station: str) -> None:
    flight = open_page()
    flight.hold("w")
    ended = flight.until("frame.translation[0] === 1 && frame.time_s > 1.5")
    flight.release("w")
    flight.from_the_start()
    flight.page.locator(".rec > button").click()
    rows = flight.page.locator(".recordings a")
    rows.nth(1).wait_for()
    assert "this run so far" in rows.first.inner_text()
    assert collisions(flight, ".choices.recordings") == []
    rows.nth(1).click()
    flight.page.wait_for_url("**/replay/first-flight-*.mcap/")
    replay = Flight(flight.page)
    assert replay.page.locator(".replay-tag").inner_text().upper() == "REPLAY"
    replay.press("End")
    assert replay.until("!(frame.time_s < 1.5)").time_s >= ended.time_s
    replay.page.get_by_role("link", name="Back to flight").click()
    flight.page.wait_for_url(station)
    Flight(flight.page).until(FLIES)
