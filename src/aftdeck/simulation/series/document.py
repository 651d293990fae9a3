"""Table of the columns in docs/series.md: ``python -m aftdeck.simulation.series.document FILE``."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import groupby

from aftdeck.made_tables import renew_file
from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.readings.reading import XYZ
from aftdeck.simulation.series.groups import columns_of, in_series

EXAMPLE = "srms-berth"
"""Built-in scenario whose columns the document lists: its arm has booms, and it has a payload."""

_FROM = {"": "frame", "masses": "frame, with masses", "gauges": "gauges"}
"""Where values come from, and on which plants there are any, by what a reading needs."""


def tables() -> str:
    """Return the table of all groups, with the columns of a flexible arm and a payload."""
    return "\n".join(_lines())


def _lines() -> Iterator[str]:
    scenario = load_scenario(EXAMPLE, {"plant": "flexible"})
    columns = [(reading, column) for reading in in_series(scenario) for column in columns_of(reading, scenario)]
    yield "| group | from | columns | unit | definition |\n|---|---|---|---|---|"
    for (group, needs, definition, unit), found in groupby(
        columns, lambda each: (each[0].group, each[0].needs, each[1].definition, each[1].unit)
    ):
        names = _names([column.name for _, column in found])
        yield f"| `{group}` | {_FROM[needs]} | {names} | {unit} | {definition} |"
    yield ""


def _names(names: list[str]) -> str:
    """Return the names of columns, of many only the first and the last."""
    few = len(names) <= len(XYZ)
    return ", ".join(f"`{name}`" for name in names) if few else f"`{names[0]}` … `{names[-1]}`"


if __name__ == "__main__":
    renew_file(tables())
