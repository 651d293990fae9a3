"""Recordings of episodes: their random starts are in them."""

from __future__ import annotations

from pathlib import Path

import gymnasium
import numpy as np
import pytest

from aftdeck.errors import InputError
from aftdeck.export.flight import read_flight
from aftdeck.export.samples import samples
from aftdeck.gym.lerobot import LerobotEnv
from aftdeck.gym.mission.env import CaptureEnv
from aftdeck.gym.record import RecordEpisodes
from aftdeck.recording.replay import verify
from tests.gym.test_missions import careful


@pytest.mark.parametrize("task", ["Capture", "Extract", "Dock"])
def test_recorded_episodes_are_verified_and_begin_at_their_own_starts(task: str, tmp_path: Path) -> None:
    env = RecordEpisodes(gymnasium.make(f"aftdeck/{task}-v0"), tmp_path)
    rng, ends = np.random.default_rng(0), []
    for seed in (3, 4):
        env.reset(seed=seed)
        for _ in range(8):
            env.step(rng.uniform(-1.0, 1.0, env.action_space.shape).astype(np.float32))
        ends.append(env.unwrapped.simulation.look())  # type: ignore[attr-defined]
    env.close()
    files = sorted(tmp_path.iterdir())
    assert [file.name for file in files] == ["episode-000000.mcap", "episode-000001.mcap"]
    for file, end in zip(files, ends, strict=True):
        assert verify(file).equal
        flight = read_flight(file)
        assert flight.frames_sha256 and flight.steps == end.tick == 41
        assert flight.tips[-1] == pytest.approx(end.position, abs=1e-9)
    assert ends[0].position != ends[1].position


def test_success_of_an_episode_is_that_of_its_samples(tmp_path: Path) -> None:
    inner = CaptureEnv()
    env = RecordEpisodes(inner, tmp_path)
    seen, _ = env.reset(seed=0)
    over = success = False
    while not over:
        seen, _, over, _, info = env.step(careful(inner, seen))
        success = info["is_success"]
    env.close()
    assert success
    found = list(samples(read_flight(tmp_path / "episode-000000.mcap"), 5, None))
    assert [sample.success for sample in found] == [False] * (len(found) - 1) + [True]


def test_episodes_with_pictures_can_be_recorded(tmp_path: Path) -> None:
    env = RecordEpisodes(LerobotEnv("Dock", cameras=()), tmp_path)
    env.reset(seed=0)
    env.step(env.action_space.sample())
    env.close()
    assert verify(tmp_path / "episode-000000.mcap").equal


def test_other_environments_are_rejected(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="expected Capture, Extract, Dock"):
        RecordEpisodes(gymnasium.make("aftdeck/Reach-v0"), tmp_path)
