"""Pairs that are measured repeatedly: the memory of a pair makes a measurement faster, and never changes its result."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from aftdeck.arrays import Array
from aftdeck.bodies.hexahedron import pack, unpack
from aftdeck.bodies.hexahedron_check import hexahedron
from aftdeck.bodies.pair import CLEARANCE, CONTACT, NORMAL, PAIR, SIMPLEX, SIZE
from aftdeck.bodies.pair_check import measure, measure_all, verdict, verified
from tests.bodies.plain import results
from tests.bodies.shapes import CUBE, boxes, moved, near_contact, rotations, skewed
from tests.bodies.witnesses import features_penetrate, planes_hold, points_hold


def motions(seed: int, count: int, frames: int) -> list[tuple[Array, list[Array]]]:
    """Return pairs: a body, and the vertices of a second body in each frame.

    In each frame, the second body moves a few millimetres past the first body and rotates by about 1 degree.
    """
    rng = np.random.default_rng(seed)
    a, b = skewed(rng, count), boxes(rng, count)
    start = near_contact(rng, a, b).shift
    passes = []
    for k in range(count):
        drift, spin = rng.normal(size=3) * 0.005, rng.normal(size=3) * 0.01
        turn = np.eye(3) + np.cross(np.eye(3), spin)
        turn, _ = np.linalg.qr(turn)
        turn *= np.sign(np.diag(turn))
        second, body = [], b[k]
        for frame in range(frames):
            second.append(body + start[k] + (frame - frames / 2) * drift)
            body = body @ turn.T
        passes.append((a[k], second))
    return passes


def test_warm_pair_gives_the_same_result_as_a_cold_pair() -> None:
    for a, places in motions(31, 30, 20):
        first, warm, quick = hexahedron(a), np.zeros(PAIR), np.zeros(PAIR)
        for place in places:
            second, cold = pack(place), np.zeros(PAIR)
            clearance = measure(first, second, cold)
            assert measure(first, second, warm) == pytest.approx(clearance, abs=1e-12)
            assert verdict(first, second, quick) == (clearance <= CONTACT)
            for found in (cold, warm):
                there = a[None], place[None], found[None]
                assert points_hold(*there).all()
                assert (planes_hold(*there) | (clearance <= CONTACT)).all()
                assert (features_penetrate(*there) | (clearance > -1e-12)).all()


def test_stale_pair_memory_does_not_change_the_result() -> None:
    rng = np.random.default_rng(32)
    bodies = np.einsum("nij,nvj->nvi", rotations(rng, 600), np.concatenate([skewed(rng, 300), boxes(rng, 300)]))
    a, b = bodies[:300], bodies[300:]
    b = b + near_contact(rng, a, b).shift[:, None]
    for k in range(300):
        cold, stale = np.zeros(PAIR), rng.normal(size=PAIR)
        stale[SIZE], stale[SIMPLEX : SIMPLEX + 3] = rng.integers(0, 4), rng.integers(0, 64, 3)
        if k % 2:
            stale[NORMAL : NORMAL + 3] /= np.linalg.norm(stale[NORMAL : NORMAL + 3])
        else:
            stale[NORMAL : NORMAL + 3] = 0.0
        first, second = hexahedron(a[k]), hexahedron(b[k])
        clearance = measure(first, second, cold)
        assert verdict(first, second, stale.copy()) == (clearance <= CONTACT)
        assert measure(first, second, stale) == pytest.approx(clearance, abs=1e-12)


def test_last_plane_is_kept_only_while_it_separates() -> None:
    first, pair = hexahedron(CUBE), np.zeros(PAIR)
    assert not verified(first, hexahedron(CUBE + 3.0), pair)
    measure(first, hexahedron(moved(CUBE, 1.5, 0.0, 0.0)), pair)
    for shift, holds in [(1.5, True), (3.0, True), (1.0 + 2e-9, True), (1.0, False), (0.5, False)]:
        second = hexahedron(moved(CUBE, shift, 0.4, -0.3))
        assert verified(first, second, pair) is holds
        if holds:
            assert planes_hold(CUBE[None], unpack(second)[None], pair[None]).all()


def test_measuring_many_pairs_equals_measuring_each_alone() -> None:
    rng = np.random.default_rng(33)
    bodies = np.array(
        [hexahedron(body + shift) for body, shift in zip(boxes(rng, 8), rng.normal(size=(8, 3)), strict=True)]
    )
    watched = np.array([(i, j) for i in range(8) for j in range(i)])
    pairs = np.zeros((len(watched), PAIR))
    measure_all(bodies, watched, pairs)
    for (i, j), pair in zip(watched, pairs, strict=True):
        alone = np.zeros(PAIR)
        assert measure(bodies[i], bodies[j], alone) == pair[CLEARANCE]
        assert np.array_equal(alone, pair)


def test_uncompiled_laws_agree_with_the_compiled_ones() -> None:
    done = subprocess.run(
        [sys.executable, "-m", "tests.bodies.plain"],
        cwd=Path(__file__).parents[2],
        env={**os.environ, "NUMBA_DISABLE_JIT": "1"},
        capture_output=True,
        text=True,
        timeout=400,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert np.array(json.loads(done.stdout)) == pytest.approx(np.array(results()), abs=1e-9, nan_ok=True)
