"""State that a learner sees: numbers that an operator's page shows, in one vector, from a frame."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from aftdeck.errors import InputError
from aftdeck.scenario.model import Scenario
from aftdeck.scene.stick_axes import StickAxes
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.readings.reading import Known, Reading
from aftdeck.simulation.readings.table import readings
from aftdeck.task.along_sticks import seen_along
from aftdeck.task.remaining import Remaining

Floats32 = NDArray[np.float32]


def in_state() -> tuple[Reading, ...]:
    """Return the readings that the state of every run has, in their order."""
    return tuple(reading for reading in readings() if reading.state)


class StateReader:
    """Reader of the state from the frames of one scenario.

    Attributes:
        names: name of each number.
    """

    def __init__(self, scenario: Scenario) -> None:
        self._scenario, self._sticks, self._readings = scenario, StickAxes(scenario), in_state()
        self.names = tuple(name for reading in self._readings for name in reading.names(reading.state, scenario))

    def of(self, frame: Frame, left: Remaining | None) -> Floats32:
        """Return the state (numbers,).

        Args:
            frame: the frame.
            left: remaining motion; None if there is no place to move to.
        """
        known = Known(frame, self._scenario, along=seen_along(frame, left, self._sticks.in_l(frame)))
        return np.array([value for reading in self._readings for value in reading.values(known)], dtype=np.float32)


def same_names(what: str, ours: tuple[str, ...], first: tuple[str, ...], where: str, there: str) -> None:
    """Check that two runs have the same names of something.

    Raises:
        InputError: they differ; the message states which names only one of the runs has.
    """
    if ours == first:
        return
    more, less = [name for name in ours if name not in first], [name for name in first if name not in ours]
    raise InputError(
        f"{where}: {what} differ from those of {there}: {', '.join(more) or 'none'} instead of "
        f"{', '.join(less) or 'none'}; export runs of different arms into different folders"
    )
