"""Definition of a metric of a run, and its value."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple, Protocol

from aftdeck.simulation.frame import Frame
from aftdeck.simulation.readings.quantity import UNITS, Quantity
from aftdeck.simulation.readings.source import OWN
from aftdeck.table import with_unit
from aftdeck.worksite.watch.alarm import Level


class Metric(NamedTuple):
    """Definition of a metric.

    Attributes:
        name: name in tables, without the unit: ``tip_path``.
        title: name for people: ``Tip path``.
        quantity: kind of the number, with its unit.
        definition: what is measured, in a sentence.
        source: document that defines it or asks for it.
    """

    name: str
    title: str
    quantity: Quantity
    definition: str
    source: str = OWN

    @property
    def is_text(self) -> bool:
        """Whether its values are texts."""
        return self.quantity == "words"

    @property
    def column(self) -> str:
        """Name of a table's column, with the unit: ``tip_path_m``, ``closing_speed_m_s``."""
        return with_unit(self.name, UNITS[self.quantity])


class Value(NamedTuple):
    """Value of a metric in a run.

    Attributes:
        number: in the SI unit of the metric's quantity; None for a text.
        text: the value, if it is a text.
        detail: where or when it occurred: ``lower boom to sill, at 12.4 s``.
        level: worst level of its alarm during the run.
    """

    number: float | None
    text: str = ""
    detail: str = ""
    level: Level = "info"


Found = tuple[Metric, Value]


class Collector(Protocol):
    """What computes some metrics of a run, frame by frame."""

    def see(self, frame: Frame, before: Frame | None) -> None:
        """Add the next frame.

        Args:
            frame: the frame.
            before: the frame of the step before; None in the first step of the run.
        """

    def found(self) -> Iterable[Found]:
        """Return each metric for which the run has data, with its value."""
