"""Inputs of any kind: an object is flown as its plain value, or rejected by an `InputError` without any effect."""

from __future__ import annotations

import functools
import random
from collections.abc import Callable
from typing import Any, cast

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import aftdeck
from aftdeck import Inputs
from aftdeck.errors import InputError
from aftdeck.frames import Pose
from aftdeck.simulation.camera_drives import CameraDrive
from aftdeck.simulation.run import Simulation
from aftdeck.steering.batch import steer_batch
from fuzz.inputs import Endless, Foreign, OwnNumber, OwnText, Rude, RudeFloat, inputs_of_any_kind
from tests import loaded

UNIT = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


@functools.cache
def simulation() -> Simulation:
    return Simulation("concept-1972")


def seal(sim: Simulation) -> bytes:
    sim._seal = b""
    return sim.seal()


@settings(max_examples=200, deadline=None)
@given(st.randoms(use_true_random=False))
def test_step_flies_plain_values_or_leaves_the_state_unchanged(rng: random.Random) -> None:
    sim = simulation()
    before = seal(sim)
    try:
        sim.step(inputs_of_any_kind(rng))
    except InputError:
        assert seal(sim) == before
    else:
        assert sim.given is not None
        for name in Inputs.__struct_fields__:
            value = getattr(sim.given, name)
            assert type(value) in (float, int, bool, str, tuple, dict, CameraDrive, aftdeck.Target, type(None))
    sim.step(Inputs())


PLAIN: list[tuple[dict[str, Any], dict[str, Any]]] = [
    ({"translation": np.array([0.5, 0, -0.5], dtype=np.float32)}, {"translation": (0.5, 0.0, -0.5)}),
    ({"translation": np.array([1, 0, -1])}, {"translation": (1.0, 0.0, -1.0)}),
    ({"rotation": [np.float16(0.5), np.int8(1), np.longdouble(0)]}, {"rotation": (0.5, 1.0, 0.0)}),
    ({"telescope": np.float32(0.25)}, {"telescope": 0.25}),
    ({"drive": OwnNumber(0.5)}, {"drive": 0.5}),
    ({"drive": np.array(1, dtype=np.int16)}, {"drive": 1.0}),
    ({"brakes": np.bool_(True)}, {"brakes": True}),
    ({"proceed": np.int8(1)}, {"proceed": True}),
    ({"joint": np.uint8(3)}, {"joint": 3}),
    ({"mode": np.str_("SINGLE")}, {"mode": "SINGLE"}),
    ({"rate": OwnText("vernier")}, {"rate": "vernier"}),
    ({"master": np.zeros(6, dtype=np.float16)}, {"master": (0.0,) * 6}),
    (
        {"target": aftdeck.Target(cast("Any", np.zeros(3, np.float32)), cast("Any", np.eye(3, dtype=np.int8)))},
        {"target": aftdeck.Target((0.0, 0.0, 0.0), UNIT)},
    ),
    (
        {"camera": CameraDrive(np.str_("A"), np.float32(0.5), slow=np.bool_(False))},  # type: ignore[arg-type]
        {"camera": CameraDrive("A", 0.5)},
    ),
]


@pytest.mark.parametrize(("given_values", "plain"), PLAIN, ids=lambda values: next(iter(values)))
def test_value_of_another_type_is_flown_as_its_plain_value(given_values: dict[str, Any], plain: dict[str, Any]) -> None:
    one, other = Simulation("concept-1972"), Simulation("concept-1972")
    assert one.step(Inputs(**given_values)) == other.step(Inputs(**plain))
    assert one.given == other.given == Inputs(**plain)
    for name in plain:
        assert repr(getattr(one.given, name)) == repr(getattr(other.given, name))


FOREIGN: list[object] = [
    {0.5}, b"abc", bytearray(3), {"a": 1}, iter([0.0] * 3), (x for x in [0.0] * 3), "no", "0.5", ["0.5"] * 3, object(),
    Rude(), [Rude()] * 3, RudeFloat(0.5), Foreign(), Endless(), 10**400, [10**400] * 3, float("nan"), 1j,
    [float("nan")] * 3, [None] * 3, [True] * 3, np.array(["0.5"] * 3), np.array([1j] * 3), np.zeros((3, 1)),
    np.zeros(0), np.datetime64("2020-01-01"), np.bytes_(b"x"), range(50), type, NotImplemented, Inputs(),
]  # fmt: skip
"""Objects that no field of `Inputs` allows."""


@pytest.mark.parametrize("name", Inputs.__struct_fields__)
def test_foreign_object_is_rejected_with_the_field_and_the_state_unchanged(name: str) -> None:
    sim = simulation()
    for value in FOREIGN:
        if name == "mode" and isinstance(value, str):
            continue  # any text may be entered; the step logs that the mode does not exist
        fields: dict[str, Any] = {name: value}
        before = seal(sim)
        with pytest.raises(InputError, match=rf"^{name}: "):
            sim.step(Inputs(**fields))
        assert seal(sim) == before
        sim.step(Inputs())


def test_foreign_object_instead_of_inputs_is_rejected() -> None:
    sim = simulation()
    before = seal(sim)
    for value in (*FOREIGN, {}, (), 0, ""):
        if not isinstance(value, Inputs):
            with pytest.raises(InputError, match=r"^inputs: "):
                sim.step(value)  # type: ignore[arg-type]
    assert seal(sim) == before


def test_seed_is_an_integer_in_its_range() -> None:
    for value in (-1, 2**53 + 1, 10**400, True, "1", 1.0, Rude(), {1}):
        with pytest.raises(InputError, match=r"^seed: "):
            Simulation("free-flyer", value)  # type: ignore[arg-type]


def steered(angles: Any, target: Any = None, **changed: Any) -> object:
    target = loaded.arm().forward(np.zeros(6)) if target is None else target
    return steer_batch(loaded.arm(), angles, target, **{"period": 0.02, "gain": 1.0, **changed})


CALLS: list[Callable[[Any], object]] = [
    lambda value: loaded.arm().forward(value),
    lambda value: loaded.arm().jacobian(value),
    lambda value: loaded.arm().singularities(value),
    lambda value: loaded.arm().inverse(value),
    lambda value: loaded.arm().rmangs(value),
    lambda value: loaded.arm().panel(value),
    lambda value: loaded.arm().orbiter(value),
    lambda value: loaded.arm().end_effector(value),
    lambda value: loaded.arm().at(stand=value),
    lambda value: loaded.arm().joint_rates(value, np.zeros(6)),
    lambda value: loaded.arm().joint_rates(np.zeros(6), value),
    lambda value: loaded.arm().joint_rates(np.zeros(6), np.zeros(6), singular=value),
    lambda value: loaded.arm().inverse(Pose(value, np.eye(3))),
    lambda value: loaded.arm().inverse(Pose(np.zeros(3), value)),
    lambda value: loaded.arm().inverse(loaded.arm().forward([0.1] * 6), near=value),
    lambda value: loaded.arm().panel(Pose(np.zeros(3), value)),
    lambda value: loaded.arm().from_panel(value, np.zeros(3)),
    lambda value: loaded.arm().from_panel(np.zeros(3), value),
    lambda value: steered(value, np.zeros(12)),
    lambda value: steered(np.zeros(6), value),
    lambda value: steered(np.zeros(6), steps=value),
    lambda value: steered(np.zeros(6), period=value),
    lambda value: steered(np.zeros(6), gain=value),
    lambda value: simulation().ahead(value),
    lambda value: simulation().ahead(5.0, value),
    lambda value: simulation().restore(value),
]


@pytest.mark.parametrize("call", CALLS)
def test_foreign_argument_is_an_input_error(call: Callable[[Any], object]) -> None:
    for value in FOREIGN:
        with pytest.raises(InputError):
            call(value)


@pytest.mark.parametrize("load", [aftdeck.load_arm, aftdeck.load_scenario, Simulation])
def test_foreign_name_is_an_input_error(load: Callable[[Any], object]) -> None:
    for value in (3, None, b"srms", Rude(), ["srms"]):
        with pytest.raises(InputError):
            load(value)
