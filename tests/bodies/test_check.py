"""Invalid hexahedra are rejected, and the message names the vertex at fault."""

from __future__ import annotations

import re
from itertools import permutations

import numpy as np
import pytest

from aftdeck import separation
from aftdeck.arrays import Array
from aftdeck.bodies.hexahedron import unpack
from aftdeck.bodies.hexahedron_check import hexahedra, hexahedron
from aftdeck.errors import InputError
from tests.bodies.shapes import CUBE, boxes, moved, rotations, skewed


def changed(vertex: int, point: list[float]) -> Array:
    """Return the unit cube with one vertex replaced."""
    body = CUBE.copy()
    body[vertex - 1] = point
    return body


FAULTS = {
    "not a number": (changed(4, [0.5, np.nan, 0.5]), "vertex 4 is .*nan.* finite"),
    "infinite": (changed(7, [np.inf, 0.5, -0.5]), "vertex 7 is .*inf.* finite"),
    "far away": (moved(CUBE, 0.0, 2e4, 0.0), "vertex 1 is .* at most 10000 m"),
    "doubled vertex": (changed(6, [0.5, 0.5, 0.5]), "vertex 8 at .* is 0 m from vertex 6"),
    "too small": (CUBE * 1e-7, "vertex 2 at .* 1e-07 m from vertex 1"),
    "no volume": (CUBE * [1.0, 1.0, 0.0], "vertex 2 at .* 0 m from vertex 1"),
    "sheared flat": (CUBE @ [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.3, 0.4, 0.0]], "vertex .* is in one plane with"),
    "bent faces": (changed(8, [0.6, 0.6, 0.6]), "vertex 8 at .* 0.1 m .*d, e, f"),
    "hardly bent face": (changed(3, [0.5, -0.5, -0.5 + 1e-7]), "vertex 3 at .* 1e-07 m off"),
    "dented": (changed(8, [-0.25, -0.25, -0.25]), "vertex 8 at .* is dented in"),
    "flat edge": (changed(8, [0.5, 0.5, -0.5 + 2e-6]), "vertex 8 at .* off the plane"),
    "mirror image": (CUBE * [-1.0, 1.0, 1.0], "vertex 2 at .* mirror image"),
    "two vertices exchanged": (CUBE[[1, 0, 2, 3, 4, 5, 6, 7]], "vertex 1 at .* numbered wrongly"),
    "numbered round its faces": (CUBE[[0, 1, 3, 2, 4, 5, 7, 6]], "vertex"),
    "too thin": (CUBE * [10.0, 10.0, 2e-6], "vertex .* at .* 2e-06 m .*face [cd]"),
}


@pytest.mark.parametrize(("body", "pattern"), FAULTS.values(), ids=FAULTS.keys())
def test_invalid_hexahedron_is_rejected_with_its_vertex(body: Array, pattern: str) -> None:
    with pytest.raises(InputError, match=f"the first hexahedron: {pattern}"):
        separation(body, CUBE)
    with pytest.raises(InputError, match=f"the second hexahedron: {pattern}"):
        separation(CUBE, body)


@pytest.mark.parametrize("given", ["a cube", None, [[1.0, 2.0]], np.zeros((8, 2)), np.zeros((2, 8, 3)), [[1], [2, 3]]])
def test_input_other_than_eight_points_is_rejected(given: object) -> None:
    with pytest.raises(InputError, match="shape"):
        hexahedron(given)  # type: ignore[arg-type]  # invalid on purpose


def test_first_of_several_invalid_hexahedra_is_named() -> None:
    bodies = np.array([CUBE, changed(8, [0.6, 0.6, 0.6]), CUBE * 1e-7])  # the third fails the check that comes first
    with pytest.raises(InputError, match="second: vertex 8"):
        hexahedra(bodies, ["first", "second", "third"])
    assert hexahedra(bodies[:0], []).shape == (0, 48)
    assert np.array_equal(hexahedra(bodies[:1], ["first"])[0], hexahedron(CUBE))


def test_only_the_24_rotated_numberings_of_a_box_are_accepted() -> None:
    body = CUBE * [1.0, 2.0, 3.0]
    taken = 0
    # To save time, skip orders in which more than one of the six edges at vertices 1 and 4 is wrong.
    for order in permutations(range(8)):
        if sum(order[k] ^ order[k ^ bit] in (1, 2, 4) for k in (0, 3) for bit in (1, 2, 4)) < 5:
            continue
        try:
            hexahedron(body[list(order)])
        except InputError as error:
            assert re.search(r"vertex \d", str(error))
        else:
            taken += 1
    assert taken == 24


def test_boxes_and_tapered_hexahedra_are_accepted_unchanged() -> None:
    rng = np.random.default_rng(11)
    for bodies in (boxes(rng, 300), skewed(rng, 300)):
        for body in np.einsum("nij,nvj->nvi", rotations(rng, 300), bodies):
            assert np.array_equal(unpack(hexahedron(body)), body)


@pytest.mark.parametrize("sizes", [(60.0, 15.0, 0.01), (36.0, 78.0, 1.0), (1e-5, 1e-5, 1e-5), (1e-3, 1e-3, 50.0)])
def test_slabs_needles_and_grains_are_accepted(sizes: tuple[float, float, float]) -> None:
    assert not separation(CUBE * sizes, CUBE * sizes + [0.0, 0.0, 60.0]).collides


def test_input_array_is_not_modified() -> None:
    body = CUBE.copy()
    separation(body, body + 1.0)
    assert np.array_equal(body, CUBE)
