"""Results on disk: they survive every end of a study."""

from __future__ import annotations

import random
from collections.abc import Callable
from pathlib import Path
from typing import Any

import msgspec
import pytest

from aftdeck.report.table import Row
from aftdeck.study.case import Outcome
from aftdeck.study.columns import NUMERIC
from aftdeck.study.design import cases
from aftdeck.study.file import Study, load_study
from aftdeck.study.plan import plan_of
from aftdeck.study.result import row_of
from aftdeck.study.store import LINES, Store, StoreError, _first, _lines, outcomes_in
from tests.each import each, seeds
from tests.study.studies import FOUR, loaded

Make = Callable[..., Outcome]


@pytest.fixture
def outcome(tmp_path: Path) -> Make:
    """Maker of the result of a case of the study with four runs, without a flight."""
    study = loaded(tmp_path)
    plan, designed = plan_of(study), cases(study)

    def make(index: int, error: str = "") -> Outcome:
        found: Row = {"error": error}
        if not error:
            number = next(name for name in plan.metrics if name in NUMERIC)
            found |= {"ended": "completed", "success": True, "state_sha256": f"{index:064x}", number: 0.1 + index / 3.0}
        return Outcome(row_of(plan, designed[index], found), 1.0 / 3.0)

    return make


def test_outcomes_are_read_as_they_were_added(tmp_path: Path, outcome: Make) -> None:
    study, folder = loaded(tmp_path), tmp_path / "out"
    with Store(folder, study) as store:
        for index in (2, 0):
            store.add(index, outcome(index))
    with Store(folder, study) as store:
        assert store.done == {0, 2}
        assert store.outcomes() == [outcome(0), outcome(2)]
    assert outcomes_in(folder, study) == [outcome(0), outcome(2)]


@pytest.mark.parametrize("cut", [1, 20, 100])
def test_cut_line_is_one_case_that_was_not_finished(tmp_path: Path, cut: int, outcome: Make) -> None:
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


def test_case_is_never_stored_twice(tmp_path: Path, outcome: Make) -> None:
    with Store(tmp_path / "out", loaded(tmp_path)) as store:
        store.add(0, outcome(0))
        store.add(0, outcome(0, "late"))
        assert store.outcomes() == [outcome(0)]
    assert (tmp_path / "out" / LINES).read_bytes().count(b"\n") == 1


def test_folder_of_another_study_is_refused(tmp_path: Path, outcome: Make) -> None:
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


def test_failed_cases_can_be_run_again(tmp_path: Path, outcome: Make) -> None:
    study, folder = loaded(tmp_path), tmp_path / "out"
    with Store(folder, study) as store:
        store.add(0, outcome(0))
        store.add(1, outcome(1, "TooLong"))
        store.drop_failed()
        assert store.done == {0}
        store.add(1, outcome(1))
    assert outcomes_in(folder, study) == [outcome(0), outcome(1)]


def _kept(folder: Path, study: Study, outcome: Make) -> list[bytes]:
    """Store three results; return their lines."""
    with Store(folder, study) as store:
        for index in (2, 0, 3):
            store.add(index, outcome(index))
    return (folder / LINES).read_bytes().splitlines(keepends=True)


def _is_refused(folder: Path, study: Study) -> None:
    for read in (outcomes_in, Store):
        with pytest.raises(StoreError, match="this study did not write this line"):
            read(folder, study)


@each("seed", seeds(300, 5000))
def test_lines_that_the_study_did_not_write_there_are_refused(seed: int, tmp_path: Path, outcome: Make) -> None:
    """Bytes are changed at random; lines are moved, doubled, taken out of the middle, or taken from another study."""
    study, folder, rng = loaded(tmp_path), tmp_path / f"out-{seed}", random.Random(seed)
    lines = _kept(folder, study, outcome)
    match seed % 5:
        case 0:
            lines.append(rng.choice(lines))
        case 1:
            lines = [lines[k] for k in rng.choice(((0, 2, 1), (1, 0, 2), (1, 2, 0), (2, 1, 0), (2, 0, 1)))]
        case 2:
            del lines[rng.randrange(2)]
        case 3:
            lines.insert(
                rng.randrange(4), rng.choice((b"\n", b"{}\n", b"null\n", rng.randbytes(20).replace(b"\n", b"") + b"\n"))
            )
        case _:
            at = rng.randrange(3)
            line = bytearray(lines[at])
            line[rng.randrange(len(line) - 1)] ^= 1 << rng.randrange(7)
            lines[at] = bytes(line)
    (folder / LINES).write_bytes(b"".join(lines))
    _is_refused(folder, study)


WRONG: dict[str, dict[str, Any]] = {
    "index below 0": {"index": -1},
    "index beyond the last": {"index": 4},
    "index of another case": {"index": 1},
    "index as a switch": {"index": False},
    "index as a text": {"index": "2"},
    "another seed": {"seed": 9},
    "another level": {"speed": "9 ft/s"},
    "a column that no metric has": {"colour": 1.0},
    "success as a number": {"success": 1},
    "no end": {"ended": ""},
    "another end": {"ended": "won"},
    "no state": {"state_sha256": ""},
    "a text as a number": {"final_error_m": "small"},
    "a switch as a number": {"final_angle_rad": True},
    "an error with a result": {"error": "TooLong"},
    "no text as error": {"error": None},
}


@pytest.mark.parametrize("wrong", WRONG)
def test_rows_outside_the_design_are_refused_even_with_matching_digests(
    wrong: str, tmp_path: Path, outcome: Make
) -> None:
    study, folder = loaded(tmp_path), tmp_path / "out"
    _kept(folder, study, outcome)
    row = outcome(2).row | WRONG[wrong]
    lines, _ = _lines([msgspec.structs.replace(outcome(2), row=row)], _first(study))
    (folder / LINES).write_bytes(lines)
    _is_refused(folder, study)


def test_a_metric_that_is_no_number_is_refused(tmp_path: Path, outcome: Make) -> None:
    study, folder = loaded(tmp_path), tmp_path / "out"
    _kept(folder, study, outcome)
    for name in plan_of(study).metrics:
        wrong = "text" if name in NUMERIC else 1.0
        lines, _ = _lines([msgspec.structs.replace(outcome(2), row=outcome(2).row | {name: wrong})], _first(study))
        (folder / LINES).write_bytes(lines)
        _is_refused(folder, study)
