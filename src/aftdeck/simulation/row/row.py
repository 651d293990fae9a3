"""Row of a state: the flat arrays in which the state's arrays are, so that compiled code takes few arguments."""

from __future__ import annotations

from struct import Struct
from typing import TYPE_CHECKING

import numpy as np

from aftdeck.arrays import Array, Indices, Mask
from aftdeck.flat import parts, size
from aftdeck.kinematics.observe import SEEN
from aftdeck.simulation.row.now import INDICES, MARKS, NUMBERS, Arrays, Limits, Tables, tables_of
from aftdeck.simulation.row.scalars import GIVEN
from aftdeck.steering.layout import LAW, MOTION_ACTIVE

if TYPE_CHECKING:
    from aftdeck.simulation.row.constants import Packed
    from aftdeck.simulation.state import State

_GIVEN, _ORDERED = Struct(f"{GIVEN}d"), Struct(f"{MOTION_ACTIVE - LAW}d")
_OWN = ("steering", "command", "report", "observed")
_PLANT = ("angles", "rates", "commanded", "base")
_WORKSITE = (
    "orbiter", "orbiter_velocity", "poses_in_carrier", "frames", "before", "carrier", "monitored_before", "permitted",
)  # fmt: skip
_CONTACTS = ("count", "essential", "arm")
_RENAMED = {"count": "frames_touching", "solids": "placed"}
_WATCH = (
    "at", "solids", "bound", "moved", "moved_then", "beyond", "pair_bound", "memory", "found", "likely", "moves",
    "placed_after", "listed", "near", "reviewed", "active", "counts",
)  # fmt: skip
"""Arrays of a state that are parts of its row, by the part of the state to which they belong."""
REMEMBERED = (
    "at", "solids", "bound", "moved", "moved_then", "pair_bound", "memory", "likely", "moves", "placed_after",
)  # fmt: skip
"""Arrays of a clearance monitor that make measurements faster and change no result (`Measured`)."""


RowArrays = tuple[Array, Indices, Mask]
"""Flat arrays of a row: float64, int64 and uint8."""


def new_arrays(tables: Tables, *shape: int) -> RowArrays:
    """Return arrays with zeros for the parts of one row, or those of many rows (*shape, size)."""
    numbers, indices, marks = map(size, tables)
    return (
        np.zeros((*shape, numbers)),
        np.zeros((*shape, indices), np.int64),
        np.zeros((*shape, marks), np.uint8),
    )


class Row:
    """Flat arrays of a state.

    Attributes:
        numbers: float64.
        indices: int64.
        marks: uint8.
        scalars: the part of the numbers that `row.scalars` describes.
        values: the scalars after the last step, as Python's numbers.
        flights: (c, 39) free flights, filled before a step in which a payload floats.
        floats: whether a payload floats according to `flights`.
        snare: the part that is `Snare.packed`.
        limits: the parts that `now.Limits` describes.
        limited: whether `limits` may have zones, singularities or advice.
        goes_on: whether the row has what the state has, so that a step with other sticks needs nothing else.
        packed: the three flat arrays.
        tables: tables of their parts.
    """

    def __init__(self, tables: Tables, packed: RowArrays | None = None) -> None:
        """Make a row in the arrays `packed`, whose contents it keeps; None for new ones."""
        self.packed = new_arrays(tables) if packed is None else packed
        self.numbers, self.indices, self.marks = self.packed
        self.tables = tables
        self._parts = {
            name: part
            for names, flat, table in (
                (NUMBERS, self.numbers, tables.numbers),
                (INDICES, self.indices, tables.indices),
                (MARKS, self.marks, tables.marks),
            )
            for name, part in zip(names, parts(flat, table), strict=True)
        }
        self.scalars, self.flights = self._parts["scalars"], self._parts["flights"]
        self.snare = self._parts["snare"]
        self.limits = Limits(*(self._parts[name] for name in Limits._fields))
        if packed is None:
            self.limits.advice[:] = -1
        self.floats = self.limited = self.goes_on = False
        self.values = self.scalars.tolist()
        self._given, self._ordered = self.scalars.data.cast("B"), self._parts["command"].data.cast("B")

    def arrays(self, packed: Packed) -> Arrays:
        """Return the constants of a run and this row, as Python passes them to a law."""
        return *packed, *self.packed

    def give(self, *values: float) -> None:
        """Write the first scalars, up to `scalars.GIVEN`; this takes less time than to assign them to the array."""
        _GIVEN.pack_into(self._given, 0, *values)

    def order(self, law: int, sticks: tuple[float, ...], joint: int, drive: float) -> None:
        """Write the beginning of the steering's command: its law, sticks, joint and drive."""
        _ORDERED.pack_into(self._ordered, 0, law, *sticks, joint, drive)

    def take(self, state: State) -> None:
        """Move the arrays of a state into the row: the state's arrays are parts of the row from then on."""
        worksite = state.worksite
        owners = (state, state.plant, worksite, worksite.contacts, worksite.watch)
        for owner, names in zip(owners, (_OWN, _PLANT, _WORKSITE, _CONTACTS, _WATCH), strict=True):
            for name in names:
                part, given = self._parts[_RENAMED.get(name, name)], getattr(owner, name)
                if given is not part:
                    part[...] = given
                    setattr(owner, name, part)
        worksite.watch.pack()
        self.goes_on = False

    def renew(self, state: State) -> None:
        """Become the row of a new state, whose clearance monitor goes on with what is remembered.

        The state to which this row belonged can no longer be used.
        """
        for name in ("scalars", "flights", "snare", "zones", "singular", "ways"):
            self._parts[name][...] = 0
        self.limits.advice[:] = -1
        self.floats = self.limited = False
        self.values = self.scalars.tolist()
        for name in REMEMBERED:
            setattr(state.worksite.watch, name, self._parts[_RENAMED.get(name, name)])
        self.take(state)

    def moved_to(self, packed: RowArrays, state: State) -> Row:
        """Return the row that this one becomes when it moves, with its state's arrays, into the arrays `packed`."""
        numbers, indices, marks = packed
        numbers[:], indices[:], marks[:] = self.packed
        row = Row(self.tables, packed)
        row.take(state)
        row.floats, row.limited, row.goes_on = self.floats, self.limited, self.goes_on
        return row


def row_of(state: State) -> Row:
    """Return a row that contains the arrays of a state from now on."""
    layout, payloads = state.worksite.watch.layout, len(state.worksite.payloads)
    row = Row(tables_of(layout, len(state.plant.angles), len(state.observed) - SEEN, payloads))
    row.take(state)
    return row
