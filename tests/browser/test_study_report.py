"""Report page of a study in a browser."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import Browser

from aftdeck.study.case import Runner
from aftdeck.study.design import cases
from aftdeck.study.plan import plan_of
from aftdeck.study.report import page
from tests.browser.test_policy import VIOLATIONS
from tests.study.studies import loaded
from tests.study.test_report_page import DRAWN

pytestmark = pytest.mark.browser

ATTACKS = (
    "const script = document.createElement('script'); script.textContent = 'window.ran = 1'; "
    "document.body.append(script)",
    "document.body.insertAdjacentHTML('beforeend', `<img src='data:,' onerror='window.ran = 2'>`)",
    "document.body.insertAdjacentHTML('beforeend', `<style>body { color: red }</style>`)",
    "document.body.insertAdjacentHTML('beforeend', `<img src='http://127.0.0.1:9/x.png'>`)",
    "fetch('http://127.0.0.1:9/').catch(() => {})",
)
"""What a text that became HTML could try; the page's policy forbids each."""


def test_browser_shows_the_page_without_a_request_or_an_error(tmp_path: Path, browser: Browser) -> None:
    study = loaded(tmp_path, DRAWN)
    runner = Runner(plan_of(study))
    file = tmp_path / "report.html"
    file.write_text(page(study, [runner.run(case).row for case in cases(study)[:2]], tmp_path), encoding="utf-8")
    requests: list[str] = []
    errors: list[str] = []
    shown = browser.new_page(viewport={"width": 420, "height": 800})
    shown.on("request", lambda request: requests.append(request.url))
    shown.on("console", lambda message: errors.append(message.text))
    shown.on("pageerror", lambda error: errors.append(str(error)))
    shown.add_init_script(VIOLATIONS)
    shown.goto(file.as_uri())
    assert shown.locator("svg").count() == 8
    assert shown.evaluate("document.documentElement.scrollWidth <= window.innerWidth")
    assert shown.evaluate("window.violations") == []
    assert requests == [file.as_uri()]
    assert errors == []
    for attack in ATTACKS:
        shown.evaluate(f"{{ {attack} }}")
    shown.wait_for_function(f"() => window.violations.length >= {len(ATTACKS)}")
    assert shown.evaluate("window.ran") is None
    shown.close()
