"""Recordings of episodes of Capture, Extract and Dock, each with its random start.

A recording contains the scenario of its run. The scenario of an episode is that of the environment with another
``initial``, the random start, and with the environment's step of the task only.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import gymnasium
from msgspec.structs import replace

from aftdeck.errors import InputError, RecordingError
from aftdeck.gym.lerobot import LerobotEnv
from aftdeck.gym.mission.env import MissionEnv
from aftdeck.gym.mission.episode import started
from aftdeck.gym.terms import Floats32
from aftdeck.recording.writer import Recorder
from aftdeck.simulation.run import Simulation
from aftdeck.units import short


class RecordEpisodes(gymnasium.Wrapper[Any, Floats32, Any, Floats32]):
    """Wrapper that records each episode into a file of its own: ``episode-000000.mcap`` and so on.

    A file is complete when the next episode begins, or when the environment is closed.

    Args:
        env: Capture, Extract or Dock, or `LerobotEnv`.
        folder: folder of the files; it is created if it is missing.

    Raises:
        InputError: it is another environment.
    """

    def __init__(self, env: gymnasium.Env[Any, Floats32], folder: str | Path) -> None:
        super().__init__(env)
        inner = env.unwrapped.mission_env if isinstance(env.unwrapped, LerobotEnv) else env.unwrapped
        if not isinstance(inner, MissionEnv):
            raise InputError(f"env: got {short(env.unwrapped)}, expected Capture, Extract, Dock, or one of LeRobot")
        self._folder, self._count = Path(folder), 0
        self._inner: MissionEnv = inner
        self._inner.stepped = self._record
        self._recorder: Recorder | None = None

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[Any, dict[str, Any]]:
        """Finish the file of the last episode, and begin an episode and its file.

        Raises:
            RecordingError: a file cannot be written, or exists already.
        """
        self._finish()
        result = super().reset(seed=seed, options=options)
        sim = self._inner.simulation
        assert self._inner.start is not None, "`reset` has drawn a start"
        path = self._folder / f"episode-{self._count:06d}.mcap"
        self._recorder = Recorder(path, started(sim.scenario, self._inner.start, self._inner.task_step), sim.seed)
        self._count += 1
        self._record(sim)
        return result

    def close(self) -> None:
        """Finish the file of the last episode, and close the environment."""
        self._finish()
        super().close()

    def _record(self, sim: Simulation) -> None:
        if self._recorder is not None:
            # the environment's simulation computes no digests
            self._recorder.step(sim.given, replace(sim.look(), sha256=sim.seal().hex()))
            self._recorder.take_turns()

    def _finish(self) -> None:
        recorder, self._recorder = self._recorder, None
        if recorder is not None:
            recorder.close("stopped")
            if recorder.failure:
                raise RecordingError(recorder.failure, "unwritable")
