"""The pages of which the documents have pictures: scenario, start, and what is pressed before the picture is taken.

Nothing is flown. If the moment comes late in a run, `scenario_file` lets the run start at this moment. A picture's page
is therefore always the same, and a test can compare it with the list beside the picture.
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import NamedTuple

from playwright.sync_api import Browser, Page

from aftdeck.scenario.build import BUILT_IN

WINDOW = (1440, 900)
"""Size of the window [px]: a laptop's."""
WAIT_MS = 60_000
"""Longest wait for the page [ms]; software drawing is slow."""
COMPILED_MS = 300_000
"""Longest wait for a page that is ready [ms]; the first station on a machine compiles the laws."""
SETTLED_S, REACTION_S = 5.0, 1.0
"""Time of the run from which on, and time after a press until which, the page may change by itself [s]: it shows, for
example, that steps of the task are done."""
STARTED = "localStorage.setItem('aftdeck.started', 'yes')"
"""JavaScript: mark of an earlier start of the station in this browser."""
READY = """() => window.__aftdeck?.lastFrame
    && document.querySelector('.rail .who')?.matches('.flying')
    && !document.querySelector('.compiling')?.checkVisibility()"""
"""Whether the page has drawn a frame and has control, and the laws are compiled."""
RESTARTED = "(before) => window.__aftdeck.restarts > before"
DRAWN = "([time, drawn]) => window.__aftdeck.lastFrame.time_s >= time && window.__aftdeck.frames > drawn"
"""Whether the page has drawn more than a number of pictures, and shows this time of the run or a later one."""
START = re.compile(r"^\[initial\.pose\]\n(?:\w.*\n)+|^pose = .*\n", re.MULTILINE)
"""The arm's start in a scenario file: the first match."""


class Picture(NamedTuple):
    """Page of a picture.

    Attributes:
        scenario: built-in scenario.
        above: distance of the end effector from the payload's pin or bar at the start, such as "2 in"; "" for the
            scenario's own start.
        presses: texts of buttons that are pressed, in this order.
        first: whether the browser starts the station for the first time, and shows the opening shot.
    """

    scenario: str
    above: str = ""
    presses: tuple[str, ...] = ()
    first: bool = False


PICTURES = {
    "opening": Picture("first-flight", first=True),
    "scenarios": Picture("first-flight", presses=("First flight",)),
    "guide": Picture("tutorial", above="2 in", presses=("Skip step", "Skip step")),
    "berth": Picture("srms-berth"),
    "capture": Picture(
        "srms-deploy",
        above="2 in",
        presses=("Open the guide", "Skip step", "Enter END EFF", "Close the guide", "Full panel"),
    ),
    "concept": Picture("concept-1972", above="14 in"),
}
"""The pictures by the names of their files."""


def scenario_file(picture: Picture, folder: Path) -> str:
    """Return the scenario of a picture for `aftdeck fly`: a name, or a file in `folder` with another start of the arm.

    Raises:
        ValueError: the built-in file has no start of the expected form.
    """
    if not picture.above:
        return picture.scenario
    start = f'[initial.pose]\ncargo = "payload"\nabove = "{picture.above}"\n'
    inline = f'pose = {{ cargo = "payload", above = "{picture.above}" }}\n'
    text, found = START.subn(
        lambda match: start if match[0].startswith("[") else inline,
        (BUILT_IN / f"{picture.scenario}.toml").read_text(encoding="utf-8"),
        count=1,
    )
    if not found:
        raise ValueError(
            f"{picture.scenario}.toml: found no pose of the arm's start, expected `pose` or [initial.pose]"
        )
    path = folder / f"{picture.scenario}.toml"
    path.write_text(text, encoding="utf-8")
    return str(path)


def open_page(browser: Browser, address: str, picture: Picture) -> Page:
    """Open the page of a picture at a station; wait until it no longer changes by itself.

    The low drawing profile is fast without a graphics card. The restart removes log lines about slow first pictures.
    Buttons are pressed without the pointer, which would show a tooltip, and without the focus, which has a frame.
    """
    width, height = WINDOW
    page = browser.new_page(viewport={"width": width, "height": height})
    page.set_default_timeout(WAIT_MS)
    if not picture.first:
        page.add_init_script(STARTED)
    page.goto(f"{address}?quality=low")
    page.wait_for_function(READY, timeout=COMPILED_MS)
    _wait(page, 0.0)
    restarts = page.evaluate("() => window.__aftdeck.restarts")
    _press(page, "Restart")
    page.wait_for_function(RESTARTED, arg=restarts)
    _wait(page, SETTLED_S)
    page.wait_for_function("() => !document.querySelector('.spine.lit-lately')")
    for name in picture.presses:
        _press(page, name)
        _wait(page, _time(page) + REACTION_S)
    return page


def _press(page: Page, name: str) -> None:
    page.locator(f'button:text-is("{name}")').first.dispatch_event("click")


def _time(page: Page) -> float:
    return float(page.evaluate("() => window.__aftdeck.lastFrame.time_s"))


def _wait(page: Page, time_s: float) -> None:
    drawn = int(page.evaluate("() => window.__aftdeck.frames"))
    page.wait_for_function(DRAWN, arg=[time_s, drawn + 2])
