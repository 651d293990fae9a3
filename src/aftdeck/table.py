"""Table: columns with units, of numbers or texts, and its file, CSV or Parquet."""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, Literal, NamedTuple

from aftdeck.extra import needed
from aftdeck.new_file import check_new_file
from aftdeck.whole_file import new_file, write_new

Cell = bool | int | float | str | None
ENDINGS = (".csv", ".parquet")
"""Endings of a table's name."""


class Column(NamedTuple):
    """Column of a table.

    Attributes:
        name: its name, with the unit.
        unit: unit; empty for a number without a unit, and for a text.
        definition: what it is.
        kind: kind of its values.
    """

    name: str
    unit: str
    definition: str
    kind: Literal["number", "whole number", "text"] = "number"


def with_unit(name: str, unit: str) -> str:
    """Return the name of a column with its unit.

    >>> with_unit("closing_speed", "m/s"), with_unit("torque", "N m"), with_unit("ratio", "1")
    ('closing_speed_m_s', 'torque_n_m', 'ratio')
    """
    text = "" if unit == "1" else unit.replace("/", "_").replace(" ", "_").lower()
    return f"{name}_{text}" if text else name


class Table(Mapping[str, Any]):
    """Table: the values of each column by its name, in the order of `columns`: an array (n,), or a sequence.

    Attributes:
        columns: the columns.
    """

    def __init__(self, columns: Sequence[Column], values: Iterable[Sequence[Cell]]) -> None:
        """Take the values of each column: an array (n,) or a sequence, with NaN or None where there is no value."""
        self.columns = tuple(columns)
        self._values = dict(zip((column.name for column in self.columns), values, strict=True))

    def __getitem__(self, name: str) -> Any:
        """Return the values of a column."""
        return self._values[name]

    def __iter__(self) -> Iterator[str]:
        """Return an iterator over the names of the columns."""
        return iter(self._values)

    def __len__(self) -> int:
        """Return the number of columns."""
        return len(self._values)

    def write(self, file: str | Path) -> None:
        """Write a new CSV or Parquet file; a missing value is an empty cell or null.

        In a Parquet file, each column's metadata have its description and its unit.

        Raises:
            InputError: the file exists already or cannot be written, its name has another ending, or pyarrow is not
                installed.
        """
        file = Path(file)
        check_new_file(file, ENDINGS)
        if file.suffix == ".csv":
            write_new(file, self._csv())
            return
        table = self._arrow()
        with new_file(file) as out:
            needed("pyarrow.parquet").write_table(table, out, compression="zstd")

    def _csv(self) -> str:
        text = io.StringIO(newline="")
        table = csv.writer(text)
        table.writerow(self._values)
        table.writerows(zip(*map(_plain, self._values.values()), strict=True))
        return text.getvalue()

    def _arrow(self) -> Any:
        arrow: Any = needed("pyarrow")
        kinds = {"number": arrow.float64(), "whole number": arrow.int64(), "text": arrow.string()}
        fields = [
            arrow.field(one.name, kinds[one.kind], metadata={"description": one.definition, "unit": one.unit})
            for one in self.columns
        ]
        arrays = [
            arrow.array(_plain(values), kinds[one.kind])
            for one, values in zip(self.columns, self._values.values(), strict=True)
        ]
        return arrow.Table.from_arrays(arrays, schema=arrow.schema(fields))


def _plain(values: Sequence[Cell]) -> list[Cell]:
    """Return values as a list, with None in place of NaN."""
    listed = getattr(values, "tolist", lambda: list(values))()
    return [None if isinstance(value, float) and math.isnan(value) else value for value in listed]
