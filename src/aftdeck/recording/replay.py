"""Verification of a recording: re-simulation of its inputs, and comparison of every frame."""

from __future__ import annotations

import hashlib
from collections.abc import Callable
from pathlib import Path

import msgspec

from aftdeck.errors import AftdeckError, RecordingError
from aftdeck.law import state_of_the_laws
from aftdeck.recording.bundle import machine, scenario_of
from aftdeck.recording.compare import Difference, alike, first_difference
from aftdeck.recording.convert import DIGITS, inputs_of
from aftdeck.recording.delays import Delays
from aftdeck.recording.reader import Recording
from aftdeck.recording.records import FrameRecord
from aftdeck.simulation.run import Simulation
from aftdeck.simulation.state import State
from aftdeck.state_part import declaration
from aftdeck.version import __version__

Progress = Callable[[float], None]
"""Function that is called repeatedly with the fraction of the work that is done, 0 to 1."""


class Verdict(msgspec.Struct, frozen=True):
    """Result of comparing re-simulated frames with the recorded ones."""

    equal: bool
    frames: int
    """Number of frames compared."""
    time_s: float
    """Simulated time of the last frame [s]."""
    different: int
    """Number of frames that differ."""
    first: Difference | None
    """Difference in the first frame that differs; None if all frames are equal."""
    whole: bool
    """True if the digests were compared; equal frames are then equal in all digits.

    False if the recording and this version declare different fields of the state. In this case the recorded values were
    compared instead of the digests, as `verify` describes.
    """
    cut: bool
    """True if the recording is cut short; all its frames were compared."""
    recorded_by: str
    """Version of Aftdeck that made the recording."""
    version: str
    """Version of Aftdeck that verified the recording."""
    same_laws: bool
    """True if the source code of the laws has not changed since the recording."""
    same_machine: bool
    """True if this machine has the processor, system and compilers with which the recording was made."""
    delays: Delays | None
    """Delays of the recorded steps, and lost time; None if the recording does not tell them (`Recording.delays`)."""


def verify(
    path: str | Path, progress: Progress | None = None, stepped: Callable[[Simulation], None] | None = None
) -> Verdict:
    """Re-simulate a recording's inputs and compare every frame's digest.

    A recording of another version is re-simulated too; the verdict names that version. If the two versions declare
    different fields of the state, all recorded values are compared instead of the digests. Log lines are then compared
    only by time, kind and level, because their texts may differ between versions.

    Args:
        path: the recording.
        progress: called repeatedly with the fraction of the recording that is done, 0 to 1.
        stepped: called after every step with the simulation.

    Raises:
        RecordingError: the file is not a recording, is damaged, or cannot be re-simulated by this version.
    """
    recording = Recording(path)
    opening = recording.opening
    try:
        sim = Simulation(scenario_of(opening), opening.seed)
        return _compared(recording, sim, progress, stepped)
    except RecordingError:
        raise
    except AftdeckError as error:
        if opening.version == __version__:
            raise
        raise RecordingError(
            f"{path}: was recorded by Aftdeck {opening.version} and cannot be re-simulated by {__version__}: {error}"
        ) from None


def _logged(record: FrameRecord, reworded: bool) -> list[tuple[float, str, str, str]]:
    """Return the log lines of a frame. If `reworded`, leave the texts empty: versions may word them differently."""
    return [(event.time_s, event.kind, event.level, "" if reworded else event.text) for event in record.events]


def _compared(
    recording: Recording, sim: Simulation, progress: Progress | None, stepped: Callable[[Simulation], None] | None
) -> Verdict:
    frames = hashlib.sha256()
    count = different = 0
    digests = recording.opening.digests == declaration(State)
    reworded = recording.opening.version != __version__
    first: Difference | None = None
    for recorded_inputs, record in recording.steps():
        sim.advance(inputs_of(recorded_inputs))
        if stepped is not None:
            stepped(sim)
        digest = sim.seal()
        frames.update(digest)
        count += 1
        if not digests or digest.hex()[:DIGITS] != record.sha256:
            computed = recording.as_recorded(sim.look())
            if digests or not alike(record, computed) or _logged(record, reworded) != _logged(computed, reworded):
                different += 1
                first = first or first_difference(record, computed)
        if progress is not None and count % 256 == 0:
            progress(recording.share)
    footer_agrees = recording.cut or not digests or frames.hexdigest() == recording.frames_sha256
    return Verdict(
        equal=different == 0 and footer_agrees,
        frames=count,
        time_s=recording.time_s,
        different=different,
        first=first,
        whole=digests,
        cut=recording.cut,
        recorded_by=recording.opening.version,
        version=__version__,
        same_laws=recording.opening.laws == state_of_the_laws(),
        same_machine=recording.opening.machine == machine(),
        delays=recording.delays,
    )
