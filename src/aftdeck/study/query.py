"""Questions in SQL about the results of a study, answered by DuckDB."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

from aftdeck.errors import InputError
from aftdeck.extra import needed
from aftdeck.study.case import Outcome
from aftdeck.study.file import Study
from aftdeck.study.table import results_table, times_table

CLOSED = {
    "enable_external_access": "false",
    "python_enable_replacements": "false",
    "temp_directory": "",
    "lock_configuration": "true",
}
"""Configuration of DuckDB in which a question reads the tables alone: no file, no network, no variable of Python.

A question may come with a stranger's study, and cannot change this configuration.
"""


class Answer(NamedTuple):
    """Answer to a question: names of the columns, and the rows."""

    columns: tuple[str, ...]
    rows: list[tuple[Any, ...]]


def ask(study: Study, outcomes: Sequence[Outcome], sql: str) -> Answer:
    """Return the answer to a question about the tables `results` and `times`.

    Raises:
        InputError: the SQL is wrong or asks for anything else, such as a file; or DuckDB or pyarrow is not installed.
    """
    duckdb: Any = needed("duckdb")
    with duckdb.connect(config=CLOSED) as base:
        base.register("results", results_table(study, [outcome.row for outcome in outcomes]))
        base.register("times", times_table(outcomes))
        try:
            found = base.sql(sql)
            if found is None:
                raise InputError(f"--query needs a question, such as SELECT * FROM results; got {sql!r}")
            return Answer(tuple(found.columns), found.fetchall())
        except duckdb.Error as error:
            raise InputError(f"--query: {error}") from None
