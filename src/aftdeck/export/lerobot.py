"""Writer of a LeRobotDataset, through LeRobot's own interface."""

from __future__ import annotations

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
from aftdeck.export.samples import samples
from aftdeck.export.written import about_of, episode_of, new_folder, numbers_of
from aftdeck.extra import needed

FOLDER = Path("meta", "aftdeck")
"""Folder of the description in a dataset."""


def features(plan: Plan) -> dict[str, dict[str, Any]]:
    """Return the features of a dataset."""
    n, names = plan.per_sample, plan.inputs
    inputs = [name if n == 1 else f"{name}_{k}" for k in range(n) for name in names]
    width, height = plan.size
    flag = {"shape": (1,), "names": None}
    return {
        "observation.state": {"dtype": "float32", "shape": (len(plan.state),), "names": list(plan.state)},
        **{
            f"observation.images.{name}": {
                "dtype": "image",
                "shape": (height, width, 3),
                "names": ["height", "width", "channels"],
            }
            for name in plan.pictures
        },
        "action": {"dtype": "float32", "shape": (len(plan.action),), "names": list(plan.action)},
        "inputs": {"dtype": "float64", "shape": (len(inputs),), "names": inputs},
        "next.reward": {"dtype": "float32", **flag},
        "next.success": {"dtype": "bool", **flag},
        "next.done": {"dtype": "bool", **flag},
    }


def write_lerobot(
    flights: Sequence[Flight], folder: Path, plan: Plan, progress: Callable[[float], None] | None = None
) -> list[Episode]:
    """Write a LeRobotDataset (format v3.0) with an episode for each flight; return the description of each episode.

    Pictures are stored without loss, as images in the Parquet files.

    Args:
        flights: the flights.
        folder: folder to create.
        plan: the plan.
        progress: called repeatedly with the fraction that is done, 0 to 1.

    Raises:
        InputError: LeRobot is not installed, the folder exists, or a scenario lacks a camera.
    """
    try:
        library = needed("lerobot.datasets.lerobot_dataset", "lerobot")
    except ImportError as error:  # LeRobot without its extra for datasets
        raise InputError(f"LeRobot cannot write datasets: {error}") from error
    needed("datasets", "lerobot").disable_progress_bars()
    total, done, episodes = sum(flight.steps for flight in flights), 0, []
    # all painters first: a missing camera is found before anything is written
    painters = [Painter(flight.scenario, plan.pictures, plan.size) if plan.pictures else None for flight in flights]
    rate = int(plan.fps) if plan.fps == int(plan.fps) else plan.fps
    with new_folder(folder) as made:
        dataset = library.LeRobotDataset.create(
            repo_id=f"aftdeck/{folder.name}",
            fps=rate,
            features=features(plan),
            root=made,
            robot_type=flights[0].scenario.arm.model.name,
            use_videos=False,
        )
        for number, (flight, painter) in enumerate(zip(flights, painters, strict=True)):
            numbers, success = numbers_of(flight, plan), False
            for k, sample in enumerate(samples(flight, plan.per_sample, painter)):
                pictures = sample.seen.pictures
                dataset.add_frame(
                    {
                        "observation.state": sample.seen.state,
                        **{f"observation.images.{name}": picture for name, picture in pictures.items()},
                        "action": numbers.action[k].astype(np.float32),
                        "inputs": numbers.inputs[k].ravel(),
                        "next.reward": np.array([sample.reward], dtype=np.float32),
                        "next.success": np.array([sample.success]),
                        "next.done": np.array([sample.done]),
                        "task": plan.task_of(flight),
                    }
                )
                success = sample.success
                if progress is not None:
                    progress((done + min((k + 1) * plan.per_sample, flight.steps)) / total)
            with warnings.catch_warnings():
                # LeRobot computes the histogram of a truth value
                warnings.filterwarnings("ignore", "Converting input from bool", RuntimeWarning)
                dataset.save_episode()
            done += flight.steps
            episodes.append(episode_of(flight, plan, numbers, success=success))
            write_episode(made / FOLDER, number, episodes[-1], flight.recording.opening)
        dataset.finalize()
        write_about(made / FOLDER, about_of(plan))
    return episodes
