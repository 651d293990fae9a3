"""Verification of a recording: re-simulation of its inputs, comparison of its messages, and the hash chain."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Literal

import msgspec

from aftdeck.errors import AftdeckError, RecordingError
from aftdeck.law_folder import state_of_the_laws
from aftdeck.recording.apart import Apart, within_tolerance
from aftdeck.recording.bundle import scenario_of
from aftdeck.recording.check import ChannelChange, Check
from aftdeck.recording.compare import Difference, FieldChange
from aftdeck.recording.delays import Delays
from aftdeck.recording.environment import Environment, environment, machine
from aftdeck.recording.reader import Recording
from aftdeck.recording.records import FrameRecord
from aftdeck.simulation.run import Simulation
from aftdeck.version import __version__

Progress = Callable[[float], None]
"""Function that is called repeatedly with the fraction of the work that is done, 0 to 1."""
Chained = Literal["unbroken", "broken", "removed", "unlisted", "none"]
"""Result of a recording's hash chain.

``unbroken``: every message is as the chain has it. ``broken``: a message was changed, removed, added or moved.
``removed``: the file should have a chain and has none. ``unlisted``: the chain is unbroken, but the list of recordings
has another one for this file. ``none``: the file is cut short or of an earlier version, and has no chain.
"""
OF_THE_WALL_CLOCK = ("wall_s in /frames", "latency_ms in /frames")
"""Fields of frames that the simulation does not produce."""


class Verdict(msgspec.Struct, frozen=True):
    """Result of comparing a recording with its re-simulation."""

    equal: bool
    """True if everything that was computed again is equal, and no hash chain shows a change of the other messages."""
    agrees: bool
    """True if `equal` is; also true if another environment repeats an unchanged recording of a run with masses, and all
    lengths and angles agree within the tolerance (`recording.apart`)."""
    frames: int
    """Number of frames compared."""
    time_s: float
    """Simulated time of the last frame [s]."""
    different: int
    """Number of frames that differ."""
    first: Difference | None
    """Difference in the first frame that differs; None if all frames are equal."""
    apart: Apart | None
    """Greatest differences of all recorded lengths and angles, in all frames; None if all frames are equal."""
    changes: tuple[ChannelChange, ...]
    """Channels other than ``/frames`` that differ from the re-simulation."""
    whole: bool
    """True if the digests were compared; equal frames are then equal in all digits.

    False if the recording and this version declare different fields of the state. In this case only the recorded values
    were compared, as `verify` describes.
    """
    cut: bool
    """True if the recording is cut short; all its frames were compared."""
    chain: Chained
    """Result of the hash chain."""
    recomputed: tuple[str, ...]
    """Channels that were computed again and compared."""
    unchanged: tuple[str, ...]
    """Channels and fields that the re-simulation cannot compute, but that the hash chain shows to be unchanged."""
    not_covered: tuple[str, ...]
    """Channels and fields of which it is not known whether they are unchanged."""
    recorded_by: str
    """Version of Aftdeck that made the recording."""
    version: str
    """Version of Aftdeck that verified the recording."""
    same_laws: bool
    """True if the source code of the laws has not changed since the recording."""
    same_machine: bool
    """True if this machine computes with the same processor, system, libraries and compiler as the recording's."""
    environment: tuple[FieldChange, ...]
    """Parts of the computing environment that differ: before as recorded, after as on this machine.

    Empty for a file of an earlier version, which has no `Environment`.
    """
    delays: Delays | None
    """Delays of the recorded steps, and lost time; None if the recording does not tell them (`Recording.delays`)."""


def verify(
    path: str | Path,
    progress: Progress | None = None,
    stepped: Callable[[Simulation], None] | None = None,
    listed: str = "",
) -> Verdict:
    """Re-simulate a recording's inputs, and compare every message that the simulation produces.

    Frames, log lines, the channels for viewers and the footer are compared in every recorded digit, and the frames'
    digests in all digits. A hash chain shows whether the other messages are as they were written.

    A recording of another version is re-simulated too; the verdict names that version. Then only frames are compared,
    by their values, and by their digests if both versions declare the same fields of the state. Log lines are then
    compared only by time, kind and level, because their texts may differ between versions.

    Args:
        path: the recording.
        progress: called repeatedly with the fraction of the recording that is done, 0 to 1.
        stepped: called after every step with the simulation.
        listed: head of the hash chain as the list of recordings has it (`Index.chain_of`); empty if unknown.

    Raises:
        RecordingError: the file is not a recording, is damaged, has no control step, or cannot be re-simulated by this
            version.
    """
    recording = Recording(path)
    opening = recording.opening
    try:
        sim = Simulation(scenario_of(opening), opening.seed)
        check = Check(recording, sim)
        for entry in recording.entries_with_inputs():
            check.take(entry)
            if isinstance(entry.message, FrameRecord):
                if stepped is not None:
                    stepped(sim)
                if progress is not None and check.frames % 256 == 0:
                    progress(recording.share)
        if not check.frames:
            raise RecordingError(f"{path}: ends before its first step; there is nothing to compare", "empty")
    except RecordingError:
        raise
    except AftdeckError as error:
        if opening.version == __version__:
            raise
        raise RecordingError(
            f"{path}: was recorded by Aftdeck {opening.version} and cannot be re-simulated by {__version__}: {error}"
        ) from None
    return _verdict(recording, check, listed)


def _verdict(recording: Recording, check: Check, listed: str) -> Verdict:
    opening = recording.opening
    changes, chained = check.changes(), _chained(recording, check, listed)
    recomputed = check.recomputed()
    others = (*[topic for topic in check.topics if topic not in recomputed], *OF_THE_WALL_CLOCK)
    here = environment(check.plant)
    equal = check.different == 0 and not changes and chained in ("unbroken", "none")
    same_machine = opening.environment == here if opening.environment else opening.machine == machine()
    elsewhere = check.plant != "kinematic" and not same_machine and chained == "unbroken"
    return Verdict(
        equal=equal,
        agrees=equal or (elsewhere and within_tolerance(check.apart)),
        frames=check.frames,
        time_s=recording.time_s,
        different=check.different,
        first=check.first,
        apart=check.apart,
        changes=changes,
        whole=check.digests,
        cut=recording.cut,
        chain=chained,
        recomputed=recomputed,
        unchanged=others if chained == "unbroken" else (),
        not_covered=() if chained == "unbroken" else others,
        recorded_by=opening.version,
        version=__version__,
        same_laws=opening.laws == state_of_the_laws(),
        same_machine=same_machine,
        environment=_differing(opening.environment, here) if opening.environment else (),
        delays=recording.delays,
    )


def _chained(recording: Recording, check: Check, listed: str) -> Chained:
    if check.stated:
        if check.head != check.stated:
            return "broken"
        return "unlisted" if listed not in ("", check.head) else "unbroken"
    if listed or (not recording.cut and recording.opening.environment is not None):
        return "removed"
    return "none"


def _differing(before: Environment, after: Environment) -> tuple[FieldChange, ...]:
    """Return the fields in which two environments differ; of their features, only those that one of them lacks."""
    found = []
    for name in Environment.__struct_fields__:
        old, new = getattr(before, name), getattr(after, name)
        if name == "features":
            old, new = (", ".join(sorted(set(own) - set(other))) for own, other in ((old, new), (new, old)))
        if old != new:
            found.append(FieldChange(name, old, new))
    return tuple(found)
