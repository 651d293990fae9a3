"""Arrays that are lent to laws."""

from __future__ import annotations

import sys

import numpy as np

from aftdeck.arrays import Array
from aftdeck.law import interpreted, law
from aftdeck.lent import lend


@law
def summed(values: Array, out: Array) -> float:
    """Write twice the values after the first into `out`, through arrays that are lent; return their sum."""
    own, result, total = lend(values), lend(out), 0.0
    for part in (own[1:], own[1:]):
        for k in range(len(part)):
            result[k] += part[k]
            total += part[k]
    return total


def test_a_law_reads_and_writes_what_it_is_lent() -> None:
    values, compiled, plain = np.arange(5.0), np.zeros(4), np.zeros(4)
    before = sys.getrefcount(values)
    for _ in range(100):
        compiled[:] = 0.0
        assert summed(values, compiled) == 20.0
    with interpreted():
        assert summed(values, plain) == 20.0
    assert compiled.tolist() == plain.tolist() == [2.0, 4.0, 6.0, 8.0]
    assert sys.getrefcount(values) == before
