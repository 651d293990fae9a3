"""The top rail with all that can stand in it: many phases, a recording, a delay, a page that watches."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

import aftdeck
from tests.browser.conftest import NARROW, SIZES, OpenPage, flown
from tests.browser.flight import WHO, Flight

pytestmark = [pytest.mark.browser, pytest.mark.slow]

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
"""Delays of the scenarios that have some."""
NAME = "Maximiliana Alexandrina"
LATE = """
    const send = WebSocket.prototype.send;
    WebSocket.prototype.send = function (text) {
        setTimeout(() => this.readyState === WebSocket.OPEN && send.call(this, text), 400);
    };
"""
"""A link on which all that the page says takes 0.4 s longer."""

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
    folder = tmp_path_factory.mktemp("rail")
    file = (str(folder / "flights"),) if option == "--record" else ()
    given = late(folder, LATE_BY[scenario]) if scenario in LATE_BY else scenario
    with flown(given, option, *file) as address:
        yield address


def late(folder: Path, delays: str) -> str:
    """A scenario with many tasks and these delays."""
    berth = Path(aftdeck.__file__).parent / "scenario" / "builtin" / "srms-berth.toml"
    (folder / "late.toml").write_text(f"{delays}\n{berth.read_text(encoding='utf-8')}", encoding="utf-8")
    return str(folder / "late.toml")


def assert_whole(page: Flight) -> None:
    """Nothing of the rail is out of the page, and what is cut off is told whole by a title."""
    assert page.script(_LEAVES) == []
    assert page.script(_CUT) == []


@pytest.mark.parametrize(("width", "height"), [*SIZES, *NARROW])
def test_nothing_in_the_rail_leaves_the_page(open_page: OpenPage, width: int, height: int) -> None:
    pages = (open_page(width, height), open_page(width, height))  # one flies, one watches
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
def test_a_delay_stands_as_set_and_as_measured_where_commands_take_longer(
    open_page: OpenPage, delay: int, width: int, height: int
) -> None:
    told = "document.querySelector('.rail .delay').textContent"
    page = open_page(width, height, prepare=lambda page: page.add_init_script(LATE))
    page.until(f"{WHO} === 'You fly'")
    page.until(f"{told}.trim() === '{'Command delay 2.00 s' if delay else 'Delay'}'")
    page.hold("w")
    page.until("frame.translation[0] === 1")
    page.release("w")
    page.until(f"/^Command set {delay}.00, measured {delay}\\.[4-9]/.test({told})")
    page.until_lit("LINK")
    assert_whole(page)
    open_page(width, height)
    page.until(f"{WHO} === 'You fly · 1 watches'")
    assert_whole(page)
