"""Save the pictures of the documents in ``docs/pictures/``: ``python scripts/pictures.py [NAME ...]``; default: all.

For each picture, the script starts `aftdeck fly`, opens the page in Chromium, and saves a screenshot and the list of
the page's parts. It fails if the page shows a caution or a warning, for example on a busy machine.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory

from page_parts import parts_of, write
from picture_pages import PICTURES, WAIT_MS, open_page, scenario_file
from playwright.sync_api import Browser, Page, sync_playwright

FOLDER = Path(__file__).resolve().parent.parent / "docs" / "pictures"
MOST_BYTES = 600_000
"""Greatest size of a picture in the README [bytes]."""
# As in benchmarks/page.py: Mesa's GL draws the scene, and Chromium composites the page without GL.
FLAGS = [
    "--use-angle=gl-egl",
    "--disable-gpu-compositing",
    "--ignore-gpu-blocklist",
    "--no-sandbox",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
]
SHARP = """() => {
    const { scale, samples } = window.__aftdeck.sharpness ?? {};
    return scale === 1 && samples === 8;
}"""
"""Whether the still pictures of the cameras are complete."""
CAUTIONS = """() => [...document.querySelectorAll('.caution, .warning')]
    .filter((node) => node.checkVisibility({ visibilityProperty: true }))
    .map((node) => node.textContent.trim())"""
"""Texts of the visible cautions and warnings: lamps, the master alarm, log lines, a slow latency."""


def main() -> None:
    """Save the named pictures, or all pictures, each with the list of the page's parts."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    for name in sys.argv[1:] or PICTURES:
        picture = PICTURES[name]
        with (
            TemporaryDirectory() as folder,
            station(scenario_file(picture, Path(folder))) as address,
            chromium() as browser,
        ):
            page = open_page(browser, address, picture)
            page.wait_for_function(SHARP)
            keep(page, FOLDER / f"{name}.jpg")
            write(parts_of(page), FOLDER / f"{name}.json")


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


def keep(page: Page, path: Path) -> None:
    """Save a screenshot of the page.

    Raises:
        SystemExit: the page shows a caution or a warning, or the picture is too large.
    """
    start = time.perf_counter()
    taken = page.screenshot(type="jpeg", quality=86, timeout=WAIT_MS)
    if lit := page.evaluate(CAUTIONS):
        raise SystemExit(f"{path.name} would show a caution: {'; '.join(lit)}. On a busy machine, try again later.")
    if len(taken) > MOST_BYTES:
        raise SystemExit(f"{path.name} has {len(taken)} bytes; at most {MOST_BYTES} are allowed in the README.")
    path.write_bytes(taken)
    print(f"{path}: {len(taken) / 1000:.0f} kB in {time.perf_counter() - start:.1f} s")


if __name__ == "__main__":
    main()
