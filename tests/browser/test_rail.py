"""The top rail with all its elements: many phases, a recording, a delay, an observer."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

import aftdeck
from tests.browser.conftest import NARROW, SIZES, OpenPage, running_station
from tests.browser.flight import WHO, Flight

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.long]

FLIGHTS = {
    "recorded": ("concept-1972", "--record"),
    "six tasks, recorded": ("srms-berth", "--record"),
    "the report's script": ("concept-1972-script", "--demo"),
    "delayed script": ("srms-deploy", "--demo"),
    "a command delay, recorded": ("late", "--record"),
    "three delays, recorded": ("later", "--record"),
}
LATE_BY = {
    "late": 'command_delay = "2 s"',
    "later": 'command_delay = "2 s"\ntelemetry_delay = "1.25 s"\ncamera_delay = "1.5 s"',
}
"""Delays of the two scenarios with a delay."""
NAME = "Maximiliana Alexandrina"
LATE = """
    const send = WebSocket.prototype.send;
    WebSocket.prototype.send = function (text) {
        setTimeout(() => this.readyState === WebSocket.OPEN && send.call(this, text), 400);
    };
"""
"""A link that delays each message of the page by 0.4 s."""

_LEAVES = """() => [...document.querySelectorAll('.rail > *, .rail button')]
    .filter((node) => node.getBoundingClientRect().right > innerWidth + .5)
    .map((node) => node.textContent)"""
_CUT = """() => [...document.querySelectorAll('.phases .present, .rail .met, .rail .who, .rail button')]
    .filter((node) => node.scrollWidth > node.clientWidth + 1 && node.clientWidth > 0)
    .filter((node) => !node.title.startsWith(node.textContent))
    .map((node) => node.textContent)"""
"""Texts that are cut off and have no tooltip with the whole text."""


@pytest.fixture(scope="module", params=FLIGHTS.values(), ids=list(FLIGHTS))
def station(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """Address of a station with a full rail."""
    scenario, option = request.param
    folder = tmp_path_factory.mktemp("rail")
    file = (str(folder / "flights"),) if option == "--record" else ()
    given = late(folder, LATE_BY[scenario]) if scenario in LATE_BY else scenario
    with running_station(given, option, *file) as address:
        yield address


def late(folder: Path, delays: str) -> str:
    """Write a scenario with many phases and these delays; return its path."""
    berth = Path(aftdeck.__file__).parent / "scenario" / "builtin" / "srms-berth.toml"
    (folder / "late.toml").write_text(f"{delays}\n{berth.read_text(encoding='utf-8')}", encoding="utf-8")
    return str(folder / "late.toml")


def assert_whole(page: Flight) -> None:
    """Assert that the rail is within the page and that each text that is cut off has a tooltip."""
    assert page.script(_LEAVES) == []
    assert page.script(_CUT) == []


@pytest.mark.parametrize(("width", "height"), [*SIZES, *NARROW])
def test_rail_stays_within_the_page(open_page: OpenPage, width: int, height: int) -> None:
    pages = (open_page(width, height), open_page(width, height))  # an operator and an observer
    for page in pages:
        page.until("frame.time_s > 0.3")
        assert_whole(page)
    for page in pages:
        page.give_name(NAME)
    for page in pages:
        page.until(f"{WHO}.includes('{NAME}')")
        assert_whole(page)


@pytest.mark.parametrize(("width", "height"), SIZES)
@pytest.mark.parametrize(
    ("station", "delay"),
    [(FLIGHTS["recorded"], 0), (FLIGHTS["a command delay, recorded"], 2)],
    ids=["no delay", "a delay"],
    indirect=["station"],
)
def test_rail_shows_a_set_and_a_longer_measured_delay(open_page: OpenPage, delay: int, width: int, height: int) -> None:
    delay_text = "document.querySelector('.rail .delay').textContent"
    page = open_page(width, height, prepare=lambda page: page.add_init_script(LATE))
    page.until(f"{WHO} === 'You fly'")
    page.until(f"{delay_text}.trim() === '{'Command delay 2.00 s' if delay else 'Delay'}'")
    page.hold("w")
    page.until("frame.translation[0] === 1")
    page.release("w")
    page.until(f"/^Command set {delay}.00, measured {delay}\\.[4-9]/.test({delay_text})")
    page.until_lit("LINK")
    assert_whole(page)
    open_page(width, height)
    page.until(f"{WHO} === 'You fly · 1 observes'")
    assert_whole(page)
