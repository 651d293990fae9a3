"""Writer of a Minari dataset, through Minari's own interface."""

from __future__ import annotations

import os
import re
import warnings
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from aftdeck.errors import InputError
from aftdeck.export.about import Episode, write_about, write_episode
from aftdeck.export.flight import Flight
from aftdeck.export.pictures import Painter
from aftdeck.export.plan import Plan
from aftdeck.export.samples import Seen, samples
from aftdeck.export.written import about_of, episode_of, new_folder, numbers_of
from aftdeck.extra import needed

FOLDER = Path("aftdeck")
"""Folder of the description in a dataset."""
_PLACE = "MINARI_DATASETS_PATH"
"""Environment variable that tells Minari the folder of its datasets."""
_NAME = re.compile(r"[-_\w]+-v\d+")


def check_name(folder: Path) -> None:
    """Check that a folder has the name of a dataset.

    Raises:
        InputError: it has not.
    """
    if _NAME.fullmatch(folder.name) is None:
        raise InputError(f"{folder}: the name of a Minari dataset has to end in -v and a number, such as flights-v0")


def write_minari(
    flights: Sequence[Flight], folder: Path, plan: Plan, progress: Callable[[float], None] | None = None
) -> list[Episode]:
    """Write a Minari dataset with an episode for each flight; return the description of each episode.

    Args:
        flights: the flights.
        folder: folder to create; its name is the dataset's, such as ``flights-v0``.
        plan: the plan. Minari stores pictures as JPEG. The inputs are in the information that follows each step.
        progress: called repeatedly with the fraction that is done, 0 to 1.

    Raises:
        InputError: Minari is not installed, the folder exists or has no name of a dataset, or a scenario lacks a
            camera.
    """
    library, buffers = needed("minari", "minari"), needed("minari.data_collector", "minari")
    needed("pyarrow", "minari")
    check_name(folder)
    total, done, episodes = sum(flight.steps for flight in flights), 0, list[Episode]()
    painters = [Painter(flight.scenario, plan.pictures, plan.size) if plan.pictures else None for flight in flights]
    observation_space, action_space = _spaces(plan)
    dataset: Any = None
    with new_folder(folder) as made:
        for number, (flight, painter) in enumerate(zip(flights, painters, strict=True)):
            numbers, seen, rewards, successes = numbers_of(flight, plan), list[Seen](), list[float](), list[bool]()
            for k, sample in enumerate(samples(flight, plan.per_sample, painter)):
                seen.append(sample.seen)
                rewards.append(sample.reward)
                successes.append(sample.success)
                last = sample.then
                if progress is not None:
                    progress((done + min((k + 1) * plan.per_sample, flight.steps)) / total)
            ended = [False] * (len(rewards) - 1)
            buffer = buffers.EpisodeBuffer(
                id=number,
                seed=flight.recording.opening.seed,
                observations=_observations([*seen, last]),
                actions=numbers.action.astype(np.float32),
                rewards=rewards,
                terminations=[*ended, successes[-1]],
                truncations=[*ended, not successes[-1]],
                infos={
                    "is_success": [False, *successes],
                    "inputs": np.concatenate([np.zeros((1, *numbers.inputs.shape[1:])), numbers.inputs]),
                },
            )
            if dataset is None:
                dataset = _created(library, made, buffer, observation_space, action_space)
            else:
                dataset.update_dataset_from_buffer([buffer])
            done += flight.steps
            episodes.append(episode_of(flight, plan, numbers, success=successes[-1]))
            write_episode(made / FOLDER, number, episodes[-1], flight.recording.opening)
        write_about(made / FOLDER, about_of(plan))
    return episodes


def _spaces(plan: Plan) -> tuple[Any, Any]:
    """Return the spaces of the observations and of the actions."""
    spaces = needed("gymnasium.spaces", "minari")
    width, height = plan.size
    pictures = {name: spaces.Box(0, 255, (height, width, 3), np.uint8) for name in plan.pictures}
    state = spaces.Box(-np.inf, np.inf, (len(plan.state),), np.float32)
    observation = {"state": state} | ({"pictures": spaces.Dict(pictures)} if pictures else {})
    return spaces.Dict(observation), spaces.Box(-np.inf, np.inf, (len(plan.action),), np.float32)


def _observations(seen: Sequence[Seen]) -> dict[str, Any]:
    """Return the observations of an episode, in the form of Minari's buffer."""
    states = np.stack([one.state for one in seen])
    names = seen[0].pictures
    if not names:
        return {"state": states}
    return {"state": states, "pictures": {name: np.stack([one.pictures[name] for one in seen]) for name in names}}


def _created(library: Any, folder: Path, buffer: Any, observation_space: Any, action_space: Any) -> Any:
    """Return a new dataset with one episode."""
    before = os.environ.get(_PLACE)
    os.environ[_PLACE] = str(folder.absolute().parent)
    try:
        with warnings.catch_warnings():
            # Minari wants an author, an address and an environment for the evaluation
            warnings.simplefilter("ignore", UserWarning)
            return library.create_dataset_from_buffers(
                folder.name,
                [buffer],
                observation_space=observation_space,
                action_space=action_space,
                description="Recorded runs of Aftdeck, a simulator of the Space Shuttle's arm",
                data_format="parquet",
            )
    finally:
        if before is None:
            del os.environ[_PLACE]
        else:
            os.environ[_PLACE] = before
