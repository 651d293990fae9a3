"""Location words and edge tests, against tables with the report's vertex numbers and face letters."""

from __future__ import annotations

import numpy as np
import pytest

from aftdeck.arrays import Array
from aftdeck.bodies.edges import piercing_edge
from aftdeck.bodies.hexahedron import BESIDE, EDGES, ENDS, FACES, pack, place
from aftdeck.bodies.hexahedron_check import hexahedron
from aftdeck.bodies.location_words import heights, location_words
from tests.bodies.shapes import CUBE, rotations, skewed

BIT = {"a": 1, "b": 2, "c": 4, "d": 8, "e": 16, "f": 32}
POSITIONS = {
    (0, 0, 0): "",
    (-1, 0, 0): "a",
    (0, -1, 0): "b",
    (0, 0, -1): "c",
    (0, 0, 1): "d",
    (0, 1, 0): "e",
    (1, 0, 0): "f",
    (-1, -1, 0): "ab",
    (1, -1, 0): "bf",
    (0, -1, -1): "bc",
    (0, 1, 1): "de",
    (1, 0, 1): "df",
    (-1, 1, 0): "ae",
    (-1, -1, -1): "abc",
    (1, 1, 1): "def",
    (1, -1, 1): "bdf",
    (-1, 1, -1): "ace",
}
"""Position of a small body relative to a large body: faces of the large body on whose TRUE side the small body is."""


def words(a: Array, b: Array) -> list[int]:
    """Return the location word of each vertex of `a`: the faces of `b` on whose TRUE side the vertex is."""
    above, found = np.empty((6, 8)), np.empty(8, dtype=np.int64)
    heights(pack(a), pack(b), above)
    location_words(above, found)
    return [int(word) for word in found]


def pierced(a: Array, b: Array) -> tuple[int, int]:
    """Return an edge of `a` that pierces a face of `b`, and this face, as indices from 0.

    The edge is -1 if no edge pierces a face.
    """
    above, found = np.empty((6, 8)), np.empty(8, dtype=np.int64)
    heights(pack(a), pack(b), above)
    location_words(above, found)
    edge, face = piercing_edge(above, found)
    return int(edge), int(face)


@pytest.mark.parametrize(("position", "faces"), POSITIONS.items(), ids=str)
def test_location_words_name_the_faces_that_a_vertex_is_outside_of(position: tuple[int, int, int], faces: str) -> None:
    word = sum(BIT[letter] for letter in faces)
    turn = rotations(np.random.default_rng(21), 1)[0]
    for rotation in (np.eye(3), turn):
        small, large = (CUBE * 0.1 + position) @ rotation.T, CUBE @ rotation.T
        assert words(small, large) == [word] * 8


def test_location_words_of_an_enclosing_body_are_those_of_its_corners() -> None:
    assert words(CUBE * 3.0, CUBE) == [BIT[z] + BIT[x] + BIT[y] for y in "be" for x in "af" for z in "cd"]


def test_vertex_on_a_face_is_on_its_false_side() -> None:
    assert words(CUBE, CUBE) == [0] * 8


def test_faces_and_edges_follow_the_numbering() -> None:
    assert {letter: "".join(map(str, face)) for letter, face in FACES.items()} == {
        "a": "1256",
        "b": "1234",
        "c": "1357",
        "d": "2468",
        "e": "5678",
        "f": "3478",
    }
    assert {f"{p}{q}" for p, q in EDGES} == {
        *("12", "34", "56", "78"),
        *("13", "24", "57", "68"),
        *("15", "26", "37", "48"),
    }


def test_edge_direction_follows_the_turn_between_its_face_normals() -> None:
    for body in skewed(np.random.default_rng(22), 20):
        normals = hexahedron(body)[24:42].reshape(3, 6).T
        turns = np.cross(normals[BESIDE[:, 0]], normals[BESIDE[:, 1]])
        assert ((body[ENDS[:, 1]] - body[ENDS[:, 0]]) * turns).sum(axis=1).min() > 0.0


def test_each_vertex_is_inside_the_faces_that_do_not_contain_it() -> None:
    for body in skewed(np.random.default_rng(23), 20):
        packed, above = hexahedron(body), np.empty((6, 8))
        heights(packed, packed, above)
        for face, vertices in zip(above, FACES.values(), strict=True):
            on = np.array(vertices) - 1
            assert np.abs(face[on]).max() <= 1e-15
            assert np.delete(face, on).max() < -1e-3


@pytest.mark.parametrize("reach", [0.6, 1.5, 5.0])
def test_edge_that_passes_through_a_face_pierces_it(reach: float) -> None:
    # Edges 12 and 56 of the needle run along z. They pass through face c, because their x and y are inside this face.
    needle = CUBE * [0.02, 0.02, 2.0 * reach]
    edge, face = pierced(needle, CUBE)
    assert EDGES[edge] == (1, 2)
    assert list(FACES)[face] == "c"


def test_edge_that_ends_before_a_face_does_not_pierce_it() -> None:
    turn = rotations(np.random.default_rng(24), 40)
    for rotation in turn:
        needle = (CUBE * [0.02, 0.02, 1.0]) @ rotation.T
        beyond = needle + rotation[:, 2] * 1.6
        assert pierced(beyond, CUBE)[0] == -1


def test_plate_does_not_pierce_the_needle_through_it() -> None:
    plate, needle = CUBE * [4.0, 4.0, 0.5], CUBE * [0.02, 0.02, 3.0]
    assert pierced(plate, needle)[0] == -1
    assert pierced(needle, plate)[0] >= 0


def test_placed_body_equals_the_body_packed_at_that_pose() -> None:
    rng = np.random.default_rng(25)
    for body, rotation in zip(skewed(rng, 50), rotations(rng, 50), strict=True):
        position, placed = rng.normal(size=3) * 5.0, np.empty(48)
        place(hexahedron(body), position, rotation, placed)
        assert placed == pytest.approx(hexahedron(body @ rotation.T + position), abs=1e-12)
