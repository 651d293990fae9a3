"""One page of the station, as a test handles it."""

from __future__ import annotations

from typing import Any

import msgspec
from playwright.sync_api import Locator, Page

from aftdeck.station.protocol import Frame

WAIT_MS = 20_000
"""The longest wait for anything that a page shall do [ms]; software drawing on a busy machine is slow."""

TURNED = "document.querySelector('.rotary .turned')?.textContent"
"""The mode turned to and not entered, in JavaScript."""
ENTERED = "document.querySelector('.rotary [aria-pressed=true]')?.textContent"
"""The mode that the rotary shows as entered, in JavaScript."""


class Flight:
    """A page, its keys, and the last frame that it has drawn."""

    def __init__(self, page: Page) -> None:
        self.page = page
        page.set_default_timeout(WAIT_MS)
        self.until("window.__aftdeck?.lastFrame")

    def from_the_start(self) -> Flight:
        """Waits for the sticks to be ours, and puts the scenario back to its first instant."""
        self.until("document.querySelector('.who').textContent.startsWith('You fly') && frame.time_s > 1")
        before = self.frame().tick
        self.page.get_by_role("button", name="Restart").click()
        self.until(f"frame.tick < {before} && {ENTERED} === frame.mode")
        return self

    def frame(self) -> Frame:
        """The last frame drawn."""
        return msgspec.convert(self.page.evaluate("window.__aftdeck.lastFrame"), Frame)

    def until(self, condition: str, timeout_ms: float = WAIT_MS) -> None:
        """Waits for a JavaScript condition, in which `frame` is the last frame drawn."""
        expression = f"() => {{ const frame = window.__aftdeck?.lastFrame; return {condition}; }}"
        self.page.wait_for_function(expression, timeout=timeout_ms)

    def script(self, text: str) -> Any:  # what a page returns has no type
        """Evaluates JavaScript in the page."""
        return self.page.evaluate(text)

    def hold(self, key: str) -> None:
        """Presses a key and keeps it down."""
        self.page.keyboard.down(key)

    def release(self, key: str) -> None:
        """Lets go of a key."""
        self.page.keyboard.up(key)

    def press(self, *keys: str) -> None:
        """Presses and lets go of keys, one after the other."""
        for key in keys:
            self.page.keyboard.press(key)

    def turn_to(self, mode: str) -> None:
        """Turns the mode rotary by its key on the panel."""
        self._mode_key(mode).click()
        self.until(f"{TURNED} === '{mode}'")

    def enter(self, mode: str) -> None:
        """Enters a mode by its key on the panel: pressed once it turns the rotary, again it enters."""
        if self.frame().mode != mode:
            self.turn_to(mode)
            self._mode_key(mode).click()
        self.until(f"frame.mode === '{mode}' && {ENTERED} === '{mode}'")

    def _mode_key(self, mode: str) -> Locator:
        return self.page.get_by_role("group", name="Mode").get_by_role("button", name=mode, exact=True)

    def press_key(self, name: str) -> None:
        """Presses a key of the desk by its name."""
        self.page.get_by_role("button", name=name, exact=True).click()

    def until_logged(self, text: str) -> None:
        """Waits for a line of the log."""
        self.page.locator(".log").get_by_text(text).first.wait_for()

    def pad_axes(self, *axes: float) -> None:
        """Puts the test pad's four axes."""
        self.script(f"window.testPad.axes = {list(axes)}")

    def until_lit(self, lamp: str) -> None:
        """Waits for a lamp of the spine."""
        self.page.locator(".lamp.caution", has_text=lamp).wait_for()
