"""Rows of states, and constants of runs in flat arrays."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from aftdeck.scenario.load import built_in
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.row.now import (
    INDICES,
    MARKS,
    NUMBERS,
    Flat,
    Limits,
    Motion,
    Watch,
    limits_of,
    motion_of,
    watch_of,
)
from aftdeck.simulation.row.world import pairs_of, world_arrays, world_of
from aftdeck.simulation.run import Simulation
from aftdeck.simulation.state import State
from aftdeck.state_part import encoded

FLOWN = 40
"""Number of steps before a state is examined."""


@cache
def flown(name: str) -> tuple[Flight, State]:
    sim = Simulation(name)
    for _ in range(FLOWN):
        sim.advance()
    return sim._flight, sim._state


def parts_of(flight: Flight, state: State) -> dict[str, np.ndarray]:
    """Return the parts of a row by the names of the named tuples in which laws receive them."""
    flat = Flat(*state.row.arrays(flight.packed))
    return motion_of(flat)._asdict() | watch_of(flat)._asdict() | limits_of(flat)._asdict()


@pytest.mark.parametrize("name", built_in())
def test_the_arrays_of_a_state_are_the_parts_of_its_row(name: str) -> None:
    flight, state = flown(name)
    parts, worksite = parts_of(flight, state), state.worksite
    assert set(parts) == {*NUMBERS, *INDICES, *MARKS} == {*Motion._fields, *Watch._fields, *Limits._fields}
    owners = (state, state.plant, worksite, worksite.contacts, worksite.watch)
    for name_of, part in parts.items():
        if name_of in ("scalars", "flights", "snare", *Limits._fields):
            continue
        attribute = {"frames_touching": "count", "placed": "solids"}.get(name_of, name_of)
        (own,) = [
            array
            for owner in owners
            if isinstance(array := vars_of(owner).get(attribute), np.ndarray) and array.shape == part.shape
        ]
        assert not part.size or np.shares_memory(own, part), name_of
    places = [part.__array_interface__["data"][0] for part in parts.values() if part.size]
    assert len(set(places)) == len(places)


def vars_of(owner: object) -> dict[str, object]:
    """Return the fields of a part of the state, without its properties."""
    names = getattr(owner, "__struct_fields__", None) or vars(owner)
    return {name: getattr(owner, name) for name in names}


@pytest.mark.parametrize("name", built_in())
def test_laws_receive_the_constants_of_a_run(name: str) -> None:
    flight, state = flown(name)
    flat = Flat(*state.row.arrays(flight.packed))
    world, pairs = world_arrays(flight), flight.site.layout.packed
    given: tuple[np.ndarray, ...] = (*world, *pairs)
    got: tuple[np.ndarray, ...] = (*world_of(flat), *pairs_of(flat))
    for name_of, array, expected in zip((*world._fields, *pairs._fields), got, given, strict=True):
        assert array.shape == expected.shape, name_of
        assert np.array_equal(array, expected, equal_nan=expected.dtype.kind == "f"), name_of
        assert not array.flags.writeable


def test_a_copied_state_has_a_row_of_its_own() -> None:
    flight, state = flown("srms-berth")
    before = encoded(state)
    copy = state.fork()
    for array in (copy.row.numbers, copy.row.indices, copy.row.marks):
        array[:] = 1
    assert encoded(state) == before
    assert parts_of(flight, copy)["angles"].tolist() == copy.plant.angles.tolist() == [1.0] * 6
