"""``aftdeck run --out``, ``aftdeck replay`` and ``aftdeck recordings``: exit codes and sentences."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import msgspec
import platformdirs
import pytest

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
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A short run's recording, in many chunks."""
    folder = tmp_path_factory.mktemp("made")
    (folder / "short.toml").write_text(SCENARIO)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("aftdeck.recording.writer.FLUSH_S", 0.0)  # a chunk for each step
        record(folder / "short.toml", folder / "run.mcap")
    return folder / "run.mcap"


@pytest.fixture
def wrong(made: Path, tmp_path: Path) -> Path:
    """A recording in which a frame was changed."""
    first = next(m for m in messages(made) if isinstance(m, FrameRecord))
    other = msgspec.structs.replace(first, rate="vernier", sha256="0" * 16)
    rewritten(made, tmp_path / "wrong.mcap", {"/frames": encode(other)})
    return tmp_path / "wrong.mcap"


@pytest.fixture
def cut(made: Path, tmp_path: Path) -> Path:
    data = made.read_bytes()
    (tmp_path / "cut.mcap").write_bytes(data[: [at for at, kind, _ in chunks(data) if kind == 6][-1] + 5])
    return tmp_path / "cut.mcap"


def test_a_run_is_recorded_listed_and_verified(run: Run, tmp_path: Path) -> None:
    (tmp_path / "short.toml").write_text(SCENARIO)
    out = tmp_path / "run.mcap"
    summary = run.json("run", str(tmp_path / "short.toml"), "--out", str(out), "--seed", "3")
    code, said, err = run("replay", str(out))
    assert (code, err) == (0, "")
    assert "'short' (short), seed 3" in said
    assert f"equal        all {round(summary['time_s'] / 0.02)} frames" in said and "bit for bit" in said
    code, said, err = run("recordings", "--json")
    (entry,) = json.loads(said)
    assert (code, entry["path"], entry["seed"], entry["ended"]) == (0, str(out), 3, "completed")


def test_run_says_where_it_cannot_record_and_does_not_fly(run: Run, made: Path, tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    code, out, err = run("run", "uncradle", "--out", str(tmp_path / "file" / "run.mcap"))
    assert (code, out) == (2, "")
    assert "run.mcap: cannot be written" in err
    code, out, err = run("run", "uncradle", "--out", str(made))
    assert (code, out) == (2, "") and "exists already, and no recording is written over" in err


def test_verify_is_what_replay_does_when_nothing_else_is_asked(run: Run, made: Path) -> None:
    assert run("replay", str(made)) == run("replay", str(made), "--verify")
    verdict = run.json("replay", str(made))
    assert verdict["equal"] is True and verdict["different"] == 0


def test_frames_that_differ_end_with_exit_code_1(run: Run, wrong: Path) -> None:
    code, out, err = run("replay", str(wrong))
    assert (code, err) == (1, "")
    assert "DIFFERENT    1 of" in out and 'rate: "vernier" -> "coarse"' in out and "at 0.02 s (step 1)" in out
    code, out, _ = run("replay", str(wrong), "--json")
    assert code == 1 and json.loads(out)["first"]["tick"] == 1


def test_a_cut_recording_is_verified_as_far_as_it_goes_with_exit_code_0(run: Run, cut: Path) -> None:
    assert list(Recording(cut).messages())
    code, out, err = run("replay", str(cut))
    assert (code, err) == (0, "")
    assert "cut short    after" in out and "bit for bit" in out


def test_a_recording_of_another_version_says_so_and_is_tried(run: Run, made: Path, tmp_path: Path) -> None:
    start = msgspec.structs.replace(Recording(made).opening, version="0.0.1")
    rewritten(made, tmp_path / "old.mcap", {"/opening": msgspec.json.encode(start)})
    code, out, _ = run("replay", str(tmp_path / "old.mcap"))
    assert code == 0 and "made by      Aftdeck 0.0.1; this is" in out


@pytest.mark.parametrize("options", [(), ("--verify",), ("--set", "rate=vernier")])
@pytest.mark.parametrize(
    ("how", "text"),
    [
        ("missing", "cannot be read: No such file"),
        ("folder", "is a folder, no recording"),
        ("empty", "nothing in it to read"),
        ("foreign", "is no MCAP file"),
        ("damaged", "is damaged after"),
    ],
)
def test_what_is_no_recording_ends_with_a_sentence_and_exit_code_2(
    run: Run, made: Path, tmp_path: Path, options: tuple[str, ...], how: str, text: str
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
            data = bytearray(made.read_bytes())
            data[data.index(b"zstd") + 40] ^= 1
            path.write_bytes(data)
    code, out, err = run("replay", str(path), *options)
    assert (code, out) == (2, "")
    assert err.startswith(f"aftdeck: {path}: ") and text in err and err.count("\n") == 1


def test_a_change_is_flown_reported_and_recorded(run: Run, made: Path, tmp_path: Path) -> None:
    out = tmp_path / "changed.mcap"
    code, said, err = run("replay", str(made), "--set", "phase[0].rate=vernier", "--out", str(out))
    assert (code, err) == (0, "")
    assert "with phase[0].rate=vernier" in said and "first        at" in said and f"recorded   {out}" in said
    code, said, _ = run("replay", str(out))
    assert code == 0 and "changed      phase[0].rate=vernier" in said


def test_a_change_that_changes_nothing_says_so(run: Run, made: Path) -> None:
    code, out, _ = run("replay", str(made), "--set", "strict=false")
    assert code == 0 and "no difference in" in out


def test_several_changes_come_as_json(run: Run, made: Path) -> None:
    outcome = run.json("replay", str(made), "--set", "phase[0].rate=vernier", "--set", "phase[0].duration=2 s")
    assert outcome["changes"] == ["phase[0].rate=vernier", "phase[0].duration=2 s"]
    assert outcome["time_after_s"] > outcome["time_before_s"]


@pytest.mark.parametrize(
    ("options", "text"),
    [
        (("--verify", "--set", "rate=vernier"), "are given one at a time"),
        (("--verify", "--open"), "are given one at a time"),
        (("--out", "x.mcap"), "--out goes with --set"),
        (("--set", "rate"), "a change is KEY=VALUE"),
        (("--set", "rate=fast"), "expected one of coarse, vernier, got 'fast'"),
        (("--set", "phase[3].rate=coarse"), "there is no item 3"),
        (("--set", "arm=gone.toml"), "gone.toml: cannot be read"),
        (("--set", "command_delay=0.25"), "is a whole number of control periods: 0.25 s is 12.5 of 0.02 s"),
    ],
)
def test_wrong_options_end_with_a_sentence_and_exit_code_2(
    run: Run, made: Path, options: tuple[str, ...], text: str
) -> None:
    code, out, err = run("replay", str(made), *options)
    assert (code, out) == (2, "")
    assert err.startswith("aftdeck: ") and text in err


# --- who took part ----------------------------------------------------------------------------------------


@pytest.fixture
def trials(run: Run, made: Path, tmp_path: Path) -> list[Path]:
    """A run of P07, one of P08, and one of nobody, in the list; the same inputs and frames in all."""
    listing.Index().begin(made, Recording(made).opening)
    paths = [made]
    for code in ("P07", "P08"):
        paths.append(tmp_path / f"{code}.mcap")
        record(made.with_name("short.toml"), paths[-1], index=listing.Index(), trial=Trial(code, "delay 2 s"))
    return paths


def test_a_recording_says_who_took_part_and_repeats_itself_as_without(run: Run, trials: list[Path]) -> None:
    nobodys, one, _ = trials
    code, out, err = run("replay", str(one))
    assert (code, err) == (0, "") and "equal " in out
    assert "  participant  P07\n  condition    delay 2 s\n" in out
    out = run("replay", str(nobodys))[1]
    assert "participant" not in out and "condition" not in out
    first, second = (list(Recording(path).messages())[-1] for path in (nobodys, one))
    assert isinstance(first, Closing) and isinstance(second, Closing)
    assert first.frames_sha256 == second.frames_sha256


def test_the_list_has_a_row_with_participant_and_condition_for_each_run(run: Run, trials: list[Path]) -> None:
    rows = {Path(row["path"]): row for row in json.loads(run("recordings", "--json")[1])}
    told = [tuple(rows[path][name] for name in ("participant", "condition", "changes")) for path in trials]
    assert told == [("", "", ""), ("P07", "delay 2 s", ""), ("P08", "delay 2 s", "")]
    (only,) = json.loads(run("recordings", "--participant", "P08", "--json")[1])
    assert Path(only["path"]) == trials[2]
    out = run("recordings", "--participant", "P07")[1]
    assert "  participant  P07\n  condition    delay 2 s\n" in out and "P08" not in out


def test_a_recording_from_before_there_were_participants_is_read_as_nobodys(
    run: Run, made: Path, tmp_path: Path
) -> None:
    opening = msgspec.to_builtins(Recording(made).opening)
    del opening["participant"], opening["condition"]
    old = tmp_path / "old.mcap"
    rewritten(made, old, {"/opening": msgspec.json.encode(opening)})
    code, out, err = run("replay", str(old))
    assert (code, err) == (0, "") and "equal " in out and "participant" not in out


def test_a_run_that_was_changed_afterwards_is_told_from_the_trial(run: Run, trials: list[Path], tmp_path: Path) -> None:
    out = tmp_path / "changed.mcap"
    assert run("replay", str(trials[1]), "--set", "phase[0].rate=vernier", "--out", str(out))[0] == 0
    rows = json.loads(run("recordings", "--participant", "P07", "--json")[1])
    assert {Path(row["path"]): row["changes"] for row in rows} == {trials[1]: "", out: "phase[0].rate=vernier"}


@pytest.mark.parametrize(
    ("options", "text"),
    [
        (("--participant", "P07"), "--participant goes with --record DIR"),
        (("--condition", "A"), "--condition goes with --record DIR"),
        (("--record", "DIR", "--participant", ""), "a participant's code needs at least one letter or digit"),
        (("--record", "DIR", "--participant", " P07"), "begins and ends without a space, got ' P07'"),
        (("--record", "DIR", "--participant", "P" * 41), "a participant's code has 40 characters at most, got 41"),
        (("--record", "DIR", "--condition", "c" * 121), "a condition has 120 characters at most, got 121"),
        (("--record", "DIR", "--condition", "two\nlines"), "a condition stands on one line"),
        (("--record", "DIR", "--condition", "a \x1b[31m colour"), "a condition stands on one line"),
        (("--record", "DIR", "--condition", "\u202eback"), "a condition stands on one line"),
    ],
)
def test_a_trial_that_cannot_be_recorded_is_refused_before_anything_flies(
    run: Run, monkeypatch: pytest.MonkeyPatch, tmp_path: Path, options: tuple[str, ...], text: str
) -> None:
    monkeypatch.chdir(tmp_path)
    code, out, err = run("fly", "--no-browser", "--port", "0", *options)
    assert (code, out) == (2, "") and err.startswith("aftdeck: ") and text in err
    assert err.count("\n") == 1 and not (tmp_path / "DIR").exists()


# --- the list ---------------------------------------------------------------------------------------------


@pytest.fixture
def kept(run: Run, made: Path, tmp_path: Path) -> tuple[Path, Path]:
    """Two recordings in the list."""
    one, two = tmp_path / "one.mcap", tmp_path / "two.mcap"
    for path in (one, two):
        shutil.copyfile(made, path)
        listing.Index().begin(path, Recording(path).opening)
        listing.Index().end(path, "completed", 1.0)
    return one, two


def test_no_recordings_are_told_as_such(run: Run) -> None:
    code, out, err = run("recordings")
    assert (code, err) == (0, "") and "no such recordings; `aftdeck fly --record DIR`" in out
    assert run("recordings", "--json") == (0, "[]\n", "")


def test_recordings_are_listed_and_filtered(run: Run, kept: tuple[Path, Path]) -> None:
    code, out, _ = run("recordings")
    assert code == 0 and {Path(line.strip()) for line in out.splitlines()[1::2]} == set(kept)
    assert all("short" in line and "completed" in line for line in out.splitlines()[::2])
    found = json.loads(run("recordings", "--json")[1])
    assert {Path(e["path"]) for e in found} == set(kept)
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
        (("--ended", "crashed"), "--ended is one of completed, time, fault, "),
        (("--since", "yesterday"), "--since is a date or its beginning, such as "),
        (("--since", "2026-1"), "--since is a date"),
        (("--forget", "--delete"), "one at a time"),
    ],
)
def test_wrong_filters_are_refused_and_nothing_is_touched(
    run: Run, kept: tuple[Path, Path], options: tuple[str, ...], text: str
) -> None:
    code, out, err = run("recordings", "--delete", "--yes", *options)
    assert (code, out) == (2, "") and text in err
    assert all(path.exists() for path in kept)


def test_a_file_that_is_gone_is_forgotten(run: Run, kept: tuple[Path, Path]) -> None:
    kept[0].unlink()
    code, _, err = run("recordings", "--gone", "--forget")
    assert code == 0 and "1 taken off the list; no file was touched" in err
    assert len(json.loads(run("recordings", "--json")[1])) == 1 and kept[1].exists()


def test_recordings_are_deleted_when_that_is_confirmed(run: Run, kept: tuple[Path, Path]) -> None:
    code, _, err = run("recordings", "--scenario", "short", "--delete", "--yes")
    assert code == 0 and "2 recordings, " in err and "deleted" in err
    assert not any(path.exists() for path in kept)
    assert run("recordings", "--json")[1] == "[]\n"


def test_a_list_that_cannot_be_read_ends_with_exit_code_2_and_a_run_goes_on(run: Run, tmp_path: Path) -> None:
    (tmp_path / "data").mkdir()
    (tmp_path / "data" / "recordings.sqlite").write_bytes(b"garbage " * 200)
    code, out, err = run("recordings")
    assert (code, out) == (2, "") and "the list of recordings cannot be used" in err
    (tmp_path / "short.toml").write_text(SCENARIO)
    code, out, err = run("run", str(tmp_path / "short.toml"), "--out", str(tmp_path / "run.mcap"))
    assert code == 0 and "short: completed after" in out
    assert "the list of recordings cannot be used" in err and err.count("\n") == 1
    assert (tmp_path / "run.mcap").exists()
