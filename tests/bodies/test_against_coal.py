"""Random pairs near contact: verdicts against coal, clearances against known clearances, and every witness."""

from __future__ import annotations

import coal
import numpy as np
import pytest
from numpy.typing import NDArray

from aftdeck.arrays import Array
from aftdeck.bodies.hexahedron import BODY, place
from aftdeck.bodies.hexahedron_check import hexahedron
from aftdeck.bodies.pair import CLEARANCE, CONTACT, FEATURE_A, FEATURE_B, PAIR
from aftdeck.bodies.pair_check import measure_all, verdict
from tests.bodies import brute
from tests.bodies.shapes import FACES, boxes, near_contact, rotations, skewed
from tests.bodies.witnesses import ROUNDING, features_penetrate, planes_hold, points_hold, vertices
from tests.each import number

Ints = NDArray[np.int64]
GAP, USUAL = coal.GJKConvergenceCriterion.DualityGap, coal.GJKConvergenceCriterion.Default
"""Coal's convergence criteria. At a tolerance of 1e-12, `DualityGap` misses penetration depths of up to 1e-8 m (1 pair
in 50,000), and `Default` reports clearances of up to 3e-6 m as collisions (1 pair in 70). So the test uses
`DualityGap`. If coal and Aftdeck then disagree about a pair, the test uses `Default` for this pair, and compares the
clearance with brute force."""
KINDS = {"boxes": boxes, "skewed": skewed}


def hull(body: Array) -> object:
    """Return a body (8, 3) as a convex body of coal."""
    points, triangles = coal.StdVec_Vec3s(), coal.StdVec_Triangle()
    for point in body:
        points.append(point)
    for p, q, r, s in FACES.tolist():
        triangles.append(coal.Triangle(p, q, r))
        triangles.append(coal.Triangle(p, r, s))
    return coal.Convex(points, triangles)


def check_witnesses(a: Array, b: Array, pairs: Array, clearance: Array) -> None:
    """Check the witnesses: a separating plane for each pair that does not overlap, otherwise penetrating features."""
    apart, inside = clearance > CONTACT, clearance < -ROUNDING
    assert planes_hold(a[apart], b[apart], pairs[apart]).all()
    assert features_penetrate(a[inside], b[inside], pairs[inside]).all()
    assert (pairs[~apart][:, [FEATURE_A, FEATURE_B]] > 0.0).all()


def disagreements(kind: str, seed: int, shapes: int, rounds: int) -> tuple[int, int]:
    """Compare random pairs, `shapes` in each round; return the numbers of compared pairs and of disagreements."""
    rng = np.random.default_rng(seed)
    first = np.einsum("nij,nvj->nvi", rotations(rng, shapes), KINDS[kind](rng, shapes))
    second = KINDS[kind](rng, shapes)
    packed_first = np.array([hexahedron(body) for body in first])
    packed_second = np.array([hexahedron(body) for body in second])
    hulls_first, hulls_second = [hull(body) for body in first], [hull(body) for body in second]
    at_origin = coal.Transform3s.Identity()
    request, result = coal.CollisionRequest(), coal.CollisionResult()
    request.gjk_tolerance = request.epa_tolerance = 1e-12
    request.gjk_convergence_criterion_type = coal.GJKConvergenceCriterionType.Absolute
    request.enable_contact = False
    watched = np.column_stack([np.arange(shapes), np.arange(shapes, 2 * shapes)])
    wrong = seen = 0
    for _ in range(rounds):
        order, turn = rng.permutation(shapes), rotations(rng, shapes)
        turned = np.einsum("nij,nvj->nvi", turn, second[order])
        placing = near_contact(rng, first, turned)

        def collide(k: int, order: Ints = order, turn: Array = turn, at: Array = placing.shift) -> bool:
            result.clear()
            pose = coal.Transform3s(turn[k], at[k])
            return bool(coal.collide(hulls_first[k], at_origin, hulls_second[order[k]], pose, request, result) > 0)

        request.gjk_convergence_criterion = GAP
        bodies, pairs = np.empty((2 * shapes, BODY)), np.zeros((shapes, PAIR))
        bodies[:shapes] = packed_first
        coal_collides = np.empty(shapes, dtype=bool)
        for k in range(shapes):
            place(packed_second[order[k]], placing.shift[k], turn[k], bodies[shapes + k])
            coal_collides[k] = collide(k)
        measure_all(bodies, watched, pairs)
        clearance = pairs[:, CLEARANCE].copy()
        a, b = vertices(bodies[:shapes]), vertices(bodies[shapes:])
        collides = clearance <= CONTACT
        request.gjk_convergence_criterion = USUAL
        for pair in np.flatnonzero((collides != coal_collides) & (np.abs(clearance) > CONTACT)):
            wrong += collide(int(pair)) != bool(collides[pair])
            assert clearance[pair] == pytest.approx(brute.clearance(a[pair], b[pair]), abs=ROUNDING)
        known = np.isfinite(placing.clearance)
        assert np.abs(clearance - placing.clearance)[known].max() <= ROUNDING
        assert points_hold(a, b, pairs).all()
        check_witnesses(a, b, pairs, clearance)
        pairs[:] = 0.0
        verdicts = [verdict(bodies[k], bodies[shapes + k], pairs[k]) for k in range(shapes)]
        assert np.array_equal(verdicts, collides)
        check_witnesses(a, b, pairs, clearance)
        seen += shapes
    return seen, wrong


@pytest.mark.parametrize("kind", KINDS)
def test_verdict_agrees_with_coal_and_every_witness_holds(kind: str) -> None:
    assert disagreements(kind, 5, 1000, 5) == (5000, 0)


@pytest.mark.slow
@pytest.mark.parametrize("kind", KINDS)
def test_verdict_agrees_with_coal_for_many_pairs(kind: str) -> None:
    times = number(50, 500)
    assert disagreements(kind, 6, 2000, times) == (2000 * times, 0)
