"""Many arrays as parts of one flat array, because Python calls a compiled function in less time with few arguments.

A *table* has one row for each part: its first element in the flat array, its number of rows, and its number of columns
(0 for a part with one axis).
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from aftdeck.arrays import Indices
from aftdeck.law import law
from aftdeck.lent import lend_block, lend_line

BEGIN, ROWS, COLUMNS = range(3)
"""Columns of a table."""


def table_of(shapes: Iterable[tuple[int, ...]]) -> Indices:
    """Return the table of parts with these shapes, of one or two axes, one after the other in a flat array."""
    rows, begin = [], 0
    for shape in shapes:
        count, columns = shape if len(shape) > 1 else (shape[0], 0)
        rows.append((begin, count, columns))
        begin += count * (columns if len(shape) > 1 else 1)
    return np.array(rows, dtype=np.int64).reshape(-1, 3)


def size(table: Indices) -> int:
    """Return the number of elements of the flat array of a table."""
    return max((int(begin + rows * (columns or 1)) for begin, rows, columns in table), default=0)


def parts(flat: NDArray[Any], table: Indices) -> list[NDArray[Any]]:
    """Return the parts of a flat array as views of it."""
    views = []
    for begin, rows, columns in table.tolist():
        part = flat[begin : begin + rows * (columns or 1)]
        views.append(part.reshape(rows, columns) if columns else part)
    return views


def flattened(arrays: Sequence[NDArray[Any]], kind: type) -> NDArray[Any]:
    """Return a view that cannot be written of a flat array with the elements of arrays of the same kind of number."""
    flat = np.concatenate([np.zeros(0, kind), *(np.asarray(array, kind).ravel() for array in arrays)])
    view = flat.view()
    view.flags.writeable = False
    return view


@law
def line(flat: NDArray[Any], table: Indices, part: int) -> NDArray[Any]:
    """Return a part with one axis as a view that is lent (`lent.py`)."""
    return lend_line(flat, table[part, BEGIN], table[part, ROWS])


@law
def block(flat: NDArray[Any], table: Indices, part: int) -> NDArray[Any]:
    """Return a part with two axes as a view that is lent."""
    return lend_block(flat, table[part, BEGIN], table[part, ROWS], table[part, COLUMNS])
