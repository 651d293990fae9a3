"""The top rail with all that can stand in it: many phases, a recording, a delay, a page that watches."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.browser.conftest import NARROW, SIZES, OpenPage, flown

pytestmark = [pytest.mark.browser, pytest.mark.slow]

FLIGHTS = {
    "recorded": ("concept-1972", "--record"),
    "six tasks, recorded": ("srms-berth", "--record"),
    "the report's script": ("concept-1972-script", "--demo"),
    "delayed script": ("srms-deploy", "--demo"),
}

_LEAVES = """() => [...document.querySelectorAll('.rail > *, .rail button')]
    .filter((node) => node.getBoundingClientRect().right > innerWidth + .5)
    .map((node) => node.textContent)"""
_CUT = """() => [...document.querySelectorAll('.phases .present, .rail .met, .rail .who, .rail button')]
    .filter((node) => node.scrollWidth > node.clientWidth + 1 && node.clientWidth > 0)
    .filter((node) => !node.title.startsWith(node.textContent))
    .map((node) => node.textContent)"""
"""What is cut off, and not told whole as the pointer rests on it, as a scenario's name is."""


@pytest.fixture(scope="module", params=FLIGHTS.values(), ids=list(FLIGHTS))
def station(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """Address of a station whose rail is full."""
    scenario, option = request.param
    file: tuple[Path, ...] = (tmp_path_factory.mktemp("rail") / "flight.mcap",) if option == "--record" else ()
    with flown(scenario, option, *map(str, file)) as address:
        yield address


@pytest.mark.parametrize(("width", "height"), [*SIZES, *NARROW])
def test_nothing_in_the_rail_leaves_the_page(open_page: OpenPage, width: int, height: int) -> None:
    for page in (open_page(width, height), open_page(width, height)):  # one flies, one watches
        page.until("frame.time_s > 0.3")
        assert page.script(_LEAVES) == []
        assert page.script(_CUT) == []
