"""Table of results as a Parquet file; its metadata contain the study file."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from aftdeck.extra import needed
from aftdeck.law_folder import state_of_the_laws
from aftdeck.report.catalogue import METRICS
from aftdeck.report.table import Row, column_of
from aftdeck.study.case import Outcome
from aftdeck.study.columns import ABOUT, NUMERIC, OUTCOME
from aftdeck.study.factor import Factor
from aftdeck.study.file import Study
from aftdeck.version import __version__
from aftdeck.whole_file import whole_file

RESULTS, TIMES = "results.parquet", "times.parquet"
"""Files of the tables: the results, and how long they took, which differs from run to run."""


def results_table(study: Study, rows: Sequence[Row]) -> Any:
    """Return the results as an Arrow table: one row for each case, sorted by index.

    Its metadata contain the study file (``aftdeck.study``), the scenario, and the version; each column's metadata tell
    its description and its unit.
    """
    arrow: Any = needed("pyarrow")
    fields = [arrow.field(name, kind, metadata=about) for name, kind, about in _fields(study, arrow)]
    metadata = {
        "aftdeck.study": study.source.text,
        "aftdeck.study.name": study.name,
        "aftdeck.scenario": study.carried.text,
        "aftdeck.version": __version__,
        "aftdeck.laws": state_of_the_laws(),
    }
    schema = arrow.schema(fields, metadata=metadata)
    columns = [arrow.array([row[field.name] for row in rows], field.type) for field in fields]
    return arrow.Table.from_arrays(columns, schema=schema)


def times_table(outcomes: Sequence[Outcome]) -> Any:
    """Return how long each case took, as an Arrow table."""
    arrow: Any = needed("pyarrow")
    return arrow.table(
        {
            "index": arrow.array([outcome.row["index"] for outcome in outcomes], arrow.int64()),
            "wall_s": arrow.array([outcome.wall_s for outcome in outcomes], arrow.float64()),
            "peak_memory_mb": arrow.array([outcome.peak_memory_mb for outcome in outcomes], arrow.float64()),
        }
    )


def write_tables(study: Study, outcomes: Sequence[Outcome], folder: Path) -> None:
    """Write both tables into a folder; older ones are replaced.

    Raises:
        InputError: a file cannot be written, or pyarrow is not installed.
    """
    _write(results_table(study, [outcome.row for outcome in outcomes]), folder / RESULTS)
    _write(times_table(outcomes), folder / TIMES)


def _write(table: Any, path: Path) -> None:
    parquet: Any = needed("pyarrow.parquet")
    with whole_file(path) as file:
        parquet.write_table(table, file, compression="zstd")


def _fields(study: Study, arrow: Any) -> list[tuple[str, Any, dict[str, str]]]:
    """Return name, type and metadata of each column."""
    kinds = {name: arrow.float64() if name in NUMERIC else arrow.string() for name in OUTCOME}
    kinds["success"] = arrow.bool_()
    head = [(name, arrow.int64(), {"description": ABOUT[name]}) for name in ("index", "seed")]
    factors = [(factor.column, _kind(factor, arrow), _about(factor)) for factor in study.factors]
    outcome = [(name, kinds[name], {"description": ABOUT[name]}) for name in OUTCOME]
    metrics = [
        (
            column.name,
            arrow.string() if column.kind == "text" else arrow.float64(),
            {"description": column.definition, "unit": column.unit},
        )
        for column in map(column_of, METRICS)
        if column.name in study.metric_columns
    ]
    order = {name: place for place, name in enumerate(study.metric_columns)}
    return head + factors + outcome + sorted(metrics, key=lambda metric: order[metric[0]])


def _kind(factor: Factor, arrow: Any) -> Any:
    cells = [level.cell for level in factor.levels]
    if not cells or all(isinstance(cell, float) for cell in cells):
        return arrow.float64()
    return arrow.bool_() if all(isinstance(cell, bool) for cell in cells) else arrow.string()


def _about(factor: Factor) -> dict[str, str]:
    keys = [
        *(key.text for key in factor.keys),
        *(change.key.text for level in factor.levels for change in level.changes),
    ]
    return {"description": f"factor {factor.name}: {', '.join(dict.fromkeys(keys))}"}
