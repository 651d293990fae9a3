"""Make the pictures of the list of scenarios: ``python scripts/thumbnails.py [NAME ...]``; default: all.

For each built-in scenario, the script starts `aftdeck fly`, opens the window of one monitor in the full drawing profile
and saves the picture, without marks and lettering, in ``web/src/panel/rail/thumbnails/``.
"""

from __future__ import annotations

import base64
import sys
import time
from pathlib import Path
from typing import NamedTuple

from picture_pages import WAIT_MS
from pictures import chromium, station
from playwright.sync_api import Browser, Page

from aftdeck.scenario.load import built_in

FOLDER = Path(__file__).resolve().parent.parent / "web" / "src" / "panel" / "rail" / "thumbnails"
WINDOW = (960, 640)
"""Size of the window [px]."""
SIZE = (192, 120)
"""Size of a thumbnail [px], twice that on the page, for screens with fine pixels."""
QUALITY = 0.55
"""Quality of the WebP file, 0 to 1: about 2 kB for a picture."""
PLAIN = ".bezel * { opacity: 0 !important }"
"""Style that hides marks and lettering in the picture."""
SHRINK = """async ([picture, width, height, quality]) => {
    const whole = await createImageBitmap(await (await fetch(picture)).blob());
    const high = Math.min(whole.height, whole.width * height / width);
    const wide = high * width / height;
    const canvas = new OffscreenCanvas(width, height);
    const context = canvas.getContext('2d');
    context.imageSmoothingQuality = 'high';
    context.drawImage(whole, (whole.width - wide) / 2, (whole.height - high) / 2, wide, high, 0, 0, width, height);
    const bytes = new Uint8Array(await (await canvas.convertToBlob({ type: 'image/webp', quality })).arrayBuffer());
    return btoa(String.fromCharCode(...bytes));
}"""
"""JavaScript: cut a picture to the thumbnail's shape, shrink it, and return a WebP file in base64."""


class Shot(NamedTuple):
    """What a thumbnail shows.

    Attributes:
        camera: camera on the monitor; "" for the one that the station chooses.
        seconds: time of the scenario's script [s]; None for the start of a run by hand.
    """

    camera: str = ""
    seconds: float | None = None


SHOTS = {
    "concept-1972-script": Shot("W", 50.0),
    "flight-test": Shot("C"),
    "loaded": Shot("C"),
    "sequence": Shot("C", 14.0),
    "sts-400-closed": Shot("B", 50.0),
    "sts-400-open": Shot("C", 50.0),
    "sts-400-position": Shot("B", 30.0),
    "tutorial": Shot("WR"),
    "uncradle": Shot("C"),
}
"""Shots by scenario that differ from the station's own choice at the start, which is dark or like another one."""


def main() -> None:
    """Make the named thumbnails, or all."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    with chromium() as browser:
        for name in sys.argv[1:] or built_in():
            shot = SHOTS.get(name, Shot())
            demo = () if shot.seconds is None else ("--demo",)
            with station(name, *demo) as address:
                path = FOLDER / f"{name}.webp"
                path.write_bytes(shrunk(browser, picture(browser, address, shot)))
                print(f"{path}: {path.stat().st_size} bytes")


def picture(browser: Browser, address: str, shot: Shot) -> bytes:
    """Return the picture of a shot [PNG]."""
    width, height = WINDOW
    page = browser.new_page(viewport={"width": width, "height": height}, bypass_csp=True)  # for `PLAIN`
    page.set_default_timeout(WAIT_MS)
    page.goto(f"{address}?view=mon1&quality=full")
    page.wait_for_function("() => window.__aftdeck?.lastFrame")
    if shot.camera:
        keys = page.get_by_role("group", name="Camera of MON 1")
        keys.get_by_role("button", name=shot.camera, exact=True).click()
    page.wait_for_function("at => window.__aftdeck.lastFrame.time_s >= at", arg=shot.seconds or 0.0)
    settle(page)
    taken = page.locator(".monitor .bezel").screenshot(style=PLAIN)
    page.close()
    return taken


def settle(page: Page) -> None:
    """Wait until the last changes are drawn."""
    drawn = page.evaluate("window.__aftdeck.frames")
    page.wait_for_function("least => window.__aftdeck.frames > least", arg=drawn + 3)
    time.sleep(1.0)  # textures arrive


def shrunk(browser: Browser, taken: bytes) -> bytes:
    """Return a picture as a thumbnail [WebP]."""
    page = browser.new_page()
    given = "data:image/png;base64," + base64.b64encode(taken).decode()
    text = str(page.evaluate(SHRINK, [given, *SIZE, QUALITY]))
    page.close()
    return base64.b64decode(text)


if __name__ == "__main__":
    main()
