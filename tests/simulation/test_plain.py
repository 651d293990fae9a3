"""Numbers, arrays and texts of NumPy's types are accepted like those of Python's types, with the same results."""

from __future__ import annotations

import functools
import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import aftdeck
from aftdeck import Inputs
from aftdeck.errors import InputError
from aftdeck.files import Where
from aftdeck.recording.run import record
from aftdeck.scenario.load import load_scenario, parse_scenario
from aftdeck.scenario.target import Target, target_at
from aftdeck.simulation.camera_drives import CameraDrive
from tests import loaded

NUMBER_TYPES: list[Callable[[Any], Any]] = [
    np.float64,
    np.float32,
    np.float16,
    np.array,
    lambda x: np.array(x, dtype=np.float32),
    lambda x: int(x) if float(x).is_integer() else x,
    lambda x: np.int64(x) if float(x).is_integer() else np.float64(x),
    float,
]
"""Types for a number in inputs; each keeps a value that is exact in half precision."""
halves = st.integers(-64, 64).map(lambda k: k / 64)
threes = st.tuples(halves, halves, halves)
flags = st.one_of(st.none(), st.booleans())


def choice(*names: str) -> st.SearchStrategy[str | None]:
    return st.sampled_from([None, *names])


@functools.cache
def start() -> Target:
    """Return the pose at which the scenario starts."""
    scenario = loaded.scenario("concept-1972")
    return target_at(scenario.arm.forward(scenario.initial_angles))


inputs = st.builds(
    Inputs, translation=threes, rotation=threes, drive=halves, mode=choice("MASTER", "SINGLE", "OPR CMD", "END EFF"),
    joint=st.one_of(st.none(), st.integers(0, 5)), rate=choice("coarse", "vernier"), law=choice("open loop"),
    target=st.one_of(st.none(), st.builds(start)), rate_hold=st.booleans(), position_hold=flags, brakes=flags,
    safing=flags,
    proceed=st.booleans(), stop=st.booleans(), effector=choice("stop", "close", "open"), latch=choice("latch"),
    telescope=halves, orbiter=threes, master=st.one_of(st.none(), st.tuples(*[halves] * 6)),
    camera=st.one_of(st.none(), st.builds(CameraDrive, st.sampled_from("ABF"), halves, halves, halves, st.booleans())),
)  # fmt: skip


def as_numpy(given: Inputs, data: st.DataObject) -> Inputs:
    """Return the same inputs with values of random NumPy types."""

    def number(value: float) -> Any:
        return data.draw(st.sampled_from(NUMBER_TYPES))(value)

    def some(values: Any) -> Any:
        wrapped: Any = data.draw(st.sampled_from([tuple, list, np.array]))
        return wrapped([number(value) for value in values])

    def of(value: Any) -> Any:
        if isinstance(value, bool):
            return np.bool_(value)
        if isinstance(value, str):
            return np.str_(value)
        if isinstance(value, int):
            return np.int16(value)
        if isinstance(value, float):
            return number(value)
        if isinstance(value, tuple):
            return some(value) if value else list(value)
        if isinstance(value, CameraDrive):
            return CameraDrive(*map(of, msgspec.structs.astuple(value)))
        if isinstance(value, aftdeck.Target):
            pose = value.pose
            return aftdeck.Target(pose.position, tuple(pose.rotation))  # type: ignore[arg-type]
        return value

    return Inputs(*map(of, msgspec.structs.astuple(given)))


@settings(max_examples=12)
@given(st.lists(inputs, min_size=1, max_size=6), st.data())
def test_run_with_numpy_inputs_is_the_same(flight: list[Inputs], data: st.DataObject) -> None:
    plain, other = aftdeck.Simulation("concept-1972"), aftdeck.Simulation("concept-1972", np.int64(0))  # type: ignore[arg-type]
    for step in flight:
        assert plain.step(step) == other.step(as_numpy(step, data))
        one, two = (msgspec.msgpack.encode(sim.save()) for sim in (plain, other))
        assert one == two and msgspec.msgpack.decode(two, type=type(plain.save())) == plain.save()


def test_target_joint_angles_may_be_an_array() -> None:
    made = load_scenario("first-flight")
    plain = target_at(made.arm.forward(made.initial_angles), tuple(made.initial_angles.tolist()))
    other = aftdeck.Target(plain.position, plain.rotation, np.array(plain.joints))  # type: ignore[arg-type]
    one, two = aftdeck.Simulation(made), aftdeck.Simulation(made)
    assert one.step(Inputs(target=plain)) == two.step(Inputs(target=other))


def test_delayed_input_is_stored_in_plain_values() -> None:
    scenario = parse_scenario(
        load_scenario("concept-1972").text, "late", "late.toml", Path("."), {("command_delay",): np.float64(0.1)}
    )
    sim = aftdeck.Simulation(scenario)
    sim.step(Inputs(translation=np.array([0.5, 0.0, -0.5]), joint=np.int8(3)))  # type: ignore[arg-type]
    again = msgspec.msgpack.decode(msgspec.msgpack.encode(sim.save()), type=type(sim.save()))
    assert again == sim.save()


def test_negative_zero_deflection_equals_zero() -> None:
    """A digest distinguishes -0.0 from 0.0, and a page can send either of them for a centred stick."""
    one, other = aftdeck.Simulation("first-flight"), aftdeck.Simulation("first-flight")
    for sim, zero in ((one, 0.0), (other, -0.0)):
        sim.step(Inputs((zero, 0.5, zero), (zero, zero, zero), zero, telescope=zero, orbiter=(zero, zero, zero)))
    assert one.frame == other.frame and math.copysign(1.0, one.step().translation[0]) == 1.0


def test_seed_time_and_axis_may_be_numpy_numbers(tmp_path: Path) -> None:
    sim = aftdeck.Simulation("first-flight", np.int32(7))  # type: ignore[arg-type]
    sim.step(Inputs())
    assert msgspec.json.encode(sim.save()) and sim.seed == 7
    found = sim.ahead(np.float64(2.0), (np.int64(3), np.int64(-1)))  # type: ignore[arg-type]
    assert found == sim.ahead(2.0, (3, -1)) and msgspec.json.encode(found)
    given = iter([Inputs(), Inputs()])
    done = record("first-flight", tmp_path / "run.mcap", np.int64(5), inputs=lambda _: next(given, None))  # type: ignore[arg-type]
    assert done.summary.seed == 5 and msgspec.json.encode(done.summary)


@settings(max_examples=10)
@given(st.sampled_from(NUMBER_TYPES[:5]))
def test_scenario_changes_may_be_numpy_numbers(kind: Callable[[Any], Any]) -> None:
    text = load_scenario("first-flight").text
    joints = np.array([0.0, 0.5, -0.5, 0.25, 0.0, 0.0], dtype=np.float32)
    changes: dict[Where, object] = {("duration",): kind(2.0), ("seed",): np.uint8(3), ("initial",): {"joints": joints}}
    found = parse_scenario(text, "t", "t.toml", Path("."), changes)
    assert (found.duration, found.seed) == (2.0, 3) and found.initial_angles.tolist() == joints.tolist()


@pytest.mark.parametrize("seed", [1.5, np.float64(1.0), "1", True, None.__class__])
def test_seed_that_is_not_an_integer_is_rejected(seed: Any) -> None:
    with pytest.raises(InputError, match="seed"):
        aftdeck.Simulation("first-flight", seed)
