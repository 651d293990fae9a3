"""Materials of the clusters' faces."""

from __future__ import annotations

import numpy as np
import pytest

from aftdeck.scene.colours import COLOURS
from aftdeck.shapes import Material
from aftdeck.visual.paint import Surfaces, _Triangles

MATERIALS: list[Material] = list(COLOURS)
NORMALS = np.vstack([np.eye(3), -np.eye(3)])
CUBE = np.column_stack([NORMALS, np.ones(6)])
"""Faces of a cube of 2 m."""


def surfaces(out: float, material: list[int]) -> Surfaces:
    """Return a triangle before each face of the cube, at a distance outside it [m]."""
    return Surfaces({"here": _Triangles(NORMALS * (1.0 + out), NORMALS.copy(), np.array(material))})


@pytest.mark.parametrize("out", [-0.5, 0.0, 0.02])
def test_a_face_has_the_material_of_what_is_drawn_there(out: float) -> None:
    own = [k % len(MATERIALS) for k in range(6)]
    assert surfaces(out, own).of("here", CUBE) == [MATERIALS[k] for k in own]


def test_a_face_alone_has_the_most_frequent_material_of_the_cluster() -> None:
    one = _Triangles(np.zeros((3, 3)), np.diag([1.0, 2.0, 1.5]), np.array([1, 2, 1]))
    found = Surfaces({"here": one}).of("here", CUBE)
    assert found == [MATERIALS[k] for k in (1, 2, 1, 1, 1, 1)]


def test_what_is_drawn_away_from_a_cluster_does_not_count() -> None:
    assert surfaces(0.05, [1] * 6).of("here", CUBE) == ["structure"] * 6
    assert surfaces(0.0, [1] * 6).of("elsewhere", CUBE) == ["structure"] * 6
