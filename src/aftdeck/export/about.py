"""Description of an exported dataset: JSON files beside its data, enough to fly its episodes without a recording."""

from __future__ import annotations

from pathlib import Path
from typing import TypeVar

import msgspec

from aftdeck.errors import InputError
from aftdeck.recording.codec import decode, encode
from aftdeck.recording.records import Opening

FORMAT = 1
"""Number of the description's layout."""
_SET = "dataset.json"

T = TypeVar("T")


class About(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Description of a dataset: common to all its episodes."""

    format: int
    version: str
    """Aftdeck's version."""
    fps: float
    """Samples in a second of simulated time [1/s]."""
    per_sample: int
    """Control steps in a sample."""
    action: tuple[str, ...]
    """Columns of `action`."""
    inputs: tuple[str, ...]
    """Columns of `inputs`, which a sample has for each of its control steps."""
    state: tuple[str, ...]
    """Names of the numbers of the state."""
    pictures: dict[str, str]
    """Camera of each picture, by the picture's name."""


class Episode(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """One episode: the run of one recording."""

    recording: str
    """Name of the recording's file."""
    task: str
    steps: int
    """Control steps; the last sample can have fewer than the others."""
    samples: int
    driven: tuple[str, ...]
    """Cameras with a drive; the column `camera` has their numbers, from 1."""
    frames_sha256: str
    """SHA-256 over the digests of the recorded run's frames; empty if this version computes other frames."""
    success: bool
    """Whether the task was complete at the end."""
    inputs_equal: bool
    """Whether the flight by `inputs` equals the recorded one, bit for bit."""
    inputs_apart_m: float
    """Greatest distance of the tip of the flight by `inputs` from that of the recorded flight, which is rounded [m]."""
    action_equal: bool
    """Whether the flight by `action` equals the recorded one, bit for bit."""
    action_apart_m: float | None
    """Greatest distance of the tip of the flight by `action` from that of the recorded flight [m]; null if the actions
    cannot be flown alone."""


def write_about(folder: Path, about: About) -> None:
    """Write the description of a dataset into a folder."""
    folder.mkdir(parents=True, exist_ok=True)
    _write(folder / _SET, msgspec.json.encode(about))


def write_episode(folder: Path, number: int, episode: Episode, opening: Opening) -> None:
    """Write the description of an episode, and the header of its recording, which contains the scenario's texts."""
    folder.mkdir(parents=True, exist_ok=True)
    _write(folder / f"episode-{number:06d}.json", msgspec.json.encode(episode))
    _write(folder / f"opening-{number:06d}.json", encode(opening))


def _write(path: Path, text: bytes) -> None:
    path.write_bytes(msgspec.json.format(text) + b"\n")


def read_about(folder: Path) -> About:
    """Return the description of a dataset.

    Raises:
        InputError: the folder has none, or it has another layout.
    """
    about = _read(folder / _SET, About)
    if about.format != FORMAT:
        raise InputError(f"{folder / _SET}: has layout {about.format}, expected {FORMAT}")
    return about


def read_episode(folder: Path, number: int) -> tuple[Episode, Opening]:
    """Return the description of an episode, and the header of its recording.

    Raises:
        InputError: there is no such episode.
    """
    episode = _read(folder / f"episode-{number:06d}.json", Episode)
    path = folder / f"opening-{number:06d}.json"
    try:
        return episode, decode(Opening, path.read_bytes())
    except (OSError, msgspec.MsgspecError) as error:
        raise InputError(f"{path}: cannot be read: {error}") from None


def _read(path: Path, kind: type[T]) -> T:
    try:
        return msgspec.json.decode(path.read_bytes(), type=kind)
    except (OSError, msgspec.MsgspecError) as error:
        raise InputError(f"{path}: cannot be read: {error}") from None
