"""Delays of telemetry and pictures: the read-outs and the pictures have the age that the scenario sets."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser

import aftdeck
from aftdeck.station.core.link import LinkDelays
from aftdeck.station.session.session import Session
from tests.browser.conftest import FULL_PANEL, STARTED, OpenPage, running_station
from tests.browser.flight import FLIES, Flight
from tests.loaded import scenario
from tests.station.pages import served

pytestmark = [pytest.mark.browser, pytest.mark.slow]

TELEMETRY_S, CAMERA_S, PERIOD_S = 0.3, 2.3, 0.02
SOON_S = 2.0
"""Longest time from the due time of a frame to its picture, with software drawing; CAMERA_S - TELEMETRY_S or less."""

RECORD_ARRIVALS = """
    window.arrived = [];
    const Socket = window.WebSocket;
    window.WebSocket = class extends Socket {
        constructor(...given) {
            super(...given);
            this.addEventListener('message', ({ data }) => {
                const message = JSON.parse(data);
                if (message.type === 'frame') window.arrived.push({ ...message, came: performance.now() });
            });
        }
    };
"""
"""Stores each frame with its time of arrival at the page."""

AGES = """() => {
    const [hours, minutes, seconds] = document.querySelector('.picture .code').textContent.split(':').map(Number);
    const newest = window.arrived.at(-1);
    const age = (time_s) => newest.time_s - time_s + (performance.now() - newest.came) / 1000;
    return {
        figures: age(window.__aftdeck.lastFrame.time_s),
        picture: age(3600 * hours + 60 * minutes + seconds),
        stale: document.querySelector('.is-stale, body.stale') !== null,
    };
}"""
"""Ages of the read-outs and of the picture [s], and whether the page marks them as stale.

The time of the simulation counts up to the newest frame: frames take more or less time to a busy page.
"""

RAIL_AGE = """(() => {
    const [, hours, minutes, seconds] = document.querySelector('.rail .met b').textContent.split(/[/:]/).map(Number);
    const newest = window.arrived.at(-1);
    return newest.time_s - (3600 * hours + 60 * minutes + seconds) + (performance.now() - newest.came) / 1000;
})()"""
"""Age of the mission time in a secondary window [s], in which each time stays for a second."""


@pytest.fixture(scope="module")
def station(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """Address of a station with delayed telemetry and pictures."""
    first = Path(aftdeck.__file__).parent / "scenario" / "builtin" / "first-flight.toml"
    file = tmp_path_factory.mktemp("late") / "late.toml"
    delays = f"telemetry_delay = {TELEMETRY_S}\ncamera_delay = {CAMERA_S}\n"
    file.write_text(delays + first.read_text(encoding="utf-8"), encoding="utf-8")
    with running_station(str(file)) as address:
        yield address


@pytest.fixture
def page(open_page: OpenPage) -> Flight:
    """A page of the station, in control."""
    page = open_page(prepare=lambda page: page.add_init_script(RECORD_ARRIVALS))
    page.until(FLIES)
    return page


CODES = """[...document.querySelectorAll('.picture .code')].map(({ textContent }) => {
    const [hours, minutes, seconds] = textContent.split(':').map(Number);
    return 3600 * hours + 60 * minutes + seconds;
})"""
"""Times of the pictures on the monitors [s]."""


def until_delayed(page: Flight) -> None:
    """Wait until the pictures no longer show the first frame, which has no delay."""
    first = page.script("window.arrived[0].time_s")
    page.until(f"frame.time_s > {first + CAMERA_S + 1.0}")


def ages(page: Flight, count: int = 20) -> list[dict[str, float]]:
    """Measure `AGES` `count` times, with at least one new picture between two measurements."""
    found = []
    for _ in range(count):
        found.append(page.script(AGES))
        page.polled()
    return found


def test_figures_and_pictures_have_the_delays_of_the_scenario(page: Flight) -> None:
    page.hold("w")
    page.until("frame.translation[0] === 1")
    page.release("w")
    until_delayed(page)
    measured = ages(page)
    for age in measured:
        assert TELEMETRY_S <= age["figures"] <= TELEMETRY_S + SOON_S
        assert CAMERA_S <= age["picture"] <= CAMERA_S + SOON_S
    # A delay alone makes nothing stale. On a busy machine, slow pictures do, for a moment.
    assert not all(age["stale"] for age in measured)
    page.page.locator(".burned.time", has_text="2.3 s old").first.wait_for()
    # On a busy machine, the rail also shows how long the command took, for some seconds.
    page.until("document.querySelector('.rail .delay').textContent === 'Delay TLM 0.30 · CAM 2.30 s'")
    link = page.page.locator(".lamp.info", has_text="LINK DELAY")
    assert link.get_attribute("title") == "figures are 0.30 s old, pictures are 2.30 s old"
    # The stick-to-picture time is measured without the delays.
    page.until("window.__aftdeck.latency95 !== null")
    assert 0 < page.script("window.__aftdeck.latency95") < 1000 * SOON_S


def test_log_and_mode_have_the_telemetry_delay(page: Flight) -> None:
    page.script("""() => {
        const lines = () => document.querySelectorAll('.log [data-kind=mode]').length;
        const before = lines();
        new MutationObserver(() => {
            window.logged ??= lines() > before ? window.arrived.at(-1).time_s : undefined;
        }).observe(document.querySelector('.log'), { childList: true, subtree: true, characterData: true });
    }""")
    page.enter("END EFF")
    page.until("window.logged")
    before, entered, logged = page.script("""(() => {
        const first = window.arrived.findIndex(({ mode }) => mode === 'END EFF');
        return [window.arrived[first - 1].time_s, window.arrived[first].time_s, window.logged];
    })()""")
    # a line comes just before the frame of its step; a page on a busy machine does not get every frame
    assert logged - before >= TELEMETRY_S - 1e-9
    assert logged - entered <= TELEMETRY_S + SOON_S


def test_monitor_window_has_the_camera_delay(browser: Browser, station: str) -> None:
    other = browser.new_page(viewport={"width": 900, "height": 600})
    other.add_init_script(RECORD_ARRIVALS)
    other.goto(f"{station}?view=mon1&quality=low")
    second = Flight(other)
    until_delayed(second)
    for age in ages(second, 5):
        assert CAMERA_S <= age["picture"] <= CAMERA_S + SOON_S
        assert CAMERA_S <= second.script(RAIL_AGE) <= CAMERA_S + SOON_S + 1.0
    other.close()


def test_restart_is_shown_after_the_delays(page: Flight) -> None:
    page.until(f"{CODES}[0] > {CAMERA_S}")
    page.page.get_by_role("button", name="Restart").click()
    page.until("window.arrived.at(-1).time_s < 1.5")
    newest, codes = page.script(f"[window.arrived.at(-1).time_s, {CODES}]")
    assert newest < CAMERA_S < min(codes)
    page.until(f"{CODES}[0] < 1")
    assert page.script("window.arrived.at(-1).time_s") >= CAMERA_S
    assert page.script("window.__aftdeck.restarts") == 1


def test_each_camera_can_have_a_delay_of_its_own(browser: Browser) -> None:
    with served(Session(scenario())) as station:
        page = browser.new_page(viewport={"width": 1280, "height": 720})
        for script in (FULL_PANEL, STARTED):
            page.add_init_script(script)
        page.goto(f"http://127.0.0.1:{station.port}/?quality=low")
        flight = Flight(page)
        first, second = flight.script("window.__aftdeck.views.monitors.flat()")
        station.session.link.delays = LinkDelays(0.0, 0.0, {first: 0.5, second: 2.0})
        flight.until(f"Math.abs({CODES}[0] - {CODES}[1] - 1.5) < 0.03")
        page.close()
