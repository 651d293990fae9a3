"""What the page may not do: run a text of a recording, reach a foreign server, or fly with the key for observing."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, expect

from aftdeck.recording.trial import Trial
from aftdeck.station.playback.one_file import write_html
from aftdeck.station.session.session import Session
from tests.browser.conftest import OpenPage
from tests.browser.flight import WAIT_MS
from tests.loaded import scenario
from tests.station.pages import served
from tests.station.recordings import playing, record_run
from tests.station.test_access import KEYED, WATCH

pytestmark = pytest.mark.browser

HOSTILE = "</script><script>window.ran = 1</script><img src=x onerror='window.ran = 2'>"
VIOLATIONS = """
    window.violations = [];
    document.addEventListener('securitypolicyviolation', (event) => window.violations.push(event.violatedDirective));
"""


@pytest.fixture(scope="module")
def recording(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Recording whose texts contain scripts."""
    path = tmp_path_factory.mktemp("hostile") / "flight.mcap"
    record_run(path, 100, trial=Trial(HOSTILE[:40], HOSTILE))
    return path


@pytest.fixture(scope="module")
def station(recording: Path) -> Iterator[str]:
    with playing(recording) as address:
        yield address


@pytest.fixture
def one_file(recording: Path, browser: Browser, tmp_path: Path) -> Iterator[Page]:
    out = tmp_path / "replay.html"
    write_html(recording, out)
    page = browser.new_page()
    page.set_default_timeout(WAIT_MS)
    page.add_init_script(VIOLATIONS)
    page.goto(out.as_uri())
    yield page
    page.close()


def test_texts_of_a_recording_run_nothing(open_page: OpenPage) -> None:
    replay = open_page(prepare=lambda page: page.add_init_script(VIOLATIONS))
    replay.until("frame !== null")
    assert replay.page.evaluate("[window.ran, window.violations]") == [None, []]


def test_one_file_runs_only_its_own_script_and_reaches_no_server(one_file: Page, station: str) -> None:
    one_file.wait_for_function("() => window.__aftdeck?.lastFrame")
    assert one_file.evaluate("[window.ran, window.violations]") == [None, []]
    for attack in (
        "const script = document.createElement('script'); script.textContent = 'window.ran = 3';"
        "document.body.append(script)",
        "document.body.insertAdjacentHTML('beforeend', `<img src=x onerror='window.ran = 4'>`)",
        "document.body.insertAdjacentHTML('beforeend', `<p style='color: red'>`)",
        f"fetch('{station}health').catch(() => {{}})",
    ):
        one_file.evaluate(f"{{ {attack} }}")
    one_file.wait_for_function("() => window.violations.length >= 4")
    assert one_file.evaluate("window.ran") is None


@pytest.mark.slow
def test_address_for_observing_offers_no_control(browser: Browser) -> None:
    with served(Session(scenario()), access=KEYED) as keyed:
        page = browser.new_page()
        try:
            page.set_default_timeout(WAIT_MS)
            page.goto(f"http://{keyed.address}/{WATCH}/?quality=low")
            page.wait_for_function("() => window.__aftdeck?.lastFrame")
            expect(page.get_by_text("Observing · unattended")).to_be_visible(timeout=WAIT_MS)
            expect(page.get_by_role("button", name="Ask for the sticks")).to_be_hidden()
            page.reload()
            page.wait_for_function("() => window.__aftdeck?.lastFrame")
        finally:
            page.close()
