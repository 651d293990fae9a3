"""The pilot's loop: it reads the page, decides, and presses keys until all steps are past."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field, replace

from playwright.sync_api import Page, TimeoutError

from tests.browser.text_pilot.decide import STICK_KEYS, Act, Fly, Go, Lost, Press, Wait, decide
from tests.browser.text_pilot.reading import Part, Reading, read
from tests.browser.text_pilot.snapshot import parse

CODES = {"full stop": ".", "comma": ",", "grave accent": "`"}
"""Keys whose spoken name is not that of playwright."""
MOST_TABS = 120
"""Most presses of Tab on the way to a button."""
PATIENCE_S = 60.0
"""Longest wait for something that the page says, and for the effect of a key [s]."""
BACK = dict(zip("WSADQEIKJLUO", "SWDAEQKILJOU", strict=True))
"""Opposite of each key that moves the arm."""
BACK_S = 1.0
"""Press of a key that backs out of a contact [s]."""
BLIND_S = 2.0
"""Longest wait for a look at the page while a key is held; then the key is released [s]."""
STUCK_S = 20.0
"""Longest hold of a key without an effect [s]."""
FULL_S, RETURN_S = 0.35, 0.15
"""Time in which a held key reaches full deflection, and from there zero after its release [s]; `docs/keys.md`."""
FIRST_LAG_S, MOST_LAG_S = 2.0, 15.0
"""Time from a look at the page to the end of the motion [s]: as expected at first, and the longest."""
WINDOW_S = 2.0
"""Time over which the present speed is measured [s]."""
SHORT_S = 1.0
"""Longest press without a look at the page [s]."""
LEAST_S = 0.06
"""Shortest press [s]."""
UNKNOWN_S = (0.2, 0.8)
"""First press for a small and for a large motion, whose speed is not known [s]."""
SLOWEST = 0.01
"""Speed after a press without an effect [m/s, deg/s]."""
SMALL = (0.1, 3.0)
"""Translation [m] and rotation [deg] that count as small."""


Kind = tuple[str, str, str]
"""Kind of motion: axis, rate and place. Each has its own speed and lag."""


@dataclass
class Report:
    """Figures of a run.

    Attributes:
        steps: title of each completed step, with the time at which it was completed [s].
        result: grade and figures, as the page shows them.
        presses: number of key presses.
        lost: texts with which the pilot did not know what to do.
        complete: whether the page says that all steps are done.
    """

    steps: list[tuple[str, float]] = field(default_factory=list)
    result: str = ""
    presses: int = 0
    lost: list[str] = field(default_factory=list)
    complete: bool = False


class Pilot:
    """A pilot at a page.

    Attributes:
        report: figures so far.
    """

    def __init__(self, page: Page, tell: bool = False, seen: Callable[[], None] | None = None) -> None:
        self.report = Report()
        self._page, self._tell, self._seen = page, tell, seen
        self._speeds: dict[Kind, float] = {}
        self._lags: dict[Kind, float] = {}
        self._clock, self._last = 0.0, ""  # the last key with an effect

    def fly(self, limit_s: float) -> Report:
        """Fly the task until all steps are past, at most for this real time [s]."""
        end, text, pressed, since = time.monotonic() + limit_s, ("", ""), frozenset[str](), time.monotonic()
        before = Reading()
        while time.monotonic() < end:
            now = self._look()
            self._note(before, now)
            before = now
            if self._seen is not None:
                self._seen()
            if now.over and now.result:
                break  # the result appears with the next frame
            if (now.title, _plain(now.text)) != text:
                text, pressed, since = (now.title, _plain(now.text)), frozenset(), time.monotonic()
            if now.busy:
                since = time.monotonic()
            act = decide(now, pressed)
            if isinstance(act, Wait) and time.monotonic() > since + PATIENCE_S:
                act = Lost(f"waited in vain for {act.why}")
            if isinstance(act, Press) and act.key not in STICK_KEYS:
                pressed |= {act.key}
            if isinstance(act, Lost):
                self._lose(act.why)
                pressed, since = frozenset(), time.monotonic()
            self._say(f"{self._clock:7.2f} {now.count} {now.title}: {act}")
            self._do(act, now)
        self.report.complete = before.count.startswith("All ")
        self.report.result = before.result
        return self.report

    def _do(self, act: Act, now: Reading) -> None:
        match act:
            case Go(button):
                self._go(button)
            case Press(key, seconds):
                with self._held(key):
                    time.sleep(seconds)
                time.sleep(0.3)
            case Fly(part):
                self._fly(part, now)
            case Wait() | Lost():
                time.sleep(0.5)

    def _fly(self, part: Part, now: Reading) -> None:
        """Hold the key of a component; release it in time for the motion to end where the component is zero."""
        kind = (part.axis, now.rate, now.to.split(":")[0])
        known = self._speeds.get(kind)
        if known is None or part.size < known * SHORT_S:
            self._tap(part, now, kind, known)
            return
        speed = known
        seen, stuck = [(time.monotonic(), part.size)], False
        with self._held(part.key):
            while True:
                try:
                    then = self._look_at_guide(BLIND_S)
                except TimeoutError:
                    break
                there, act = then.part(part.key), decide(replace(then, rate=now.rate, holds=now.holds))
                if then.step != now.step or there is None or not isinstance(act, Fly):
                    break
                self._say(f"        {part.key}: {there.size:.2f} left, speed {speed:.3f}")
                if there.size < seen[-1][1]:
                    seen.append((time.monotonic(), there.size))
                    speed = _speed(seen, speed)
                if time.monotonic() > seen[-1][0] + STUCK_S:
                    self._lose(f"{part.key} has no effect; {self._look().alerts}")
                    stuck = True
                    break
                if kind not in self._lags and there.size < part.size / 2:
                    break  # half-way, to learn how far the motion goes on
                if there.size <= speed * self._lags.get(kind, FIRST_LAG_S):
                    break
        if stuck and self._last in BACK:  # a contact may hold the arm: back out on the way by which it came
            self._do(Press(BACK[self._last], BACK_S), now)
        if not stuck:
            self._last = part.key
        at_rest = self._settle(kind)
        self._speeds[kind] = speed
        left = _left(part, at_rest)
        if at_rest.step == now.step and left is not None:
            went_on = seen[-1][1] - left
            lag = self._lags.get(kind, FIRST_LAG_S)
            self._lags[kind] = min(MOST_LAG_S, max(0.5 * lag, 1.2 * went_on / speed, RETURN_S))

    def _tap(self, part: Part, now: Reading, kind: Kind, speed: float | None) -> None:
        """Press a key for a short time, and learn the speed from its effect."""
        unknown_s = UNKNOWN_S[part.size > SMALL[part.turns]]
        seconds = unknown_s if speed is None else max(LEAST_S, 0.8 * _press_s(part.size / speed))
        with self._held(part.key):
            time.sleep(seconds)
        then = self._settle(kind)
        left = _left(part, then)
        if then.step != now.step or left is None:
            return
        moved = part.size - left
        if moved > 0.0:
            found = moved / _effective_s(seconds)
            self._speeds[kind] = found if speed is None else 0.5 * (speed + found)
        else:
            self._speeds[kind] = SLOWEST if speed is None else 0.7 * speed

    def _settle(self, kind: Kind) -> Reading:
        """Wait until the remaining motion does not change; return what the guide says then."""
        still_s = 0.4 + self._lags.get(kind, 0.0) / 3
        before, since, end = self._look_at_guide(), time.monotonic(), time.monotonic() + MOST_LAG_S
        while time.monotonic() < min(since + still_s, end):
            time.sleep(0.1)
            now = self._look_at_guide()
            if [part.size for part in now.parts] != [part.size for part in before.parts]:
                before, since = now, time.monotonic()
        return before

    def _go(self, button: str) -> None:
        """Press Tab until a button has the focus, then Enter."""
        for _ in range(MOST_TABS):
            snapshot = self._page.locator("body").aria_snapshot(mode="ai")  # names the element in focus
            focused = [node for node in parse(snapshot).walk() if "active" in node.states]
            if any(node.role == "button" and node.name == button for node in focused):
                self._press("Enter")
                time.sleep(0.5)
                return
            self._press("Shift+Tab" if button.startswith("Enter") else "Tab")
        self._lose(f"Tab does not reach the button {button}")

    @contextmanager
    def _held(self, key: str) -> Iterator[None]:
        code = CODES.get(key, key.lower() if len(key) == 1 else key)
        self.report.presses += 1
        self._page.keyboard.down(code)
        try:
            yield
        finally:
            self._page.keyboard.up(code)

    def _press(self, key: str) -> None:
        self.report.presses += 1
        self._page.keyboard.press(key)

    def _look(self) -> Reading:
        """Read the whole page."""
        return read(self._page.locator("body").aria_snapshot())

    def _look_at_guide(self, limit_s: float = PATIENCE_S) -> Reading:
        """Read only the guide, which takes less time.

        Raises:
            TimeoutError: the page has not answered in this time.
        """
        guide = self._page.get_by_role("region", name="Guide", exact=True)
        return read(guide.aria_snapshot(timeout=limit_s * 1000.0))

    def _note(self, before: Reading, now: Reading) -> None:
        """Note the completion of a step."""
        self._clock = now.clock or self._clock
        if before.count and now.step != before.step and not before.shut:
            skipped = _number(now) - _number(before) - 1
            also = f" and the next {skipped}" if skipped > 0 else ""
            self.report.steps.append((before.title + also, self._clock))

    def _lose(self, why: str) -> None:
        if [_plain(each) for each in self.report.lost[-1:]] == [_plain(why)]:
            return
        self._say(f"no idea: {why}")
        self.report.lost.append(why)

    def _say(self, words: str) -> None:
        if self._tell:
            print(words, flush=True)


def _left(part: Part, now: Reading) -> float | None:
    """Return how much of a component is left, below zero if it was overshot; None if the page does not have it."""
    there = next((each for each in now.parts if each.axis == part.axis), None)
    if there is None:
        return None
    return there.size if there.stick == part.stick else -there.size


def _speed(seen: list[tuple[float, float]], known: float) -> float:
    """Return the present speed, from times and sizes; at first the known speed."""
    time_s, size = seen[-1]
    then = next((each for each in reversed(seen) if each[0] <= time_s - WINDOW_S), seen[0])
    elapsed = time_s - then[0]
    newest = (seen[-2][1] - size) / max(time_s - seen[-2][0], 0.4)
    return known if elapsed < 0.8 else max(0.5 * known, (then[1] - size) / elapsed, newest)


def _number(now: Reading) -> int:
    """Return the number of the step; 0 if all are past."""
    digits = now.count.partition(" ")[0]
    return int(digits) if digits.isdigit() and not now.over else 0


def _press_s(effective: float) -> float:
    """Return how long to press a key for the same motion as full deflection for `effective` seconds [s]."""
    low, high = 0.0, effective + FULL_S
    for _ in range(20):
        middle = (low + high) / 2
        low, high = (middle, high) if _effective_s(middle) < effective else (low, middle)
    return high


def _effective_s(seconds: float) -> float:
    """Return the time at full deflection that moves as far as a press of some seconds, with its two ramps [s]."""
    peak = min(1.0, seconds / FULL_S)
    return max(0.0, seconds - FULL_S) + peak * peak * (FULL_S + RETURN_S) / 2


def _plain(text: str) -> str:
    """Return a text without its numbers, which change in each frame."""
    return "".join(letter for letter in text if not letter.isdigit() and letter not in ".−-")
