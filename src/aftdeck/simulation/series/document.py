"""Table of the columns in docs/series.md: ``python -m aftdeck.simulation.series.document FILE``."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import groupby

from aftdeck.made_tables import renew_file
from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.series.groups import GROUPS, XYZ, Group

EXAMPLE = "srms-berth"
"""Built-in scenario whose columns the document lists: its arm has booms, and it has a payload."""


def tables() -> str:
    """Return the table of all groups, with the columns of a flexible arm and a payload."""
    return "\n".join(_lines())


def _lines() -> Iterator[str]:
    scenario = load_scenario(EXAMPLE, {"plant": "flexible"})
    yield "| group | from | columns | unit | definition |\n|---|---|---|---|---|"
    for group in GROUPS:
        for (definition, unit), columns in groupby(
            group.columns(scenario), lambda column: (column.definition, column.unit)
        ):
            names = _names([column.name for column in columns])
            yield f"| `{group.name}` | {_from(group)} | {names} | {unit} | {definition} |"
    yield ""


def _names(names: list[str]) -> str:
    """Return the names of columns, of many only the first and the last."""
    few = len(names) <= len(XYZ)
    return ", ".join(f"`{name}`" for name in names) if few else f"`{names[0]}` … `{names[-1]}`"


def _from(group: Group) -> str:
    """Return where the values of a group come from, and on which plants it has values."""
    if group.gauged:
        return "gauges"
    return "frame, with masses" if group.masses else "frame"


if __name__ == "__main__":
    renew_file(tables())
