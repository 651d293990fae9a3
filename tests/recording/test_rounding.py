"""Rounding of many numbers at once."""

from __future__ import annotations

import math
import struct
from typing import Any

import hypothesis.strategies as st
from hypothesis import given

from aftdeck.recording.rounding import Rounding

decimals = st.integers(0, 12)
ties = st.builds(lambda n, digits: (n + 0.5) / 10**digits, st.integers(-(10**12), 10**12), decimals)
binary = st.builds(math.ldexp, st.integers(-(2**30), 2**30).map(float), st.integers(-40, 0))
numbers = st.lists(st.floats() | ties | ties.map(lambda x: math.nextafter(x, 0.0)) | binary)


def bits(values: Any) -> list[bytes]:
    return [struct.pack("<d", value) for value in values if not math.isnan(value)]


@given(numbers, decimals)
def test_results_are_those_of_round_to_the_last_bit(values: list[float], digits: int) -> None:
    box, rounding = {"list": values, **{str(n): value for n, value in enumerate(values)}}, Rounding()
    singles = [(str(n), bytes([digits])) for n in range(len(values))]
    rounding.add(box, singles, [("list", bytes([digits]))])
    rounding.finish()
    expected = bits(round(value, digits) for value in values)
    assert bits(box.pop("list")) == expected
    assert bits(box.values()) == expected
