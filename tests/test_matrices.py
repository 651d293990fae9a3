"""Products and lengths against NumPy's, for every combination of shapes that they accept."""

from __future__ import annotations

import math

import numpy as np
import pytest

from aftdeck.matrices import distance, dots, length, lengths, product

RNG = np.random.default_rng(83)


@pytest.mark.parametrize(
    ("a", "b"),
    [
        ((3, 3), (3, 3)),
        ((3, 3), (3,)),
        ((3,), (3,)),
        ((3,), (3, 4)),
        ((8, 3), (3, 3)),
        ((5, 8, 3), (3, 3)),
        ((3, 3), (5, 3, 3)),
        ((2, 5, 3, 3), (2, 5, 3, 3)),
        ((2, 5, 3), (3,)),
        ((4, 7), (7, 2)),
    ],
)
def test_product_equals_that_of_numpy_to_rounding(a: tuple[int, ...], b: tuple[int, ...]) -> None:
    left, right = RNG.normal(size=a), RNG.normal(size=b)
    assert product(left, right).shape == (left @ right).shape
    assert np.allclose(product(left, right), left @ right, rtol=0.0, atol=1e-14)


def test_product_adds_its_terms_in_the_order_of_the_indices() -> None:
    big, one = 2.0**53, 1.0
    assert product(np.array([big, one, -big]), np.ones(3)) == (big + one) - big
    assert product(np.array([[one, big, -big]]), np.ones((3, 1)))[0, 0] == (one + big) - big


def test_lengths_and_dot_products_equal_those_of_numpy_to_rounding() -> None:
    vectors, others = RNG.normal(size=(6, 5, 3)), RNG.normal(size=(5, 3))
    assert np.allclose(lengths(vectors), np.linalg.norm(vectors, axis=-1), rtol=1e-15, atol=0.0)
    assert np.allclose(dots(vectors, others), np.einsum("ijk,jk->ij", vectors, others), rtol=0.0, atol=1e-14)
    for vector in vectors[0].tolist():
        assert length(vector) == pytest.approx(math.hypot(*vector), rel=1e-15)
        assert distance(vector, [1.0, 2.0, 3.0]) == pytest.approx(math.dist(vector, [1.0, 2.0, 3.0]), rel=1e-15)
