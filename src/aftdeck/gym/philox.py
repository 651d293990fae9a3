"""Philox4x32-10: random numbers as a function of a key and a counter.

Source: J. Salmon, M. Moraes, R. Dror, D. Shaw, *Parallel random numbers: as easy as 1, 2, 3*, SC 2011. No state is
updated. Each environment has its own key, and each episode its own counter; the numbers of an episode therefore depend
neither on the other environments of a batch nor on the order in which they are reset.
"""

from __future__ import annotations

from aftdeck.law import law

MASK = 0xFFFFFFFF
"""The lower 32 bits of an integer."""
_MULTIPLIER_0, _MULTIPLIER_1 = 0xD2511F53, 0xCD9E8D57
_WEYL_0, _WEYL_1 = 0x9E3779B9, 0xBB67AE85
_ROUNDS = 10
_PER_WORD = 2.0**-32

Four = tuple[int, int, int, int]


@law
def philox(a: int, b: int, c: int, d: int, low: int, high: int) -> Four:
    """Return four random words of 32 bits for a counter (a, b, c, d) and a key (low, high); all are 32-bit words.

    A product has up to 64 bits. Compiled code keeps it in a signed integer; the masks make the result the same as that
    of unsigned arithmetic, and of Python's long integers.
    """
    for _ in range(_ROUNDS):
        p, q = _MULTIPLIER_0 * a, _MULTIPLIER_1 * c
        a, b, c, d = ((q >> 32) & MASK) ^ b ^ low, q & MASK, ((p >> 32) & MASK) ^ d ^ high, p & MASK
        low, high = (low + _WEYL_0) & MASK, (high + _WEYL_1) & MASK
    return a, b, c, d


@law
def uniform(word: int) -> float:
    """Return a number between 0 and 1, without both ends, from a random word of 32 bits."""
    return (word + 0.5) * _PER_WORD
