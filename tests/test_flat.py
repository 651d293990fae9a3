"""Parts of flat arrays."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from aftdeck.flat import block, flattened, line, parts, size, table_of

SHAPES = st.lists(st.one_of(st.tuples(st.integers(0, 5)), st.tuples(st.integers(0, 4), st.integers(1, 4))), max_size=6)


@given(SHAPES)
def test_parts_of_a_flat_array_are_the_arrays_from_which_it_was_made(shapes: list[tuple[int, ...]]) -> None:
    counter = iter(range(1000))
    arrays = [np.array([float(next(counter)) for _ in range(int(np.prod(shape)))]).reshape(shape) for shape in shapes]
    table, flat = table_of(shapes), flattened(arrays, np.float64)
    assert len(flat) == size(table) == sum(array.size for array in arrays) and not flat.flags.writeable
    for k, (array, part) in enumerate(zip(arrays, parts(flat, table), strict=True)):
        again = line(flat, table, k) if array.ndim == 1 else block(flat, table, k)
        for found in (part, again):
            assert found.shape == array.shape and np.array_equal(found, array)
            assert not found.size or np.shares_memory(found, flat)


def test_a_part_that_is_written_changes_the_flat_array() -> None:
    table = table_of([(2,), (2, 3)])
    flat = np.zeros(size(table))
    parts(flat, table)[1][1, 2] = 7.0
    assert flat.tolist() == [0.0] * 7 + [7.0]
