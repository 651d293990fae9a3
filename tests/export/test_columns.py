"""Inputs as numbers, and back without loss."""

from __future__ import annotations

from typing import Any

import msgspec
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from aftdeck.errors import InputError
from aftdeck.export.columns import SCRIPT, Encoding
from aftdeck.scenario.disturbance import Disturbance
from aftdeck.scenario.target import Target
from aftdeck.simulation.camera_drives import CameraDrive
from aftdeck.simulation.inputs import POSITIONS, Inputs
from aftdeck.simulation.readings.panel import MODE_NUMBERS
from aftdeck.steering.mode import MODES
from aftdeck.tuples import MOST_JOINTS

DRIVEN = ("A", "AFT P")
ENCODING = Encoding(DRIVEN, 6)

stick = st.floats(-1.0, 1.0).map(lambda x: x + 0.0)
three, number = st.tuples(stick, stick, stick), st.floats(-1e6, 1e6)
rows = st.tuples(*[st.tuples(*[number] * 3)] * 3)


def fields(joints: int = 6) -> dict[str, st.SearchStrategy[Any]]:
    """Return any value of each field of `Inputs`, for an arm with this number of joints."""
    angles = st.tuples(*[number] * joints)
    return {
        **{name: st.sampled_from([None, *positions]) for name, positions in POSITIONS.items()},
        **dict.fromkeys(("translation", "rotation", "orbiter"), three),
        **dict.fromkeys(("drive", "telescope"), stick),
        **dict.fromkeys(("rate_hold", "proceed", "stop"), st.booleans()),
        "mode": st.sampled_from([None, *MODES]),
        "joint": st.sampled_from([None, *range(joints)]),
        "master": st.none() | angles,
        "target": st.none() | st.builds(Target, st.tuples(*[number] * 3), rows, st.none() | angles),
        "disturbances": st.just(()),
        "changes": st.just({}),
        "script": st.just(False),
        "camera": st.none() | st.builds(CameraDrive, st.sampled_from(DRIVEN), stick, stick, stick, st.booleans()),
    }


inputs = st.builds(Inputs, **fields())


def test_every_field_of_the_inputs_has_columns() -> None:
    assert set(fields()) == set(Inputs.__struct_fields__) == {field.name for field in ENCODING.fields}
    assert len(set(ENCODING.names)) == len(ENCODING.names)


@given(st.data(), st.integers(1, MOST_JOINTS))
def test_numbers_give_back_the_inputs(data: st.DataObject, joints: int) -> None:
    encoding, given_inputs = Encoding(DRIVEN, joints), data.draw(st.builds(Inputs, **fields(joints)))
    numbers = encoding.encode(given_inputs)
    assert encoding.decode(numbers) == given_inputs
    assert len(numbers) == len(encoding.names)
    assert encoding.decode(encoding.encode(msgspec.structs.replace(given_inputs, script=True))) is None


@given(inputs)
def test_inputs_that_are_held_have_no_switch_and_no_button(given_inputs: Inputs) -> None:
    held = ENCODING.decode(ENCODING.encode(given_inputs), held_only=True)
    assert held is not None
    assert held.translation == given_inputs.translation and held.camera == given_inputs.camera
    assert not any(getattr(held, name) for name in (*POSITIONS, "mode", "joint", "target", "rate_hold", "proceed"))


@given(inputs, st.data())
def test_columns_that_are_0_can_be_left_out(given_inputs: Inputs, data: st.DataObject) -> None:
    numbers = np.array([ENCODING.encode(given_inputs)])
    used = [name for name, value in zip(ENCODING.names, numbers[0], strict=True) if value]
    names = data.draw(st.permutations(used))
    assert (ENCODING.completed(names, numbers[:, ENCODING.index(names)]) == numbers).all()


def test_centred_inputs_are_0() -> None:
    assert not any(ENCODING.encode(Inputs()))


@pytest.mark.parametrize(
    ("column", "value", "part"),
    [
        ("rate", 7.0, "rate: got 7"),
        ("camera", 3.0, "camera: got 3"),
        ("joint", -2.0, "-2"),
        ("mode", float("nan"), "nan"),
        ("script", float("inf"), "inf"),
        ("target", 7.0, "7"),
        ("master", -1.0, "-1"),
    ],
)
def test_number_without_a_position_is_rejected(column: str, value: float, part: str) -> None:
    numbers = [0.0] * len(ENCODING.names)
    numbers[ENCODING.names.index(column)] = value
    with pytest.raises(InputError, match=part):
        ENCODING.decode(numbers)


def test_every_mode_has_a_number_of_its_own() -> None:
    assert set(MODE_NUMBERS) == set(MODES) and len(set(MODE_NUMBERS.values())) == len(MODES)


def test_disturbances_have_no_numbers() -> None:
    with pytest.raises(InputError, match="disturbances"):
        ENCODING.encode(Inputs(disturbances=(Disturbance("tip", (1.0, 0.0, 0.0)),)))


def test_mode_without_a_number_is_rejected() -> None:
    with pytest.raises(InputError, match="'FREE' has no number"):
        ENCODING.encode(Inputs(mode="FREE"))


@pytest.mark.parametrize("names", [["thc_x", "thc_q"], ["thc_x", "thc_x"]])
def test_unknown_or_repeated_columns_are_rejected(names: list[str]) -> None:
    with pytest.raises(InputError, match="expected different names of thc_x, "):
        ENCODING.index(names)


def test_script_is_the_last_column() -> None:
    assert ENCODING.names[-1] == SCRIPT.name
