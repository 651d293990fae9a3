"""No path in a recording is opened: every text that a recording needs is in the recording itself."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from msgspec.structs import replace

import aftdeck
from aftdeck.errors import RecordingError
from aftdeck.recording.codec import encode
from aftdeck.recording.reader import Recording
from aftdeck.recording.replay import verify
from aftdeck.recording.run import record
from tests.recording.flown import rewritten
from tests.recording.test_bundle import delete_files, own_files

_WATCHED = """
import json, sys
from pathlib import Path
opened = []
sys.addaudithook(lambda event, given: opened.append(str(given[0])) if event == "open" else None)
from aftdeck.errors import AftdeckError
from aftdeck.recording.changed import rerun
from aftdeck.recording.replay import verify
from aftdeck.station.playback.store import PlaybackStore
for path in map(Path, sys.argv[2:]):
    outcomes = []
    for action in (verify, lambda path: rerun(path, ("seed=5",)), PlaybackStore):
        try:
            action(path)
            outcomes.append("")
        except AftdeckError as error:
            outcomes.append(str(error))
    print(json.dumps([outcomes, [name for name in opened if sys.argv[1] in name and not name.endswith(".mcap")]]))
"""
CANARY = "canary-file"
"""Part of the path of every file that must not be opened."""


def watched(*paths: Path) -> list[tuple[list[str], list[str]]]:
    """Verify, re-run and play recordings in another process; return for each the errors, and the opened canaries."""
    done = subprocess.run(
        [sys.executable, "-c", _WATCHED, CANARY, *map(str, paths)],
        capture_output=True,
        text=True,
        check=True,
        timeout=300,
    )
    return [(errors, opened) for errors, opened in map(json.loads, done.stdout.splitlines())]


def recorded_with(folder: Path, shapes: str) -> tuple[Path, Path]:
    """Record a run of an arm whose shapes are in another folder; return the recording and the shapes file."""
    looks, path = folder / CANARY / "looks.toml", folder / "run.mcap"
    looks.parent.mkdir(parents=True)
    scenario = own_files(folder / "own")
    arm = folder / "own" / "arms" / "mine" / "arm.toml"
    (arm.parent / "looks.toml").rename(looks)
    os.symlink(looks, arm.parent / "linked.toml")
    arm.write_text(arm.read_text().replace('"looks.toml"', json.dumps(shapes.format(looks=looks))))
    record(replace_duration(scenario), path)
    return path, looks


@pytest.mark.slow
def test_shapes_of_any_path_are_recorded_and_replayed_without_the_file(tmp_path: Path) -> None:
    kinds = {"absolute": "{looks}", "upwards": f"../../../{CANARY}/looks.toml", "link": "linked.toml"}
    made = [recorded_with(tmp_path / kind, shapes) for kind, shapes in kinds.items()]
    text = made[0][1].read_text()
    for _, looks in made:
        looks.write_text("this is not the file that was recorded")
    for errors, opened in watched(*[path for path, _ in made]):
        assert errors == ["", "", ""] and opened == []
    for path, looks in made:
        delete_files(looks.parent)
        delete_files(path.parent / "own")
        assert verify(path).equal
        assert Recording(path).opening.shapes_text == text


def replace_duration(scenario: Path) -> aftdeck.Scenario:
    scenario.write_text(scenario.read_text().replace('"30 s"', '"0.2 s"'))
    return aftdeck.load_scenario(scenario)


@pytest.mark.slow
def test_paths_in_hostile_texts_are_not_opened(tmp_path: Path) -> None:
    canary, path = tmp_path / CANARY, tmp_path / "run.mcap"
    canary.mkdir()
    for name in ("arm.toml", "worksite.toml", "shapes.toml"):
        (canary / name).write_text("secret = 1")
    scenario = tmp_path / "plain.toml"
    scenario.write_text(
        'title = "t"\nduration = "0.1 s"\n[initial]\njoints = ["10 deg", "30 deg", "-60 deg", 0, 0, 0]\n'
    )
    record(scenario, path)
    start = Recording(path).opening
    hostile = replace(
        start,
        scenario_text=f'arm = "{canary}/arm.toml"\nworksite = "{canary}/worksite.toml"\n{start.scenario_text}',
        arm_text=start.arm_text.replace('"srms.shapes.toml"', f'"{canary}/shapes.toml"'),
        shapes_file=f"{canary}/shapes.toml",
        scenario=f"{canary}/scenario.toml",
        changes=(f"arm={canary}/arm.toml", f"worksite={canary}/worksite.toml"),
    )
    rewritten(path, tmp_path / "hostile.mcap", {"/opening": encode(hostile)}, rechained=True)
    without = replace(hostile, shapes_text="")
    rewritten(path, tmp_path / "without.mcap", {"/opening": encode(without)}, rechained=True)
    with pytest.raises(RecordingError, match="shapes"):
        verify(tmp_path / "without.mcap")
    for errors, opened in watched(tmp_path / "hostile.mcap", tmp_path / "without.mcap"):
        assert opened == [] and "secret" not in "".join(errors)
