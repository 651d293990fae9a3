"""Make the tables of the pages about dynamics again that benchmarks measure; name some of `TABLES` for only these."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import NamedTuple

from benchmarks import flight_tests, jets, linear_models, plants, ring_down, stops

DOCS = Path(__file__).parent.parent / "docs"


class Table(NamedTuple):
    """Table of a page: the page's name, and the function that returns the table's lines."""

    page: str
    lines: Callable[[], Iterable[str]]


TABLES = {
    "flight_tests": Table("dynamics.md", lambda: flight_tests.table(flight_tests.FULL)),
    "jets": Table("dynamics.md", lambda: jets.table(jets.FULL)),
    "linear_models": Table("dynamics-python.md", lambda: linear_models.table(linear_models.FULL)),
    "plants": Table("dynamics.md", lambda: plants.table(plants.FULL)),
    "ring_down": Table("dynamics.md", lambda: ring_down.table(ring_down.FULL)),
    "stops": Table("dynamics.md", lambda: stops.table(stops.FULL)),
}
"""Tables by the name of their benchmark."""


def replaced(page: str, table: list[str]) -> str:
    """Return the page with a table of the same heading replaced.

    Raises:
        ValueError: the page has no table with this heading, or more than one.
    """
    lines = page.split("\n")
    if lines.count(table[0]) != 1:
        raise ValueError(f"expected one table with the heading {table[0]!r}, got {lines.count(table[0])}")
    first = lines.index(table[0])
    last = first
    while lines[last].startswith("|"):
        last += 1
    return "\n".join([*lines[:first], *table, *lines[last:]])


def main(names: list[str]) -> None:
    """Replace the named tables, or all."""
    if unknown := sorted(set(names) - set(TABLES)):
        sys.exit(f"unknown tables {', '.join(unknown)}; the tables are {', '.join(TABLES)}")
    for name in names or TABLES:
        path, table = DOCS / TABLES[name].page, list(TABLES[name].lines())
        path.write_text(replaced(path.read_text(), table))
        print(name, flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
