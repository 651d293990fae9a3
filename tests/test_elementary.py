"""The elementary functions against the standard library, and compiled against plain Python."""

from __future__ import annotations

import math
import struct
import subprocess
import sys

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from aftdeck.elementary import acos, asin, atan2, ceiling, sincos

OURS, THEIRS = 2e-16, 1.2e-16
"""Greatest errors: that of `sincos`, as promised, and that of `math`, which is one unit in the last place."""
FEW = settings(derandomize=True, deadline=None, max_examples=500, database=None)


def off(angle: float) -> float:
    s, c = sincos(angle)
    return max(abs(s - math.sin(angle)), abs(c - math.cos(angle)))


@FEW
@given(st.floats(-1e5, 1e5))
def test_sine_and_cosine_are_within_the_promised_error(angle: float) -> None:
    assert off(angle) <= OURS + THEIRS


@pytest.mark.parametrize("reach", [1e-8, 1.0, 10.0, 1e3, 1e5])
def test_sine_and_cosine_are_accurate_over_many_angles(reach: float) -> None:
    angles = np.random.default_rng(80).uniform(-reach, reach, 20_000)
    assert max(off(float(a)) for a in angles) <= OURS + THEIRS


def test_sine_and_cosine_are_accurate_near_multiples_of_45_deg() -> None:
    for k in range(-4000, 4000):
        middle = k * math.pi / 4
        for angle in (math.nextafter(middle, -math.inf), middle, math.nextafter(middle, math.inf)):
            assert off(angle) <= OURS + THEIRS


def test_smallest_angles_equal_their_sine() -> None:
    for angle in (0.0, 5e-324, 1e-300, -1e-20, 1e-9):
        assert sincos(angle) == (angle, 1.0)


def test_squares_of_sine_and_cosine_add_up_to_one() -> None:
    for angle in np.random.default_rng(81).uniform(-100, 100, 5000):
        s, c = sincos(float(angle))
        assert s * s + c * c == pytest.approx(1.0, abs=6e-16)


FINITE = st.floats(-1e6, 1e6)


@FEW
@given(FINITE, FINITE)
def test_arc_tangent_is_within_the_promised_error(y: float, x: float) -> None:
    exact = math.atan2(y, x)
    assert abs(atan2(y, x) - exact) <= min(3e-16 + math.ulp(exact), 4.0 * math.ulp(exact))


@pytest.mark.parametrize("y", [0.0, -0.0, 1.0, -1.0, 5e-324])
@pytest.mark.parametrize("x", [0.0, -0.0, 1.0, -1.0])
def test_arc_tangent_on_the_axes_and_diagonals_equals_the_standard_library_and_its_signs(y: float, x: float) -> None:
    assert struct.pack("d", atan2(y, x)) == struct.pack("d", math.atan2(y, x))


@FEW
@given(st.floats(-1.0, 1.0))
def test_arc_cosine_and_arc_sine_are_within_the_promised_error(value: float) -> None:
    assert abs(acos(value) - math.acos(value)) <= 4e-16 + math.ulp(math.pi) / 2
    assert abs(asin(value) - math.asin(value)) <= 3e-16 + math.ulp(1.5)


@FEW
@given(st.floats(-1e15, 1e15))
def test_ceiling_equals_the_standard_library(value: float) -> None:
    assert ceiling(value) == math.ceil(value)


def test_compiled_functions_equal_plain_python_to_the_last_bit() -> None:
    code = """
import hashlib, struct, numpy as np
from aftdeck import law
from aftdeck import elementary as e
def digest():
    found = hashlib.sha256()
    for y, x in np.random.default_rng(82).uniform(-1, 1, (20_000, 2)).tolist():
        values = (*e.sincos(1e3 * y), e.atan2(y, x), e.acos(y), e.asin(y), e.ceiling(1e3 * y), e.nearest(1e3 * y))
        found.update(struct.pack("7d", *values))
    return found.hexdigest()
plain = digest()
law.load()
assert plain == digest()
"""
    subprocess.run([sys.executable, "-c", code], check=True, timeout=300)
