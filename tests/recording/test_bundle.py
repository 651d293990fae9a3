"""A recording holds all that its run started from: it is flown again after every file of it is gone."""

from __future__ import annotations

from pathlib import Path

import hypothesis.strategies as st
import msgspec
import pytest
from hypothesis import given

import aftdeck
from aftdeck.errors import InputError, RecordingError
from aftdeck.recording.bundle import opening, parse_change, scenario_of
from aftdeck.recording.changed import rerun
from aftdeck.recording.reader import Recording
from aftdeck.recording.replay import verify
from aftdeck.recording.run import record

ARMS = Path(aftdeck.__file__).parent / "arms"
WORKSITES = Path(aftdeck.__file__).parent / "worksite"
SCENARIO = """title = "of my own"
arm = "{arm}"
worksite = "{worksite}"
duration = "30 s"

[initial]
joints = ["-31 deg", "79 deg", "-103 deg", "-77 deg", "17 deg", "-128 deg"]

[[phase]]
mode = "ORB UNL"
translation = [0.6, 0, -0.3]
duration = "2 s"
"""


def slower(text: str) -> str:
    """An arm's file whose servos are as quick as each other."""
    before, after = text.split("[rates.servo]\nvalue = ")
    return f"{before}[rates.servo]\nvalue = {['2.7 deg/s'] * 6}\n{after.partition(chr(10))[2]}"


def own_files(folder: Path, shapes: str = "looks.toml") -> Path:
    """A scenario with an arm, shapes and a worksite of its own, in folders of their own."""
    (folder / "arms" / "mine").mkdir(parents=True)
    arm = slower((ARMS / "srms.toml").read_text()).replace('shapes = "srms.shapes.toml"', f'shapes = "{shapes}"')
    (folder / "arms" / "mine" / "arm.toml").write_text(arm)
    looks = folder / "arms" / "mine" / shapes
    looks.parent.mkdir(parents=True, exist_ok=True)
    looks.write_text((ARMS / "srms.shapes.toml").read_text())
    (folder / "site.toml").write_text("# mine\n" + (WORKSITES / "orbiter.toml").read_text())
    path = folder / "mine.toml"
    path.write_text(SCENARIO.format(arm="arms/mine/arm.toml", worksite="site.toml"))
    return path


def emptied(folder: Path) -> None:
    for path in sorted(folder.rglob("*"), reverse=True):
        path.rmdir() if path.is_dir() else path.unlink()


@pytest.mark.parametrize("shapes", ["looks.toml", "../shapes/looks.toml", "below/looks.toml"])
def test_a_run_of_own_files_is_repeated_after_they_are_gone(
    tmp_path: Path, shapes: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder, path = tmp_path / "own", tmp_path / "run.mcap"
    made = aftdeck.load_scenario(own_files(folder, shapes))
    record(made, path)
    emptied(folder)
    monkeypatch.chdir(tmp_path)
    assert verify(path).equal
    again = scenario_of(Recording(path).opening)
    assert again.arm.model.text == made.arm.model.text
    assert again.arm.model.shapes is not None and made.arm.model.shapes is not None
    assert again.arm.model.shapes.text == made.arm.model.shapes.text
    assert again.worksite.text.startswith("# mine\n")
    assert (again.name, again.text) == ("mine", made.text)


def test_an_own_arm_flies_otherwise_and_its_recording_repeats_itself(tmp_path: Path) -> None:
    folder, path, out = tmp_path / "own", tmp_path / "run.mcap", tmp_path / "changed.mcap"
    own_files(folder)
    (tmp_path / "plain.toml").write_text(SCENARIO.format(arm="srms", worksite="orbiter"))
    record(tmp_path / "plain.toml", path)
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)  # a path is sought from where the person stands
        outcome = rerun(path, ("arm=arms/mine/arm.toml", "worksite=site.toml"), out)
    assert outcome.first is not None and "rate_limits" in {c.field for c in outcome.first.fields}
    emptied(folder)
    assert verify(out).equal
    back = rerun(out, ("arm=srms",))
    assert back.frames_sha256 != outcome.frames_sha256
    assert back.frames_sha256 == rerun(path, ("rate=coarse",)).frames_sha256


def test_the_concept_arm_is_recorded_whole_and_takes_over_a_run_of_the_shuttles(tmp_path: Path) -> None:
    folder, path, out = tmp_path / "own", tmp_path / "run.mcap", tmp_path / "shuttle.mcap"
    folder.mkdir()
    (folder / "arm.toml").write_text("# mine\n" + (ARMS / "concept-1972.toml").read_text())
    (folder / "mine.toml").write_text(SCENARIO.format(arm="arm.toml", worksite="orbiter"))
    summary = record(folder / "mine.toml", path).summary
    emptied(folder)
    assert verify(path).equal
    again = scenario_of(Recording(path).opening)
    assert again.arm.model.text.startswith("# mine\n") and again.arm.model.shapes is None
    assert rerun(path, ("arm=srms",), out).frames_sha256 != summary.frames_sha256
    assert verify(out).equal
    assert rerun(out, ("arm=concept-1972",)).frames_sha256 == summary.frames_sha256


@pytest.mark.parametrize("name", ["../" * 20 + "etc/looks.toml", "/etc/looks.toml"])
def test_a_recording_writes_nothing_outside_its_own_folder(tmp_path: Path, name: str) -> None:
    start = opening(aftdeck.load_scenario("uncradle"), 0, 0)
    with pytest.raises(RecordingError, match="a place outside the recording"):
        scenario_of(msgspec.structs.replace(start, shapes_file=name))


def test_nothing_is_left_of_the_files_that_a_scenario_was_made_of(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    scenario_of(opening(aftdeck.load_scenario("uncradle"), 0, 0))
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("text", "where", "value"),
    [
        ("rate=vernier", ("rate",), "vernier"),
        (" rate = vernier ", ("rate",), "vernier"),
        ("command_delay=0.5", ("command_delay",), 0.5),
        ("duration=10 min", ("duration",), "10 min"),
        ("duration='10 min'", ("duration",), "10 min"),
        ("seed=7", ("seed",), 7),
        ("strict=true", ("strict",), True),
        ("limits.por.translation=1 ft/s", ("limits", "por", "translation"), "1 ft/s"),
        ("phase[0].rate=coarse", ("phase", 0, "rate"), "coarse"),
        ("sequence[1].point[12].pause=false", ("sequence", 1, "point", 12, "pause"), False),
        ("initial.joints=[0, 1]", ("initial", "joints"), [0, 1]),
        ("title=a = b", ("title",), "a = b"),
        ("title=", ("title",), ""),
        ("title=x\ny = 3", ("title",), "x\ny = 3"),
        ("seed=1\ny = 3", ("seed",), "1\ny = 3"),
        ("title=# no", ("title",), "# no"),
    ],
)
def test_a_change_is_read_as_toml_where_it_is_toml(text: str, where: tuple[str | int, ...], value: object) -> None:
    assert parse_change(text) == (where, value)


@given(st.text())
def test_any_text_is_a_change_or_is_refused(text: str) -> None:
    try:
        where, _ = parse_change(text)
    except InputError as error:
        assert "a change is KEY=VALUE" in str(error)
    else:
        assert where and "=" in text
