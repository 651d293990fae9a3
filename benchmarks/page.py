"""Benchmark of the page in headless Chromium without a graphics card.

It measures the time between two pictures, and the time from a key press to the first picture that shows the effect
of the key.

The computer's processor draws the pictures.
"""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from typing import NamedTuple

from playwright.sync_api import Page, sync_playwright

from benchmarks.measure import Figure, absent
from benchmarks.station import flying

FLAGS = ("--use-angle=gl-egl", "--ignore-gpu-blocklist", "--disable-gpu-compositing", "--no-sandbox")
"""Mesa's GL draws the scene. Chromium composites the page without GL, as on a machine without a graphics card. If
Mesa's GL also composited the page, Chromium would draw half as many pictures."""
WIDTH, HEIGHT = 640, 400
"""Size of each monitor's picture [px]."""
BROWSERS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
"""Programs that draw the page, unless AFTDECK_CHROMIUM names another one."""


class Size(NamedTuple):
    """Scenarios that are flown, and number of keys that move the arm in each, for half a second each."""

    scenarios: tuple[str, ...]
    keys: int


FULL, TINY = Size(("first-flight", "srms-deploy"), 20), Size(("first-flight",), 3)
WAIT_MS = 300_000.0
"""Longest wait [ms]; the first run compiles the laws."""
PROGRESS = "[window.__aftdeck.frames, performance.now()]"
"""JavaScript for the number of pictures drawn, and the present time [ms]."""
SIZE = "(({ clientWidth, clientHeight }) => [clientWidth, clientHeight])(document.querySelector('.picture'))"
"""JavaScript for the size of a monitor's picture [px]."""


def page(size: Size) -> list[Figure]:
    """Measure two monitors of 640 x 400 px in the low profile, with the station on the same machine."""
    program = os.environ.get("AFTDECK_CHROMIUM") or next(filter(None, map(shutil.which, BROWSERS)), None)
    if program is None:
        return [absent("time between pictures", "ms", "install chromium, or name one in AFTDECK_CHROMIUM")]
    figures = []
    for name in size.scenarios:
        with flying(name) as address, _opened(program, address) as shown:
            _fit(shown)
            before = shown.evaluate(PROGRESS)
            keys = ("w", "s", "a", "d", "q", "e")
            for k in range(size.keys):
                shown.keyboard.down(keys[k % len(keys)])
                shown.wait_for_timeout(400)
                shown.keyboard.up(keys[k % len(keys)])
                shown.wait_for_timeout(100)
            drawn, milliseconds = (now - was for now, was in zip(shown.evaluate(PROGRESS), before, strict=True))
            late = shown.evaluate("window.__aftdeck.latency95")
            width, height = shown.evaluate(SIZE)
            note = f"low profile, {width:.0f} x {height:.0f} each, {shown.evaluate('window.__aftdeck.renderer')}"
        figures += [
            Figure(
                f"{name}, time between pictures",
                milliseconds / drawn,
                "ms",
                40.0,
                f"{1e3 * drawn / milliseconds:.1f} a second; {note}",
            ),
            absent(f"{name}, key to picture, p95", "ms", "no key took effect")
            if late is None
            else Figure(f"{name}, key to picture, p95", late, "ms", 100.0, "of the last 10 s"),
        ]
    return figures


@contextmanager
def _opened(program: str, address: str) -> Iterator[Page]:
    """Open the page and wait until its first frame is drawn."""
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=program, args=FLAGS)
        shown = browser.new_page(viewport={"width": 1440, "height": 800})
        shown.goto(f"http://{address}/?quality=low", timeout=WAIT_MS)
        # a function, because the page's content policy forbids to evaluate a text again and again
        shown.wait_for_function("() => window.__aftdeck?.lastFrame", timeout=WAIT_MS)
        yield shown
        browser.close()


def _fit(shown: Page) -> None:
    """Resize the window until each monitor has the size WIDTH x HEIGHT."""
    for _ in range(12):
        width, height = shown.evaluate(SIZE)
        size = shown.viewport_size
        assert size is not None
        wide, tall = round(size["width"] * WIDTH / width), size["height"] + round(HEIGHT - height)
        if (wide, tall) == (size["width"], size["height"]):
            break
        shown.set_viewport_size({"width": wide, "height": tall})
        shown.wait_for_timeout(300)
