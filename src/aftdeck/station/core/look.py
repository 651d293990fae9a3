"""Look-ahead of a session, and the pair that the present step of the task brings together."""

from __future__ import annotations

from aftdeck.law import is_plain
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.observe.look_ahead import Axis
from aftdeck.simulation.run import Simulation
from aftdeck.station.conversion.frame_of import Displays
from aftdeck.station.messages.frame import Ahead, TaskPair
from aftdeck.task.progress import Progress

EVERY = 10
"""Steps from one look-ahead to the next, and from one search for the task's pair to the next."""


class Look:
    """Look-ahead and pair of one run.

    Attributes:
        ahead: newest look-ahead; None before the first one, and while the laws run as plain Python.
        pair: pair of the task, likewise; None if the present step has none.
    """

    def __init__(self, displays: Displays) -> None:
        self.ahead: Ahead | None = None
        self.pair: TaskPair | None = None
        self._displays = displays
        self._axis: Axis | None = None

    def renew(self, sim: Simulation, frame: Frame, progress: Progress, seconds: float) -> None:
        """Compute look-ahead and pair, in different steps, when they are due.

        As plain Python, each takes several control periods: then there are none.

        Args:
            sim: the simulation.
            frame: its newest frame.
            progress: progress through the task.
            seconds: time span of the look-ahead [s].
        """
        if is_plain():
            self.ahead, self.pair = None, None
        elif frame.tick % EVERY == 1:
            self._axis = _deflected(frame) or self._axis
            self.ahead = self._displays.ahead(sim.ahead(seconds, self._axis), frame)
        elif frame.tick % EVERY == 1 + EVERY // 2:
            self.pair = self._displays.pair(sim.watched, frame, progress)


def _deflected(frame: Frame) -> Axis | None:
    """Return the index of the axis with the largest deflection, and its sign; None if the sticks are centred."""
    axes = (*frame.rotation, *frame.translation, frame.drive)
    largest = max(range(len(axes)), key=lambda k: abs(axes[k]))
    if axes[largest] == 0.0:
        return None
    return largest, 1 if axes[largest] > 0.0 else -1
