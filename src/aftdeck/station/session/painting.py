"""Process that draws pictures of a scenario, so that drawing delays no control step.

Pictures and control steps need the same interpreter lock if one process makes both: a sheet would delay some steps by a
tenth of a second.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cached_property
from multiprocessing.connection import Connection
from typing import NamedTuple

import msgspec

from aftdeck import law_cache
from aftdeck.law import are_compiled
from aftdeck.law_change import Counter, Progress
from aftdeck.law_folder import compiled_before
from aftdeck.scenario.light import LightCondition
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Frame
from aftdeck.station.conversion.polygons_of import PolygonPictures, Shot
from aftdeck.station.session.answering import Answering, answer_all
from aftdeck.visual.diagram import sheet
from aftdeck.visual.scene import VisualScene
from aftdeck.visual.warm import FILES, warm_up


class LitFrame(NamedTuple):
    """Frame, the light in it, and the number that its pictures have (`Polygons.step`)."""

    frame: Frame
    light: LightCondition
    step: int


class Wanted(NamedTuple):
    """Request for pictures of a frame in the look of 1972, with the aspect of each picture."""

    lit: LitFrame
    aspects: Mapping[Shot, float]


class Sheet(NamedTuple):
    """Request for the sheet that shows what decides the order of a camera's picture."""

    lit: LitFrame
    camera: str


class Painting:
    """Process that draws for one session; its methods may be called from any thread."""

    def __init__(self, scenario: Scenario) -> None:
        """Start the process."""
        self._process = Answering(paint, scenario)

    @property
    def pid(self) -> int:
        """Number of the process in the operating system."""
        return self._process.pid

    def wait(self, tell: Callable[[Progress], None]) -> None:
        """Wait until the process can draw, which may take minutes on the first start; `tell` is called meanwhile.

        Raises:
            EOFError: the process has ended; so do the other methods.
        """
        self._process.messages(tell)

    def pictures(self, wanted: Wanted) -> dict[Shot, bytes]:
        """Return pictures, encoded as JSON."""
        return {shot: picture for shot, picture in zip(wanted.aspects, self._process.ask(wanted), strict=True)}

    def sheet(self, wanted: Sheet) -> bytes:
        """Return a sheet as SVG.

        Raises:
            InputError: there is no such camera.
            SimulationError: the camera is inside a body, or the bodies cannot be put in order.
        """
        svg: bytes
        (svg,) = self._process.ask(wanted)
        return svg

    def close(self) -> None:
        """End the process; a method that waits for it then raises an EOFError."""
        self._process.close()


class Drawer:
    """Pictures of a scenario, in the process that draws them."""

    def __init__(self, scenario: Scenario) -> None:
        self._scenario = scenario
        self._encode = msgspec.json.Encoder().encode

    @cached_property
    def _pictures(self) -> PolygonPictures:
        return PolygonPictures(self._scenario)

    @cached_property
    def _scene(self) -> VisualScene:
        return VisualScene(self._scenario)

    def answer(self, request: Wanted | Sheet) -> list[bytes]:
        """Return what a request asks for.

        Raises:
            InputError: there is no such camera.
            SimulationError: a sheet cannot be drawn.
        """
        frame, light, step = request.lit
        if isinstance(request, Sheet):
            return [sheet(self._scene, frame, request.camera, light, self._scenario.title).encode()]
        aspects = request.aspects.items()
        return [self._encode(self._pictures.of(frame, shot, aspect, light, step)) for shot, aspect in aspects]


def paint(pipe: Connection, scenario: Scenario) -> None:
    """Compile the laws of pictures if this was never done; then answer requests. What the process runs."""
    if not compiled_before("aftdeck.visual") and are_compiled():
        counter = Counter(FILES, pipe.send)
        law_cache.observers.append(lambda _: counter.add_one())
        warm_up()
        law_cache.observers.clear()
    drawer = Drawer(scenario)
    pipe.send(None)
    answer_all(pipe, drawer.answer)
