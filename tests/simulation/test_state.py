"""The state: every value of it is saved and in the digest, and what is a cache changes nothing."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import cache
from typing import Any

import msgspec
import numpy as np
import pytest

import aftdeck
from aftdeck.errors import InputError
from aftdeck.simulation.parts.checking import Rehearsed
from aftdeck.simulation.parts.standing import Standing
from aftdeck.simulation.payloads.grasp import steer
from aftdeck.simulation.resume import look_again, resume
from aftdeck.simulation.state import State
from aftdeck.state_part import Cache, StatePart, copied, digest, encoded
from tests.simulation.flights import anything

FLOWN = ("srms-berth", "srms-deploy", "concept-1972-script", "free-flyer", "sts-400-closed")
"""Scenarios whose scripts are flown, or random sticks where there is none."""


@cache
def flight(name: str) -> tuple[aftdeck.Simulation, tuple[bytes, ...], tuple[bytes, ...]]:
    """A scenario's flight: the simulation, the digest of each step, and the first state of each kind."""
    sim = aftdeck.Simulation(name)
    sticks = None if sim.scenario.phases else anything(np.random.default_rng(3), 100_000)
    seals: list[bytes] = []
    states: dict[object, bytes] = {}
    while len(seals) < 3000 and not sim.ended:
        sim.advance(None if sticks is None else next(sticks))
        seals.append(sim.seal())
        states.setdefault(kind(sim._state), encoded(sim._state))
    return sim, tuple(seals), (*states.values(), encoded(sim._state))


def kind(state: State) -> tuple[object, ...]:
    """What is under way in a state."""
    worksite, checking = state.worksite, state.checking
    rehearsing = checking is not None and checking.steps > 0
    return (
        checking is None,
        rehearsing,
        worksite.held,
        worksite.arm_fixed,
        bool(worksite.logged_contacts),
        bool(worksite.aligned_with),
    )


def altered(value: Any) -> Iterator[tuple[str, Any]]:
    """Yield copies of a value with one thing in them changed, each by as little as can be, and where."""
    match value:
        case bool():
            yield "", not value
        case float():
            yield "", math.nextafter(value, math.inf if value >= 0.0 else -math.inf)
        case int():
            yield "", value + 1
        case str():
            yield "", value + "x"
        case bytes():
            yield "", value + b"x"
        case None:
            yield "", 0
        case np.ndarray():
            flat = value.ravel()
            for k in range(len(flat)) if len(flat) < 80 else (0, len(flat) // 2, len(flat) - 1):
                changed = value.copy()
                number = flat[k]
                changed.ravel()[k] = np.nextafter(number, np.inf) if value.dtype == np.float64 else number ^ 1
                yield f"[{k}]", changed
        case msgspec.Struct():
            for name in value.__struct_fields__:
                if isinstance(one := getattr(value, name), Cache):
                    continue
                for where, changed in altered(one):
                    yield f".{name}{where}", msgspec.structs.replace(value, **{name: changed})
        case dict():
            yield "+", {**value, "x": 1}
        case tuple() | list():
            yield "+", [*value, 0]
            for k, one in enumerate(value):
                for where, changed in altered(one):
                    yield f"[{k}]{where}", [*value[:k], changed, *value[k + 1 :]]
        case _:
            raise AssertionError(f"{value!r} has no place in a state")


@pytest.mark.parametrize("name", FLOWN)
def test_every_value_of_the_state_is_in_its_digest(name: str) -> None:
    sim, seen = flight(name)[0], 0
    for data in flight(name)[2]:
        state = resume(sim._flight, data)
        own = digest(state)
        assert own == digest(copied(state))
        for where, changed in altered(state):
            assert digest(changed) != own, f"the digest does not see {where}"
            seen += 1
    assert seen > 1000


def test_a_flight_has_been_checked_held_and_touching() -> None:
    states = [resume(flight(name)[0]._flight, data) for name in FLOWN for data in flight(name)[2]]
    assert any(state.checking is not None and state.checking.steps > 0 for state in states)
    assert any(state.worksite.held is not None for state in states)
    assert any(state.worksite.logged_contacts for state in states)
    assert any(any(state.worksite.floating) for state in states)


@pytest.mark.parametrize("name", FLOWN)
def test_a_saved_state_is_taken_up_whole(name: str) -> None:
    sim, _, states = flight(name)
    for data in states:
        assert encoded(resume(sim._flight, data)) == data


@pytest.mark.parametrize("name", FLOWN)
def test_a_flight_without_its_caches_is_the_same_to_the_last_digit(name: str) -> None:
    """At every step but a few the watch forgets; now and then every cache is lost, as if saved and restored."""
    sim, rng, lost = aftdeck.Simulation(name), np.random.default_rng(9), set[str]()
    sticks = None if sim.scenario.phases else anything(np.random.default_rng(3), 100_000)
    for tick, expected in enumerate(flight(name)[1]):
        if tick % 20 == 0:
            forget_everything(sim, lost)
        elif rng.random() < 0.9:
            sim._state.worksite.watch.forget()
        sim.advance(None if sticks is None else next(sticks))
        assert sim.seal() == expected, f"after step {tick + 1}"
    assert {type(one).__name__ for one in caches(sim._state)} <= lost


def caches(part: StatePart) -> Iterator[Cache]:
    """Yield every cache in a part."""
    for name in part.__struct_fields__:
        value = getattr(part, name)
        if isinstance(value, Cache):
            yield value
        elif isinstance(value, StatePart):
            yield from caches(value)


def forget_everything(sim: aftdeck.Simulation, lost: set[str]) -> None:
    """Empty every cache of a simulation, and have those worked out again that a saved state leaves out."""
    state, flown = sim._state, sim._flight
    lost |= {type(one).__name__ for one in caches(state)}
    state.standing = Standing(flown.scenario.arm)
    if state.checking is not None:
        state.checking.rehearsal = Rehearsed()
    steer(flown, state)
    look_again(flown, state)


@pytest.mark.parametrize(
    "spoilt",
    [
        pytest.param(lambda data: b"", id="nothing"),
        pytest.param(lambda data: data[:-1], id="cut"),
        pytest.param(lambda data: b"\xc0", id="no state"),
        pytest.param(lambda data: data.replace(b"srms", b"\xff\xff\xff\xff", 1)[::-1], id="backwards"),
    ],
)
def test_bytes_that_are_no_state_are_refused_and_nothing_changes(spoilt: Any) -> None:
    sim = aftdeck.Simulation("uncradle")
    for _ in range(3):
        sim.step()
    before, seal = sim.save(), sim.seal()
    with pytest.raises(InputError, match="saved state"):
        sim.restore(msgspec.structs.replace(before, state=spoilt(before.state)))
    assert sim.seal() == seal and sim.save() == before


def test_a_state_whose_arrays_have_another_length_is_refused() -> None:
    sim, other = aftdeck.Simulation("srms-berth"), aftdeck.Simulation("first-flight")
    with pytest.raises(InputError, match="another worksite"):
        sim.restore(msgspec.structs.replace(sim.save(), state=other.save().state))
