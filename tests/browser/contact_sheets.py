"""Command: contact sheets of built-in scenarios as a new user sees them: the opening, each step, and the result.

The script of a scenario flies, or, if it has none, the pilot that only reads the page. Each sheet has one size of the
window.
"""

from __future__ import annotations

import argparse
import io
import sys
import time
from pathlib import Path

from PIL import Image, ImageDraw
from playwright.sync_api import Page, sync_playwright

from aftdeck.scenario.load import about, built_in, load_scenario
from tests.browser.conftest import FLAGS, running_station
from tests.browser.flight import WAIT_MS, Flight
from tests.browser.text_pilot.pilot import Pilot
from tests.conftest import find_chromium

SIZES = ((1440, 900), (1024, 768))
"""Sizes of the window [px]."""
WIDTH, COLUMNS, CAPTION = 640, 3, 20
"""Width of a picture on the sheet [px], pictures in a row, and height of a caption [px]."""
SETTLED_S = 2.0
"""Time after a new step until its picture is taken [s]."""
Shots = list[tuple[str, Image.Image]]


def main() -> int:
    """Write a contact sheet for each size of the window and each scenario that the command line names, or for all."""
    options = argparse.ArgumentParser(description=main.__doc__)
    options.add_argument("folder", type=Path)
    options.add_argument("scenarios", nargs="*", default=[name for name in built_in() if load_scenario(name).steps])
    options.add_argument("--limit", type=float, default=600.0, help="longest flight [s]")
    given = options.parse_args()
    given.folder.mkdir(parents=True, exist_ok=True)
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=find_chromium(), args=FLAGS, timeout=WAIT_MS)
        for name in given.scenarios:
            scripted = about(name).scripted
            with running_station(name, *(["--demo"] if scripted else [])) as address:
                page = browser.new_page(viewport={"width": SIZES[0][0], "height": SIZES[0][1]})
                page.set_default_timeout(WAIT_MS)
                page.goto(f"{address}?quality=low")
                taken = flown(page, given.limit, scripted)
                page.close()
            for (width, _), shots in taken.items():
                sheet(shots).save(given.folder / f"{name}-{width}.jpg", quality=85)
            print(f"{name}: {len(taken[SIZES[0]])} pictures")
            sys.stdout.flush()
        browser.close()
    return 0


class Camera:
    """Camera that takes a picture of the page in each size of the window when a step or the result begins.

    Attributes:
        taken: pictures for each size of the window.
        over: whether the result has been taken.
    """

    def __init__(self, page: Page) -> None:
        self.taken = {size: Shots() for size in SIZES}
        self.over = False
        self._page, self._flight, self._last = page, Flight(page), ""
        self._flight.until("window.__aftdeck.frames > 5")

    def look(self) -> None:
        """Take the pictures if a step or the result has begun."""
        frame = self._flight.frame()
        task = frame.display.task
        self.over = task is not None and task.debrief is not None
        now = "result" if self.over else f"step {task.at + 1}" if task is not None else ""
        if now == self._last:
            return
        self._last = now
        time.sleep(SETTLED_S if self.taken[SIZES[0]] else 0.0)
        for size in SIZES:
            self._flight.resize(*size)
            shot = Image.open(io.BytesIO(self._page.screenshot()))
            self.taken[size].append((f"{now}, {frame.time_s:.0f} s", shot))
        self._flight.resize(*SIZES[0])


def flown(page: Page, limit_s: float, scripted: bool) -> dict[tuple[int, int], Shots]:
    """Return the pictures of a flight for each size of the window."""
    camera = Camera(page)
    if not scripted:
        report = Pilot(page, seen=camera.look).fly(limit_s)
        camera.look()
        print(f"{report.result}, {report.presses} key presses, not understood: {report.lost}")
        return camera.taken
    end = time.monotonic() + limit_s
    while time.monotonic() < end and not camera.over:
        camera.look()
        time.sleep(0.3)
    return camera.taken


def sheet(shots: Shots) -> Image.Image:
    """Return the pictures in rows, each with its caption."""
    height = WIDTH * shots[0][1].height // shots[0][1].width
    columns = min(COLUMNS, len(shots))
    rows = -(-len(shots) // columns)
    whole = Image.new("RGB", (columns * WIDTH, rows * (height + CAPTION)), "white")
    pen = ImageDraw.Draw(whole)
    for i, (caption, picture) in enumerate(shots):
        x, y = i % columns * WIDTH, i // columns * (height + CAPTION)
        pen.text((x + 6, y + 4), caption, fill="black")
        whole.paste(picture.convert("RGB").resize((WIDTH, height)), (x, y + CAPTION))
    return whole


if __name__ == "__main__":
    sys.exit(main())
