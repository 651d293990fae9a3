"""Constants of a run as parts of three flat arrays."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from aftdeck.arrays import Array, Indices, Mask
from aftdeck.flat import flattened, table_of
from aftdeck.simulation.row.aligning import ALIGNING_INDICES, ALIGNING_NUMBERS, ON_WAY, aligning_arrays
from aftdeck.simulation.row.now import TABLES, tables_of
from aftdeck.simulation.row.on_way import PLACES, least_on_way
from aftdeck.simulation.row.world import WORLD_INDICES, WORLD_NUMBERS, world_arrays

if TYPE_CHECKING:
    from aftdeck.simulation.constants.flight import Flight


class Packed(NamedTuple):
    """Constants of a run in flat arrays, which cannot be written; only `learn_way` does.

    The indices begin with the places of the tables in the indices, and with the tables.

    Attributes:
        numbers: float64.
        indices: int64.
        marks: uint8.
    """

    numbers: Array
    indices: Indices
    marks: Mask


def packed(flight: Flight) -> Packed:
    """Return the constants of a run in flat arrays: those of `World`, the monitored pairs, and those of `Aligning`."""
    world, layout, own = world_arrays(flight), flight.site.layout.packed, aligning_arrays(flight)
    first, last = WORLD_NUMBERS, WORLD_NUMBERS + WORLD_INDICES
    begin, end = ALIGNING_NUMBERS, ALIGNING_NUMBERS + ALIGNING_INDICES
    groups = (
        (*world[:first], layout.solids, layout.reach, *own[:begin]),
        (*world[first:last], layout.frame, layout.pairs, layout.begins, layout.between_frames, *own[begin:end]),
        (*world[last:], *own[end:]),
    )
    tables = [table_of(array.shape for array in group) for group in groups]
    model, site = flight.scenario.arm.model, flight.site
    tables += tables_of(site.layout, len(site.arm.joints), len(model.singularities), len(site.payloads))
    places = TABLES + 1 + np.cumsum([0, *(one.size for one in tables)], dtype=np.int64)
    indices = [places, *tables, *groups[1]]
    return Packed(flattened(groups[0], np.float64), flattened(indices, np.int64), flattened(groups[2], np.uint8))


def learn_way(flight: Flight, berth: int) -> None:
    """Compute the clearances on the way into a berth, numbered as in `Aligning`, and keep them with the constants.

    This takes milliseconds, as plain Python seconds, and most runs need it for few berths or for none.
    """
    fits = [(k, number) for k, own in enumerate(flight.site.fits) for number in range(len(own))]
    own = flight.packed
    table = own.indices[TABLES + 1 :][: own.indices[1] - own.indices[0]].reshape(-1, 3)
    begin, _, groups = table[WORLD_NUMBERS + 2 + ON_WAY].tolist()
    rows = begin + berth * PLACES * groups
    numbers = own.numbers.base
    assert numbers is not None, "the constants are a view"
    numbers[rows : rows + PLACES * groups] = least_on_way(flight.site, *fits[berth]).ravel()
