"""Conversion of inputs and frames to messages and back."""

from __future__ import annotations

from typing import Annotated, Any

import hypothesis.strategies as st
import msgspec
import numpy as np
import pytest
from hypothesis import given, settings

import aftdeck
from aftdeck.field_meta import field_meta
from aftdeck.recording.codec import as_read, decode, encode
from aftdeck.recording.convert import DIGITS, frame_record, input_record, inputs_of
from aftdeck.recording.records import FrameRecord
from aftdeck.recording.schema import schema
from aftdeck.scenario.target import Target
from aftdeck.simulation.camera_drives import CameraDrive
from aftdeck.simulation.frame import Force, Frame, Holding
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.plain import plain_inputs
from aftdeck.steering.mode import MODES
from aftdeck.worksite.report import Work
from tests.steering.flying import scenario
from tests.steering.random_runs import equipped, inputs, start

COARSE = 0.51e-7
COARSER = {
    "translation",
    "rotation",
    "drive",
    "twist",
    "twist_commanded",
    "twist_demanded",
    "ratio",
    "singularity",
}
"""Fields that are recorded to seven decimals."""
GRAIN = 0.5000001 * 10**-9
"""Greatest rounding error of the numbers that are recorded to nine decimals."""
COARSE_WORK = 0.5000001 * 10**-5
"""Greatest rounding error of clearances and other quantities between bodies."""
FINE_FIELDS = {"stand", "orbiter", "orbiter_velocity", "master"}
"""Fields of the worksite with as many decimals as those of the arm."""
ROTATION_ERROR = 4e-9
"""Greatest error of a rotation matrix: its entries are products of rounded components of a quaternion."""

stick = st.floats(-1.0, 1.0)
three = st.tuples(stick, stick, stick)
number = st.floats(allow_nan=False, allow_infinity=False)
place = st.tuples(number, number, number)
targets = st.builds(
    Target,
    position=place,
    rotation=st.tuples(place, place, place),
    joints=st.none() | st.tuples(*[number] * 6),
)
any_inputs = st.builds(
    Inputs,
    translation=three,
    rotation=three,
    drive=stick,
    mode=st.none() | st.sampled_from(list(MODES)),
    joint=st.none() | st.integers(0, 5),
    rate=st.sampled_from([None, "coarse", "vernier"]),
    target=st.none() | targets,
    law=st.sampled_from([None, "position", "closed loop", "open loop"]),
    payload_axes=st.none() | st.booleans(),
    rate_hold=st.booleans(),
    position_hold=st.none() | st.booleans(),
    proceed=st.booleans(),
    stop=st.booleans(),
    effector=st.sampled_from([None, "stop", "close", "open"]),
    effector_mode=st.sampled_from([None, "auto", "manual"]),
    rigid=st.sampled_from([None, "off", "rigid", "derigid"]),
    latch=st.sampled_from([None, "latch", "unlatch"]),
    telescope=stick,
    orbiter=three,
    master=st.none() | st.tuples(*[number] * 6),
    initialise=st.sampled_from([None, "full problem", "acquisition", "extraction", "manoeuvring"]),
    camera=st.none() | st.builds(CameraDrive, camera=st.text(), pan=stick, tilt=stick, zoom=stick, slow=st.booleans()),
)


def through_json(record: msgspec.Struct) -> Any:
    return decode(type(record), encode(record))


@given(any_inputs, st.integers(1, 10**7))
def test_inputs_survive_to_the_last_bit(operator: Inputs, tick: int) -> None:
    record = through_json(input_record(tick, operator))
    assert record.tick == tick
    # compared as bytes, to distinguish 0.0 and -0.0
    assert msgspec.msgpack.encode(inputs_of(record)) == msgspec.msgpack.encode(plain_inputs(operator))


def test_scripted_step_has_no_inputs() -> None:
    assert inputs_of(through_json(input_record(7, None))) is None


def test_sticks_given_as_numpy_numbers_are_recorded() -> None:
    sticks: Any = tuple(np.array([0.1, -0.0, 1.0]))
    record = through_json(input_record(1, Inputs(translation=sticks, drive=np.float64(0.3))))
    assert record.translation == (0.1, 0.0, 1.0)
    assert record.drive == 0.3


def near(one: Any, other: Any, grain: float) -> bool:
    """Return whether all numbers of two values differ by at most `grain`, and everything else is equal."""
    if isinstance(one, float) and isinstance(other, float | int):
        return abs(one - other) <= grain
    if isinstance(one, msgspec.Struct) and type(one) is type(other):
        return near(msgspec.structs.astuple(one), msgspec.structs.astuple(other), grain)
    if isinstance(one, tuple | list):
        return len(one) == len(other) and all(near(a, b, grain) for a, b in zip(one, other, strict=True))
    return bool(one == other)


def check_work(was: Work, now: Work) -> None:
    for name in Work.__struct_fields__:
        one, other = getattr(was, name), getattr(now, name)
        if name == "cargo":
            for a, b in zip(one, other, strict=True):
                assert near(a.orientation, b.orientation, ROTATION_ERROR)
                assert near(a, msgspec.structs.replace(b, orientation=a.orientation), GRAIN)
        else:
            assert near(one, other, GRAIN if name in FINE_FIELDS else COARSE_WORK), name


def check_round_trip(frame: Frame) -> None:
    back = through_json(frame_record(frame, 1.5, 42.0))
    assert back == as_read(frame_record(frame, 1.5, 42.0))
    assert (back.wall_s, back.latency_ms) == (1.5, 42.0)
    for name in Frame.__struct_fields__:
        was, now = getattr(frame, name), getattr(back, name)
        if name in ("orientation", "wrist_pitch"):
            assert near(was, now, ROTATION_ERROR), name
        elif name == "payload" and was is not None:
            assert near(was.position, now.position, GRAIN) and near(was.orientation, now.orientation, ROTATION_ERROR)
        elif name == "goal" and was is not None:
            assert now is not None
            assert near(was.rotation, now.rotation, ROTATION_ERROR) and near(was.position, now.position, GRAIN)
            remaining, remaining_now = ((g.distance, g.angle, g.remaining_s) for g in (was, now))
            assert near(remaining, remaining_now, GRAIN)
        elif name == "work":
            check_work(was, now)
        elif name == "sha256":
            assert len(now) == DIGITS and was.startswith(now)
        else:
            assert near(was, now, COARSE if name in COARSER else GRAIN), name


@settings(max_examples=6)
@given(st.integers(0, 2**32))
def test_frames_of_random_runs_survive_to_their_decimals(seed: int) -> None:
    rng = np.random.default_rng(seed)
    first = start(rng)
    sim = aftdeck.Simulation(scenario(first.tolist(), equipped(rng, first, "32000 lb" if seed % 2 else "")))
    operator = inputs(rng, sim)
    for k in range(150):
        frame = sim.step(next(operator))
        if k % 10 == 0:
            check_round_trip(frame)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["concept-1972-script", "srms-berth", "free-flyer"])
def test_frames_of_a_worksite_survive(name: str) -> None:
    sim = aftdeck.Simulation(name)
    for k in range(2500):
        frame = sim.step()
        if k % 50 == 0 or frame.events:
            check_round_trip(frame)


@pytest.mark.parametrize("mode", MODES)
def test_frame_of_every_mode_survives(mode: str) -> None:
    rng = np.random.default_rng(1)
    sim = aftdeck.Simulation(
        scenario(extra=equipped(rng, np.array((-31.0, 79.0, -103.0, -77.0, 17.0, -128.0)), "32000 lb"))
    )
    sim.step(Inputs(mode=mode, proceed=True))
    check_round_trip(sim.step(Inputs(translation=(0.5, 0.0, -0.2), drive=1.0)))


def test_added_frame_field_is_recorded_without_second_declaration() -> None:
    wind = Annotated[float, field_meta("wind speed", "m/s", decimals=2)]
    kind = msgspec.defstruct("WithMore", [("wind", wind)], bases=(FrameRecord,), frozen=True, kw_only=True)
    sim = aftdeck.Simulation("first-flight")
    made = frame_record(sim.step(Inputs()), 0.0, None)
    known = {name: getattr(made, name) for name in FrameRecord.__struct_fields__}
    back: Any = decode(kind, encode(kind(**known, wind=1.2345)))
    assert back.wind == 1.23 and back.angles == as_read(made).angles
    assert schema(kind)["properties"]["wind"] == {"type": "number", "description": "wind speed [m/s]"}


def test_forces_of_an_earlier_version_are_their_own_greatest() -> None:
    force = decode(Force, b'{"a": "a", "b": "b", "force": [3.0, 4.0, 0.0], "position": [0.0, 0.0, 0.0]}')
    hold = decode(Holding, b'{"payload": "payload", "by": "orbiter", "force": 7.0}')
    assert (force.greatest, force.peak, hold.greatest, hold.peak) == (None, 5.0, None, 7.0)
