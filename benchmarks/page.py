"""Benchmark of the page in headless Chromium without a graphics card.

While the arm moves, it measures the time between two pictures, and the time from a key press to the first picture that
shows the effect of the key. When the arm has stopped, it measures the time until the pictures are still ones.

The computer's processor draws the pictures.
"""

from __future__ import annotations

import os
import shutil
import time
from collections.abc import Iterator
from contextlib import contextmanager
from typing import NamedTuple

from playwright.sync_api import Page, ViewportSize, sync_playwright

from benchmarks.measure import Figure, absent
from benchmarks.station import flying

FLAGS = ("--use-angle=gl-egl", "--ignore-gpu-blocklist", "--disable-gpu-compositing", "--no-sandbox")
"""Mesa's GL draws the scene. Chromium composites the page without GL, as on a machine without a graphics card. If
Mesa's GL also composited the page, Chromium would draw half as many pictures."""
WIDTH, HEIGHT = 640, 400
"""Size of each monitor's picture in the first window [px]."""
LARGE: ViewportSize = {"width": 1440, "height": 900}
"""Size of the second window [px]."""
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
SHARPNESS = "window.__aftdeck.sharpness"
"""JavaScript for the resolution of the pictures, as a share of the screen's, and the number of samples of a pixel."""
RATES, PAUSED = (25.0, 15.0), 700
"""Pictures a second that are promised for two monitors of WIDTH x HEIGHT and for the window LARGE; length of the pause
after each key in which still pictures are drawn [ms]."""


def page(size: Size) -> list[Figure]:
    """Measure two monitors of 640 x 400 px and a window of 1440 x 900 px in the low profile."""
    program = os.environ.get("AFTDECK_CHROMIUM") or next(filter(None, map(shutil.which, BROWSERS)), None)
    if program is None:
        return [absent("time between pictures", "ms", "install chromium, or name one in AFTDECK_CHROMIUM")]
    figures = []
    for name in size.scenarios:
        with flying(name) as address, _opened(program, address) as shown:
            _fit(shown)
            figures += _moving(shown, size.keys, f"{name}, {WIDTH} x {HEIGHT}", RATES[0])
            figures.append(_latency(shown, size.keys, f"{name}, key to picture, p95", 100))
            figures.append(_latency(shown, size.keys, f"{name}, key to picture at rest, p95", PAUSED))
            shown.set_viewport_size(LARGE)
            figures += _moving(shown, size.keys, f"{name}, window {LARGE['width']} x {LARGE['height']}", RATES[1])
            figures += _resting(shown, name)
    return figures


def _moving(shown: Page, keys: int, name: str, rate: float) -> list[Figure]:
    """Measure the time between pictures that show a motion, and their resolution, when this has been chosen."""
    _press(shown, keys // 2, 100)  # the page chooses the resolution
    before, scales = shown.evaluate(PROGRESS), list[float]()
    for _ in range(keys):
        _press(shown, 1, 100)
        scales.append(shown.evaluate(SHARPNESS)["scale"])
    drawn, milliseconds = (now - was for now, was in zip(shown.evaluate(PROGRESS), before, strict=True))
    width, height = shown.evaluate(SIZE)
    finest = f"{100 * min(scales):.0f} to {100 * max(scales):.0f} % of the screen's resolution"
    note = f"{1e3 * drawn / milliseconds:.1f} a second; two monitors, {width:.0f} x {height:.0f} each, {finest}"
    return [Figure(f"{name}, time between pictures", milliseconds / drawn, "ms", 1e3 / rate, note)]


def _latency(shown: Page, keys: int, name: str, pause: float) -> Figure:
    """Measure the time from a key to its picture, with pauses after the keys [ms]."""
    _press(shown, keys, pause)
    late = shown.evaluate("window.__aftdeck.latency95")
    if late is None:
        return absent(name, "ms", "no key took effect")
    return Figure(name, late, "ms", 100.0, "of the last 10 s")


def _resting(shown: Page, name: str) -> list[Figure]:
    """Measure the pictures after the end of a motion."""
    _press(shown, 2, 0)
    start = time.perf_counter()
    shown.wait_for_function(f"() => {SHARPNESS}.samples > 1", timeout=WAIT_MS)
    waited, sharp = time.perf_counter() - start, shown.evaluate(SHARPNESS)
    renderer = shown.evaluate("window.__aftdeck.renderer")
    return [
        Figure(f"{name}, key released to still pictures", waited, "s", None, f"{sharp['samples']} samples of a pixel"),
        Figure(f"{name}, screen's resolution by that of still pictures", 1.0 / sharp["scale"], "", 1.0, renderer),
    ]


def _press(shown: Page, count: int, pause: float) -> None:
    """Press keys that move the arm, each for 0.4 s and with a pause after it [ms]."""
    for k in range(count):
        key = "wsadqe"[k % 6]
        shown.keyboard.down(key)
        shown.wait_for_timeout(400)
        shown.keyboard.up(key)
        if pause:
            shown.wait_for_timeout(pause)


@contextmanager
def _opened(program: str, address: str) -> Iterator[Page]:
    """Open the page and wait until its first frame is drawn."""
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=program, args=FLAGS)
        shown = browser.new_page(viewport={"width": 1440, "height": 800})
        shown.add_init_script("localStorage.setItem('aftdeck.started', 'yes')")  # the whole page, no opening shot
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
