"""Cases of a study: for each index, the values of the factors and the seed. They depend on the study file alone."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from typing import Any

import msgspec

from aftdeck.extra import needed
from aftdeck.scenario.keys import Change
from aftdeck.study.factor import Factor, Level
from aftdeck.study.file import Study
from aftdeck.table import Cell


class Case(msgspec.Struct, frozen=True):
    """One run of a study."""

    index: int
    seed: int
    cells: tuple[Cell, ...]
    """Value of each factor, as in the table of results."""
    changes: tuple[Change, ...]
    """New values of the case."""


def cases(study: Study) -> list[Case]:
    """Return all cases of a study, in order.

    A grid has all combinations of its levels; the last factor changes fastest. If a factor of a grid has no levels, the
    repetitions draw its values, and all points of the grid get the same draws, which makes them comparable. The
    repetitions of a point follow each other.
    """
    spec, factors, seeds = study.spec, study.factors, study.seeds
    if spec.design == "grid":
        drawn = [factor for factor in factors if not factor.levels]
        draws = _points("latin", len(drawn), len(seeds), spec.seed)
        grid = itertools.product(*(factor.levels or (None,) for factor in factors))
        points = [[_with_draws(factors, fixed, draw) for draw in draws] for fixed in grid]
    else:
        shares = _points(spec.design, len(factors), spec.runs or 1, spec.seed)
        points = [
            [tuple(factor.at(u) for factor, u in zip(factors, share, strict=True))] * len(seeds) for share in shares
        ]
    levels = ((point[i], seed) for point in points for i, seed in enumerate(seeds))
    return [
        Case(
            index,
            seed,
            tuple(level.cell for level in point),
            tuple(change for level in point for change in level.changes),
        )
        for index, (point, seed) in enumerate(levels)
    ]


def _with_draws(
    factors: tuple[Factor, ...], fixed: tuple[Level | None, ...], draw: Sequence[float]
) -> tuple[Level, ...]:
    """Return the level of each factor: the fixed one, or the next drawn one."""
    shares = iter(draw)
    return tuple(
        factor.at(next(shares)) if level is None else level for factor, level in zip(factors, fixed, strict=True)
    )


def _points(design: str, dimensions: int, count: int, seed: int) -> list[list[float]]:
    """Return `count` points in the unit cube.

    Raises:
        InputError: SciPy is not installed.
    """
    if dimensions == 0:
        return [[]] * count
    qmc: Any = needed("scipy.stats.qmc")
    if design == "latin":
        sampler = qmc.LatinHypercube(dimensions, rng=seed)
        found: list[list[float]] = sampler.random(count).tolist()
    else:
        sampler = qmc.Sobol(dimensions, rng=seed)
        found = sampler.random_base2((count - 1).bit_length())[:count].tolist()
    return found
