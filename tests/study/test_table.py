"""Table of results, and questions about it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from aftdeck import extra
from aftdeck.errors import InputError
from aftdeck.study.case import Outcome, Runner
from aftdeck.study.design import cases
from aftdeck.study.file import Study
from aftdeck.study.plan import plan_of
from aftdeck.study.query import ask
from aftdeck.study.table import RESULTS, TIMES, write_tables
from tests.study.studies import FOUR, loaded


@pytest.fixture(scope="module")
def study(tmp_path_factory: pytest.TempPathFactory) -> Study:
    return loaded(tmp_path_factory.mktemp("study"))


@pytest.fixture(scope="module")
def outcomes(study: Study) -> list[Outcome]:
    runner = Runner(plan_of(study))
    return [runner.run(case) for case in cases(study)]


def test_table_has_a_row_for_each_case_and_the_study_inside(
    study: Study, outcomes: list[Outcome], tmp_path: Path
) -> None:
    write_tables(study, outcomes, tmp_path)
    parquet: Any = extra.needed("pyarrow.parquet")
    table = parquet.read_table(tmp_path / RESULTS)
    assert table.to_pylist() == [outcome.row for outcome in outcomes]
    metadata: dict[bytes, bytes] = table.schema.metadata
    assert metadata[b"aftdeck.study"].decode() == FOUR
    assert metadata[b"aftdeck.scenario"].decode() == study.carried.text
    assert table.schema.field("tip_path_m").metadata[b"unit"] == b"m"
    times = parquet.read_table(tmp_path / TIMES)
    assert times.column("index").to_pylist() == [0, 1, 2, 3]


def test_wall_time_is_not_in_the_table_of_results(study: Study, outcomes: list[Outcome], tmp_path: Path) -> None:
    write_tables(study, outcomes, tmp_path)
    first = (tmp_path / RESULTS).read_bytes()
    write_tables(study, [Outcome(outcome.row, 2.0 * outcome.wall_s) for outcome in outcomes], tmp_path)
    assert (tmp_path / RESULTS).read_bytes() == first


def test_question_is_answered_in_sql(study: Study, outcomes: list[Outcome]) -> None:
    sql = "SELECT speed_ft_s, count(*) AS n FROM results JOIN times USING (index) GROUP BY ALL ORDER BY ALL"
    assert ask(study, outcomes, sql) == (("speed_ft_s", "n"), [(1.0, 2), (2.0, 2)])


@pytest.mark.parametrize("sql", ["SELECT nothing FROM results", "SELEC", "SELECT * FROM elsewhere"])
def test_wrong_question_is_an_input_error(study: Study, outcomes: list[Outcome], sql: str) -> None:
    with pytest.raises(InputError):
        ask(study, outcomes, sql)


def test_missing_library_is_named_with_its_extra(monkeypatch: pytest.MonkeyPatch) -> None:
    def missing(name: str) -> Any:
        raise ModuleNotFoundError(f"No module named {name!r}", name=name)

    monkeypatch.setattr("importlib.import_module", missing)
    with pytest.raises(InputError, match=r"pyarrow.*aftdeck\[study\]"):
        extra.needed("pyarrow")
