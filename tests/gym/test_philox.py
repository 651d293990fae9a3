"""The random numbers of the environments."""

from __future__ import annotations

import math

import numpy as np
import pytest

from aftdeck.gym.philox import philox, uniform

ALL = 0xFFFFFFFF
KNOWN = [
    ((0, 0, 0, 0), (0, 0), (0x6627E8D5, 0xE169C58D, 0xBC57AC4C, 0x9B00DBD8)),
    ((ALL, ALL, ALL, ALL), (ALL, ALL), (0x408F276D, 0x41C83B0E, 0xA20BC7C6, 0x6D5451FD)),
    (
        (0x243F6A88, 0x85A308D3, 0x13198A2E, 0x03707344),
        (0xA4093822, 0x299F31D0),
        (0xD16CFE09, 0x94FDCCEB, 0x5001E420, 0x24126EA1),
    ),
]
"""Known answers of Philox4x32-10, from `kat_vectors` of the authors' library Random123: counter, key, words."""


@pytest.mark.parametrize(("counter", "key", "words"), KNOWN)
def test_philox_gives_the_authors_known_answers(
    counter: tuple[int, int, int, int], key: tuple[int, int], words: tuple[int, int, int, int]
) -> None:
    assert philox(*counter, *key) == words


@pytest.mark.parametrize(("counter", "key", "words"), KNOWN)
def test_philox_as_plain_python_gives_the_same_words(
    counter: tuple[int, int, int, int], key: tuple[int, int], words: tuple[int, int, int, int]
) -> None:
    plain = getattr(philox, "py_func", philox)
    assert plain(*counter, *key) == words


def test_uniform_numbers_are_between_0_and_1_and_evenly_spread() -> None:
    numbers = np.array([uniform(word) for n in range(5000) for word in philox(n, 7, 0, 0, 3, 4)])
    assert 0.0 < uniform(0) < uniform(ALL) < 1.0
    counts, _ = np.histogram(numbers, bins=20, range=(0.0, 1.0))
    expected = len(numbers) / 20
    chi_square = float(((counts - expected) ** 2 / expected).sum())
    assert chi_square < 19 + 5 * math.sqrt(2 * 19)  # mean and standard deviation for 19 degrees of freedom
