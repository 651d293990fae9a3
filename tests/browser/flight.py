"""A page of the station, with the actions and waits of the tests."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import msgspec
from playwright.sync_api import Locator, Page, TimeoutError

from aftdeck.station.messages.frame import Frame
from tests.waits import WAIT_S

WAIT_MS = int(1000.0 * WAIT_S)
"""Longest wait for an action of a page [ms]; software drawing on a busy machine is slow."""

TURNED = "document.querySelector('.rotary .turned')?.textContent"
"""JavaScript: mode to which the rotary is turned; undefined if this mode is already entered."""
ENTERED = "document.querySelector('.rotary [aria-pressed=true]')?.textContent"
"""JavaScript: mode that the rotary shows as entered."""

WHO = "document.querySelector('.rail .who').textContent"
"""JavaScript: the rail's text about the operator."""
FLIES = "document.querySelector('.rail .who').matches('.flying')"
"""JavaScript condition: the page is in control."""
OBSERVES = "document.querySelector('.rail .who').matches(':not(.flying, .lost)')"
"""JavaScript condition: the page observes."""
NAMING = "!document.querySelector('.choices.naming').hidden"
"""JavaScript condition: the field for the name is open."""
TYPING = "document.body.classList.contains('typing')"
"""JavaScript condition: keys write text, and do not move the arm."""
TITLE = "document.querySelector('.rail .scenario > button').textContent"
"""JavaScript: text of the button with the scenario's title."""
LOGGED = "[...document.querySelectorAll('.log li:not(.hint)')].map((line) => line.dataset.kind)"
"""JavaScript: kind of each log line that the page shows, newest line first."""

WATCH = """() => {
    window.shown = false;
    new MutationObserver((_, observer) => {
        if (!(CONDITION)) return;
        window.shown = true;
        observer.disconnect();
    }).observe(document, { attributes: true, characterData: true, childList: true, subtree: true });
}"""
"""Check CONDITION after every change of the page; set `window.shown` when it is true for the first time."""

STATE = f"""() => {{
    const {{ lastFrame, frames, restarts }} = window.__aftdeck ?? {{}};
    const {{ time_s, translation, rotation, mode, position_hold, rate_hold }} = lastFrame ?? {{}};
    const state = {{ time_s, translation, rotation, mode, position_hold, rate_hold, frames, restarts }};
    return {{ ...state, who: {WHO}, hidden: document.hidden, body: document.body.className }};
}}"""
"""JavaScript: what the page shows, for the message of a failed test."""


class Flight:
    """A page, its keys, and the last frame that pictures, lamps and read-outs show."""

    def __init__(self, page: Page) -> None:
        self.page = page
        task = self.until("window.__aftdeck?.lastFrame").display.task
        self._guided = task is not None and task.debrief is not None
        """Whether the page has opened the guide, because another test had completed the task."""

    def from_the_start(self) -> Flight:
        """Wait until this page has control, then restart the scenario."""
        self.until(f"{FLIES} && frame.time_s > 1")
        before = self.script("window.__aftdeck.restarts")
        self.page.get_by_role("button", name="Restart").click()
        self.until(f"window.__aftdeck.restarts > {before}")
        if self._guided:
            self._guided = False
            self.page.reload()
            self.until(f"{FLIES} && window.__aftdeck.frames > 2")
        return self

    def frame(self) -> Frame:
        """Return the last frame shown."""
        return msgspec.convert(self.page.evaluate("window.__aftdeck.lastFrame"), Frame)

    def until(self, condition: str, timeout_ms: float = WAIT_MS) -> Frame:
        """Wait for a JavaScript condition, in which `frame` is the last frame shown; return that frame.

        `until` may miss a state that lasts only a short time; use `shows` for such a state.
        """
        expression = (
            f"() => {{ const frame = window.__aftdeck?.lastFrame; return frame && ({condition}) && {{ frame }}; }}"
        )
        try:
            found = self.page.wait_for_function(expression, timeout=timeout_ms)
        except TimeoutError as error:
            raise AssertionError(f"not within {timeout_ms:g} ms: {condition}; {self._state()}") from error
        return msgspec.convert(found.json_value()["frame"], Frame)

    def _state(self) -> str:
        """Return what the page shows now, and its errors so far, for the message of a failed wait."""
        seen = self.script(STATE)
        return f"{seen}, errors of the page: {[*map(str, self.page.page_errors())]}"

    @contextmanager
    def shows(self, condition: str) -> Iterator[None]:
        """Wait until a JavaScript condition was true, however briefly, since the start of the `with` block."""
        self.script(WATCH.replace("CONDITION", condition))
        yield
        self.until("window.shown")

    def script(self, text: str) -> Any:  # a result of JavaScript has no type
        """Evaluate JavaScript in the page."""
        return self.page.evaluate(text)

    def hold(self, key: str) -> None:
        """Press a key and hold it."""
        self.page.keyboard.down(key)

    def release(self, key: str) -> None:
        """Release a key."""
        self.page.keyboard.up(key)

    def press(self, *keys: str) -> None:
        """Press and release keys one after the other."""
        for key in keys:
            self.page.keyboard.press(key)

    def turn_to(self, mode: str) -> None:
        """Turn the mode rotary by its key on the panel. A second press of the key would enter the mode."""
        self._mode_key(mode).click()
        self.until(f"{TURNED} === '{mode}'")

    def enter(self, mode: str) -> None:
        """Enter a mode by its key on the panel: the first press turns the rotary, the second enters the mode."""
        if self.frame().mode != mode:
            if self.script(TURNED) != mode:
                self.turn_to(mode)
            self._mode_key(mode).click()
        self.until(f"frame.mode === '{mode}' && {ENTERED} === '{mode}'")

    def _mode_key(self, mode: str) -> Locator:
        return self.page.get_by_role("group", name="Mode").get_by_role("button", name=mode, exact=True)

    def give_name(self, name: str) -> None:
        """Type the name of this page's user into the field in the rail, key by key."""
        self.page.locator(".rail .who").click()
        self.until(f"{NAMING} && {TYPING}")
        self.page.keyboard.type(name)
        self.press("Enter")

    def resize(self, width: int, height: int) -> None:
        """Resize the window, and wait until the page is drawn in the new size."""
        self.page.set_viewport_size({"width": width, "height": height})
        drawn = self.script("window.__aftdeck.frames")
        self.until(f"innerWidth === {width} && window.__aftdeck.frames > {drawn + 2}")

    def choose(self, title: str) -> None:
        """Load a scenario from the page's list, and wait for its first pictures."""
        self.page.locator(".rail .scenario > button").click()
        self.page.locator(".scenarios button").filter(has=self.page.get_by_text(title, exact=True)).click()
        leave = self.page.get_by_role("button", name="Leave and fly it")
        self.until(f"{TITLE}.includes('{title}') || !document.querySelector('.leaving').hidden")
        if leave.is_visible():
            leave.click()
        self.until(f"{TITLE}.includes('{title}') && window.__aftdeck.frames > 2")

    def press_key(self, name: str) -> None:
        """Press a button of the page by its name."""
        self.page.get_by_role("button", name=name, exact=True).click()

    @contextmanager
    def logs(self, kind: str) -> Iterator[None]:
        """Wait until the actions of the `with` block have added a line of this kind to the log."""
        lines = f"document.querySelectorAll('.log.wrapped [data-kind=\"{kind}\"]').length"
        with self._whole_log():
            before = self.script(lines)
        yield
        with self._whole_log():
            self.until(f"{lines} > {before}")

    def newest(self, kind: str) -> str:
        """Return the text of the newest line of this kind in the whole log."""
        with self._whole_log():
            return self.page.locator(f".log.wrapped [data-kind='{kind}']").first.inner_text()

    @contextmanager
    def _whole_log(self) -> Iterator[None]:
        """Open the whole log inside the `with` block, because otherwise only the last three lines are on the page."""
        more = self.page.locator(".events .more")
        opened = more.get_attribute("aria-expanded") == "false"
        if opened:
            more.dispatch_event("click")  # does not move the pointer or the focus
        yield
        if opened:
            more.dispatch_event("click")

    def pad_buttons(self, *pressed: int) -> None:
        """Hold only these buttons of the test pad. The page reads the releases first, then each press separately."""
        self.script("window.testPad.buttons.forEach((button) => { button.pressed = false; })")
        self.polled()
        for number in pressed:
            self.script(f"window.testPad.buttons[{number}].pressed = true")
            self.polled()

    def polled(self) -> None:
        """Wait until the page has read its devices, which it does for every picture."""
        drawn = self.script("window.__aftdeck.frames")
        self.until(f"window.__aftdeck.frames > {drawn + 1}")

    def pad_axes(self, *axes: float) -> None:
        """Set the four axes of the test pad."""
        self.script(f"window.testPad.axes = {list(axes)}")

    def until_lit(self, lamp: str) -> None:
        """Wait until a lamp of the spine is lit."""
        self.page.locator(".lamp.caution", has_text=lamp).wait_for()


def shows(monitor: int, *names: str) -> str:
    """JavaScript condition: a monitor shows the pictures of these cameras, from left to right."""
    pictures = f"document.querySelectorAll('.monitor')[{monitor}].querySelectorAll('.picture .name b')"
    return f"[...{pictures}].map((name) => name.textContent).join() === '{','.join(names)}'"
