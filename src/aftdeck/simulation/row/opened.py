"""Parts of the flat arrays that a compiled function takes."""

from __future__ import annotations

from typing import NamedTuple

from aftdeck.arrays import Array, Indices, Mask
from aftdeck.law import law
from aftdeck.lent import lend
from aftdeck.simulation.row.now import Motion, Watch, motion_of, watch_of
from aftdeck.simulation.row.world import World, pairs_of, row_tables, world_of
from aftdeck.worksite.watch.groups import PackedLayout


class Opened(NamedTuple):
    """Constants of a run and a row of its state, as named tuples of their parts."""

    world: World
    pairs: PackedLayout
    now: Motion
    watch: Watch


@law
def opened(
    fixed_numbers: Array, fixed_indices: Indices, fixed_marks: Mask, numbers: Array, indices: Indices, marks: Mask
) -> Opened:
    """Return the parts of the flat arrays, which have to live until the law that calls this one returns.

    Args:
        fixed_numbers: constants of the run (`world.Packed`).
        fixed_indices: the same.
        fixed_marks: the same.
        numbers: the state's row (`row.Row`).
        indices: the same.
        marks: the same.
    """
    floats, whole = lend(fixed_numbers), lend(fixed_indices)
    own, others, tables = lend(numbers), lend(indices), row_tables(whole)
    return Opened(
        world_of(floats, whole, lend(fixed_marks)),
        pairs_of(floats, whole),
        motion_of(own, others, tables),
        watch_of(own, others, lend(marks), tables),
    )
