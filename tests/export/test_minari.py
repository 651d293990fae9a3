"""Minari datasets: written by Minari, loaded by Minari alone in another process."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from aftdeck.export.about import read_episode
from aftdeck.export.flight import read_flight
from aftdeck.export.minari import FOLDER
from aftdeck.export.plan import plan
from aftdeck.export.replay import replays
from aftdeck.export.samples import samples
from aftdeck.export.written import numbers_of
from tests.commands import Run
from tests.export.runs import STEPS, by_hand, by_script_then_hand

LOAD = """
import json, sys
import minari, numpy
data = minari.load_dataset("set-v0")
assert "aftdeck" not in sys.modules
out = []
for n, episode in enumerate(data):
    numpy.save(f"{sys.argv[1]}/{n}.npy", episode.infos["inputs"][1:])
    numpy.save(f"{sys.argv[1]}/action-{n}.npy", episode.actions)
    numpy.save(f"{sys.argv[1]}/state-{n}.npy", episode.observations["state"])
    out.append({
        "state": episode.observations["state"].shape,
        "pictures": {name: one.shape for name, one in episode.observations["pictures"].items()},
        "ends": [bool(episode.terminations[-1]), bool(episode.truncations[-1])],
        "spaces": data.observation_space["state"].shape == episode.observations["state"].shape[1:]
        and data.action_space.contains(episode.actions[0]),
    })
print(json.dumps(out))
"""


def test_dataset_loads_by_minari_alone_and_its_inputs_give_the_recorded_flights(tmp_path: Path, run: Run) -> None:
    pytest.importorskip("minari")
    files = [str(by_hand(tmp_path / "hand.mcap")), str(by_script_then_hand(tmp_path / "script.mcap"))]
    folder = tmp_path / "set-v0"
    found = run.json(
        "export", *files, "--minari", str(folder), "--camera", "WR", "--size", "32x24", "--task", "reach the payload"
    )
    assert [episode["inputs_equal"] for episode in found["episodes"]] == [True, True]
    here = os.environ | {"MINARI_DATASETS_PATH": str(tmp_path), "PYTHONPATH": ""}
    loaded = subprocess.run(
        [sys.executable, "-c", LOAD, str(tmp_path)],
        env=here,
        cwd=tmp_path,
        capture_output=True,
        check=True,
        timeout=300,
    )
    count = -(-STEPS // 5)
    flights = [read_flight(Path(file)) for file in files]
    planned = plan(flights)
    episodes = json.loads(loaded.stdout)
    assert len(episodes) == len(flights)
    for number, (episode, flight) in enumerate(zip(episodes, flights, strict=True)):
        seen = [sample.seen.state for sample in samples(flight, 5, None)]
        assert (np.load(tmp_path / f"state-{number}.npy")[:-1] == seen).all()
        actions = numbers_of(flight, planned).action.astype(np.float32)
        assert (np.load(tmp_path / f"action-{number}.npy") == actions).all()
        assert episode["state"][0] == count + 1
        assert episode["pictures"] == {"wr": [count + 1, 24, 32, 3]}
        assert episode["ends"] == [False, True]
        assert episode["spaces"]
        inputs = np.load(tmp_path / f"{number}.npy")
        assert replays(folder / FOLDER, number, inputs.reshape(count, -1))
        about, _ = read_episode(folder / FOLDER, number)
        assert about.task == "reach the payload"
        assert np.load(tmp_path / f"action-{number}.npy").shape == (count, len(found["plan"]["action"]))
