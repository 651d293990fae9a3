"""Files that appear only when they are complete, whichever command writes them."""

from __future__ import annotations

import ast
import os
from collections.abc import Iterator
from pathlib import Path

import pytest

import aftdeck
from aftdeck.errors import InputError
from aftdeck.recording.run import record
from aftdeck.scenario.load import load_scenario
from aftdeck.whole_file import new_file, whole_file, write_new, write_whole
from tests.commands import Run
from tests.full_disk import full_disk

SOURCE = Path(aftdeck.__file__).parent
OTHERWISE = {
    "cli/__init__.py": "the null device",
    "whole_file.py": "writes aside",
    "recording/sink.py": "a recording that ends early is of use",
    "study/store.py": "appends a line for each case; an incomplete one is cut off",
    "export/about.py": "into a folder that appears when it is complete",
    "made_tables.py": "a document of this repository",
}
"""Modules that may open a file for writing, and why."""
WRITERS = [
    ("render", "{run}", "--camera", "A", "--size", "80x60", "-o", "{out}.svg"),
    ("render", "{run}", "--camera", "A", "--size", "80x60", "-o", "{out}.png"),
    ("render", "{run}", "--camera", "A", "--size", "80x60", "--every", "0.1", "-o", "{out}-##.svg"),
    ("planes", "{run}", "--camera", "A", "-o", "{out}.svg"),
    ("report", "{run}", "--table", "{out}.csv"),
    ("report", "{run}", "--table", "{out}.parquet"),
    pytest.param(("report", "{run}", "-o", "{out}.html"), marks=pytest.mark.slow),
    ("replay", "{run}", "--html", "{out}.html"),
    ("replay", "{run}", "--words", "{out}.jsonl"),
]
"""Calls of commands that write a file."""


@pytest.fixture(scope="module")
def recording(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Recording of a short run of the report's arm."""
    path = tmp_path_factory.mktemp("short") / "run.mcap"
    record(load_scenario("concept-1972", {("duration",): "0.2 s"}), path)
    return path


def writing_calls(source: str) -> Iterator[int]:
    """Yield the lines of a source that open a file for writing, or write a whole one."""
    for node in ast.walk(ast.parse(source)):
        if not isinstance(node, ast.Call):
            continue
        name = node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", "")
        texts = [argument.value for argument in node.args if isinstance(argument, ast.Constant)]
        modes = [
            text for text in texts if isinstance(text, str) and set(text) & set("wxa+") and set(text) <= set("rwxab+t")
        ]
        flags = {part.attr for part in ast.walk(node) if isinstance(part, ast.Attribute)}
        if name in ("write_text", "write_bytes") or (name == "open" and (modes or flags & {"O_WRONLY", "O_RDWR"})):
            yield node.lineno


def test_scan_finds_each_way_of_writing() -> None:
    for source in ("p.write_text('')", "p.open('x')", "open(p, 'ab')", "os.open(p, os.O_RDWR | os.O_CREAT)"):
        assert list(writing_calls(source)) == [1]
    assert not list(writing_calls("p.open('rb'), open(p), p.open(encoding='utf-8')"))


def test_every_module_writes_its_files_aside() -> None:
    found = {
        str(path.relative_to(SOURCE))
        for path in SOURCE.rglob("*.py")
        if any(writing_calls(path.read_text(encoding="utf-8")))
    }
    assert found == set(OTHERWISE)


@pytest.mark.parametrize("command", WRITERS)
def test_command_on_a_full_disk_leaves_no_file(
    run: Run, recording: Path, tmp_path: Path, command: tuple[str, ...]
) -> None:
    arguments = [part.format(run=recording, out=tmp_path / "out") for part in command]
    code, _, _ = run(*arguments)
    assert code == 0
    (first, *_) = made = sorted(tmp_path.iterdir())
    half = first.stat().st_size // 2
    for path in made:
        path.unlink()
    with full_disk(half):
        code, _, err = run(*arguments)
    assert code == 2
    assert "out" in err and "cannot be written: File too large" in err
    assert not list(tmp_path.iterdir())


def test_failure_leaves_the_file_as_it_was(tmp_path: Path) -> None:
    place = tmp_path / "file"
    write_whole(place, "before")
    with pytest.raises(RuntimeError), whole_file(place) as file:
        file.write(b"half")
        raise RuntimeError
    with full_disk(10), pytest.raises(InputError, match="file: cannot be written: File too large"):
        write_whole(place, "longer than ten bytes")
    assert place.read_text() == "before"
    write_whole(place, "after")
    assert place.read_text() == "after" and list(tmp_path.iterdir()) == [place]


def test_new_file_replaces_nothing_that_appeared_meanwhile(tmp_path: Path) -> None:
    place = tmp_path / "file"
    with pytest.raises(InputError, match="exists already"), new_file(place) as file:
        file.write(b"mine")
        place.write_text("another program's")
    with pytest.raises(InputError, match="exists already"):
        write_new(place, "mine")
    assert place.read_text() == "another program's" and list(tmp_path.iterdir()) == [place]


def test_link_stays_a_link_and_a_device_a_device(tmp_path: Path) -> None:
    link, place = tmp_path / "link", tmp_path / "deeper" / "file"
    link.symlink_to(place)
    write_whole(link, "text")
    assert link.is_symlink() and place.read_text() == "text"
    write_whole(Path(os.devnull), "text")
    assert Path(os.devnull).is_char_device()


@pytest.mark.parametrize("name", ["a" * 250, "no\0name", "file/below", "."])
def test_place_that_cannot_be_written_is_named(tmp_path: Path, name: str) -> None:
    (tmp_path / "file").touch()
    if name.startswith("a"):
        write_whole(tmp_path / name, "the longest name has room")
        return
    with pytest.raises(InputError, match="cannot be written: "):
        write_whole(tmp_path / name, "text")
