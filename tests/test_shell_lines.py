"""Shell lines of the documents run as they are printed, page by page and in order, in an empty folder.

What the pages take for granted, such as a recording or a study file, is made first. A line that cannot run in a test is
listed with the reason, and what it names is checked.
"""

from __future__ import annotations

import glob
import os
import subprocess
import sys
from collections.abc import Callable, Collection
from contextlib import nullcontext
from fnmatch import fnmatchcase
from importlib.util import find_spec
from pathlib import Path

import pytest
from _pytest.mark import ParameterSet

from tests.commands import Run
from tests.export.runs import by_hand, by_script_then_hand
from tests.pages import PAGES, ROOT, Line, commands_in_text, shell_lines
from tests.ray_lines import Nodes
from tests.served import ask_and_end
from tests.shell_checks import problem
from tests.study.studies import written

NOT_RUN = {
    "make *": "it installs, opens a window, or runs all tests; `.ci/run` calls check and test",
    "pip install *": "it needs the package index; test_requirements.py checks that the tests have each extra",
    "python examples/learn/*": "it trains for minutes, with torch",
    "aftdeck export * --lerobot *": "it needs LeRobot; scripts/test-lerobot runs it",
}
"""Lines that are only checked, as patterns, with the reason."""
IF_INSTALLED = {"aftdeck export * --lerobot *": "lerobot"}
"""Lines that run where a library is installed."""
SHORTER = {
    "aftdeck study capture-tolerance -o capture": ("--only", "17"),
}
"""Options added to lines that take too long, for the same command with less work."""
EXIT_CODES = {
    "aftdeck replay run.mcap --max-lost 0.5": 1,  # this recording, of a run without a screen, does not tell its delays
}
"""Exit codes of lines, if not 0."""
WAIT_S = 600.0
"""Longest time of a line [s]; the first one may compile the laws."""


def a_run(scenario: str, name: str = "run.mcap") -> Callable[[Path, Run], None]:
    """Return a preparation that records the script of a scenario."""

    def prepare(folder: Path, run: Run) -> None:
        assert run("run", scenario, "--out", str(folder / name))[0] == 0

    return prepare


def of_export(folder: Path, _: Run) -> None:
    (folder / "episodes").mkdir()
    for name in ("run", "P07-1", "episodes/1"):
        by_hand(folder / f"{name}.mcap")
    by_script_then_hand(folder / "P07-2.mcap")


def of_metrics(folder: Path, _: Run) -> None:
    for name in ("run", "first", "P07-1"):
        by_hand(folder / f"{name}.mcap")
    for name in ("second", "P07-2"):
        by_script_then_hand(folder / f"{name}.mcap")


def of_studies(folder: Path, _: Run) -> None:
    """Write the study file that the page shows, with fewer cases."""
    lines = (ROOT / "docs" / "studies.md").read_text(encoding="utf-8").partition("## A study file")[2].splitlines()
    text = "\n".join(line[4:] for line in lines[: lines.index("| field | content |")])
    fewer = text.replace("repeats = 3 ", "repeats = 2 ").replace("count = 5", "count = 3")
    assert len(fewer) == len(text)
    (folder / "mine.toml").write_text(fewer, encoding="utf-8")


def of_pictures(folder: Path, run: Run) -> None:
    a_run("concept-1972-script")(folder, run)
    assert run("run", "concept-1972-script", "--words", str(folder / "words.jsonl"))[0] == 0


PREPARED: dict[str, Callable[[Path, Run], None]] = {
    "export.md": of_export,
    "metrics.md": of_metrics,
    "recording.md": a_run("concept-1972-script", "concept.mcap"),
    "studies.md": of_studies,
    "visual-scene.md": of_pictures,
    "worksite.md": a_run("concept-1972-script"),
}
"""Files that a page takes for granted."""
SLOW = {
    *("dynamics.md", "mainprior.md", "metrics.md", "operators.md", "recording.md", "series.md", "studies.md"),
    *("visual-scene.md", "worksite.md"),
}
"""Pages whose lines take more than a few seconds."""
LONG = {"operators.md", "recording.md", "studies.md", "worksite.md"}
"""Pages whose lines take a minute or more: missions, flights of operators, a cluster of two nodes, and five studies."""


def reason_not_to_run(line: Line) -> str:
    """Return why a line is not run; "" if it is."""
    for pattern, reason in NOT_RUN.items():
        if fnmatchcase(line.text, pattern):
            library = IF_INSTALLED.get(pattern)
            return "" if library and find_spec(library) else reason
    return ""


def pages_with(lines: Callable[[Path], list[Line]], slow: Collection[str] = ()) -> list[ParameterSet]:
    """Return the pages that have lines, as parameters."""
    found = []
    for page in PAGES:
        marks = [pytest.mark.slow] if page.name in slow else []
        marks += [pytest.mark.long] if marks and page.name in LONG else []
        if lines(page):
            found.append(pytest.param(page, id=page.name, marks=marks))
    return found


@pytest.mark.parametrize("page", pages_with(shell_lines, SLOW))
def test_shell_lines_of_a_page_run(page: Path, tmp_path: Path, run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "examples").symlink_to(ROOT / "examples")
    if page.name in PREPARED:
        PREPARED[page.name](tmp_path, run)
    lines = shell_lines(page)
    with Nodes(monkeypatch) if any(map(Nodes.takes, lines)) else nullcontext() as cluster:
        for line in lines:
            assert problem(line) == "", line.place
            if reason_not_to_run(line):
                continue
            words = [*line.words, *SHORTER.get(line.text, ())]
            if cluster is not None and cluster.takes(line):
                written(tmp_path)
                cluster.run(line)
            elif words[0] == "aftdeck" and (words[1] == "fly" or "--open" in words):
                ask_and_end(*words[1:])
            else:
                code, err = called(words, line.variables, run)
                assert code == EXIT_CODES.get(line.text, 0), f"{line.place}: {err}"


def called(words: list[str], variables: dict[str, str], run: Run) -> tuple[int, str]:
    """Run a command of Aftdeck in this process, another program in its own; return exit code and errors."""
    if words[0] == "aftdeck":
        code, _, err = run(*(name for word in words[1:] for name in (sorted(glob.glob(word)) or [word])))
        return code, err
    assert words[0] == "python", words
    done = subprocess.run(
        [sys.executable, *words[1:]],
        env=os.environ | variables,
        capture_output=True,
        text=True,
        timeout=WAIT_S,
        check=False,
    )
    return done.returncode, done.stderr


@pytest.mark.parametrize("page", pages_with(commands_in_text))
def test_commands_in_the_text_of_a_page_exist(page: Path) -> None:
    assert [(line.place, found) for line in commands_in_text(page) if (found := problem(line))] == []


@pytest.mark.parametrize("table", [NOT_RUN, SHORTER, EXIT_CODES], ids=["not run", "shorter", "exit codes"])
def test_every_exception_is_needed(table: dict[str, object]) -> None:
    texts = [line.text for page in PAGES for line in shell_lines(page)]
    assert [pattern for pattern in table if not any(fnmatchcase(text, pattern) for text in texts)] == []
