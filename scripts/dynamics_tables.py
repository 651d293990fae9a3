"""Make the tables of docs/dynamics.md again that benchmarks measure; name some of `TABLES` to make only these."""

from __future__ import annotations

import sys
from pathlib import Path

from benchmarks import flight_tests, plants, ring_down, stops

PAGE = Path(__file__).parent.parent / "docs" / "dynamics.md"
TABLES = {
    "flight_tests": lambda: flight_tests.table(flight_tests.FULL),
    "plants": lambda: plants.table(plants.FULL),
    "ring_down": lambda: ring_down.table(ring_down.FULL),
    "stops": lambda: stops.table(stops.FULL),
}
"""Lines of each table, by the name of its benchmark."""


def replaced(page: str, table: list[str]) -> str:
    """Return the page with a table of the same heading replaced.

    Raises:
        ValueError: the page has no table with this heading, or more than one.
    """
    lines = page.split("\n")
    if lines.count(table[0]) != 1:
        raise ValueError(f"{PAGE.name}: expected one table with the heading {table[0]!r}, got {lines.count(table[0])}")
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
        table = list(TABLES[name]())
        PAGE.write_text(replaced(PAGE.read_text(), table))
        print(name, flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
