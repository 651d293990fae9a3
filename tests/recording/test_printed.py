"""Nothing that a file contains is printed raw: the output has no control characters and no marks of direction."""

from __future__ import annotations

import sys
from pathlib import Path

import hypothesis.strategies as st
import pytest
from hypothesis import HealthCheck, given, settings
from msgspec.structs import replace

import aftdeck
from aftdeck.cli import main
from aftdeck.lines import visible
from aftdeck.recording.codec import encode
from aftdeck.recording.index import Index
from aftdeck.recording.reader import Recording
from aftdeck.recording.records import FrameRecord, Opening
from aftdeck.recording.writer import Recorder
from aftdeck.simulation.frame import Event
from aftdeck.simulation.inputs import Inputs
from tests.recording.flown import bay, messages, rewritten

NASTY = "\x1b]0;owned\x07\x1b[2J\r\n  equal        all 9 frames\x9b31m\u202egnp\u2066\u200f\x00\x7f\u2028[red]x[/red]"
"""Text with escape codes, line breaks, marks of direction, and markup."""


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("printed") / "whole.mcap"
    made = bay()
    sim = aftdeck.Simulation(made)
    recorder = Recorder(path, made, sim.seed)
    for k in range(3):
        inputs = Inputs(mode="END EFF" if k == 0 else None)
        recorder.step(inputs, sim.step(inputs))
    recorder.close("stopped")
    return path


@pytest.fixture(autouse=True)
def _own_list(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("platformdirs.user_data_dir", lambda *_, **__: str(tmp_path / "data"))


def output(capsys: pytest.CaptureFixture[str], *arguments: str) -> str:
    """Run the command line, and return what it prints on both streams."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(sys, "argv", ["aftdeck", *arguments])
        with pytest.raises(SystemExit):
            main()
    out, err = capsys.readouterr()
    return out + err


def check_plain(text: str) -> None:
    assert text
    assert [c for c in text if not c.isprintable() and c != "\n"] == []


@settings(max_examples=200, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.text())
def test_any_text_becomes_one_visible_line(text: str) -> None:
    shown = visible(text)
    assert shown.isprintable() and visible(shown) == shown
    assert text.isprintable() == (shown == text)


TEXTS = (
    "scenario",
    "title",
    "participant",
    "condition",
    "began",
    "version",
    "machine",
    "laws",
    "scenario_text",
    "arm_text",
)


@pytest.mark.slow
@pytest.mark.parametrize("field", TEXTS)
@settings(max_examples=3, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(extra=st.text(max_size=20))
def test_replay_prints_no_raw_text_of_the_header(
    whole: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], field: str, extra: str
) -> None:
    start = Recording(whole).opening
    assert isinstance(start, Opening)
    (tmp_path / "nasty.mcap").unlink(missing_ok=True)
    changed = replace(start, **{field: NASTY + extra.encode(errors="ignore").decode()})
    rewritten(whole, tmp_path / "nasty.mcap", {"/opening": encode(changed)})
    for options in ((), ("--set", "seed=3"), ("--json",)):
        text = output(capsys, "replay", str(tmp_path / "nasty.mcap"), *options)
        check_plain(text)
        assert "\n  equal " not in text, "a text of the file looks like a line of the verdict"


def test_replay_prints_no_raw_text_of_frames_and_environment(
    whole: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    start = Recording(whole).opening
    first = next(m for m in messages(whole) if isinstance(m, FrameRecord))
    frame = replace(first, phase=NASTY, events=(Event(0.02, NASTY, "info", NASTY),))
    assert start.environment is not None
    header = replace(start, environment=replace(start.environment, target=NASTY, features=(NASTY,)), laws=NASTY)
    changes = {"/frames": encode(frame), "/opening": encode(header)}
    rewritten(whole, tmp_path / "nasty.mcap", changes, rechained=True)
    for options in ((), ("--set", "seed=3"), ("--json",)):
        check_plain(output(capsys, "replay", str(tmp_path / "nasty.mcap"), *options))


def test_list_prints_no_raw_text(whole: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    start = replace(Recording(whole).opening, scenario=NASTY, participant=NASTY, condition=NASTY, changes=(NASTY,))
    (tmp_path / "data").mkdir()
    Index().begin(tmp_path / "a\x1b[31m.mcap", start)
    for options in ((), ("--json",)):
        check_plain(output(capsys, "recordings", *options))


@pytest.mark.parametrize(
    "text", [f"{NASTY}", 'title = "\\u001b[2J\\u202e"\nrate = "\\u001b]0;x\\u0007"', 'arm = "\\u001b[2J.toml"']
)
def test_check_prints_no_raw_text(tmp_path: Path, capsys: pytest.CaptureFixture[str], text: str) -> None:
    (tmp_path / "nasty\x1b[31m.toml").write_text(text)
    for command in ("check", "run"):
        check_plain(output(capsys, command, str(tmp_path / "nasty\x1b[31m.toml")))
