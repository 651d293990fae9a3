"""Names of files that are not UTF-8: every command works with them, and shows them with escapes."""

from __future__ import annotations

import os
import shutil
from pathlib import Path
from typing import Any

import msgspec
import pytest

import aftdeck
from aftdeck import cli
from aftdeck.encodable import encodable
from aftdeck.historical.words_file import WordsWriter, new_words_file
from aftdeck.recording.index import Index
from aftdeck.recording.run import record
from aftdeck.scenario.load import about, load_scenario
from aftdeck.simulation.run import Simulation
from tests.commands import Run
from tests.study.studies import FOUR, SHORT

NAME = os.fsdecode(b"not-\xff-utf-8")
"""Name of folders and files in these tests, without an ending."""
SHOWN = r"not-\udcff-utf-8"
"""How a person reads this name."""
SCENARIO, CONCEPT, RECORDING = f"{NAME}.toml", f"concept-{NAME}.toml", f"{NAME}.mcap"
COMMANDS: list[Any] = [
    ("run", SCENARIO),
    ("run", SCENARIO, "--json"),
    ("run", SCENARIO, "--out", f"new-{NAME}.mcap"),
    ("run", CONCEPT, "--words", f"new-{NAME}.jsonl"),
    ("run", CONCEPT, "--channels", f"{NAME}.jsonl"),
    ("run", CONCEPT, "--vcu", f"blocks-{NAME}.jsonl"),
    ("check", SCENARIO),
    ("check", SCENARIO, "--json"),
    ("arm", f"arm-{NAME}.toml", "limits", "--json"),
    ("render", RECORDING, "--camera", "A", "--size", "80x60", "-o", f"{NAME}.svg"),
    ("render", SCENARIO, "--camera", "A", "--size", "80x60", "-o", f"{NAME}.png"),
    ("planes", RECORDING, "--camera", "A", "--json"),
    ("planes", RECORDING, "--camera", "A", "-o", f"planes-{NAME}.svg"),
    ("replay", RECORDING),
    ("replay", RECORDING, "--json"),
    ("replay", RECORDING, "--set", "phase[0].rate=vernier", "--out", f"changed-{NAME}.mcap"),
    ("replay", RECORDING, "--html", f"{NAME}.html"),
    ("recordings",),
    ("recordings", "--json"),
    ("report", RECORDING),
    ("report", RECORDING, "--json"),
    ("report", RECORDING, "--table", f"{NAME}.csv"),
    ("report", RECORDING, "--table", f"{NAME}.parquet"),
    pytest.param(("report", RECORDING, "-o", f"report-{NAME}.html"), marks=pytest.mark.slow),
    ("export", RECORDING, "--minari", "PLAIN/flights-v0", "--json"),
    ("study", f"study-{NAME}.toml", "-o", f"study-{NAME}", "--only", "0", "--json"),
    pytest.param(("study", f"study-{NAME}.toml", "-o", f"study-{NAME}", "--jobs", "1"), marks=pytest.mark.slow),
    ("scenarios",),
    ("arms",),
    ("studies",),
]
"""Calls of commands with such names; each succeeds."""
ELSEWHERE = {"fly"}
"""Commands that `station/test_recorded.py` tests."""
MISSING = [
    *(("run", f"missing-{NAME}{ending}") for ending in (".toml", "")),
    *((command, f"missing-{NAME}.toml") for command in ("fly", "check")),
    ("arm", f"missing-{NAME}.toml", "limits"),
    *((command, f"missing-{NAME}.mcap") for command in ("replay", "report")),
    ("render", f"missing-{NAME}.mcap", "--camera", "A", "-o", "any.svg"),
    ("export", f"missing-{NAME}.mcap", "--minari", "/tmp/missing-v0"),
    ("study", f"missing-{NAME}.toml", "-o", "missing"),
    ("run", CONCEPT, "--channels", f"missing-{NAME}.jsonl"),
    ("fly", "--policy", f"missing-{NAME}.npz"),
]
"""Calls with files that do not exist."""


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Folder with a file of each kind; its name and theirs are not UTF-8."""
    folder = tmp_path_factory.mktemp("names") / NAME
    folder.mkdir()
    arms = Path(aftdeck.__file__).parent / "arms"
    for name in ("srms.toml", "srms.shapes.toml"):
        shutil.copy(arms / name, folder)
    shutil.copy(arms / "srms.toml", folder / f"arm-{NAME}.toml")
    own = SHORT.replace('"srms"', '"srms.toml"')
    for name in (SCENARIO, "short.toml"):
        (folder / name).write_text(own, encoding="utf-8")
    (folder / CONCEPT).write_text(about("concept-1972").file.replace("3600 s", "0.2 s"), encoding="utf-8")
    (folder / f"study-{NAME}.toml").write_text(FOUR, encoding="utf-8")
    sim = Simulation(load_scenario(folder / CONCEPT))
    with new_words_file(sim.scenario, folder / f"{NAME}.jsonl") as file:
        writer = WordsWriter(file, sim.scenario)
        sim.step()
        writer.step(sim)
    record(load_scenario(folder / SCENARIO), folder / RECORDING, index=Index())
    return folder


def test_every_command_is_tested() -> None:
    calls = [getattr(call, "values", (call,))[0] for call in COMMANDS]
    assert {call[0] for call in calls} | ELSEWHERE == {
        info.name or info.callback.__name__ for info in cli.app.registered_commands if info.callback
    }


@pytest.mark.slow
@pytest.mark.long
@pytest.mark.parametrize("command", COMMANDS, ids=lambda command: encodable(" ".join(command)))
def test_command_works_with_names_that_are_not_utf_8(
    run: Run, folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, command: tuple[str, ...]
) -> None:
    monkeypatch.chdir(folder)
    code, out, err = run(*(part.replace("PLAIN", str(tmp_path)) for part in command))
    assert code == 0, err
    (out + err).encode()
    if "--json" in command:
        msgspec.json.decode(out.encode())


@pytest.mark.parametrize("command", MISSING, ids=lambda command: encodable(" ".join(command)))
def test_missing_file_is_named_with_escapes(
    run: Run, folder: Path, monkeypatch: pytest.MonkeyPatch, command: tuple[str, ...]
) -> None:
    monkeypatch.chdir(folder)
    code, out, err = run(*command)
    assert code == 2
    assert f"missing-{SHOWN}" in err
    (out + err).encode()


def test_dataset_in_a_folder_whose_name_is_not_utf_8_is_rejected(
    run: Run, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(folder)
    code, _, err = run("export", RECORDING, "--minari", "flights-v0")
    assert code == 2
    assert f"{SHOWN}/flights-v0: the path of a dataset has to be UTF-8" in err
