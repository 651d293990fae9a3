"""Commands ``run --out``, ``replay`` and ``recordings``: exit codes and output."""

from __future__ import annotations

import json
import re
import shutil
from pathlib import Path

import msgspec
import platformdirs
import pytest

from aftdeck.errors import RecordingError
from aftdeck.recording import index as listing
from aftdeck.recording.codec import encode
from aftdeck.recording.reader import Recording
from aftdeck.recording.records import Closing, FrameRecord
from aftdeck.recording.run import record
from aftdeck.recording.trial import Trial
from tests.commands import Run
from tests.recording.flown import chunks, messages, rewritten

SCENARIO = """title = "short"
duration = "30 s"

[initial]
joints = ["-31 deg", "79 deg", "-103 deg", "-77 deg", "17 deg", "-128 deg"]

[[phase]]
name = "forward"
mode = "ORB UNL"
translation = [0.6, 0, 0.2]
duration = "1 s"
"""


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Run:
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))
    monkeypatch.setattr(platformdirs, "user_data_dir", lambda *_, **__: str(tmp_path / "data"))
    monkeypatch.setattr(listing, "FRESH_S", -1.0)
    return Run(capsys, monkeypatch)


@pytest.fixture(scope="module")
def recording(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Recording of a short run, in many chunks."""
    folder = tmp_path_factory.mktemp("recording")
    (folder / "short.toml").write_text(SCENARIO)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("aftdeck.recording.writer.FLUSH_S", 0.0)  # a chunk for each step
        record(folder / "short.toml", folder / "run.mcap")
    return folder / "run.mcap"


@pytest.fixture
def wrong(recording: Path, tmp_path: Path) -> Path:
    """Recording with one changed frame."""
    first = next(m for m in messages(recording) if isinstance(m, FrameRecord))
    other = msgspec.structs.replace(first, rate="vernier", sha256="0" * 16)
    rewritten(recording, tmp_path / "wrong.mcap", {"/frames": encode(other)})
    return tmp_path / "wrong.mcap"


@pytest.fixture
def cut(recording: Path, tmp_path: Path) -> Path:
    data = recording.read_bytes()
    (tmp_path / "cut.mcap").write_bytes(data[: [at for at, kind, _ in chunks(data) if kind == 6][-1] + 5])
    return tmp_path / "cut.mcap"


def test_run_is_recorded_listed_and_verified(run: Run, tmp_path: Path) -> None:
    (tmp_path / "short.toml").write_text(SCENARIO)
    out = tmp_path / "run.mcap"
    summary = run.json("run", str(tmp_path / "short.toml"), "--out", str(out), "--seed", "3")
    verdict = run.json("replay", str(out))
    assert verdict["equal"] and verdict["frames"] == round(summary["time_s"] / 0.02)
    code, text, err = run("replay", str(out))
    assert (code, err) == (0, "")
    assert "'short' (short), seed 3" in text and f" {verdict['frames']} frames" in text
    code, text, err = run("recordings", "--json")
    (entry,) = json.loads(text)
    assert (code, entry["path"], entry["seed"], entry["ended"]) == (0, str(out), 3, "completed")


def test_run_into_an_unusable_file_exits_with_2_before_running(run: Run, recording: Path, tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    code, out, err = run("run", "uncradle", "--out", str(tmp_path / "file" / "run.mcap"))
    assert (code, out) == (2, "")
    assert str(tmp_path / "file" / "run.mcap") in err
    code, out, err = run("run", "uncradle", "--out", str(recording))
    assert (code, out) == (2, "") and str(recording) in err


def test_replay_verifies_by_default(run: Run, recording: Path) -> None:
    assert run("replay", str(recording)) == run("replay", str(recording), "--verify")
    verdict = run.json("replay", str(recording))
    assert verdict["equal"] is True and verdict["different"] == 0


def test_different_frame_exits_with_1(run: Run, wrong: Path) -> None:
    code, out, err = run("replay", str(wrong))
    assert (code, err) == (1, "")
    assert " 1 of " in out and 'rate: "vernier" -> "coarse"' in out and "0.02 s (step 1)" in out
    code, out, _ = run("replay", str(wrong), "--json")
    assert code == 1 and json.loads(out)["first"]["tick"] == 1


def test_recording_cut_short_is_verified_and_exits_with_0(run: Run, cut: Path) -> None:
    assert list(Recording(cut).messages())
    code, out, err = run("replay", str(cut))
    assert (code, err) == (0, "")
    assert "cut short" in out
    verdict = run.json("replay", str(cut))
    assert verdict["equal"] and verdict["cut"]


def test_recording_of_another_version_is_verified_with_a_remark(run: Run, recording: Path, tmp_path: Path) -> None:
    start = msgspec.structs.replace(Recording(recording).opening, version="0.0.1")
    rewritten(recording, tmp_path / "old.mcap", {"/opening": msgspec.json.encode(start)}, rechained=True)
    code, out, _ = run("replay", str(tmp_path / "old.mcap"))
    assert code == 0 and "Aftdeck 0.0.1" in out


@pytest.mark.parametrize("options", [(), ("--verify",), ("--set", "rate=vernier")])
@pytest.mark.parametrize(
    ("how", "fault"),
    [
        ("missing", "unreadable"),
        ("folder", "unreadable"),
        ("empty", "empty"),
        ("foreign", "foreign"),
        ("damaged", "damaged"),
    ],
)
def test_invalid_recording_exits_with_2_and_the_error(
    run: Run, recording: Path, tmp_path: Path, options: tuple[str, ...], how: str, fault: str
) -> None:
    path = tmp_path / "x.mcap"
    match how:
        case "folder":
            path.mkdir()
        case "empty":
            path.touch()
        case "foreign":
            path.write_text(SCENARIO)
        case "damaged":
            data = bytearray(recording.read_bytes())
            data[data.index(b"zstd") + 40] ^= 1
            path.write_bytes(data)
    with pytest.raises(RecordingError) as caught:
        list(Recording(path).messages())
    assert caught.value.fault == fault
    code, out, err = run("replay", str(path), *options)
    assert (code, out, err) == (2, "", f"aftdeck: {caught.value}\n") and str(path) in err


def test_rerun_with_a_change_is_reported_and_recorded(run: Run, recording: Path, tmp_path: Path) -> None:
    out = tmp_path / "changed.mcap"
    code, text, err = run("replay", str(recording), "--set", "phase[0].rate=vernier", "--out", str(out))
    assert (code, err) == (0, "")
    assert "phase[0].rate=vernier" in text and re.search(r"first +at \d", text) and str(out) in text
    code, text, _ = run("replay", str(out))
    assert code == 0 and "phase[0].rate=vernier" in text


def test_rerun_without_a_difference_is_reported(run: Run, recording: Path) -> None:
    outcome = run.json("replay", str(recording), "--set", "strict=false")
    assert outcome["first"] is None and outcome["events"] == []
    code, out, _ = run("replay", str(recording), "--set", "strict=false")
    assert code == 0 and f" {outcome['compared']} frames" in out


def test_rerun_with_several_changes_as_json(run: Run, recording: Path) -> None:
    outcome = run.json("replay", str(recording), "--set", "phase[0].rate=vernier", "--set", "phase[0].duration=2 s")
    assert outcome["changes"] == ["phase[0].rate=vernier", "phase[0].duration=2 s"]
    assert outcome["time_after_s"] > outcome["time_before_s"]


@pytest.mark.parametrize(
    ("options", "text"),
    [
        (("--verify", "--set", "rate=vernier"), "--verify"),
        (("--verify", "--open"), "--open"),
        (("--out", "x.mcap"), "--set"),
        (("--set", "rate"), "KEY=VALUE"),
        (("--set", "rate=fast"), "got 'fast'"),
        (("--set", "phase[3].rate=coarse"), "item 3"),
        (("--set", "arm=gone.toml"), "gone.toml: "),
        (("--set", "command_delay=0.25"), "12.5 of 0.02 s"),
    ],
)
def test_invalid_options_exit_with_2_and_name_the_error(
    run: Run, recording: Path, options: tuple[str, ...], text: str
) -> None:
    code, out, err = run("replay", str(recording), *options)
    assert (code, out) == (2, "")
    assert err.startswith("aftdeck: ") and text in err


# --- participants ----------------------------------------------------------------------------------------


@pytest.fixture
def trials(run: Run, recording: Path, tmp_path: Path) -> list[Path]:
    """List of three equal runs: without a participant, with participant P07, with participant P08."""
    listing.Index().begin(recording, Recording(recording).opening)
    paths = [recording]
    for code in ("P07", "P08"):
        paths.append(tmp_path / f"{code}.mcap")
        record(recording.with_name("short.toml"), paths[-1], index=listing.Index(), trial=Trial(code, "delay 2 s"))
    return paths


def test_participant_is_printed_and_does_not_change_the_run(run: Run, trials: list[Path]) -> None:
    unnamed, named, _ = trials
    code, out, err = run("replay", str(named))
    assert (code, err) == (0, "") and "equal " in out
    assert "  participant  P07\n  condition    delay 2 s\n" in out
    out = run("replay", str(unnamed))[1]
    assert "participant" not in out and "condition" not in out
    first, second = (list(Recording(path).messages())[-1] for path in (unnamed, named))
    assert isinstance(first, Closing) and isinstance(second, Closing)
    assert first.frames_sha256 == second.frames_sha256


def test_list_has_participant_and_condition_of_each_run(run: Run, trials: list[Path]) -> None:
    rows = {Path(row["path"]): row for row in json.loads(run("recordings", "--json")[1])}
    texts = [tuple(rows[path][name] for name in ("participant", "condition", "changes")) for path in trials]
    assert texts == [("", "", ""), ("P07", "delay 2 s", ""), ("P08", "delay 2 s", "")]
    (only,) = json.loads(run("recordings", "--participant", "P08", "--json")[1])
    assert Path(only["path"]) == trials[2]
    out = run("recordings", "--participant", "P07")[1]
    assert "  participant  P07\n  condition    delay 2 s\n" in out and "P08" not in out


def test_recording_without_participant_field_is_read(run: Run, recording: Path, tmp_path: Path) -> None:
    opening = msgspec.to_builtins(Recording(recording).opening)
    del opening["participant"], opening["condition"]
    old = tmp_path / "old.mcap"
    rewritten(recording, old, {"/opening": msgspec.json.encode(opening)}, rechained=True)
    code, out, err = run("replay", str(old))
    assert (code, err) == (0, "") and "equal " in out and "participant" not in out


def test_list_distinguishes_a_rerun_from_the_trial(run: Run, trials: list[Path], tmp_path: Path) -> None:
    out = tmp_path / "changed.mcap"
    assert run("replay", str(trials[1]), "--set", "phase[0].rate=vernier", "--out", str(out))[0] == 0
    rows = json.loads(run("recordings", "--participant", "P07", "--json")[1])
    assert {Path(row["path"]): row["changes"] for row in rows} == {trials[1]: "", out: "phase[0].rate=vernier"}


@pytest.mark.parametrize(
    ("options", "text"),
    [
        (("--participant", "P07"), "--participant requires --record"),
        (("--condition", "A"), "--condition requires --record"),
        (("--record", "DIR", "--participant", ""), "got ''"),
        (("--record", "DIR", "--participant", " P07"), "got ' P07'"),
        (("--record", "DIR", "--participant", "P" * 41), "40 characters at most, got 41"),
        (("--record", "DIR", "--condition", "c" * 121), "120 characters at most, got 121"),
        (("--record", "DIR", "--condition", "two\nlines"), "got 'two\\nlines'"),
        (("--record", "DIR", "--condition", "a \x1b[31m colour"), "got 'a \\x1b[31m colour'"),
        (("--record", "DIR", "--condition", "\u202eback"), "got '\\u202eback'"),
    ],
)
def test_invalid_trial_is_rejected_before_the_run(
    run: Run, monkeypatch: pytest.MonkeyPatch, tmp_path: Path, options: tuple[str, ...], text: str
) -> None:
    monkeypatch.chdir(tmp_path)
    code, out, err = run("fly", "--no-browser", "--port", "0", *options)
    assert (code, out) == (2, "") and err.startswith("aftdeck: ") and text in err
    assert err.count("\n") == 1 and not (tmp_path / "DIR").exists()


# --- the list ---------------------------------------------------------------------------------------------


@pytest.fixture
def listed(run: Run, recording: Path, tmp_path: Path) -> tuple[Path, Path]:
    """Two recordings in the list."""
    one, two = tmp_path / "one.mcap", tmp_path / "two.mcap"
    for path in (one, two):
        shutil.copyfile(recording, path)
        listing.Index().begin(path, Recording(path).opening)
        listing.Index().end(path, "completed", 1.0)
    return one, two


def test_empty_list_is_printed_with_a_hint(run: Run) -> None:
    code, out, err = run("recordings")
    assert (code, err) == (0, "") and "`aftdeck fly --record DIR`" in out
    assert run("recordings", "--json") == (0, "[]\n", "")


def test_recordings_are_listed_and_filtered(run: Run, listed: tuple[Path, Path]) -> None:
    code, out, _ = run("recordings")
    assert code == 0 and {Path(line.strip()) for line in out.splitlines()[1::2]} == set(listed)
    assert all("short" in line and "completed" in line for line in out.splitlines()[::2])
    found = json.loads(run("recordings", "--json")[1])
    assert {Path(e["path"]) for e in found} == set(listed)
    began = min(e["began"] for e in found)
    for options, count in (
        (("--scenario", "short"), 2),
        (("--scenario", "long"), 0),
        (("--ended", "completed"), 2),
        (("--ended", "cut"), 0),
        (("--since", began[:10]), 2),
        (("--since", began[:19].replace("T", " ")), 2),
        (("--since", "9999"), 0),
        (("--gone",), 0),
    ):
        assert len(json.loads(run("recordings", *options, "--json")[1])) == count, options


@pytest.mark.parametrize(
    ("options", "text"),
    [
        (("--ended", "crashed"), "completed, time, fault, "),
        (("--since", "yesterday"), "got 'yesterday'"),
        (("--since", "2026-1"), "got '2026-1'"),
        (("--forget", "--delete"), "--forget and --delete"),
    ],
)
def test_invalid_filters_are_rejected_and_files_kept(
    run: Run, listed: tuple[Path, Path], options: tuple[str, ...], text: str
) -> None:
    code, out, err = run("recordings", "--delete", "--yes", *options)
    assert (code, out) == (2, "") and text in err
    assert all(path.exists() for path in listed)


def test_missing_file_is_removed_from_the_list(run: Run, listed: tuple[Path, Path]) -> None:
    listed[0].unlink()
    code, _, err = run("recordings", "--gone", "--forget")
    assert code == 0 and err.startswith("1 ")
    assert len(json.loads(run("recordings", "--json")[1])) == 1 and listed[1].exists()


def test_confirmed_deletion_deletes_the_files(run: Run, listed: tuple[Path, Path]) -> None:
    code, _, err = run("recordings", "--scenario", "short", "--delete", "--yes")
    assert code == 0 and err.startswith("2 recordings, ")
    assert not any(path.exists() for path in listed)
    assert run("recordings", "--json")[1] == "[]\n"


def test_unreadable_list_exits_with_2_but_a_run_is_recorded(run: Run, tmp_path: Path) -> None:
    (tmp_path / "data").mkdir()
    (tmp_path / "data" / "recordings.sqlite").write_bytes(b"garbage " * 200)
    code, out, err = run("recordings")
    assert (code, out) == (2, "") and "recordings.sqlite" in err
    (tmp_path / "short.toml").write_text(SCENARIO)
    code, out, err = run("run", str(tmp_path / "short.toml"), "--out", str(tmp_path / "run.mcap"))
    assert code == 0 and "short: completed after" in out
    assert "recordings.sqlite" in err and err.count("\n") == 1
    assert (tmp_path / "run.mcap").exists()
