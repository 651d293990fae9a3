"""Every built-in scenario opens in the browser, is drawn and flies on."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from aftdeck.scenario.load import built_in
from tests.browser.conftest import OpenPage, flown

pytestmark = [pytest.mark.browser, pytest.mark.slow]


@pytest.fixture(scope="module", params=built_in())
def station(request: pytest.FixtureRequest) -> Iterator[str]:
    """Address of a station that flies this scenario."""
    with flown(str(request.param)) as address:
        yield address


def test_a_built_in_scenario_opens_is_drawn_and_flies(open_page: OpenPage) -> None:
    flight = open_page()
    flight.until("frame.time_s > 0 && window.__aftdeck.frames > 5")
    bodies = flight.script("window.__aftdeck.bodies")
    assert bodies and all(body["triangles"] > 0 for body in bodies if "." not in body["name"])
