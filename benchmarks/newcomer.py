"""Benchmark of the first start on a machine on which no law is compiled."""

from __future__ import annotations

import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import msgspec

from aftdeck.folders import OWN_CACHE
from aftdeck.station.messages import from_page
from aftdeck.station.messages.frame import Frame
from aftdeck.station.messages.to_page import Readiness
from benchmarks.measure import Figure
from benchmarks.station import flying, next_message, page_of

SCENARIO = "tutorial"
PERIOD_MS = 20.0
"""Control period: a frame is sent in each [ms]."""
AFTER = 5.0
"""Time after the change to compiled laws in which frames are still watched [s]."""


class Size(NamedTuple):
    """Extent of the measurement.

    Attributes:
        cases: names of the cases of `CASES`.
        seconds: longest time for which frames are watched [s].
    """

    cases: tuple[str, ...]
    seconds: float


def _empty(home: Path) -> Path:
    return home / "laws"


def _other_version(home: Path) -> Path:
    """Return a folder with what another version of the laws has left there."""
    other = home / "laws" / "laws-0123456789abcdef" / "aftdeck.kinematics"
    other.mkdir(parents=True)
    (other / "forward.law").write_bytes(b"machine code of another version")
    return home / "laws"


def _not_writable(home: Path) -> Path:
    """Return the name of a file: no folder can be made there."""
    (home / "laws").write_bytes(b"")
    return home / "laws"


CASES: dict[str, Callable[[Path], Path]] = {
    "nothing compiled": _empty,
    "laws of another version": _other_version,
    "no folder for laws": _not_writable,
}
"""Functions that prepare the folder of the laws' machine code; they return its name."""
FULL, TINY = Size(tuple(CASES), 400.0), Size(("nothing compiled",), 4.0)


def newcomer(size: Size) -> list[Figure]:
    """Measure ``aftdeck fly --no-browser`` up to the first motion, and its frames until the laws are compiled."""
    figures = []
    for name in size.cases:
        with tempfile.TemporaryDirectory() as home:
            figures += _start(name, str(CASES[name](Path(home))), size.seconds)
    return figures


class _Seen:
    """What a page sees while it holds a stick."""

    def __init__(self, begin: float) -> None:
        self.begin = begin
        self.moved: float | None = None
        self.compiled: float | None = None
        self.gaps: list[float] = []
        self.failure = ""
        self._first: Frame | None = None
        self._last = begin

    def frame(self, frame: Frame, now: float) -> None:
        if self._first is None:
            self._first = frame
        else:
            self.gaps.append(1e3 * (now - self._last))
        self._last = now
        if self.moved is None and frame.display.poses != self._first.display.poses:
            self.moved = now - self.begin

    def readiness(self, message: Readiness, now: float) -> None:
        self.failure = message.failure
        if message.share is None and not message.waits_for and self._first is not None:
            self.compiled = now - self.begin


def _start(name: str, folder: str, seconds: float) -> list[Figure]:
    """Start the station once, and hold a stick from the welcome on."""
    begin = time.perf_counter()
    with flying(SCENARIO, **{OWN_CACHE: folder}) as address:
        served = time.perf_counter() - begin
        seen = _Seen(begin)
        with page_of(address) as socket:
            sticks = from_page.Sticks(0, (0.2, 0.0, 0.0), (0.0, 0.0, 0.0), 0.0)
            sent = 0.0
            while (now := time.perf_counter()) < begin + seconds:
                if seen.compiled is not None and now > begin + seen.compiled + AFTER:
                    break
                if now > sent + 0.1:
                    sticks, sent = msgspec.structs.replace(sticks, seq=sticks.seq + 1), now
                    socket.send(msgspec.json.encode(sticks).decode())
                message = next_message(socket)
                now = time.perf_counter()
                if isinstance(message, Frame):
                    seen.frame(message, now)
                elif isinstance(message, Readiness):
                    seen.readiness(message, now)
    late = f"not within {seconds:g} s"
    compiled = None if seen.failure else seen.compiled
    why = seen.failure or ("by another process, meanwhile" if compiled is not None else late)
    return [
        Figure(f"{name}: aftdeck fly to its page", served, "s", None, "the address is printed"),
        Figure(
            f"{name}: aftdeck fly to the first motion",
            seen.moved,
            "s",
            6.0,
            late if seen.moved is None else "laws as plain Python",
        ),
        Figure(f"{name}: all laws compiled", compiled, "s", None, why),
        Figure(
            f"{name}: longest time between two frames",
            max(seen.gaps, default=None),
            "ms",
            3 * PERIOD_MS,
            f"{len(seen.gaps)} frames, 20 ms each",
        ),
    ]
