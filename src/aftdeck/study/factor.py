"""Factors of a study: what changes from run to run, and the values that it takes."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from aftdeck.errors import InputError
from aftdeck.files import Problem, Where
from aftdeck.scenario.changes import as_toml
from aftdeck.scenario.keys import Change, Key
from aftdeck.study.keys import parse_key
from aftdeck.study.schema import FactorSpec
from aftdeck.study.span import Span, measure, span_of
from aftdeck.table import Cell


class Level(NamedTuple):
    """One value of a factor.

    Attributes:
        cell: the value in the table of results.
        changes: new values that it stands for.
        place: place of the level in the study file, relative to its factor.
    """

    cell: Cell
    changes: tuple[Change, ...]
    place: Where


class Factor(NamedTuple):
    """What a study varies.

    Attributes:
        name: name for people.
        column: column in the table of results; it ends with the unit if the values have one.
        levels: values of a grid; empty if values are drawn from `span`.
        span: range of the values that are drawn; None if there are only levels.
        keys: keys that all take a value drawn from `span`.
    """

    name: str
    column: str
    levels: tuple[Level, ...]
    span: Span | None
    keys: tuple[Key, ...]

    def at(self, share: float) -> Level:
        """Return the value at a share of the range, from 0 to 1; with levels, one of them, all equally likely."""
        if self.span is None:
            return self.levels[min(int(share * len(self.levels)), len(self.levels) - 1)]
        number = self.span.at(share)
        return Level(number, _all(self.keys, self.span.value(number)), ())

    def samples(self) -> tuple[Level, ...]:
        """Return the levels to check; for a range, both ends; for a distribution, nearly the least and the greatest."""
        if self.levels or self.span is None:
            return self.levels
        ends = (0.0, 1.0) if self.span.distribution in ("uniform", "triangular") else (0.01, 0.99)
        return tuple(self.at(share)._replace(place=(end,)) for share, end in zip(ends, ("low", "high"), strict=True))


def factor_of(spec: FactorSpec, grid: bool, problems: list[Problem]) -> Factor | None:
    """Return the factor of a table of a study file; None if the table has errors.

    Args:
        spec: the table.
        grid: whether the design is a grid.
        problems: collects the problems, with their places in the table.
    """
    before = len(problems)
    keys = tuple(_keys(spec, problems))
    kinds = [bool(spec.levels), bool(spec.level), spec.low is not None or spec.distribution is not None]
    if sum(kinds) != 1:
        problems.append(Problem((), "needs one of: levels, tables [[factor.level]], low and high, a distribution"))
    if spec.level and not spec.name:
        problems.append(Problem((), "needs a name, because its levels have their own keys"))
    if len(problems) > before:
        return None
    name = spec.name or keys[0].text
    if spec.level:
        named = tuple(_named_levels(spec, problems))
        return None if len(problems) > before else Factor(name, name, named, None, ())
    if spec.levels:
        unit, cells = _cells(spec.levels)
        plain = tuple(
            Level(cell, _all(keys, value), ("levels", i))
            for i, (cell, value) in enumerate(zip(cells, spec.levels, strict=True))
        )
        return Factor(name, _column(name, unit), plain, None, ())
    try:
        span = span_of(spec)
    except InputError as error:
        field, _, what = str(error).partition(": ")
        problems.append(Problem((field,), what))
        return None
    drawn = Factor(name, _column(name, span.unit), (), span, keys)
    if spec.count is None:
        return drawn
    if not grid:
        problems.append(Problem(("count",), "only a grid divides a range into levels; give `runs` to the study"))
        return None
    ends = spec.distribution in (None, "uniform")
    shares = (i / (spec.count - 1) if ends else (i + 0.5) / spec.count for i in range(spec.count))
    return drawn._replace(levels=tuple(drawn.at(share) for share in shares), span=None)


def _keys(spec: FactorSpec, problems: list[Problem]) -> Iterator[Key]:
    """Yield the keys of a factor."""
    given = [(("key",), spec.key)] if spec.key else []
    texts: list[tuple[Where, str]] = [*given, *((("keys", i), key) for i, key in enumerate(spec.keys))]
    if spec.level and texts:
        problems.append(Problem(texts[0][0], "the levels [[factor.level]] have their own keys, in `set`"))
    elif not spec.level and not texts:
        problems.append(Problem((), "needs a key, or keys"))
    for where, text in texts:
        try:
            yield parse_key(text)
        except InputError as error:
            problems.append(Problem(where, str(error)))


def _named_levels(spec: FactorSpec, problems: list[Problem]) -> Iterator[Level]:
    names: set[str] = set()
    for i, level in enumerate(spec.level):
        where: Where = ("level", i)
        if level.name in names:
            problems.append(Problem((*where, "name"), f"the name {level.name!r} occurs twice"))
        names.add(level.name)
        changes = []
        for text, value in level.set.items():
            try:
                changes.append(Change(parse_key(text), value))
            except InputError as error:
                problems.append(Problem((*where, "set", text), str(error)))
        yield Level(level.name, tuple(changes), where)


def _all(keys: tuple[Key, ...], value: object) -> tuple[Change, ...]:
    return tuple(Change(key, value) for key in keys)


def _cells(values: tuple[object, ...]) -> tuple[str, list[Cell]]:
    """Return the common unit of values and their cells: numbers if all are numbers with the same unit, else texts."""
    if all(isinstance(value, bool) for value in values):
        return "", [bool(value) for value in values]
    measures = [measure(value) for value in values]
    units = {read.unit for read in measures if read is not None}
    if None not in measures and len(units) == 1:
        return units.pop(), [read.number for read in measures if read is not None]
    return "", [value if isinstance(value, str) else as_toml(value) for value in values]


def _column(name: str, unit: str) -> str:
    """Return the name of a column with its unit, as a metric has it: ``boom_ft``, ``speed_m_s``."""
    return f"{name}_{unit.replace('/', '_').replace('*', '_').lower()}" if unit else name
