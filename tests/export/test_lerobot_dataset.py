"""LeRobotDatasets: written through LeRobot, loaded by LeRobot alone in a process without Aftdeck.

LeRobot's own evaluation also runs in Aftdeck's environment. LeRobot and torch are several gigabytes:
`scripts/test-lerobot` installs them in an environment of their own, and runs this test in it.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

import numpy as np
import pytest

from aftdeck.export.flight import Flight, read_flight
from aftdeck.export.lerobot import FOLDER
from aftdeck.export.pictures import Painter
from aftdeck.export.plan import plan
from aftdeck.export.replay import replays
from aftdeck.export.samples import samples
from aftdeck.export.written import numbers_of
from aftdeck.scenario.load import load_scenario
from tests.export.runs import STEPS, busy
from tests.recording.flown import record_steps

pytestmark = [
    pytest.mark.slow,
    pytest.mark.long,
    pytest.mark.skipif(find_spec("lerobot") is None, reason="LeRobot is not installed; scripts/test-lerobot runs this"),
]

ROOT = Path(__file__).parents[2]
WAIT_S = 1800.0
CAMERAS, SIZE = ("ELB", "WR"), (64, 48)
LOAD = """
import importlib.util, json, sys
import numpy as np
from lerobot.datasets.lerobot_dataset import CODEBASE_VERSION, LeRobotDataset
assert importlib.util.find_spec("aftdeck") is None
root, out = sys.argv[1:]
data = LeRobotDataset("any/name", root=root)
stored = data.hf_dataset.with_format(None)
items = [data[k] for k in range(len(data))]
np.savez(
    out,
    inputs=np.array(stored["inputs"][:]),
    **{name: np.stack([one[name].numpy() for one in items]) for name in items[0] if name not in ("task", "inputs")},
)
print(json.dumps({
    "format": CODEBASE_VERSION, "version": data.meta.info["codebase_version"], "fps": data.fps,
    "episodes": data.num_episodes, "tasks": sorted({one["task"] for one in items}),
    "names": data.meta.names["action"],
}))
"""
CONTRACT = """
import json
import torch
from lerobot.envs.utils import _call_make_env, _normalize_hub_result, close_envs
from lerobot.scripts.lerobot_eval import rollout
import aftdeck.gym.lerobot

class Policy(torch.nn.Module):
    def reset(self):
        pass
    def select_action(self, seen):
        return torch.rand(len(seen["task"]), 8)

same = lambda given: given
envs = _normalize_hub_result(_call_make_env(aftdeck.gym.lerobot, 2, False, None))
env = next(iter(envs.values()))[0]
env.set_attr("_max_episode_steps", [5, 5])
data = rollout(env, Policy(), same, same, same, same, seeds=[0, 1], return_observations=True)
print(json.dumps({name: [list(one.shape), str(one.dtype)] for name, one in data["observation"].items()}))
close_envs(envs)
"""


def called(*arguments: str, home: Path, path: str = "") -> str:
    """Return what a program prints; nothing is asked of Hugging Face's servers."""
    here = os.environ | {"PYTHONPATH": path, "HF_HUB_OFFLINE": "1", "HF_HOME": str(home)}
    command = [sys.executable, *arguments]
    done = subprocess.run(command, env=here, cwd=home, capture_output=True, timeout=WAIT_S, check=False)
    assert done.returncode == 0, done.stderr.decode()[-2000:]
    return done.stdout.decode()


def test_dataset_loads_by_lerobot_alone_and_its_inputs_give_the_recorded_flights(tmp_path: Path) -> None:
    hand, script, folder = tmp_path / "hand.mcap", tmp_path / "script.mcap", tmp_path / "set"
    record_steps(hand, load_scenario("first-flight"), busy(), STEPS)
    record_steps(script, load_scenario("first-flight"), iter([None] * STEPS), STEPS)
    options = [word for camera in CAMERAS for word in ("--camera", camera)]
    export = ["-m", "aftdeck", "export", str(hand), str(script), "--lerobot", str(folder), *options, "--size", "64x48"]
    source = str(ROOT / "src")
    printed = json.loads(called(*export, "--json", home=tmp_path, path=source))
    assert [episode["inputs_equal"] for episode in printed["episodes"]] == [True, True]

    found = json.loads(called("-c", LOAD, str(folder), str(tmp_path / "loaded.npz"), home=tmp_path))
    assert found["format"] == found["version"] == "v3.0"
    assert (found["fps"], found["episodes"], found["names"]) == (10, 2, printed["plan"]["action"])
    flights = [read_flight(hand), read_flight(script)]
    assert found["tasks"] == sorted({flight.scenario.title for flight in flights})
    with np.load(tmp_path / "loaded.npz") as loaded:
        for number, flight in enumerate(flights):
            own = loaded["episode_index"] == number
            compare({name: loaded[name][own] for name in loaded.files}, flight, flights)
            assert replays(folder / FOLDER, number, loaded["inputs"][own])

    seen = json.loads(called("-c", CONTRACT, home=tmp_path, path=source))
    assert seen["observation.images.wr"] == [[2, 6, 3, 240, 320], "torch.float32"]
    assert seen["observation.state"] == [[2, 6, len(plan(flights).state)], "torch.float32"]


def compare(loaded: dict[str, np.ndarray], flight: Flight, flights: list[Flight]) -> None:
    """Compare every sample of an episode with the flight; pictures may differ where another Pillow paints an edge."""
    chosen = plan(flights, cameras=CAMERAS, size=SIZE)
    numbers, painter = numbers_of(flight, chosen), Painter(flight.scenario, chosen.pictures, SIZE)
    found = list(samples(flight, chosen.per_sample, painter))
    assert len(found) == len(loaded["action"]) == -(-STEPS // chosen.per_sample)
    assert loaded["inputs"].dtype == np.float64
    assert (loaded["inputs"] == numbers.inputs.reshape(len(found), -1)).all()
    assert (loaded["action"] == numbers.action.astype(np.float32)).all()
    assert (loaded["observation.state"] == np.stack([sample.seen.state for sample in found])).all()
    assert loaded["next.reward"].tolist() == [sample.reward for sample in found]
    assert loaded["next.success"].tolist() == [sample.success for sample in found]
    assert loaded["next.done"].tolist() == [sample.done for sample in found]
    assert loaded["timestamp"] == pytest.approx(np.arange(len(found)) / chosen.fps)
    for name in chosen.pictures:
        ours = np.stack([sample.seen.pictures[name] for sample in found]).transpose(0, 3, 1, 2)
        theirs = 255.0 * loaded[f"observation.images.{name}"]
        assert theirs.shape == ours.shape and ours.any()
        assert np.abs(theirs - ours).mean() < 1.0
