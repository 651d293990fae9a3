"""Painter of a session: a thread that computes pictures in the look of 1972, while any page shows them.

The thread draws the newest frame and skips the others, so that a slow picture does not delay the steps.
"""

from __future__ import annotations

import logging
import subprocess
import threading
from collections.abc import Callable, Mapping

import msgspec

from aftdeck.scenario.light import LightCondition
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Frame
from aftdeck.station.conversion.polygons_of import PolygonPictures, no_polygons
from aftdeck.station.session.compiling import start_to_compile

AT_ONCE = 4
"""Greatest number of pictures that are computed of one frame; if pages show more cameras, these are drawn in turn."""
PREPARING = "Preparing the look of 1972. The first time takes a minute or two."
"""Text on a monitor until the first picture."""

_log = logging.getLogger("aftdeck.station")
_encode = msgspec.json.Encoder().encode


class Painter:
    """Thread that computes pictures; it starts when a page asks for the first one.

    Attributes:
        drawn: newest picture of each camera, encoded as JSON. Each new picture is a new object.
        newest: newest frame, and the light in it; None before the first frame.
        failure: sentence about the error that ended the thread; empty if there was none.
        notify: called in the thread after each round of pictures.
    """

    def __init__(self, scenario: Scenario, make: Callable[[Scenario], PolygonPictures] = PolygonPictures) -> None:
        self.drawn: Mapping[str, bytes] = {}
        self.newest: tuple[Frame, LightCondition] | None = None
        self.notify: Callable[[], None] = lambda: None
        self._scenario, self._make = scenario, make
        self._wanted: Mapping[str, float] = {}
        self.failure = ""
        self._text = PREPARING
        self._lock = threading.Lock()
        self._fresh = threading.Event()
        self._compiled = threading.Event()
        self._closed = threading.Event()
        self._compiler: subprocess.Popen[bytes] | None = None
        self._thread: threading.Thread | None = None

    def want(self, wanted: Mapping[str, float]) -> None:
        """Set the cameras to draw, each with the aspect of its picture (width divided by height)."""
        with self._lock:
            self._wanted = dict(wanted)
            self._publish({})
        if wanted:
            self.prepare()

    def prepare(self) -> bool:
        """Start the thread, which first compiles the laws of pictures; return whether they are compiled."""
        if self._thread is None and not self._closed.is_set():
            self._thread = threading.Thread(target=self._run, name="painter", daemon=True)
            self._thread.start()
        return self._compiled.is_set()

    def show(self, frame: Frame, light: LightCondition) -> None:
        """Draw this frame next, in this light; without a wanted picture, only keep it."""
        self.newest = frame, light
        if self._wanted:
            self._fresh.set()

    def close(self) -> None:
        """Let the thread end; do not wait for it, because it may load laws."""
        self._closed.set()
        if self._compiler is not None:
            self._compiler.kill()
        self._fresh.set()

    def _run(self) -> None:
        try:
            self._compiler = start_to_compile()
            if self._compiler is not None:
                self._compiler.wait()
            if self._closed.is_set():
                return
            self._compiled.set()
            pictures, turn = self._make(self._scenario), 0
            while True:
                self._fresh.wait()
                self._fresh.clear()
                if self._closed.is_set():
                    return
                turn = self._draw(pictures, turn)
                self.notify()
        except Exception as error:  # any error must reach the monitors
            with self._lock:
                self.failure = self._text = f"The look of 1972 has failed: {error}"
                self._publish({})
            self.notify()
            _log.exception("the look of 1972 has failed")

    def _draw(self, pictures: PolygonPictures, turn: int) -> int:
        """Compute at most `AT_ONCE` pictures, beginning with camera number `turn`; return the next number."""
        wanted, newest = self._wanted, self.newest
        if not wanted or newest is None:
            return 0
        (frame, light), names, drawn = newest, list(wanted), {}
        count = min(AT_ONCE, len(names))
        for name in [names[(turn + k) % len(names)] for k in range(count)]:
            drawn[name] = _encode(pictures.of(frame, name, wanted[name], light))
        with self._lock:
            self._text = ""
            self._publish(drawn)
        return (turn + count) % len(names)

    def _publish(self, drawn: Mapping[str, bytes]) -> None:
        """Publish new pictures and keep the others that are wanted; if there is a text, it replaces all pictures."""
        if self._text:
            self.drawn = {name: _encode(no_polygons(name, self._text)) for name in self._wanted}
        else:
            self.drawn = {name: picture for name, picture in {**self.drawn, **drawn}.items() if name in self._wanted}
