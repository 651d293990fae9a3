"""`aftdeck study` and `aftdeck studies`."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from aftdeck.recording.reader import Recording
from aftdeck.study.file import built_in
from aftdeck.study.table import RESULTS
from tests.commands import Run
from tests.study.studies import FOUR, written

SOME_WRONG = FOUR.replace("recordings = 0", "recordings = 1") + '\n[[factor]]\nkey = "duration"\nlevels = ["2 s", 0.03]'


@pytest.mark.slow
def test_study_runs_its_cases_and_answers_questions(run: Run, tmp_path: Path) -> None:
    file, folder = str(written(tmp_path, SOME_WRONG)), tmp_path / "out"
    code, out, _ = run("study", file, "-o", str(folder), "--jobs", "1", "--json")
    assert code == 1
    assert json.loads(out) == {"folder": str(folder), "cases": 8, "successful": 4, "errors": 4}
    assert (folder / RESULTS).exists() and (folder / "report.html").exists()
    (recording,) = (folder / "recordings").glob("*.mcap")
    assert Recording(recording).opening.condition == f"case {int(recording.stem.removeprefix('case-'))}"

    sql = "SELECT duration, count(*) n FROM results WHERE error = '' GROUP BY ALL"
    assert json.loads(run("study", file, "-o", str(folder), "--query", sql, "--json")[1]) == [
        {"duration": "2 s", "n": 4}
    ]
    assert run("study", file, "-o", str(folder), "--query", "SELECT x FROM results")[0] == 2

    before = (folder / RESULTS).read_bytes()
    assert run("study", file, "-o", str(folder), "--jobs", "1")[0] == 1
    assert (folder / RESULTS).read_bytes() == before


def test_one_case_runs_alone_with_a_recording(run: Run, tmp_path: Path) -> None:
    file, folder = str(written(tmp_path)), tmp_path / "out"
    code, out, _ = run("study", file, "-o", str(folder), "--only", "3", "--json")
    row = json.loads(out)
    assert code == 0
    assert (row["index"], row["seed"], row["speed_ft_s"], row["success"]) == (3, 1, 2.0, True)
    recording = Recording(Path(row["recording"]))
    assert list(recording.messages()) and recording.ended == "completed"
    assert run("study", file, "-o", str(folder), "--only", "3")[0] == 0
    assert run("study", file, "-o", str(folder), "--only", "4")[0] == 2


def test_question_before_the_first_result_is_refused(run: Run, tmp_path: Path) -> None:
    file = str(written(tmp_path))
    code, _, err = run("study", file, "-o", str(tmp_path / "out"), "--query", "SELECT 1")
    assert code == 2 and "no results" in err
    assert run("study", file, "-o", str(tmp_path / "out"), "--query", "SELECT 1", "--only", "1")[0] == 2


def test_built_in_studies_are_listed(run: Run) -> None:
    code, out, _ = run("studies", "--json")
    assert code == 0
    assert tuple(row["name"] for row in json.loads(out)) == built_in()
