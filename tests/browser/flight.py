"""One page of the station, as a test handles it."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import msgspec
from playwright.sync_api import Locator, Page

from aftdeck.station.messages.frame import Frame

WAIT_MS = 60_000
"""The longest wait for anything that a page shall do [ms]; software drawing on a busy machine is slow."""

TURNED = "document.querySelector('.rotary .turned')?.textContent"
"""The mode turned to and not entered, in JavaScript."""
ENTERED = "document.querySelector('.rotary [aria-pressed=true]')?.textContent"
"""The mode that the rotary shows as entered, in JavaScript."""

WHO = "document.querySelector('.rail .who').textContent"
"""Who flies, as the rail says it, in JavaScript."""
NAMING = "!document.querySelector('.choices.naming').hidden"
"""Whether the field for a name is open, in JavaScript."""
TYPING = "document.body.classList.contains('typing')"
"""Whether keys type and do not fly, in JavaScript."""

WATCH = """() => {
    window.shown = false;
    new MutationObserver((_, observer) => {
        if (!(CONDITION)) return;
        window.shown = true;
        observer.disconnect();
    }).observe(document, { attributes: true, characterData: true, childList: true, subtree: true });
}"""
"""Looks after every change of the page whether CONDITION holds, and keeps in `window.shown` that it did."""


class Flight:
    """A page, its keys, and the last frame that all of it shows: pictures, lamps and figures."""

    def __init__(self, page: Page) -> None:
        self.page = page
        self.until("window.__aftdeck?.lastFrame")

    def from_the_start(self) -> Flight:
        """Waits for the sticks to be ours, and puts the scenario back to its first instant."""
        self.until("document.querySelector('.who').textContent.startsWith('You fly') && frame.time_s > 1")
        before = self.script("window.__aftdeck.restarts")
        self.page.get_by_role("button", name="Restart").click()
        self.until(f"window.__aftdeck.restarts > {before}")
        return self

    def frame(self) -> Frame:
        """The last frame shown."""
        return msgspec.convert(self.page.evaluate("window.__aftdeck.lastFrame"), Frame)

    def until(self, condition: str, timeout_ms: float = WAIT_MS) -> Frame:
        """Waits for a JavaScript condition, in which `frame` is the last frame shown; returns the frame that met it.

        What comes and goes by itself may pass unseen on a slow machine: see `shows`.
        """
        expression = (
            f"() => {{ const frame = window.__aftdeck?.lastFrame; return frame && ({condition}) && {{ frame }}; }}"
        )
        return msgspec.convert(self.page.wait_for_function(expression, timeout=timeout_ms).json_value()["frame"], Frame)

    @contextmanager
    def shows(self, condition: str) -> Iterator[None]:
        """Waits for a JavaScript condition of the page's elements to be met by what is done inside, however briefly."""
        self.script(WATCH.replace("CONDITION", condition))
        yield
        self.until("window.shown")

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
        """Turns the mode rotary by its key on the panel; pressed again, the key would enter the mode."""
        self._mode_key(mode).click()
        self.until(f"{TURNED} === '{mode}'")

    def enter(self, mode: str) -> None:
        """Enters a mode by its key on the panel: pressed once it turns the rotary, if need be, again it enters."""
        if self.frame().mode != mode:
            if self.script(TURNED) != mode:
                self.turn_to(mode)
            self._mode_key(mode).click()
        self.until(f"frame.mode === '{mode}' && {ENTERED} === '{mode}'")

    def _mode_key(self, mode: str) -> Locator:
        return self.page.get_by_role("group", name="Mode").get_by_role("button", name=mode, exact=True)

    def give_name(self, name: str) -> None:
        """Types what the person at this page is called, key by key, under the rail's words of who flies."""
        self.page.locator(".rail .who").click()
        self.until(f"{NAMING} && {TYPING}")
        self.page.keyboard.type(name)
        self.press("Enter")

    def press_key(self, name: str) -> None:
        """Presses a key of the desk by its name."""
        self.page.get_by_role("button", name=name, exact=True).click()

    def until_logged(self, text: str) -> None:
        """Waits for an entry of the log: newer ones may have pushed it off the three lines, so that all are opened."""
        more = self.page.locator(".events .more")
        opened = more.get_attribute("aria-expanded") == "false"
        if opened:
            more.dispatch_event("click")  # without the pointer and the focus
        self.page.locator(".log").get_by_text(text).first.wait_for(state="attached")
        if opened:
            more.dispatch_event("click")

    def pad_buttons(self, *pressed: int) -> None:
        """Holds these buttons of the test pad, and no others; the page sees the others go, and each before the next."""
        self.script("window.testPad.buttons.forEach((button) => { button.pressed = false; })")
        self.polled()
        for number in pressed:
            self.script(f"window.testPad.buttons[{number}].pressed = true")
            self.polled()

    def polled(self) -> None:
        """Waits until the page has read its devices: it does so in every frame that it draws."""
        drawn = self.script("window.__aftdeck.frames")
        self.until(f"window.__aftdeck.frames > {drawn + 1}")

    def pad_axes(self, *axes: float) -> None:
        """Puts the test pad's four axes."""
        self.script(f"window.testPad.axes = {list(axes)}")

    def until_lit(self, lamp: str) -> None:
        """Waits for a lamp of the spine."""
        self.page.locator(".lamp.caution", has_text=lamp).wait_for()


def shows(monitor: int, *names: str) -> str:
    """In JavaScript: a monitor's pictures have these cameras' names, from the left."""
    pictures = f"document.querySelectorAll('.monitor')[{monitor}].querySelectorAll('.picture .name b')"
    return f"[...{pictures}].map((name) => name.textContent).join() === '{','.join(names)}'"
