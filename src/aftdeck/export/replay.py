"""Flight of an episode's numbers: from the actions or the inputs of a dataset back to the frames of the run."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from pathlib import Path
from typing import Literal, NamedTuple

import numpy as np

from aftdeck.arrays import Array
from aftdeck.errors import InputError
from aftdeck.export.about import read_about, read_episode
from aftdeck.export.columns import Encoding
from aftdeck.recording.bundle import scenario_of
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.run import Simulation


class Flown(NamedTuple):
    """Flight of an episode.

    Attributes:
        frames_sha256: SHA-256 over the digests of all frames.
        tips: (steps, 3) positions of the tip in L [m].
    """

    frames_sha256: str
    tips: Array


def fly(scenario: Scenario, seed: int, rows: Array, steps: int, per_row: int) -> Flown:
    """Fly the numbers of an episode.

    Each row acts for several control steps. Its sticks, camera drives and master arm act in all of them; its switches
    act in the first.

    Args:
        scenario: the scenario.
        seed: the seed.
        rows: (n, columns) numbers for all columns of `Encoding`.
        steps: number of control steps.
        per_row: number of control steps for which a row acts.

    Raises:
        InputError: the numbers are no inputs, or there are too few rows.
    """
    if len(rows) * per_row < steps:
        raise InputError(f"rows: got {len(rows)} for {steps} control steps, expected {-(-steps // per_row)}")
    sim = Simulation(scenario, seed)
    encoding = Encoding(sim.cameras, len(scenario.arm.joints))
    digests, tips = hashlib.sha256(), np.empty((steps, 3))
    for step in range(steps):
        row, since = divmod(step, per_row)
        sim.advance(encoding.decode(rows[row].tolist(), held_only=since > 0))
        digests.update(sim.seal())
        tips[step] = sim.look().position
    return Flown(digests.hexdigest(), tips)


def fly_episode(
    folder: str | Path, number: int, numbers: Array | Sequence[object], column: Literal["inputs", "action"] = "inputs"
) -> Flown:
    """Fly an episode of an exported dataset.

    Args:
        folder: folder of the dataset's description: ``meta/aftdeck`` in a LeRobotDataset, ``aftdeck`` in one of Minari.
        number: number of the episode.
        numbers: its ``inputs``, (samples, control steps in a sample times columns), or its ``action``, (samples,
            columns).
        column: which of the two the numbers are.

    Raises:
        InputError: the folder has no description, there is no such episode, or the numbers have another shape.
    """
    about = read_about(Path(folder))
    episode, opening = read_episode(Path(folder), number)
    given = np.asarray(numbers, dtype=np.float64)
    if column == "inputs":
        names, per_row, width = about.inputs, 1, len(about.inputs) * about.per_sample
    else:
        names, per_row, width = about.action, about.per_sample, len(about.action)
    if given.shape != (episode.samples, width):
        raise InputError(f"numbers: got shape {given.shape}, expected {(episode.samples, width)} for {column}")
    scenario = scenario_of(opening)
    encoding = Encoding(episode.driven, len(scenario.arm.joints))
    rows = encoding.completed(names, given.reshape(-1, len(names)))
    return fly(scenario, opening.seed, rows, episode.steps, per_row)


def replays(
    folder: str | Path, number: int, numbers: Array | Sequence[object], column: Literal["inputs", "action"] = "inputs"
) -> bool:
    """Return whether the flight of an episode's numbers equals the recorded flight, bit for bit.

    Arguments and errors as for `fly_episode`.
    """
    episode, _ = read_episode(Path(folder), number)
    return fly_episode(folder, number, numbers, column).frames_sha256 == episode.frames_sha256
