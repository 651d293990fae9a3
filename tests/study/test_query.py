"""Questions in SQL: they reach the two tables, and nothing else on the machine."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import duckdb
import pytest

from aftdeck.errors import InputError
from aftdeck.study.file import Study
from aftdeck.study.query import CLOSED, ask
from tests.study.studies import loaded

SECRET = "17 words that only the file has"
OUTSIDE = [
    "COPY results TO '{new}'",
    "COPY results FROM '{file}'",
    "EXPORT DATABASE '{new}'",
    "IMPORT DATABASE '{folder}'",
    "ATTACH '{new}' AS other",
    "SELECT * FROM '{file}'",
    "SELECT 1; COPY results TO '{new}'",
    "SET temp_directory = '{new}'",
    "CREATE PERSISTENT SECRET one (TYPE http, bearer_token 'x')",
    "INSTALL httpfs",
    "LOAD '{file}'",
    "SELECT * FROM read_csv('http://127.0.0.1:9/x.csv')",
    "SELECT * FROM outcomes",
    "SELECT * FROM SECRET",
]


@pytest.fixture(scope="module")
def study(tmp_path_factory: pytest.TempPathFactory) -> Study:
    """A small study."""
    return loaded(tmp_path_factory.mktemp("study"))


@pytest.fixture
def base() -> Iterator[Any]:
    """Database as a question has it, without tables."""
    with duckdb.connect(config={**CLOSED}) as base:
        yield base


@pytest.fixture
def file(tmp_path: Path) -> Path:
    """File that no question may read, alone in its folder."""
    file = tmp_path / "secret.csv"
    file.write_text(SECRET, encoding="utf-8")
    return file


@pytest.mark.parametrize("sql", OUTSIDE)
def test_question_about_anything_outside_is_rejected(study: Study, file: Path, sql: str) -> None:
    with pytest.raises(InputError, match="--query: "):
        ask(study, [], sql.format(file=file, folder=file.parent, new=file.parent / "new"))
    assert list(file.parent.iterdir()) == [file]


def test_no_function_of_duckdb_reads_or_writes_a_file(base: Any, file: Path) -> None:
    rows = base.sql(
        "SELECT DISTINCT function_name, function_type, len(parameters) FROM duckdb_functions() "
        "WHERE parameter_types[1] IN ('VARCHAR', 'VARCHAR[]', 'ANY')"
    ).fetchall()
    assert len(rows) > 100 and "read_text" in {name for name, _, _ in rows}
    for name, kind, count in rows:
        given = ", ".join([f"'{file}'"] * count)
        call = f'SELECT {"* FROM " if kind == "table" else ""}"{name}"({given})'
        try:
            answer = repr(base.sql(call).fetchall())
        except duckdb.Error:
            continue
        assert SECRET not in answer, call
    assert list(file.parent.iterdir()) == [file]


def test_no_setting_can_be_changed(base: Any) -> None:
    names = [name for (name,) in base.sql("SELECT name FROM duckdb_settings()").fetchall()]
    assert len(names) > 50
    changed = set()
    for name in names:
        with contextlib.suppress(duckdb.Error):
            base.sql(f"RESET {name}")
            changed.add(name)
    assert changed == {"schema", "search_path"}  # the schema in which a question looks for its tables


def test_tables_of_a_question_are_its_own(study: Study) -> None:
    sql = "CREATE TABLE own AS SELECT count(*) AS n FROM results; SELECT n FROM own"
    assert ask(study, [], sql) == (("n",), [(0,)])
