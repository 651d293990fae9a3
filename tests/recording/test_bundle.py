"""Header of a recording: a run can be re-simulated from it, even after the scenario's files are deleted."""

from __future__ import annotations

import re
from pathlib import Path

import msgspec
import pytest

import aftdeck
from aftdeck.errors import RecordingError
from aftdeck.recording.bundle import opening, scenario_of
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


def with_equal_servos(text: str) -> str:
    """Return an arm's file with equal servo rates."""
    return re.sub(r'\nservo = "[0-9.]+ deg/s"', '\nservo = "2.7 deg/s"', text)


def own_files(folder: Path, shapes: str = "looks.toml") -> Path:
    """Write a scenario with its own arm, shapes and worksite in several folders; return its path."""
    (folder / "arms" / "mine").mkdir(parents=True)
    arm = with_equal_servos((ARMS / "srms.toml").read_text()).replace(
        'shapes = "srms.shapes.toml"', f'shapes = "{shapes}"'
    )
    (folder / "arms" / "mine" / "arm.toml").write_text(arm)
    looks = folder / "arms" / "mine" / shapes
    looks.parent.mkdir(parents=True, exist_ok=True)
    looks.write_text((ARMS / "srms.shapes.toml").read_text())
    (folder / "site.toml").write_text("# mine\n" + (WORKSITES / "orbiter.toml").read_text())
    path = folder / "mine.toml"
    path.write_text(SCENARIO.format(arm="arms/mine/arm.toml", worksite="site.toml"))
    return path


def delete_files(folder: Path) -> None:
    for path in sorted(folder.rglob("*"), reverse=True):
        path.rmdir() if path.is_dir() else path.unlink()


@pytest.mark.parametrize("shapes", ["looks.toml", "../shapes/looks.toml", "below/looks.toml"])
def test_run_of_own_files_is_verified_after_they_are_deleted(
    tmp_path: Path, shapes: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder, path = tmp_path / "own", tmp_path / "run.mcap"
    made = aftdeck.load_scenario(own_files(folder, shapes))
    record(made, path)
    delete_files(folder)
    monkeypatch.chdir(tmp_path)
    assert verify(path).equal
    again = scenario_of(Recording(path).opening)
    assert again.arm.model.text == made.arm.model.text
    assert again.arm.model.shapes is not None and made.arm.model.shapes is not None
    assert again.arm.model.shapes.text == made.arm.model.shapes.text
    assert again.worksite.text.startswith("# mine\n")
    assert (again.name, again.text) == ("mine", made.text)


def test_rerun_with_an_own_arm_differs_and_verifies(tmp_path: Path) -> None:
    folder, path, out = tmp_path / "own", tmp_path / "run.mcap", tmp_path / "changed.mcap"
    own_files(folder)
    (tmp_path / "plain.toml").write_text(SCENARIO.format(arm="srms", worksite="orbiter"))
    record(tmp_path / "plain.toml", path)
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)  # a path is relative to the working folder
        outcome = rerun(path, ("arm=arms/mine/arm.toml", "worksite=site.toml"), out)
    assert outcome.first is not None and "rate_limits[0]" in {c.field for c in outcome.first.fields}
    delete_files(folder)
    assert verify(out).equal
    back = rerun(out, ("arm=srms",))
    assert back.frames_sha256 != outcome.frames_sha256
    assert back.frames_sha256 == rerun(path, ("rate=coarse",)).frames_sha256


def test_rerun_exchanges_concept_arm_and_shuttle_arm(tmp_path: Path) -> None:
    folder, path, out = tmp_path / "own", tmp_path / "run.mcap", tmp_path / "shuttle.mcap"
    folder.mkdir()
    text = (ARMS / "concept-1972.toml").read_text().replace('shapes = "concept-1972.shapes.toml"', "")
    (folder / "arm.toml").write_text("# mine\n" + text)
    (folder / "mine.toml").write_text(SCENARIO.format(arm="arm.toml", worksite="orbiter"))
    summary = record(folder / "mine.toml", path).summary
    delete_files(folder)
    assert verify(path).equal
    again = scenario_of(Recording(path).opening)
    assert again.arm.model.text.startswith("# mine\n") and again.arm.model.shapes is None
    assert rerun(path, ("arm=srms",), out).frames_sha256 != summary.frames_sha256
    assert verify(out).equal
    assert rerun(out, ("arm=concept-1972",)).frames_sha256 == summary.frames_sha256


@pytest.mark.parametrize("name", ["srms", "concept-1972"])
def test_recording_with_an_arm_file_of_0_2_has_the_frames_of_today_s_arm(tmp_path: Path, name: str) -> None:
    old = Path(__file__).parents[1] / "arms" / f"{name}-0.2.toml"
    (tmp_path / "arm.toml").write_text(old.read_text())
    (tmp_path / "srms.shapes.toml").write_text((ARMS / "srms.shapes.toml").read_text())  # it has the arm's cameras
    summaries = []
    for arm in (name, "arm.toml"):
        (tmp_path / "one.toml").write_text(SCENARIO.format(arm=arm, worksite="orbiter"))
        summaries.append(record(tmp_path / "one.toml", tmp_path / f"{arm}.mcap").summary)
    assert summaries[0].frames_sha256 == summaries[1].frames_sha256
    (tmp_path / "arm.toml").unlink()
    assert verify(tmp_path / "arm.toml.mcap").equal
    assert 'family = "' in Recording(tmp_path / "arm.toml.mcap").opening.arm_text


@pytest.mark.parametrize("name", ["../" * 20 + "etc/looks.toml", "/etc/looks.toml"])
def test_shapes_file_outside_the_recording_is_rejected(tmp_path: Path, name: str) -> None:
    start = opening(aftdeck.load_scenario("uncradle"), 0, 0)
    with pytest.raises(RecordingError, match=re.escape(repr(name))):
        scenario_of(msgspec.structs.replace(start, shapes_file=name))


def test_rebuilding_a_scenario_leaves_no_temporary_files(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    scenario_of(opening(aftdeck.load_scenario("uncradle"), 0, 0))
    assert list(tmp_path.iterdir()) == []
