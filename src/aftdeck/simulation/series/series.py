"""Time history of a run: chosen columns, step by step, then a table."""

from __future__ import annotations

import math
from array import array
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from aftdeck.errors import InputError
from aftdeck.plant.readings import Readings
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.readings.reading import Known, Reading
from aftdeck.simulation.series.groups import columns_of, in_series
from aftdeck.table import Cell, Column, Table
from aftdeck.units import short


class _Chosen(NamedTuple):
    """Chosen columns of a reading, and their places among all columns of the reading."""

    reading: Reading
    columns: tuple[Column, ...]
    places: tuple[int, ...]


class Series:
    """Time history of a run.

    Attributes:
        gauged: whether a column needs the readings of gauges.
    """

    def __init__(self, scenario: Scenario, names: Sequence[str] = ()) -> None:
        """Choose the columns.

        Args:
            scenario: the scenario.
            names: names of groups or of columns; () for all. The time is always the first column.

        Raises:
            InputError: a run of the scenario has no such group or column.
        """
        found = [(reading, columns_of(reading, scenario)) for reading in in_series(scenario)]
        known = {reading.group for reading, _ in found} | {column.name for _, columns in found for column in columns}
        for name in names:
            if name not in known:
                groups = ", ".join(dict.fromkeys(reading.group for reading, _ in found))
                masses = "" if scenario.plant != "kinematic" else "; torques, loads and others need a plant with masses"
                raise InputError(
                    f"columns: got {short(name)}, expected a group ({groups}) or one of its columns, "
                    f"such as {found[-1][1][0].name}{masses}"
                )
        wanted = {*(names or known), "time"}
        chosen = [_chosen(reading, columns, wanted) for reading, columns in found]
        self._scenario, self._chosen = scenario, [one for one in chosen if one.columns]
        self.gauged = any(one.reading.needs == "gauges" for one in self._chosen)
        self._columns = tuple(column for one in self._chosen for column in one.columns)
        self._numbers = array("d")
        self._texts: list[str] = []

    def see(self, frame: Frame, gauges: Readings | None) -> None:
        """Add a step. Without gauges, as in a step in which the model diverged, what they give has no value."""
        known = Known(frame, self._scenario, gauges)
        for reading, _, places in self._chosen:
            if reading.needs == "gauges" and gauges is None:
                self._numbers.extend([math.nan] * len(places))
                continue
            values = reading.values(known)
            for place in places:
                value = values[place]
                if isinstance(value, str):
                    self._texts.append(value)
                else:
                    self._numbers.append(math.nan if value is None else value)

    def table(self) -> Table:
        """Return the steps so far as a table; numbers are arrays (n,), texts are tuples."""
        texts = [column.kind == "text" for column in self._columns]
        numbers = iter(np.asarray(self._numbers).reshape(-1, texts.count(False)).T)
        words = iter([tuple(self._texts[k :: texts.count(True)]) for k in range(texts.count(True))])
        values: list[Sequence[Cell]] = [next(words) if text else next(numbers) for text in texts]
        return Table(self._columns, values)


def _chosen(reading: Reading, columns: tuple[Column, ...], wanted: set[str]) -> _Chosen:
    places = tuple(k for k, column in enumerate(columns) if reading.group in wanted or column.name in wanted)
    return _Chosen(reading, tuple(columns[place] for place in places), places)
