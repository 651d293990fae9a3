"""Every built-in scenario opens in the browser, is drawn and runs."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from aftdeck.scenario.load import built_in
from tests.browser.conftest import OpenPage, running_station
from tests.browser.flight import shows

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.long]


EMPTY = {"space"}
"""Body of the empty worksite; it has no shapes."""


@pytest.fixture(scope="module", params=built_in())
def station(request: pytest.FixtureRequest) -> Iterator[str]:
    """Address of a station that runs the scenario."""
    with running_station(str(request.param)) as address:
        yield address


def test_built_in_scenario_opens_is_drawn_and_runs(open_page: OpenPage) -> None:
    flight = open_page()
    flight.until("frame.time_s > 0 && window.__aftdeck.frames > 5")
    bodies = flight.script("window.__aftdeck.bodies")
    drawn = [body for body in bodies if "." not in body["name"] and body["name"] not in EMPTY]
    assert bodies and all(body["triangles"] > 0 for body in drawn)


def test_every_camera_of_a_scenario_opens_on_either_monitor(open_page: OpenPage) -> None:
    flight = open_page()
    flight.until("window.__aftdeck.frames > 5")
    for monitor in (0, 1):
        keys = flight.page.get_by_role("group", name=f"Camera of MON {monitor + 1}").get_by_role("button")
        names = keys.all_inner_texts()
        assert len(set(names)) == len(names) >= 2
        for index, name in enumerate(names):
            keys.nth(index).click()
            flight.until(shows(monitor, name))
            drawn = flight.script("window.__aftdeck.frames")
            flight.until(f"window.__aftdeck.frames > {drawn + 2}")
