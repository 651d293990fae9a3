"""Pictures of a recording in the look of 1972, drawn by a process of their own."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from threading import Lock, Thread

import msgspec

from aftdeck.errors import AftdeckError
from aftdeck.law_change import Progress
from aftdeck.recording.bundle import scenario_of
from aftdeck.recording.reader import Recording
from aftdeck.scenario.light import condition_named
from aftdeck.station.conversion.polygons_of import Shot, no_polygons
from aftdeck.station.playback.lit import Lit
from aftdeck.station.session.painter import ENDED, PREPARING
from aftdeck.station.session.painting import LitFrame, Painting, Wanted


class ReplayPainter:
    """Draws frames of one recording; the process starts with the first picture, and ends with `close`."""

    def __init__(self, path: Path) -> None:
        """Draw frames of the recording `path`."""
        self._path = path
        self._lock = Lock()
        self._painting: Painting | None = None
        self._thread: Thread | None = None
        self._text = f"{PREPARING}."
        self._share: float | None = None
        self._closed = False

    def pictures(self, lit: Lit, aspects: dict[Shot, float]) -> list[bytes]:
        """Return the pictures of a frame, encoded as JSON; until the process can draw, texts that say so.

        May be called from any thread.
        """
        with self._lock:
            if self._thread is None and not self._closed:
                self._thread = Thread(target=self._prepare, name="replay painter", daemon=True)
                self._thread.start()
            painting, text, share = self._painting, self._text, self._share
        if painting is not None and not text:
            try:
                frame = LitFrame(lit.frame, condition_named(lit.condition), lit.frame.tick)
                return list(painting.pictures(Wanted(frame, aspects)).values())
            except EOFError:
                text, share = f"The look of 1972 has failed: {ENDED}", None
        return [msgspec.json.encode(no_polygons(shot.camera, text, share=share)) for shot in aspects]

    def close(self) -> None:
        """End the process."""
        with self._lock:
            self._closed, painting = True, self._painting
        if painting is not None:
            painting.close()

    def _prepare(self) -> None:
        try:
            painting = Painting(scenario_of(Recording(self._path).opening))
            with self._lock:
                self._painting, closed = painting, self._closed
            if closed:
                return painting.close()
            painting.wait(self._tell)
            self._say("", None)
        except (AftdeckError, OSError, EOFError) as error:
            self._say(f"The look of 1972 has failed: {ENDED if isinstance(error, EOFError) else error}", None)

    def _tell(self, progress: Progress) -> None:
        left = progress.left_s
        self._say(f"{PREPARING}: {'a minute or two' if left is None else f'{left:.0f} s'}.", round(progress.share, 2))

    def _say(self, text: str, share: float | None) -> None:
        with self._lock:
            self._text, self._share = text, share


def joined(pictures: Sequence[bytes]) -> bytes:
    """Return JSON values as a JSON array."""
    return b"[" + b",".join(pictures) + b"]"
