"""Painter of a session: a thread that has pictures in the look of 1972 drawn, while any page shows them.

The thread asks a process (`painting.py`) for pictures of the newest frame and skips the others, so that a slow picture
does not delay the steps.
"""

from __future__ import annotations

import logging
import threading
from collections.abc import Callable, Mapping

import msgspec

from aftdeck.law_change import Progress
from aftdeck.scenario.light import conditions
from aftdeck.scenario.model import Scenario
from aftdeck.station.conversion.polygons_of import Shot, no_polygons
from aftdeck.station.core.step import Step
from aftdeck.station.session.painting import LitFrame, Painting, Sheet, Wanted
from aftdeck.station.session.pictured import Pictured

AT_ONCE = 4
"""Greatest number of pictures that are computed of one frame; if pages show more cameras, these are drawn in turn."""
PREPARING = "Preparing the look of 1972"
"""Beginning of the text on a monitor until the first picture."""
ENDED = "the process that draws has ended; is the memory full?"

_log = logging.getLogger("aftdeck.station")
_encode = msgspec.json.Encoder().encode


class Painter:
    """Thread that has pictures drawn; it starts when a page asks for the first one.

    Attributes:
        drawn: newest picture of each shot, encoded as JSON. Each new picture is a new object.
        newest: newest frame, its light and the number of its step; None before the first frame.
        pictured: frames that pictures show, now or later.
        text: sentence that says why there are no pictures; empty if there are.
        failure: sentence about the error that ended the thread; empty if there was none.
        notify: called in the thread after each round of pictures.
    """

    def __init__(self, scenario: Scenario, start: Callable[[Scenario], Painting] = Painting) -> None:
        self.drawn: Mapping[Shot, bytes] = {}
        self.newest: LitFrame | None = None
        self.pictured = Pictured()
        self.notify: Callable[[], None] = lambda: None
        self._scenario, self._start = scenario, start
        self._lights = {condition.name: condition for condition in conditions()}
        self._wanted: Mapping[Shot, float] = {}
        self.failure = ""
        self.text = f"{PREPARING}."
        self._share: float | None = None
        self._lock = threading.Lock()
        self._fresh = threading.Event()
        self._ready = threading.Event()
        self._closed = False
        self._painting: Painting | None = None
        self._thread: threading.Thread | None = None

    def want(self, wanted: Mapping[Shot, float]) -> None:
        """Set the pictures to draw, each with the aspect of its picture (width divided by height)."""
        with self._lock:
            self._wanted = dict(wanted)
            self._publish({})
        if wanted:
            self.prepare()

    def prepare(self) -> bool:
        """Start the thread and its process; return whether the process can draw."""
        if self._thread is None and not self._closed:
            self._thread = threading.Thread(target=self._run, name="painter", daemon=True)
            self._thread.start()
        return self._ready.is_set()

    def see(self, step: Step) -> None:
        """Draw the frame of a step next, in its light; the pages store its picture until they show it."""
        lit = LitFrame(step.frame, self._lights[step.lighting.condition], step.link.step)
        self.pictured.add(lit, step.link)
        self.show(lit)

    def show(self, lit: LitFrame) -> None:
        """Draw this frame next; without a wanted picture, only keep it."""
        self.newest = lit
        if self._wanted:
            self._fresh.set()

    def sheet(self, camera: str) -> bytes:
        """Return the sheet of a camera in the frame that its picture shows, once `prepare` has returned True.

        Raises:
            InputError: there is no such camera.
            SimulationError: the camera is inside a body, or the bodies cannot be put in order.
            EOFError: the session is closed, or the process has ended.
        """
        lit = self.pictured.of(camera)
        assert self._painting is not None and lit is not None, "the process can draw, and the run has a frame"
        return self._painting.sheet(Sheet(lit, camera))

    def close(self) -> None:
        """End the process, and let the thread end."""
        with self._lock:
            self._closed = True
            painting = self._painting
        if painting is not None:
            painting.close()
        self._fresh.set()

    def _run(self) -> None:
        try:
            painting = self._start(self._scenario)
            with self._lock:
                self._painting, closed = painting, self._closed
            if closed:
                return painting.close()
            painting.wait(self._tell)
            self._share = None
            self._ready.set()
            turn = 0
            while True:
                self._fresh.wait()
                self._fresh.clear()
                if self._closed:
                    return None
                turn = self._draw(painting, turn)
                self.notify()
        except Exception as error:  # any error must reach the monitors
            if self._closed:
                return None
            with self._lock:
                why = ENDED if isinstance(error, EOFError) else error
                self.failure = self.text = f"The look of 1972 has failed: {why}"
                self._publish({})
            self.notify()
            _log.exception("the look of 1972 has failed")

    def _tell(self, progress: Progress) -> None:
        """Show the progress of the compilation in place of pictures."""
        with self._lock:
            share, left = round(progress.share, 2), progress.left_s
            text = f"{PREPARING}: {'a minute or two' if left is None else f'{left:.0f} s'}."
            if (text, share) == (self.text, self._share):
                return
            self.text, self._share = text, share
            self._publish({})
        self.notify()

    def _draw(self, painting: Painting, turn: int) -> int:
        """Have at most `AT_ONCE` pictures drawn, beginning with camera number `turn`; return the next number."""
        wanted, newest = self._wanted, self.newest
        if not wanted or newest is None:
            return 0
        shots = list(wanted)
        count = min(AT_ONCE, len(shots))
        chosen = [shots[(turn + k) % len(shots)] for k in range(count)]
        drawn = painting.pictures(Wanted(newest, {shot: wanted[shot] for shot in chosen}))
        with self._lock:
            self.text = ""
            self._publish(drawn)
        return (turn + count) % len(shots)

    def _publish(self, drawn: Mapping[Shot, bytes]) -> None:
        """Publish new pictures and keep the others that are wanted; if there is a text, it replaces all pictures."""
        if self.text:
            self.drawn = {
                shot: _encode(no_polygons(shot.camera, self.text, share=self._share)) for shot in self._wanted
            }
        else:
            self.drawn = {shot: picture for shot, picture in {**self.drawn, **drawn}.items() if shot in self._wanted}
