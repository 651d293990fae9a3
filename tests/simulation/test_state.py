"""State: every value is saved and in the digest, and caches change no result."""

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
from aftdeck.simulation.payloads.grasp import carried_by
from aftdeck.simulation.resume import restore_clearances, resume
from aftdeck.simulation.state import State
from aftdeck.state_part import Cache, StatePart, copied, digest, encoded
from tests.simulation.flights import random_inputs

FLOWN = ("srms-berth", "srms-deploy", "concept-1972-script", "free-flyer", "sts-400-closed")
"""Scenarios that are run with their scripts, or with random sticks if they have no script."""


@cache
def flight(name: str) -> tuple[aftdeck.Simulation, tuple[bytes, ...], tuple[bytes, ...]]:
    """Return a run of a scenario: the simulation, the digest of each step, and the first state of each kind."""
    sim = aftdeck.Simulation(name)
    sticks = None if sim.scenario.phases else random_inputs(np.random.default_rng(3), 100_000)
    digests: list[bytes] = []
    states: dict[object, bytes] = {}
    while len(digests) < 3000 and not sim.ended:
        sim.advance(None if sticks is None else next(sticks))
        digests.append(sim.seal())
        states.setdefault(kind(sim._state), encoded(sim._state))
    return sim, tuple(digests), (*states.values(), encoded(sim._state))


def kind(state: State) -> tuple[object, ...]:
    """Return the kind of a state: check in progress, held payload, fixed arm, contacts, and alignment."""
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
    """For each item in `value`, yield its path, and a copy of `value` in which only this item is changed.

    A number is changed by the least possible amount.
    """
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
                if isinstance(field := getattr(value, name), Cache):
                    continue
                for where, changed in altered(field):
                    yield f".{name}{where}", msgspec.structs.replace(value, **{name: changed})
        case dict():
            yield "+", {**value, "x": 1}
        case tuple() | list():
            yield "+", [*value, 0]
            for k, item in enumerate(value):
                for where, changed in altered(item):
                    yield f"[{k}]{where}", [*value[:k], changed, *value[k + 1 :]]
        case _:
            raise AssertionError(f"a state cannot contain {value!r}")


@pytest.mark.parametrize("name", FLOWN)
def test_digest_contains_every_value_of_the_state(name: str) -> None:
    sim, seen = flight(name)[0], 0
    for data in flight(name)[2]:
        state = resume(sim._flight, data)
        own = digest(state)
        assert own == digest(copied(state))
        for where, changed in altered(state):
            assert digest(changed) != own, f"the digest does not contain {where}"
            seen += 1
    assert seen > 1000


def test_tested_states_include_checks_payloads_and_contacts() -> None:
    states = [resume(flight(name)[0]._flight, data) for name in FLOWN for data in flight(name)[2]]
    assert any(state.checking is not None and state.checking.steps > 0 for state in states)
    assert any(state.worksite.held is not None for state in states)
    assert any(state.worksite.logged_contacts for state in states)
    assert any(any(state.worksite.floating) for state in states)


@pytest.mark.parametrize("name", FLOWN)
def test_restored_state_equals_the_saved_one(name: str) -> None:
    sim, _, states = flight(name)
    for data in states:
        assert encoded(resume(sim._flight, data)) == data


def mutable(value: Any, where: str = "") -> Iterator[tuple[str, object]]:
    """Yield the path of each part, array, list and dictionary in a state, and this object; caches are left out."""
    match value:
        case StatePart():
            yield where, value
            for name in value.__struct_fields__:
                yield from mutable(getattr(value, name), f"{where}.{name}")
        case list():
            yield where, value
            for k, item in enumerate(value):
                yield from mutable(item, f"{where}[{k}]")
        case np.ndarray() | dict():
            yield where, value


@pytest.mark.parametrize("name", FLOWN)
def test_copy_of_a_state_shares_no_object_that_a_step_changes(name: str) -> None:
    state = flight(name)[0]._state
    own, other = dict(mutable(state)), dict(mutable(copied(state)))
    assert own.keys() == other.keys() >= {".panel", ".panel.advice", ".steering", ".events"}
    assert [where for where, value in own.items() if value is other[where]] == []


def test_frame_after_restoring_is_that_of_the_restored_state() -> None:
    sim = aftdeck.Simulation("tutorial")
    ahead = aftdeck.Inputs(translation=(0.4, 0.0, 0.1))
    frames = [sim.step(ahead) for _ in range(20)]
    saved = sim.save()
    later = [sim.step(ahead) for _ in range(20)][-1]
    sim.restore(saved)
    assert sim.look() == frames[-1] != later


@pytest.mark.slow
@pytest.mark.parametrize("name", FLOWN)
def test_run_without_caches_is_bit_for_bit_equal(name: str) -> None:
    """Most steps begin without cached clearances, and every twentieth step begins as after saving and restoring."""
    sim, rng, lost = aftdeck.Simulation(name), np.random.default_rng(9), set[str]()
    sticks = None if sim.scenario.phases else random_inputs(np.random.default_rng(3), 100_000)
    for tick, expected in enumerate(flight(name)[1]):
        if tick % 20 == 0:
            forget_everything(sim, lost)
        elif rng.random() < 0.9:
            sim._state.worksite.watch.forget()
        sim.advance(None if sticks is None else next(sticks))
        assert sim.seal() == expected, f"after step {tick + 1}"
    assert {type(cache_).__name__ for cache_ in caches(sim._state)} <= lost


def caches(part: StatePart) -> Iterator[Cache]:
    """Yield every cache in a part."""
    for name in part.__struct_fields__:
        value = getattr(part, name)
        if isinstance(value, Cache):
            yield value
        elif isinstance(value, StatePart):
            yield from caches(value)


def forget_everything(sim: aftdeck.Simulation, lost: set[str]) -> None:
    """Empty every cache of a simulation, and compute again those that a saved state omits."""
    state, flown = sim._state, sim._flight
    lost |= {type(cache_).__name__ for cache_ in caches(state)}
    state.standing = Standing(flown.scenario.arm)
    if state.checking is not None:
        state.checking.rehearsal = Rehearsed()
    state.carried = carried_by(flown.scenario, flown.site, state.worksite, state.script)
    restore_clearances(flown, state)


@pytest.mark.parametrize(
    "spoilt",
    [
        pytest.param(lambda data: b"", id="nothing"),
        pytest.param(lambda data: data[:-1], id="cut"),
        pytest.param(lambda data: b"\xc0", id="no state"),
        pytest.param(lambda data: data.replace(b"srms", b"\xff\xff\xff\xff", 1)[::-1], id="backwards"),
    ],
)
def test_invalid_saved_bytes_are_rejected_without_effect(spoilt: Any) -> None:
    sim = aftdeck.Simulation("uncradle")
    for _ in range(3):
        sim.step()
    before, seal = sim.save(), sim.seal()
    with pytest.raises(InputError, match="saved state"):
        sim.restore(msgspec.structs.replace(before, state=spoilt(before.state)))
    assert sim.seal() == seal and sim.save() == before


def test_state_with_other_array_lengths_is_rejected() -> None:
    sim, other = aftdeck.Simulation("srms-berth"), aftdeck.Simulation("first-flight")
    with pytest.raises(InputError, match=r"worksite\.\w+"):
        sim.restore(msgspec.structs.replace(sim.save(), state=other.save().state))
