"""What the pilot does next: a function of what it reads, with the rules that any operator knows from `docs/keys.md`.

Nothing here depends on a scenario. A key that the step does not name is never pressed, except V, which every operator
knows.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, replace

from tests.browser.text_pilot.reading import Part, Reading

RATE = "V"
"""Key between coarse and vernier rates."""
STICK_KEYS = frozenset("WSADQEIKJLUOYN")
"""Keys that move the arm while they are held."""
SLOW_M, FAST_M = 0.3, 0.6
"""Distance [m] below which the pilot changes to vernier rates, and above which it changes back."""
HOLD_S = 1.0
"""Time for which a key is held if the page does not say how long [s]."""
ESCAPE_S = 0.4
"""Press of a key that leads out of a contact [s]."""
_WAITS = re.compile(r"\bwait\b|\bdo not move\b|\bkeep still\b|\bcome to rest\b|\bis closing\b|\bare closing\b", re.I)
_COMMAND = re.compile(r"\b(?P<verb>[Hh]old|[Pp]ress) (?P<key>full stop|comma|Space|[A-Z`])(?=[\s,.;:)]|$)")


@dataclass(frozen=True)
class Go:
    """Go to a button with Tab, and press it with Enter."""

    button: str


@dataclass(frozen=True)
class Press:
    """Press a key, and hold it for some seconds if `seconds` is not 0."""

    key: str
    seconds: float = 0.0


@dataclass(frozen=True)
class Fly:
    """Hold the key of a component until it is gone."""

    part: Part


@dataclass(frozen=True)
class Wait:
    """Wait because of something that the page says."""

    why: str


@dataclass(frozen=True)
class Lost:
    """No idea what to do."""

    why: str


Act = Go | Press | Fly | Wait | Lost


def decide(now: Reading, pressed: frozenset[str] = frozenset()) -> Act:
    """Return what to do next.

    Args:
        now: what the page says.
        pressed: keys that the pilot has pressed since this text appeared.
    """
    if not now.count:
        to_do = commands(replace(now, text=now.welcome))
        if to_do:
            return Press(to_do[0][1], ESCAPE_S)
        return Press("Space", 0.0) if now.begin else Wait("the page to load")
    if now.shut:
        return Go("Open the guide")
    if now.over:
        return Wait("nothing: all steps are past")
    if now.enter:
        return Go(now.enter)
    if now.busy:
        return Wait(now.busy)
    if now.escape:
        return Press(now.escape, ESCAPE_S)
    for verb, key in commands(now):
        if key in STICK_KEYS or key in pressed:
            continue
        return Press(key, hold_of(now, key) if verb == "hold" else 0.0)
    flown = next(iter(in_order(now)), None)
    if pressed - {RATE}:
        return Wait(f"the effect of {', '.join(sorted(pressed - {RATE}))}")
    if _WAITS.search(now.text):
        return Wait(now.text)
    if flown is None:
        return Lost(f"{now.text} [{now.to}]")
    return _at_rate(now, flown)


def commands(now: Reading) -> list[tuple[str, str]]:
    """Return the keys that the text says to press or to hold, each after `press` or `hold`."""
    found = [(match["verb"].lower(), match["key"]) for match in _COMMAND.finditer(now.text)]
    return [(verb, key) for verb, key in found if key != RATE]


def hold_of(now: Reading, key: str) -> float:
    """Return how long a key has to be held [s]."""
    return dict(now.holds).get(key, HOLD_S) + 0.5


def in_order(now: Reading) -> list[Part]:
    """Return the components to fly, in their order.

    Only keys of the step are used. Keys that the text names are the way to the place, and come after the others, which
    line up; but if the text says `first`, they come before them. Rotations come before translations, and large
    components before small ones. Components within the tolerance come last.
    """
    flown = [part for part in now.parts if part.key in dict(now.keys)]
    named = {key: at for at, key in enumerate(_named(now))}
    first = re.search(r"\bfirst\b", now.text) is not None

    def order(part: Part) -> tuple[bool, bool, int, bool, float]:
        is_named = part.key in named
        return (part.near, is_named != first, named.get(part.key, 0), not part.turns, -part.size)

    return sorted(flown, key=order)


def _named(now: Reading) -> list[str]:
    """Return the keys of sticks that the text names."""
    keys = set(dict(now.keys)) & STICK_KEYS
    return [word for word in re.findall(r"(?<![\w.])[A-Z](?=[\s,.;:)]|$)", now.text) if word in keys]


def _at_rate(now: Reading, part: Part) -> Act:
    """Return the flight of a component, or first the change to the rate for it."""
    if part.turns or not now.rate or (RATE not in now.text and RATE not in dict(now.keys)):
        return Fly(part)
    slowly = re.search(r"\bslow(?!, fast)", now.text) is not None
    slow = part.size < (FAST_M if slowly else SLOW_M)
    fast = part.size > FAST_M
    if (slow and now.rate == "Coarse") or (fast and now.rate == "Vernier"):
        return Press(RATE)
    return Fly(part)
