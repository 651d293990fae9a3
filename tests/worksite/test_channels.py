"""The operator's input channels: voltages against TABLE I, and encoding and decoding with noise."""

from __future__ import annotations

import math
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from aftdeck.errors import InputError
from aftdeck.historical.input_channels import (
    CAMERA,
    FULL_SCALE,
    START,
    STATION,
    OperatorInputs,
    decode_inputs,
    encode_inputs,
)

AT_REST = OperatorInputs(False, "full problem", (0.0,) * 6, 0, "none", 0, "E", 0)
inputs = st.builds(
    OperatorInputs,
    initialise=st.booleans(),
    start=st.sampled_from(sorted(START)),
    angles=st.tuples(*[st.floats(-FULL_SCALE, FULL_SCALE)] * 6),
    telescope=st.sampled_from([-1, 0, 1]),
    camera=st.sampled_from(sorted(CAMERA)),
    zoom=st.sampled_from([-1, 0, 1]),
    station=st.sampled_from(sorted(STATION)),
    prong=st.sampled_from([-1, 0, 1]),
)


@pytest.mark.parametrize(
    ("setting", "channel", "volts"),
    [
        ({"initialise": True}, 1, 1.0),
        ({"start": "mode 1"}, 2, 1.0),
        ({"start": "mode 2 or 3"}, 2, -1.0),
        ({"angles": (0.0, 2.0, 0.0, 0.0, 0.0, 0.0)}, 4, 0.25),
        ({"telescope": 1}, 9, 1.0),
        ({"telescope": -1}, 9, -1.0),
        ({"camera": "+pan"}, 10, 1.0),
        ({"camera": "-pan"}, 10, 0.5),
        ({"camera": "+tilt"}, 10, -0.5),
        ({"camera": "-tilt"}, 10, -1.0),
        ({"zoom": 1}, 11, 1.0),
        ({"station": "A"}, 12, 1.0),
        ({"station": "B"}, 12, 0.75),
        ({"station": "D"}, 12, 0.25),
        ({"station": "F"}, 12, -0.25),
        ({"station": "G"}, 12, -0.5),
        ({"station": "H"}, 12, -1.0),
        ({"prong": 1}, 13, 1.0),
        ({"prong": -1}, 13, -1.0),
    ],
)
def test_setting_has_the_voltage_of_table_i(setting: dict[str, Any], channel: int, volts: float) -> None:
    expected = [0.0] * 13
    expected[channel - 1] = volts
    assert encode_inputs(AT_REST._replace(**setting)) == pytest.approx(tuple(expected))


@given(inputs, st.tuples(*[st.floats(-0.12, 0.12)] * 13))
def test_switches_are_decoded_with_noise_of_an_eighth_of_a_volt(
    given_inputs: OperatorInputs, noise: tuple[float, ...]
) -> None:
    read = decode_inputs([volts + n for volts, n in zip(encode_inputs(given_inputs), noise, strict=True)])
    assert read._replace(angles=given_inputs.angles) == given_inputs
    for got, angle, n in zip(read.angles, given_inputs.angles, noise[2:8], strict=True):
        assert got == pytest.approx(angle + n * FULL_SCALE, abs=1e-12)


@given(st.tuples(*[st.floats(-FULL_SCALE, FULL_SCALE, allow_subnormal=False)] * 6))
def test_angles_keep_every_bit(angles: tuple[float, ...]) -> None:
    there = encode_inputs(AT_REST._replace(angles=angles))  # type: ignore[arg-type]
    for back, angle in zip(decode_inputs(there).angles, angles, strict=True):
        assert back.hex() == angle.hex() or abs(angle) < 1e-300  # below 1e-300 rad, the quotient loses precision


@pytest.mark.parametrize(
    ("setting", "pattern"),
    [
        ({"station": "I"}, "channel 12, .*'I'.* A, B, C, D, E, F, G, H"),
        ({"telescope": 2}, "channel 9, telescope: 2 "),
        ({"angles": (0.0, 0.0, 0.0, 0.0, 0.0, 8.1)}, r"channel 8, R2, .*8\.1 rad.* -8 to 8"),
    ],
)
def test_setting_without_a_level_is_rejected(setting: dict[str, Any], pattern: str) -> None:
    with pytest.raises(InputError, match=pattern):
        encode_inputs(AT_REST._replace(**setting))


def test_invalid_channels_are_rejected() -> None:
    with pytest.raises(InputError, match=r"13 channels.* 12 "):
        decode_inputs([0.0] * 12)
    with pytest.raises(InputError, match="channel 2 is nan V"):
        decode_inputs([0.0, math.nan, *[0.0] * 11])
    with pytest.raises(InputError, match=r"channel 3 is 100 V.* -1 to 1 V.*0\.125 V"):
        decode_inputs([0.0, 0.0, 100.0, *[0.0] * 10])
