"""A recording that ended before its first step: every command says so, and none finds two empty runs equal."""

from __future__ import annotations

from pathlib import Path

import pytest

from aftdeck.recording.reader import Recording
from aftdeck.recording.writer import Recorder
from aftdeck.station.playback.verdict import verdict
from tests.commands import Run
from tests.recording.flown import bay

COMMANDS = [
    ("replay", "{}"),
    ("replay", "{}", "--json"),
    ("replay", "{}", "--set", "rate=vernier"),
    ("replay", "{}", "--set", "control_period=0.05", "--json"),
    ("replay", "{}", "--html", "{}.html"),
    ("report", "{}"),
    ("export", "{}", "--minari", "none-v0"),
    ("render", "{}", "--camera", "A", "-o", "{}.svg"),
]


@pytest.fixture(scope="module")
def path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Recording of which only the header and the footer were written."""
    path = tmp_path_factory.mktemp("none") / "none.mcap"
    Recorder(path, bay(), 0).close("stopped")
    assert not list(Recording(path).steps())
    return path


@pytest.mark.parametrize("command", COMMANDS)
def test_command_says_that_the_recording_has_no_step(
    run: Run, path: Path, monkeypatch: pytest.MonkeyPatch, command: tuple[str, ...]
) -> None:
    monkeypatch.chdir(path.parent)
    code, out, err = run(*(part.format(path) for part in command))
    assert (code, out) == (2, "")
    assert "before its first" in err


def test_page_shows_no_verdict_for_a_recording_without_a_step(path: Path) -> None:
    found = verdict(path)
    assert found.state == "impossible" and "ends before its first step" in found.text
