"""``aftdeck run --words``: what is written, and what is refused before anything is flown."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from aftdeck.simulation.run import Simulation
from aftdeck.worksite.channels import decode_inputs
from aftdeck.worksite.words import decode_block
from tests.commands import Run

SCENARIO = """title = "short"
arm = "concept-1972"
duration = "1 s"

[initial]
joints = [0, "32 deg", "-106 deg", 0, "-16 deg", 0]

[[phase]]
name = "forward"
mode = "ORB UNL"
translation = [0.2, 0, 0]
duration = "0.2 s"
"""


@pytest.fixture
def short(tmp_path: Path) -> str:
    path = tmp_path / "short.toml"
    path.write_text(SCENARIO)
    return str(path)


@pytest.fixture
def grounded(monkeypatch: pytest.MonkeyPatch) -> None:
    """Nothing may be flown."""

    def fly(_: Simulation, *__: object) -> None:
        raise AssertionError("it is flown")

    monkeypatch.setattr(Simulation, "advance", fly)


def test_each_step_is_a_line_of_channels_and_words(run: Run, short: str, tmp_path: Path) -> None:
    path = tmp_path / "folder" / "words.jsonl"
    summary = run.json("run", short, "--words", str(path))
    lines = [json.loads(line) for line in path.read_text().splitlines()]
    assert lines[-1]["time_s"] == summary["time_s"]
    block = decode_block([int(word, 8) for word in lines[-1]["words"]])
    assert block.control.mode == 1 and block.control.station == "A"
    assert block.angles == pytest.approx(summary["joints_rad"], abs=1e-6)
    assert decode_inputs(lines[-1]["volts"]).angles == pytest.approx(summary["joints_rad"], abs=1e-6)


@pytest.mark.usefixtures("grounded")
def test_another_arm_has_no_words_and_is_not_flown(run: Run, tmp_path: Path) -> None:
    words, out = tmp_path / "words.jsonl", tmp_path / "run.mcap"
    code, said, err = run("run", "uncradle", "--words", str(words), "--out", str(out))
    assert (code, said) == (2, "")
    assert err.startswith("aftdeck: the report's words speak of its own arm") and "uncradle flies srms" in err
    assert not words.exists() and not out.exists()


@pytest.mark.usefixtures("grounded")
@pytest.mark.parametrize(("place", "why"), [("file", "File exists"), ("file/words.jsonl", "exists")])
def test_words_that_cannot_be_written_are_told_before_the_run(
    run: Run, short: str, tmp_path: Path, place: str, why: str
) -> None:
    (tmp_path / "file").write_text("kept")
    out = tmp_path / "run.mcap"
    code, said, err = run("run", short, "--words", str(tmp_path / place), "--out", str(out))
    assert (code, said) == (2, "")
    assert err.startswith(f"aftdeck: {tmp_path / place}: cannot be written: ") and why in err
    assert (tmp_path / "file").read_text() == "kept" and not out.exists()


@pytest.mark.usefixtures("grounded")
def test_a_run_that_is_not_recorded_leaves_no_words(run: Run, short: str, tmp_path: Path) -> None:
    words, out = tmp_path / "words.jsonl", tmp_path / "run.mcap"
    out.write_text("kept")
    code, said, _ = run("run", short, "--words", str(words), "--out", str(out))
    assert (code, said) == (2, "") and not words.exists()
    code, said, err = run("run", short, "--words", str(words), "--out", str(words))
    assert (code, said) == (2, "")
    assert err == f"aftdeck: --out and --words both name {words}; each needs a file of its own\n"
