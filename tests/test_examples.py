"""The examples run without error, and the Python and the commands in the README are correct."""

import doctest
import subprocess
import sys
from pathlib import Path

import pytest
from typer.main import get_command

from aftdeck.cli import app
from aftdeck.scenario.build import BUILT_IN
from aftdeck.scenario.load import built_in, parse_scenario
from aftdeck.steering.mode import MODES

ROOT = Path(__file__).resolve().parent.parent
EXAMPLES = sorted((ROOT / "examples").glob("*.py"))
README = ROOT / "README.md"
STEERING = ROOT / "docs" / "steering.md"


@pytest.mark.slow
@pytest.mark.parametrize("example", EXAMPLES, ids=lambda path: path.stem)
def test_example_runs_from_any_folder_without_a_warning(example: Path, tmp_path: Path) -> None:
    command = [sys.executable, "-W", "error", str(example)]
    ended = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, timeout=400, check=False)
    assert (ended.returncode, ended.stderr) == (0, "")
    assert ended.stdout.count("\n") >= 3


def test_examples_are_numbered_from_one_without_a_gap() -> None:
    assert [path.name[:3] for path in EXAMPLES] == [f"{i:02}_" for i in range(1, len(EXAMPLES) + 1)]


def test_readme_begins_with_its_two_commands() -> None:
    lines = [line.strip() for line in README.read_text(encoding="utf-8").splitlines() if line.strip()]
    assert [line.split("#")[0].strip() for line in lines[1:3]] == ["make fly", "make test"]


@pytest.mark.parametrize(
    "page", [README, ROOT / "docs" / "own-servos.md", ROOT / "docs" / "dynamics-python.md"], ids=lambda page: page.name
)
def test_python_of_a_page_gives_the_results_it_shows(page: Path) -> None:
    failed, tried = doctest.testfile(str(page), module_relative=False, encoding="utf-8")
    assert tried > 0
    assert failed == 0


def test_readme_names_every_command_and_every_scenario() -> None:
    text = README.read_text(encoding="utf-8")
    commands = getattr(get_command(app), "commands")  # noqa: B009  (only a group has this attribute)
    missing = [f"aftdeck {name}" for name in commands if f"`aftdeck {name}" not in text]
    missing += [name for name in built_in() if f"`{name}`" not in text]
    assert not missing


@pytest.mark.parametrize("page", [README, *sorted((ROOT / "docs").glob("*.md"))], ids=lambda path: path.name)
def test_files_linked_from_a_document_exist(page: Path) -> None:
    targets = [part.split(")")[0].split("#")[0] for part in page.read_text(encoding="utf-8").split("](")[1:]]
    missing = [t for t in targets if t and "://" not in t and not (page.parent / t).exists()]
    assert not missing


def test_sequence_in_steering_md_loads_unchanged() -> None:
    lines = STEERING.read_text(encoding="utf-8").splitlines()
    begin = lines.index("    [[sequence]]")
    end = next(i for i, line in enumerate(lines) if i > begin and line and not line.startswith("    "))
    shown = "\n".join(line.strip() for line in lines[begin:end])
    text = f'title = "shown"\n[initial]\njoints = [0, 0.9, -1.4, 0.5, 0.2, 0]\n{shown}\n'
    points = parse_scenario(text, "shown", "steering.md", BUILT_IN).sequences["AUTO 1"]
    assert [point.pause for point in points] == [False, True]


def test_steering_md_names_every_panel_position() -> None:
    text = STEERING.read_text(encoding="utf-8").replace("AUTO 1–4", "AUTO 1 AUTO 2 AUTO 3 AUTO 4")
    assert [position for position in MODES if position not in text] == []
