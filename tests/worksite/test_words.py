"""The scene generator's words: bits against TABLE II, and encoding followed by decoding."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from aftdeck.errors import InputError
from aftdeck.historical.frame_words import (
    STATIONS,
    ControlWord,
    FrameBlock,
    WordPlane,
    decode_block,
    decode_control,
    encode_block,
    encode_control,
    fixed,
    number,
)

ways = st.sampled_from([-1, 0, 1])
controls = st.builds(
    ControlWord,
    mode=st.sampled_from([1, 2, 3, 4]),
    station=st.sampled_from(sorted(STATIONS)),
    initialise=st.booleans(),
    telescope=ways,
    pan=ways,
    tilt=ways,
    zoom=ways,
    prong=ways,
    finger_inhibited=st.booleans(),
    arm_inhibited=st.booleans(),
).filter(lambda control: control.pan * control.tilt >= 0)

LEVEL = WordPlane((0.0, 0.0, -1.0), 0.0)
AT_REST = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


@pytest.mark.parametrize(
    ("control", "bits"),
    [
        (ControlWord(1, "A"), "0000 0000 0000 0000 0000 0001"),
        (ControlWord(2, "B"), "0000 0000 0001 0000 0000 0010"),
        (ControlWord(3, "C"), "0000 0000 0010 0000 0000 0100"),
        (ControlWord(4, "H"), "0000 0000 1010 0000 0000 1000"),
        (ControlWord(1, "A", initialise=True), "1000 0000 0000 0000 0000 0001"),
        (ControlWord(1, "A", telescope=1), "0110 0000 0000 0000 0000 0001"),
        (ControlWord(1, "A", telescope=-1), "0100 0000 0000 0000 0000 0001"),
        (ControlWord(1, "A", tilt=1), "0001 1000 0000 0000 0000 0001"),
        (ControlWord(1, "A", tilt=-1), "0001 0000 0000 0000 0000 0001"),
        (ControlWord(1, "A", pan=1), "0000 1100 0000 0000 0000 0001"),
        (ControlWord(1, "A", pan=-1), "0000 0100 0000 0000 0000 0001"),
        (ControlWord(1, "A", zoom=1), "0000 0011 0000 0000 0000 0001"),
        (ControlWord(1, "A", zoom=-1), "0000 0010 0000 0000 0000 0001"),
        (ControlWord(1, "A", prong=-1), "0000 0000 0000 1000 0000 0001"),
        (ControlWord(1, "A", prong=1), "0000 0000 0000 0100 0000 0001"),
        (ControlWord(1, "A", finger_inhibited=True), "0000 0000 0000 0000 0010 0001"),
        (ControlWord(1, "A", arm_inhibited=True), "0000 0000 0000 0000 0001 0001"),
    ],
)
def test_control_word_bits_match_table_ii(control: ControlWord, bits: str) -> None:
    assert encode_control(control) == int(bits.replace(" ", ""), 2)


def test_station_codes_are_unique() -> None:
    assert len(set(STATIONS.values())) == len(STATIONS)


@given(controls)
def test_control_word_round_trips(control: ControlWord) -> None:
    assert decode_control(encode_control(control)) == control


@given(st.integers(0, 2**24 - 1))
def test_decoded_control_word_encodes_to_itself(word: int) -> None:
    try:
        control = decode_control(word)
    except InputError:
        return
    idle = 0  # sign bits of drives that do not move
    if not control.telescope:
        idle |= 1 << 21
    if not (control.pan or control.tilt):
        idle |= 1 << 19
    if not control.zoom:
        idle |= 1 << 16
    assert encode_control(control) == word & ~idle


@pytest.mark.parametrize(
    ("word", "pattern"),
    [
        (1 << 24, "control word is 16777216; .* 24 bits"),
        (-1, "control word is -1"),
        (1.5, r"control word is 1\.5"),
        ("a", "control word is 'a'"),
        (None, "control word is None"),
        (0x000201, "14 to 17"),
        (0x00D001, "1101"),
        (0x000C01, "prong"),
        (0x000000, " 0 modes"),
        (0x000003, " 2 modes"),
    ],
)
def test_invalid_control_word_is_rejected(word: Any, pattern: str) -> None:
    with pytest.raises(InputError, match=pattern):
        decode_control(word)


@pytest.mark.parametrize(
    ("wrong", "pattern"),
    [
        ({"mode": 5}, "mode is 5; .*1, 2, 3 or 4"),
        ({"mode": 1.0}, r"mode is 1\.0; .*1, 2, 3 or 4"),
        ({"mode": "1"}, "mode is '1'; .*1, 2, 3 or 4"),
        ({"station": "Z"}, "station 'Z'; .*A, B"),
        ({"station": []}, r"station \[\]; .*A, B"),
        ({"zoom": 2}, "zoom is 2; .*-1, 0 or 1"),
        ({"prong": None}, "prong is None; .*-1, 0 or 1"),
        ({"initialise": 2}, "initialise is 2; .*True or False"),
        ({"initialise": "x"}, "initialise is 'x'; .*True or False"),
        ({"finger_inhibited": None}, "finger_inhibited is None; .*True or False"),
        ({"arm_inhibited": []}, r"arm_inhibited is \[\]; .*True or False"),
        ({"pan": 1, "tilt": -1}, "pan and tilt"),
    ],
)
def test_value_without_a_code_is_rejected(wrong: dict[str, Any], pattern: str) -> None:
    with pytest.raises(InputError, match=pattern):
        encode_control(ControlWord(**{"mode": 1, "station": "A", **wrong}))


@pytest.mark.parametrize(
    ("value", "scale", "word"),
    [
        (0.0, 0, 0x000000),
        (0.5, 0, 0x400000),
        (-0.5, 0, 0xC00000),
        (-1.0, 0, 0x800000),
        (1.0, 0, 0x7FFFFF),
        (1.0, 1, 0x400000),
        (-1.0, 1, 0xC00000),
        (1.0, 11, 0x001000),
        (-2048.0, 11, 0x800000),
        (2.0**-23, 0, 0x000001),
        (-(2.0**-23), 0, 0xFFFFFF),
    ],
)
def test_fixed_point_words_match_hand_computed_values(value: float, scale: int, word: int) -> None:
    assert fixed(value, scale, "it") == word


@given(st.sampled_from([0, 1, 11]), st.integers(0, 2**24 - 1))
def test_fixed_point_word_round_trips(scale: int, word: int) -> None:
    assert fixed(number(word, scale), scale, "it") == word


@given(st.sampled_from([0, 1, 11]), st.floats(-1.0, 1.0))
def test_fixed_point_rounding_error_is_at_most_half_a_step(scale: int, share: float) -> None:
    step = 2.0 ** (scale - 23)
    value = share * 2.0**scale
    assume(share < 1.0 - 2.0**-23)
    assert abs(number(fixed(value, scale, "it"), scale) - value) <= 0.5 * step


@pytest.mark.parametrize("value", [2048.1, -2048.1, math.nan, math.inf])
def test_number_outside_its_scale_is_rejected_by_name(value: float) -> None:
    plane = WordPlane((0.0, 0.0, -1.0), value * 0.3048)
    with pytest.raises(InputError, match=r"distance of plane 2 \[ft\] .*B11 .*-2048 to 2048"):
        encode_block(FrameBlock(ControlWord(1, "A"), AT_REST, (LEVEL, plane, LEVEL)))


def test_frame_block_matches_hand_computed_words() -> None:
    """HO = 90 deg, PO = -30 deg; plane 1 is X = 8 ft, the other planes are Z = 0 seen from below."""
    angles = (math.pi / 2, -math.pi / 6, 0.0, 0.0, 0.0, math.pi)
    plane = WordPlane((1.0, 0.0, 0.0), 8 * 0.3048)
    words = encode_block(FrameBlock(ControlWord(1, "A"), angles, (plane, LEVEL, LEVEL)))
    assert len(words) == 32
    assert words[0] == 1
    assert words[1:5] == (0x400000, 0, 0xE00000, round(math.sqrt(0.75) * 2**22))
    assert words[5:13] == (0, 0x400000, 0, 0x400000, 0, 0x400000, 0, 0xC00000)
    assert words[13:17] == (0x7FFFFF, 0, 0, 8 << 12)
    assert words[17:25] == (0, 0, 0x800000, 0) * 2
    assert words[25:] == (0,) * 7


units = st.tuples(*[st.floats(-1.0, 1.0)] * 3).filter(lambda v: math.hypot(*v) > 0.1)
planes = st.builds(
    lambda v, d: WordPlane((v[0] / math.hypot(*v), v[1] / math.hypot(*v), v[2] / math.hypot(*v)), d),
    units,
    st.floats(-600.0, 600.0),
)


@given(controls, st.tuples(*[st.floats(-3.2, 3.2)] * 6), st.tuples(*[planes | st.none()] * 3))
def test_frame_block_round_trips(
    control: ControlWord,
    angles: tuple[float, float, float, float, float, float],
    three: tuple[WordPlane | None, WordPlane | None, WordPlane | None],
) -> None:
    block = decode_block(encode_block(FrameBlock(control, angles, three)))
    assert block.control == control
    for got, expected in zip(block.angles, angles, strict=True):
        assert math.remainder(got - expected, math.tau) == pytest.approx(0.0, abs=2.0**-21)
    for plane, given_plane in zip(block.planes, three, strict=True):
        if plane is None or given_plane is None:
            assert plane is given_plane
            continue
        assert plane.normal == pytest.approx(given_plane.normal, abs=2.0**-23)
        assert plane.distance == pytest.approx(given_plane.distance, abs=0.3048 * 2.0**-13)


def test_invalid_frame_block_words_are_rejected() -> None:
    words = list(encode_block(FrameBlock(ControlWord(1, "A"), AT_REST, (LEVEL, LEVEL, LEVEL))))
    with pytest.raises(InputError, match=r"32 words; 31 "):
        decode_block(words[:-1])
    with pytest.raises(InputError, match=r"sine and cosine of PO: .* 0"):
        decode_block([*words[:4], 0, *words[5:]])
    with pytest.raises(InputError, match="word 5 of the frame block is 16777216"):
        decode_block([*words[:4], 1 << 24, *words[5:]])
    with pytest.raises(InputError, match=r"normal of plane 1: .* 4"):
        encode_block(FrameBlock(ControlWord(1, "A"), AT_REST, (WordPlane((2.0, 0.0, 0.0), 0.0), LEVEL, LEVEL)))


def odd(normal: Any = LEVEL.normal, distance: Any = 0.0) -> WordPlane:
    return WordPlane(normal, distance)


@pytest.mark.parametrize(
    ("wrong", "pattern"),
    [
        ({"angles": (*AT_REST[:5], math.inf)}, "angle R2 is inf rad"),
        ({"angles": (math.nan, *AT_REST[:5])}, "angle HO is nan rad"),
        ({"angles": ("a", *AT_REST[:5])}, "angle HO is 'a'"),
        ({"angles": AT_REST[:5]}, "6 angles, HO, PO, P1, H2, P2, R2; 5 "),
        ({"planes": (LEVEL,) * 5}, "3 separating planes; 5 "),
        ({"planes": (LEVEL, None)}, "3 separating planes; 2 "),
        ({"planes": (LEVEL, odd((1.0, 0.0)), None)}, "normal of plane 2 .*x, y, z; 2 "),
        ({"planes": (LEVEL, odd((0.0, None, -1.0)), None)}, "normal y of plane 2 is None"),
        ({"planes": (LEVEL, None, odd(distance="far"))}, "distance of plane 3 is 'far'"),
    ],
)
def test_frame_block_with_invalid_angles_or_planes_is_rejected(wrong: dict[str, Any], pattern: str) -> None:
    with pytest.raises(InputError, match=pattern):
        encode_block(FrameBlock(ControlWord(1, "A"), AT_REST, (LEVEL, LEVEL, LEVEL))._replace(**wrong))


@pytest.mark.parametrize("kind", [np.int32, np.uint32, np.int64])
def test_words_of_an_array_decode_to_the_same_block(kind: type[np.integer[Any]]) -> None:
    words = encode_block(FrameBlock(ControlWord(1, "A"), (-1.0, 1.0, *AT_REST[:4]), (LEVEL, None, LEVEL)))
    assert decode_block(list(np.array(words, kind))) == decode_block(words)
