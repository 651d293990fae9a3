"""Clearances and verdicts of pairs near contact: ``python -m tests.bodies.plain``.

A test compares the results with and without the compiler.
"""

from __future__ import annotations

import json

import numpy as np

from aftdeck.bodies.hexahedron import pack
from aftdeck.bodies.pair import PAIR
from aftdeck.bodies.pair_check import measure, verdict
from tests.bodies.shapes import boxes, near_contact, skewed


def results() -> list[list[float]]:
    """Return clearance and verdict of each pair."""
    rng = np.random.default_rng(41)
    a, b = skewed(rng, 30), boxes(rng, 30)
    b = b + near_contact(rng, a, b).shift[:, None]
    found = []
    for first, second in zip(map(pack, a), map(pack, b), strict=True):
        pair = np.zeros(PAIR)
        found.append([float(measure(first, second, pair)), float(verdict(first, second, pair))])
    return found


if __name__ == "__main__":
    print(json.dumps(results()))
