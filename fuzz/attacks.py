"""All attacks, by name. An attack is a function of a seed; it returns its outcome in a word, or raises an exception.

To add an attack, write such a function and add it here: ``python -m fuzz`` and the tests then run it too.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from fuzz import files, flights, inputs, recordings, wire


class Attack(NamedTuple):
    """Attack and its extent.

    Attributes:
        run: function of a seed.
        seeds: number of seeds that ``python -m fuzz`` tries.
        tested: number of seeds, from 0 on, that the tests try.
        slowest_s: greatest time of one seed [s]; it is generous, because the machine may be busy.
    """

    run: Callable[[int], str]
    seeds: int
    tested: int
    slowest_s: float


ATTACKS = {
    "files": Attack(files.attack, 50_000, 2_000, 30.0),
    "flights": Attack(flights.attack, 5_000, 200, 120.0),
    "inputs": Attack(inputs.attack, 20_000, 400, 60.0),
    "recordings": Attack(recordings.attack, 5_000, 60, 60.0),
    "wire": Attack(wire.attack, 200_000, 2_000, 10.0),
}
