"""Inputs and frames become messages and come back."""

from __future__ import annotations

from typing import Any

import hypothesis.strategies as st
import msgspec
import numpy as np
import pytest
from hypothesis import given, settings

import aftdeck
from aftdeck.recording.convert import DECIMALS, DIGITS, frame_of, frame_record, input_record, inputs_of
from aftdeck.recording.convert_work import DECIMALS as WORK_DECIMALS
from aftdeck.recording.records import FrameRecord, Input
from aftdeck.scenario.target import Target
from aftdeck.simulation.cameras import CameraDrive
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.inputs import Inputs
from aftdeck.steering.mode import MODES
from aftdeck.worksite.report import Work
from tests.steering.flying import scenario
from tests.steering.test_promises import equipped, inputs, start

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
"""What is recorded to seven decimals."""
GRAIN = 0.5000001 * 10**-DECIMALS
"""Rounding of a number."""
COARSE_WORK = 0.5000001 * 10**-WORK_DECIMALS
"""Rounding of what is measured between bodies."""
PLACES = {"stand", "orbiter", "orbiter_velocity", "master"}
"""Of the worksite, what is recorded as finely as the arm."""
TURNED = 4e-9
"""Of an attitude's matrix: each entry is made of products of its quaternion's four rounded numbers."""

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
anything = st.builds(
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
    return msgspec.json.decode(msgspec.json.encode(record), type=type(record))


@given(anything, st.integers(1, 10**7))
def test_inputs_come_back_to_the_last_bit(operator: Inputs, tick: int) -> None:
    record = through_json(input_record(tick, operator))
    assert record.tick == tick
    # encoded, so that 0.0 and -0.0 are told apart
    assert msgspec.msgpack.encode(inputs_of(record)) == msgspec.msgpack.encode(operator)


def test_every_field_of_inputs_has_its_counterpart() -> None:
    told = {name.removeprefix("target_") for name in Input.__struct_fields__} - {"tick", "script"}
    assert told == set(Inputs.__struct_fields__) - {"target"} | {"position", "rotation", "joints"}
    target = {name.removeprefix("target_") for name in Input.__struct_fields__ if name.startswith("target_")}
    assert target == set(Target.__struct_fields__)


def test_a_step_that_the_script_flew_has_nobodys_inputs() -> None:
    assert inputs_of(through_json(input_record(7, None))) is None


def test_sticks_given_as_numpys_numbers_are_recorded_as_they_were_flown() -> None:
    given_by_a_policy: Any = tuple(np.array([0.1, -0.0, 1.0]))
    record = through_json(input_record(1, Inputs(translation=given_by_a_policy, drive=np.float64(0.3))))
    assert record.translation == (0.1, 0.0, 1.0)
    assert record.drive == 0.3


def near(one: Any, other: Any, grain: float) -> bool:
    """Whether all numbers of two values are alike, and everything else equal."""
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
                assert near(a.orientation, b.orientation, TURNED)
                assert near(a, msgspec.structs.replace(b, orientation=a.orientation), GRAIN)
        else:
            assert near(one, other, GRAIN if name in PLACES else COARSE_WORK), name


def check_round_trip(frame: Frame) -> None:
    record = through_json(frame_record(frame, 1.5, 42.0))
    assert record == frame_record(frame, 1.5, 42.0)
    back = frame_of(record)
    for name in Frame.__struct_fields__:
        was, now = getattr(frame, name), getattr(back, name)
        if name in ("orientation", "wrist_pitch"):
            assert near(was, now, TURNED), name
        elif name == "payload" and was is not None:
            assert now is not None and near(was[0], now[0], GRAIN) and near(was[1], now[1], TURNED)
        elif name == "goal" and was is not None:
            assert now is not None
            assert near(was.rotation, now.rotation, TURNED) and near(was.position, now.position, GRAIN)
            left, left_now = ((g.distance, g.angle, g.remaining_s) for g in (was, now))
            assert near(left, left_now, GRAIN)
        elif name == "work":
            check_work(was, now)
        elif name == "check" and was is not None:  # recorded as it is told
            assert now is not None and (was.good, was.text) == (now.good, now.text)
        elif name == "sha256":
            assert len(now) == DIGITS and was.startswith(now)
        else:
            assert near(was, now, COARSE if name in COARSER else GRAIN), name


@settings(max_examples=6)
@given(st.integers(0, 2**32))
def test_frames_of_random_flights_come_back_to_nine_decimals(seed: int) -> None:
    rng = np.random.default_rng(seed)
    first = start(rng)
    sim = aftdeck.Simulation(scenario(first.tolist(), equipped(rng, first, "32000 lb" if seed % 2 else "")))
    operator = inputs(rng, sim)
    for k in range(150):
        frame = sim.step(next(operator))
        if k % 10 == 0:
            check_round_trip(frame)


@pytest.mark.parametrize("name", ["concept-1972-script", "srms-berth", "free-flyer"])
def test_frames_of_a_worksite_come_back(name: str) -> None:
    sim = aftdeck.Simulation(name)
    for k in range(2500):
        frame = sim.step()
        if k % 50 == 0 or frame.events:
            check_round_trip(frame)


@pytest.mark.parametrize("mode", MODES)
def test_a_frame_of_every_panel_position_is_told_in_finite_numbers(mode: str) -> None:
    rng = np.random.default_rng(1)
    sim = aftdeck.Simulation(
        scenario(extra=equipped(rng, np.array((-31.0, 79.0, -103.0, -77.0, 17.0, -128.0)), "32000 lb"))
    )
    sim.step(Inputs(mode=mode, proceed=True))
    check_round_trip(sim.step(Inputs(translation=(0.5, 0.0, -0.2), drive=1.0)))


def test_a_frames_own_fields_are_all_recorded() -> None:
    renamed = {
        "angles": "angles_rad",
        "rates": "rates_rad_s",
        "angles_commanded": "angles_commanded_rad",
        "rates_commanded": "rates_commanded_rad_s",
        "rate_limits": "rate_limits_rad_s",
        "position": "tip_m",
        "orientation": "tip_rotation",
        "resolution": "point_m",
        "payload": "payload_m",
    }
    of_the_recording = {"wall_s", "latency_ms", "sha256", "payload_rotation"}
    told = {renamed.get(name, name) for name in Frame.__struct_fields__} | of_the_recording
    assert told == set(FrameRecord.__struct_fields__)
