"""Save screenshots of the station in ``docs/pictures/``: ``python scripts/pictures.py [NAME ...]``; default: all.

For each picture, the script starts `aftdeck fly`, opens the page in Chromium at 1440 x 900 pixels, and moves the arm
with keys. The first part of the motion uses the low drawing profile, because a machine without a graphics card draws
too slowly in the full profile. The screenshot is in the full profile.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import NamedTuple

from playwright.sync_api import Browser, Page, sync_playwright

UNMEASURED = ".rail .delay { display: none }"
"""Style that hides the delay in the rail, which depends on the speed of this machine's software drawing."""
FOLDER = Path(__file__).resolve().parent.parent / "docs" / "pictures"
SIZE = (1440, 900)
MOST_BYTES = 600_000
"""Greatest size of a picture in the README [bytes]."""
WAIT_MS = 60_000
"""Longest wait for the page [ms]; software drawing is slow."""
FLAGS = [
    "--use-angle=gl-egl",
    "--ignore-gpu-blocklist",
    "--no-sandbox",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
]
Held = tuple[Sequence[str], float]
"""Keys held together, and the duration [s of simulated time]."""


class Picture(NamedTuple):
    """Motion before a picture is saved.

    Attributes:
        scenario: scenario of `aftdeck fly`.
        before: keys that are held first, in the low profile.
        last: keys that are held while the picture is saved, in the full profile. They are held for more than 10 s,
            because the page measures its delay over the last 10 s; a shorter time would include the slow opening of the
            page.
    """

    scenario: str
    before: Sequence[Held]
    last: Held


PICTURES = {
    "station": Picture("first-flight", ((("KeyD", "KeyQ"), 5.0), (("KeyS", "KeyI"), 6.0)), (("KeyW", "KeyL"), 12.0)),
    "concept": Picture("concept-1972", ((("KeyE",), 1.9),), ((), 12.0)),
    "capture": Picture("srms-deploy", ((("KeyE",), 3.9),), ((), 12.0)),
}


def main() -> None:
    """Save the named pictures, or all pictures."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    for name in sys.argv[1:] or PICTURES:
        scenario, before, last = PICTURES[name]
        with station(scenario) as address, chromium() as browser:
            page = open_page(browser, f"{address}?quality=low")
            for keys, seconds in before:
                hold(page, keys, seconds)
                release(page, keys)
            page.close()
            page = open_page(browser, f"{address}?quality=full")
            hold(page, *last)
            keep(page, f"{name}.jpg")


@contextmanager
def station(scenario: str, *options: str) -> Iterator[str]:
    """Run `aftdeck fly` with these options inside the `with` block; yields its address."""
    command = [sys.executable, "-m", "aftdeck.cli", "fly", scenario, *options, "--no-browser", "--port", "0"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        try:
            assert process.stdout is not None
            yield process.stdout.readline().removeprefix("Aftdeck station: ").strip()
        finally:
            process.terminate()
            process.wait(10)


@contextmanager
def chromium() -> Iterator[Browser]:
    """Start a headless Chromium: the executable that AFTDECK_CHROMIUM names, or else a Chromium on PATH."""
    names = ("chromium", "chromium-browser", "google-chrome")
    found = os.environ.get("AFTDECK_CHROMIUM") or next(filter(None, map(shutil.which, names)), None)
    if found is None:
        raise SystemExit("Chromium was not found: install chromium, or set AFTDECK_CHROMIUM to its executable.")
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=found, args=FLAGS)
        yield browser
        browser.close()


def open_page(browser: Browser, address: str) -> Page:
    """Open a page; wait until it has drawn its first frame and has control."""
    width, height = SIZE
    page = browser.new_page(viewport={"width": width, "height": height})
    page.set_default_timeout(WAIT_MS)
    page.add_init_script("localStorage.setItem('aftdeck.started', 'yes')")  # the whole page, no opening shot
    page.goto(address)
    page.wait_for_function("window.__aftdeck?.lastFrame")
    page.wait_for_function("document.querySelector('.who').textContent.startsWith('You fly')")
    return page


def hold(page: Page, keys: Sequence[str], seconds: float) -> None:
    """Press keys, and wait until the simulated time has advanced by `seconds`; the keys stay pressed."""
    begun = float(page.evaluate("window.__aftdeck.lastFrame.time_s"))
    for key in keys:
        page.keyboard.down(key)
    page.wait_for_function("end => window.__aftdeck.lastFrame.time_s >= end", arg=begun + seconds)


def release(page: Page, keys: Sequence[str]) -> None:
    """Release keys."""
    for key in keys:
        page.keyboard.up(key)


def keep(page: Page, name: str) -> None:
    """Save a screenshot of the page.

    Raises:
        SystemExit: the picture is too large.
    """
    path = FOLDER / name
    begun = time.perf_counter()
    page.screenshot(path=path, type="jpeg", quality=86, timeout=WAIT_MS, style=UNMEASURED)
    size = path.stat().st_size
    fps = page.evaluate("window.__aftdeck.fps")
    print(f"{path}: {size / 1000:.0f} kB in {time.perf_counter() - begun:.1f} s, {fps} pictures/s")
    if size > MOST_BYTES:
        raise SystemExit(f"{path.name} has {size} bytes; at most {MOST_BYTES} are allowed in the README.")


if __name__ == "__main__":
    main()
