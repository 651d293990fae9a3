"""Loader of study files: reads a built-in study or a file into a checked `Study`."""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import msgspec

from aftdeck.encodable import encodable
from aftdeck.errors import AftdeckError, ScenarioError
from aftdeck.files import Problem, Text, Where, beside, examine, find_toml, read, sentences
from aftdeck.operators.spec import OperatorSpec
from aftdeck.report.catalogue import METRICS
from aftdeck.report.recorded import NEED_GAUGES
from aftdeck.scenario.keys import Change
from aftdeck.scenario.load import Source, find_scenario
from aftdeck.schema_check import problems_of
from aftdeck.study.carried import Carried, carry
from aftdeck.study.columns import FIXED_COLUMNS, NUMERIC
from aftdeck.study.factor import Factor, factor_of
from aftdeck.study.keys import problem_of
from aftdeck.study.schema import StudyFile

BUILT_IN = Path(__file__).parent / "builtin"
"""Folder of the studies that come with Aftdeck."""
MOST_CASES = 1_000_000
"""Greatest number of cases of a study (assumed); their rows are kept in memory."""


class Study(NamedTuple):
    """A checked study.

    Attributes:
        name: name of the file without ``.toml``.
        source: name and text of the file.
        spec: its contents.
        factors: what the study varies.
        carried: texts of the scenario, and of all arms and worksites.
    """

    name: str
    source: Text
    spec: StudyFile
    factors: tuple[Factor, ...]
    carried: Carried

    @property
    def seeds(self) -> tuple[int, ...]:
        """Seeds of the runs at each point."""
        return self.spec.seeds or tuple(range(self.spec.seed, self.spec.seed + self.spec.repeats))

    @property
    def responses(self) -> tuple[str, ...]:
        """Columns whose dependence on the factors the report shows."""
        return self.spec.report.responses or tuple(name for name in self.metric_columns if name in NUMERIC)[:1]

    @property
    def metric_columns(self) -> tuple[str, ...]:
        """Columns of the metrics in the table of results."""
        return self.spec.metrics or tuple(metric.column for metric in METRICS)

    @property
    def gauged(self) -> bool:
        """Whether the study names a metric that needs gauges; they take time, so that not every study has them."""
        spec = self.spec
        named = (*spec.metrics, *spec.report.responses, *spec.success.at_most, *spec.success.at_least)
        return not NEED_GAUGES.isdisjoint(named)


def built_in() -> tuple[str, ...]:
    """Return the names of the studies that come with Aftdeck."""
    return tuple(sorted(path.stem for path in BUILT_IN.glob("*.toml")))


def load_study(name_or_path: str | Path) -> Study:
    """Load a built-in study by its name, or a study file by its path.

    Raises:
        ScenarioError: there is no such study, or its file has errors; the message lists all errors, with their lines.
    """
    names = "study", "studies"
    path = find_toml(name_or_path, BUILT_IN, built_in(), names, lambda text: ScenarioError([text]))
    return parse_study(read(path), encodable(path.stem), path.parent)


def parse_study(source: Text, name: str, folder: Path) -> Study:
    """Return the study that a text describes.

    Args:
        source: name and text of the file.
        name: name of the study.
        folder: folder for a relative path of the scenario.

    Raises:
        ScenarioError: the text has errors; the message lists all of them, with their lines.
    """
    spec, problems = examine(StudyFile, source)
    if spec is None or problems:
        raise ScenarioError(sentences(problems, *source))
    factors = _factors(spec, problems)
    problems += _design_problems(spec, factors)
    problems += _column_problems(spec, factors)
    problems += _operator_problems(spec)
    scenario = _scenario(spec, folder, problems)
    if problems or scenario is None:
        raise ScenarioError(sentences(problems, *source))
    try:
        carried, missing = carry(scenario, _levels(factors))
    except AftdeckError as error:
        raise ScenarioError(sentences([Problem(("scenario",), str(error))], *source)) from None
    problems += [*missing, *_level_problems(spec, factors, carried)]
    if problems:
        raise ScenarioError(sentences(problems, *source))
    return Study(name, source, spec, factors, carried)


def _factors(spec: StudyFile, problems: list[Problem]) -> tuple[Factor, ...]:
    found = []
    for i, table in enumerate(spec.factor):
        own: list[Problem] = []
        factor = factor_of(table, spec.design == "grid", own)
        problems += [Problem(("factor", i, *problem.where), problem.what) for problem in own]
        if factor is not None:
            found.append(factor)
    return tuple(found)


def _scenario(spec: StudyFile, folder: Path, problems: list[Problem]) -> Source | None:
    try:
        return find_scenario(beside(spec.scenario, folder))
    except AftdeckError as error:
        problems.append(Problem(("scenario",), str(error)))
        return None


def _design_problems(spec: StudyFile, factors: tuple[Factor, ...]) -> Iterator[Problem]:
    """Yield contradictions between the design and the number of its runs."""
    if spec.seeds and (spec.repeats > 1 or spec.seed):
        yield Problem(("seeds",), "contradicts repeats or seed: give either the seeds, or the first seed and repeats")
    if len(set(spec.seeds)) < len(spec.seeds):
        yield Problem(("seeds",), "a seed occurs twice: the same run would be counted twice")
    if spec.design == "grid" and spec.runs is not None:
        yield Problem(("runs",), "a grid has as many points as its levels give; give `repeats`, or another design")
    if spec.design != "grid" and spec.runs is None:
        yield Problem(("design",), f"{spec.design} needs `runs`, the number of points")
    if spec.design != "grid" and not spec.factor:
        yield Problem(("design",), f"{spec.design} needs a factor")
    points = spec.runs or math.prod(len(factor.levels) or 1 for factor in factors)
    cases = points * (len(spec.seeds) or spec.repeats)
    if cases > MOST_CASES:
        yield Problem((), f"has {cases} cases; at most {MOST_CASES} are allowed")


def _column_problems(spec: StudyFile, factors: tuple[Factor, ...]) -> Iterator[Problem]:
    """Yield wrong names of columns: of factors, and in lists of metrics."""
    metrics = [metric.column for metric in METRICS]
    taken = {*FIXED_COLUMNS, *metrics}
    for i, factor in enumerate(factors):
        if factor.column in taken:
            yield Problem(("factor", i), f"the column {factor.column!r} exists already; give the factor another name")
        taken.add(factor.column)
    for i, name in enumerate(spec.metrics):
        if name not in metrics:
            yield Problem(("metrics", i), f"no metric {name!r}; the metrics are {', '.join(metrics)}")
    kept = spec.metrics or tuple(metrics)
    for i, name in enumerate(spec.report.responses):
        if name not in NUMERIC:
            yield Problem(("report", "responses", i), f"no number {name!r}; the numbers are {', '.join(NUMERIC)}")
        elif name in metrics and name not in kept:
            yield Problem(("report", "responses", i), f"{name!r} is not in `metrics`, which lists what the table keeps")
    for bound in ("at_most", "at_least"):
        for name in getattr(spec.success, bound):
            if name not in NUMERIC:
                yield Problem(("success", bound, name), f"no number {name!r}; the numbers are {', '.join(NUMERIC)}")


def _operator_problems(spec: StudyFile) -> Iterator[Problem]:
    for where, what in problems_of(spec.operator, OperatorSpec):
        yield Problem(("operator", *where), what)


def _levels(factors: tuple[Factor, ...]) -> Iterator[tuple[Where, Change]]:
    """Yield all changes of all levels, and those of both ends of each range, with their places in the file."""
    for i, factor in enumerate(factors):
        for level in factor.samples():
            for change in level.changes:
                yield ("factor", i, *level.place), change


def _level_problems(spec: StudyFile, factors: tuple[Factor, ...], carried: Carried) -> Iterator[Problem]:
    """Yield the changes that the types of the changed files do not allow."""
    texts: dict[str, list[Text]] = {
        "scenario": [Text(carried.file, carried.text)],
        "arm": [texts.arm for texts in carried.arms.values()],
        "shapes": [texts.shapes for texts in carried.arms.values() if texts.shapes is not None],
        "worksite": list(carried.worksites.values()),
    }
    tables: dict[str, dict[str, Any]] = {
        "operator": spec.operator,
        "monitors": msgspec.to_builtins(spec.monitors),
    }
    told: set[tuple[object, str]] = set()
    for where, change in _levels(factors):
        what = problem_of(change, texts, tables)
        if what and (where[1], what) not in told:
            told.add((where[1], what))
            yield Problem(where, what)
