"""``--words`` and ``--channels``: files written, runs from files, and rejections before the run."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from aftdeck.historical.frame_words import decode_block
from aftdeck.historical.input_channels import decode_inputs
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
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
    """Forbid every simulation step."""

    def fly(_: Simulation, *__: object) -> None:
        raise AssertionError("a step was made")

    monkeypatch.setattr(Simulation, "advance", fly)


def test_words_file_has_one_line_per_step(run: Run, short: str, tmp_path: Path) -> None:
    path = tmp_path / "folder" / "words.jsonl"
    code, out, err = run("run", short, "--words", str(path), "--json")
    summary = json.loads(out)
    assert code == 0 and "script" in err  # the script has no channel
    lines = [json.loads(line) for line in path.read_text().splitlines()]
    assert lines[-1]["time_s"] == summary["time_s"]
    block = decode_block([int(word, 8) for word in lines[-1]["words"]])
    assert block.control.mode == 1 and block.control.station == "A"
    assert block.angles == pytest.approx(summary["joints_rad"], abs=1e-6)
    assert decode_inputs(lines[-1]["volts"]).angles == tuple(summary["joints_rad"])
    assert {"script", "mode"} <= set(lines[-1]["unsaid"])


@pytest.mark.usefixtures("grounded")
def test_words_of_another_arm_are_rejected_before_the_run(run: Run, tmp_path: Path) -> None:
    words, out = tmp_path / "words.jsonl", tmp_path / "run.mcap"
    code, output, err = run("run", "uncradle", "--words", str(words), "--out", str(out))
    assert (code, output) == (2, "")
    assert err.startswith("aftdeck: uncradle: ") and "srms" in err
    assert not words.exists() and not out.exists()


@pytest.mark.usefixtures("grounded")
@pytest.mark.parametrize(("place", "why"), [("file", "exists already"), ("file/words.jsonl", "Not a directory")])
def test_unwritable_words_file_is_rejected_before_the_run(
    run: Run, short: str, tmp_path: Path, place: str, why: str
) -> None:
    (tmp_path / "file").write_text("kept")
    out = tmp_path / "run.mcap"
    code, output, err = run("run", short, "--words", str(tmp_path / place), "--out", str(out))
    assert (code, output) == (2, "")
    assert err.startswith(f"aftdeck: {tmp_path / place}: ") and why in err
    assert (tmp_path / "file").read_text() == "kept" and not out.exists()


@pytest.mark.usefixtures("grounded")
def test_failed_recording_leaves_no_words_file(run: Run, short: str, tmp_path: Path) -> None:
    words, out = tmp_path / "words.jsonl", tmp_path / "run.mcap"
    out.write_text("kept")
    code, output, _ = run("run", short, "--words", str(words), "--out", str(out))
    assert (code, output) == (2, "") and not words.exists()
    code, output, err = run("run", short, "--words", str(words), "--out", str(words))
    assert (code, output) == (2, "")
    assert str(words) in err


def master_file(path: Path) -> Path:
    """Write the channels of a run in MASTER to a file."""
    turns = [[0.0, 0.07 + 0.0003 * k, -0.23, 0.0, -0.035, 0.0001 * k] for k in range(40)]
    lines = [{"volts": [0.0, 0.0, *turn, -1.0, 0.5, -1.0, 0.75, 1.0]} for turn in turns]
    path.write_text("".join(json.dumps(line) + "\n" for line in lines))
    return path


def test_run_from_channels_writes_equal_channels_and_words(run: Run, short: str, tmp_path: Path) -> None:
    """Three runs are equal: from a file, from the channels that the first run writes, and from its recording."""
    given, first, second, third = (tmp_path / f"{name}.jsonl" for name in ("given", "first", "second", "third"))
    out = tmp_path / "run.mcap"
    master_file(given)
    summary = run.json("run", short, "--channels", str(given), "--words", str(first), "--out", str(out))
    again = run.json("run", short, "--channels", str(first), "--words", str(second))
    verdict = run.json("replay", str(out), "--words", str(third))
    assert summary["ended"] == "completed" and summary["frames_sha256"] == again["frames_sha256"]
    assert verdict["equal"] and verdict["frames"] == 40
    assert first.read_text() == second.read_text() == third.read_text()
    lines = [json.loads(line) for line in first.read_text().splitlines()]
    assert [line["volts"] for line in lines] == [json.loads(line)["volts"] for line in given.read_text().splitlines()]
    control = decode_block([int(word, 8) for word in lines[-1]["words"]]).control
    assert (control.station, control.pan, control.zoom, control.telescope) == ("B", -1, -1, -1)


def test_channels_have_no_command_delay(run: Run, short: str, tmp_path: Path) -> None:
    late, given, out = tmp_path / "late.toml", tmp_path / "given.jsonl", tmp_path / "run.mcap"
    late.write_text(Path(short).read_text().replace('duration = "1 s"', 'duration = "1 s"\ncommand_delay = "0.1 s"'))
    master_file(given)
    at_once = run.json("run", short, "--channels", str(given))
    delayed = run.json("run", str(late), "--channels", str(given), "--out", str(out))
    assert delayed["frames_sha256"] == at_once["frames_sha256"]
    assert run.json("replay", str(out))["equal"]


@pytest.mark.usefixtures("grounded")
def test_invalid_channels_are_rejected_before_the_run(run: Run, short: str, tmp_path: Path) -> None:
    given = master_file(tmp_path / "given.jsonl")
    assert run("run", "first-flight", "--channels", str(given))[0] == 2
    code, _, err = run("run", short, "--channels", str(tmp_path / "none.jsonl"))
    assert code == 2 and "none.jsonl: cannot be read" in err
    code, _, err = run("run", short, "--channels", "/dev/zero")
    assert code == 2 and "cannot be read: it is not a regular file" in err
    given.write_text(given.read_text() + "[]\n")
    code, _, err = run("run", short, "--channels", str(given))
    assert code == 2 and "given.jsonl:41: " in err


def test_run_from_channels_lists_unsaid_commands(run: Run, short: str, tmp_path: Path) -> None:
    given = master_file(tmp_path / "given.jsonl")
    told = json.dumps({"volts": [0.0] * 13, "unsaid": ["latch", "rate"]})
    given.write_text(given.read_text() + f"{told}\n{told}\n")
    code, _, err = run("run", short, "--channels", str(given))
    assert code == 0 and "latch in 2 steps, rate in 2 steps" in err


def test_unknown_camera_in_channels_is_rejected_with_its_line(run: Run, short: str, tmp_path: Path) -> None:
    given = master_file(tmp_path / "given.jsonl")
    given.write_text(given.read_text() + json.dumps({"volts": [0.0] * 10 + [1.0, -1.0, 0.0]}) + "\n")
    code, _, err = run("run", short, "--channels", str(given))
    assert code == 2 and "line 41 of the channels" in err and "camera H" in err


@pytest.mark.parametrize("scripted", [True, False])
def test_run_without_script_prints_a_note_first(
    run: Run, short: str, tmp_path: Path, scripted: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    output: list[str] = []
    path = tmp_path / "idle.toml"
    path.write_text(SCENARIO if scripted else SCENARIO.partition("[[phase]]")[0])
    fly = Simulation.advance

    def heard(sim: Simulation, inputs: Inputs | None = None) -> None:
        output.append(run.capsys.readouterr().err)
        fly(sim, inputs)

    monkeypatch.setattr(Simulation, "advance", heard)
    assert run("run", str(path))[0] == 0
    assert ("has no script" in output[0]) is not scripted and not any(output[1:])
