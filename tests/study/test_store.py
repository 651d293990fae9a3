"""Results on disk: they survive every end of a study."""

from __future__ import annotations

from pathlib import Path

import pytest

from aftdeck.report.table import Row
from aftdeck.study.case import Outcome
from aftdeck.study.file import load_study
from aftdeck.study.store import LINES, Store, StoreError, outcomes_in
from tests.study.studies import FOUR, loaded


def outcome(index: int, error: str = "") -> Outcome:
    row: Row = {"index": index, "seed": 0, "value": 0.1 + index / 3.0, "error": error, "text": None, "success": True}
    return Outcome(row, 1.0 / 3.0)


def test_outcomes_are_read_as_they_were_added(tmp_path: Path) -> None:
    study, folder = loaded(tmp_path), tmp_path / "out"
    with Store(folder, study) as store:
        for index in (2, 0):
            store.add(index, outcome(index))
    with Store(folder, study) as store:
        assert store.done == {0, 2}
        assert store.outcomes() == [outcome(0), outcome(2)]
    assert outcomes_in(folder, study) == [outcome(0), outcome(2)]


@pytest.mark.parametrize("cut", [1, 20, 100])
def test_cut_line_is_one_case_that_was_not_finished(tmp_path: Path, cut: int) -> None:
    study, folder = loaded(tmp_path), tmp_path / "out"
    with Store(folder, study) as store:
        for index in range(3):
            store.add(index, outcome(index))
    lines = folder / LINES
    lines.write_bytes(lines.read_bytes()[:-cut])
    assert outcomes_in(folder, study) == [outcome(0), outcome(1)]
    with Store(folder, study) as store:
        assert store.done == {0, 1}
        store.add(2, outcome(2))
    assert outcomes_in(folder, study) == [outcome(index) for index in range(3)]


def test_case_is_never_stored_twice(tmp_path: Path) -> None:
    with Store(tmp_path / "out", loaded(tmp_path)) as store:
        store.add(0, outcome(0))
        store.add(0, outcome(0, "late"))
        assert store.outcomes() == [outcome(0)]
    assert (tmp_path / "out" / LINES).read_bytes().count(b"\n") == 1


def test_folder_of_another_study_is_refused(tmp_path: Path) -> None:
    folder = tmp_path / "out"
    with Store(folder, loaded(tmp_path)) as store:
        store.add(0, outcome(0))
    other = loaded(tmp_path, FOUR.replace("repeats = 2", "repeats = 3"))
    with pytest.raises(StoreError, match="study file"):
        Store(folder, other)
    with pytest.raises(StoreError, match="study file"):
        outcomes_in(folder, other)
    study = loaded(tmp_path)
    (tmp_path / "short.toml").write_text((tmp_path / "short.toml").read_text() + "\n", encoding="utf-8")
    assert study.source.text == FOUR
    with pytest.raises(StoreError, match="scenario"):
        Store(folder, load_study(tmp_path / "study.toml"))


def test_folder_in_use_is_refused(tmp_path: Path) -> None:
    study = loaded(tmp_path)
    with Store(tmp_path / "out", study), pytest.raises(StoreError, match="another process"):
        Store(tmp_path / "out", study)
    with Store(tmp_path / "out", study):
        pass


def test_folder_without_results_has_no_answer(tmp_path: Path) -> None:
    with pytest.raises(StoreError, match="no results"):
        outcomes_in(tmp_path / "out", loaded(tmp_path))


def test_failed_cases_can_be_run_again(tmp_path: Path) -> None:
    study, folder = loaded(tmp_path), tmp_path / "out"
    with Store(folder, study) as store:
        store.add(0, outcome(0))
        store.add(1, outcome(1, "TooLong"))
        store.drop_failed()
        assert store.done == {0}
        store.add(1, outcome(1))
    assert outcomes_in(folder, study) == [outcome(0), outcome(1)]
