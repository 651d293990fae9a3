"""Episodes as all writers need them: numbers of a flight by the plan, and the description beside them."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array
from aftdeck.encodable import encodable
from aftdeck.errors import InputError, SimulationError
from aftdeck.export.about import FORMAT, About, Episode
from aftdeck.export.flight import Flight
from aftdeck.export.plan import Plan
from aftdeck.export.replay import Flown, fly
from aftdeck.files import check_new
from aftdeck.version import __version__


class Numbers(NamedTuple):
    """Numbers of an episode.

    Attributes:
        action: (samples, columns) actions.
        inputs: (samples, control steps in a sample, columns) inputs; after the last control step, 0.
    """

    action: Array
    inputs: Array


def numbers_of(flight: Flight, plan: Plan) -> Numbers:
    """Return the numbers of an episode."""
    encoding, n = flight.encoding, plan.per_sample
    actions = flight.actions(n)
    inputs = np.zeros((len(actions) * n, len(plan.inputs)))
    inputs[: flight.steps] = flight.inputs[:, encoding.index(plan.inputs)]
    return Numbers(actions[:, encoding.index(plan.action)], inputs.reshape(len(actions), n, len(plan.inputs)))


def about_of(plan: Plan) -> About:
    """Return the description of a dataset."""
    return About(FORMAT, __version__, plan.fps, plan.per_sample, plan.action, plan.inputs, plan.state, plan.pictures)


def episode_of(flight: Flight, plan: Plan, numbers: Numbers, *, success: bool) -> Episode:
    """Return the description of an episode; its inputs and its actions are flown and compared with the recording.

    The numbers are flown as a learner's library returns them: inputs in float64, actions in float32.
    """
    encoding, seed = flight.encoding, flight.recording.opening.seed
    rows = encoding.completed(plan.inputs, numbers.inputs.reshape(-1, len(plan.inputs)))
    exact = fly(flight.scenario, seed, rows, flight.steps, 1)
    learned = encoding.completed(plan.action, numbers.action.astype(np.float32).astype(np.float64))
    try:
        rough = fly(flight.scenario, seed, learned, flight.steps, plan.per_sample)
        equal = rough.frames_sha256 == flight.frames_sha256
        apart = _apart(rough, flight)
    except (InputError, SimulationError):  # a target of which columns were left out; a flight that diverges
        equal, apart = False, None
    return Episode(
        recording=encodable(flight.recording.path.name),
        task=plan.task_of(flight),
        steps=flight.steps,
        samples=len(numbers.action),
        driven=flight.driven,
        frames_sha256=flight.frames_sha256,
        success=success,
        inputs_equal=exact.frames_sha256 == flight.frames_sha256,
        inputs_apart_m=_apart(exact, flight),
        action_equal=equal,
        action_apart_m=apart,
    )


def _apart(flown: Flown, flight: Flight) -> float:
    """Return the greatest distance between the tips of two flights [m]."""
    return float(np.linalg.norm(flown.tips - flight.tips, axis=1).max())


def check_new_folder(folder: Path) -> None:
    """Check that a folder can be created.

    Raises:
        InputError: its parent does not exist, or its path is not UTF-8, which the datasets' libraries cannot write; or
            as for `files.check_new`.
    """
    check_new(folder)
    if encodable(folder.absolute()) != str(folder.absolute()):
        raise InputError(f"{folder.absolute()}: the path of a dataset has to be UTF-8 text")
    if not folder.parent.is_dir():
        raise InputError(f"{folder}: the folder {folder.parent} does not exist")


@contextmanager
def new_folder(folder: Path) -> Iterator[Path]:
    """Yield a path of the same name in a private folder; what is written there becomes `folder` when it is complete.

    If something fails, nothing is left behind.

    Raises:
        InputError: as for `check_new_folder`, or the folder cannot be written.
    """
    check_new_folder(folder)
    try:
        with TemporaryDirectory(prefix=f".{folder.name}.", dir=folder.parent) as private:
            made = Path(private, folder.name)
            yield made
            check_new_folder(folder)  # another process may have made it meanwhile
            made.rename(folder)
    except OSError as error:
        raise InputError(f"cannot write {folder}: {error.strerror or error}") from error
