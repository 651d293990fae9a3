"""Types of a study file."""

from __future__ import annotations

from typing import Annotated, Any, Literal

import msgspec

from aftdeck.bounds import Bounds
from aftdeck.units import Time

Text = Annotated[str, msgspec.Meta(min_length=1)]
Design = Literal["grid", "latin", "sobol"]
"""All combinations of the levels; a Latin hypercube; a Sobol sequence."""
Distribution = Literal["uniform", "normal", "lognormal", "triangular"]
Number = float | str
"""A number in SI units, or a text with a number and its unit, such as ``20 ft``."""
Seed = Annotated[int, Bounds(0, 2**53, "JSON and JavaScript represent no greater integer exactly")]
Count = Annotated[int, Bounds(1, 1_000_000, "a million runs of a minute take a processor two years")]


class _Part(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Base of all tables: immutable, and fields that the schema does not know are errors."""


class LevelSpec(_Part, frozen=True):
    """A level with a name, which sets several keys: another arm, a set of limits, a pair of cameras."""

    name: Text
    set: dict[str, Any]
    """New values, by their keys."""


class FactorSpec(_Part, frozen=True):
    """What a study varies.

    `key` or `keys` name the values that change; all `keys` get the same value. A factor has one of these: `levels`;
    levels with names, each in its own table `level`; a range from `low` to `high`; a `distribution`. A grid divides a
    range into `count` levels. The other designs, and a grid without `count`, draw values from the range. With the scale
    `log`, equal steps are equal ratios. A normal distribution needs `mean` and `deviation`; `low` and `high` cut off
    its tails. A lognormal distribution has the median `mean`, and its logarithm the standard deviation `deviation`. A
    triangular distribution has its peak at `mean`.
    """

    name: str = ""
    """Name of the column in the table; by default the key."""
    key: str = ""
    keys: tuple[str, ...] = ()
    levels: tuple[Any, ...] = ()
    level: tuple[LevelSpec, ...] = ()
    low: Number | None = None
    high: Number | None = None
    scale: Literal["linear", "log"] = "linear"
    count: Annotated[int, Bounds(2, 1000, "a grid needs two levels, and few results need a thousand")] | None = None
    distribution: Distribution | None = None
    mean: Number | None = None
    deviation: Number | None = None


class SuccessSpec(_Part, frozen=True):
    """Rule of success: how a run ends, and bounds of its metrics, by the names of their columns (docs/metrics.md).

    A metric without a value does not satisfy its bound.
    """

    ended: Literal["completed", "any"] = "completed"
    at_most: dict[str, float] = msgspec.field(default_factory=dict)
    at_least: dict[str, float] = msgspec.field(default_factory=dict)


class MonitorsSpec(_Part, frozen=True):
    """Cameras that the monitors show during the whole run."""

    mon_1: str = ""
    mon_2: str = ""


class ReportSpec(_Part, frozen=True):
    """Content of the report page.

    `responses` are the columns whose dependence on the factors is shown. The first one also orders the worst cases: the
    greatest value is the worst, or the least if `worst` says so. Unsuccessful runs are worse than all others. Without
    `responses`, the first metric of the table is shown.
    """

    responses: tuple[str, ...] = ()
    worst: Literal["greatest", "least"] = "greatest"
    recordings: Annotated[int, Bounds(0, 100, "each worst case is run once more")] = 5
    """Number of worst cases that are run once more, with a recording."""


class StudyFile(_Part, frozen=True):
    """A study file, decoded; `study.file` makes the checks that types cannot make."""

    title: Text
    scenario: Text
    text: str = ""
    design: Design = "grid"
    runs: Count | None = None
    """Number of points of a Latin hypercube or a Sobol sequence."""
    seed: Seed = 0
    """Seed of the design, and of the first repetition."""
    repeats: Count = 1
    """Number of runs at each point, with the seeds `seed`, `seed` + 1 and so on."""
    seeds: tuple[Seed, ...] = ()
    """Seeds of the repetitions, in place of `repeats`."""
    factor: tuple[FactorSpec, ...] = ()
    operator: dict[str, Any] = msgspec.field(default_factory=dict)
    """Parameters of the operator (`operators.spec.OperatorSpec`)."""
    monitors: MonitorsSpec = MonitorsSpec()
    metrics: tuple[str, ...] = ()
    """Columns of metrics to keep; by default all."""
    success: SuccessSpec = SuccessSpec()
    report: ReportSpec = ReportSpec()
    limit: Annotated[Time, Bounds(0.1, 86_400.0, "a run of an hour takes a minute without masses")] = Time(600.0)
    """Longest time of a run by the wall clock; a longer run is ended, and its row has an error."""
