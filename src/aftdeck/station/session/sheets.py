"""Sheets that show what decides the order of a camera's picture, computed when a page asks for them."""

from __future__ import annotations

import threading

from aftdeck.scenario.light import LightCondition
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Frame
from aftdeck.visual.diagram import sheet
from aftdeck.visual.scene import VisualScene


class Sheets:
    """Sheets of a scenario's cameras (`visual.diagram`), one at a time."""

    def __init__(self, scenario: Scenario) -> None:
        self._scenario = scenario
        self._scene: VisualScene | None = None
        self._lock = threading.Lock()

    def of(self, frame: Frame, camera: str, light: LightCondition) -> str:
        """Return the sheet of a camera in a frame, as SVG; may be called from any thread.

        Raises:
            InputError: there is no such camera.
            SimulationError: the camera is inside a body, or the bodies cannot be put in order.
        """
        with self._lock:
            if self._scene is None:
                self._scene = VisualScene(self._scenario)
            return sheet(self._scene, frame, camera, light, self._scenario.title)
