"""Recorded flight, read once: the inputs of all control steps as numbers, checked by a simulation."""

from __future__ import annotations

import hashlib
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from msgspec.structs import replace

from aftdeck.arrays import Array
from aftdeck.errors import AftdeckError, RecordingError
from aftdeck.export.columns import Encoding
from aftdeck.recording.bundle import scenario_of
from aftdeck.recording.convert import DIGITS, input_record, inputs_of
from aftdeck.recording.reader import Recording
from aftdeck.recording.records import FrameRecord, Input, Shown
from aftdeck.recording.resample import merged
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.run import Simulation


@dataclass(frozen=True, eq=False)
class Flight:
    """A recorded flight.

    Attributes:
        recording: the recording, read to its end.
        scenario: its scenario.
        driven: cameras with a drive.
        inputs: (steps, columns) numbers of the inputs of each control step, for all columns.
        tips: (steps, 3) positions of the tip in L [m], as recorded.
        records: inputs of each step; in a scripted step, those of the script.
        frames_sha256: SHA-256 over the digests of all frames; empty if this version computes other frames.
        shown: cameras that the monitors showed first: of MON 1 and of MON 2.
    """

    recording: Recording
    scenario: Scenario
    driven: tuple[str, ...]
    inputs: Array
    tips: Array
    records: tuple[Input, ...]
    frames_sha256: str
    shown: tuple[str, ...]

    @property
    def encoding(self) -> Encoding:
        """Encoding of the inputs."""
        return Encoding(self.driven, len(self.scenario.arm.joints))

    @property
    def steps(self) -> int:
        """Number of control steps."""
        return len(self.inputs)

    def actions(self, per_sample: int) -> Array:
        """Return the numbers (samples, columns) of the actions.

        An action has the latest deflections of the sticks in its sample, and the last position of each switch that was
        set in it (`recording.resample.merged`).
        """
        if per_sample == 1:
            return self.inputs
        encoding, rows = self.encoding, []
        for at in range(0, self.steps, per_sample):
            since = self.records[at : at + per_sample]
            one = merged(since, since[0], at + 1)
            rows.append(encoding.encode(one))
        return np.array(rows)


def _numbers(encoding: Encoding, given: Input, path: Path) -> list[float]:
    """Return the numbers of a step's inputs.

    Raises:
        RecordingError: inputs have no numbers in a dataset.
    """
    try:
        return encoding.encode(given)
    except AftdeckError as error:
        raise RecordingError(f"{path}: cannot be exported: {error}") from None


def read_flight(path: Path, progress: Callable[[float], None] | None = None) -> Flight:
    """Read a recording, and simulate its inputs again.

    Args:
        path: the recording.
        progress: called repeatedly with the fraction of the recording that is read, 0 to 1.

    Raises:
        RecordingError: the file is not a recording, is damaged, has no control step, or cannot be simulated again by
            this version.
    """
    recording = Recording(path)
    opening = recording.opening
    rows, tips, records = list[list[float]](), list[tuple[float, ...]](), list[Input]()
    digests, equal, shown = hashlib.sha256(), True, tuple[str, ...]()
    given = Input(tick=0)
    try:
        scenario = scenario_of(opening)
        sim = Simulation(scenario, opening.seed)
        encoding = Encoding(sim.cameras, len(scenario.arm.joints))
        for entry in recording.entries_with_inputs():
            message = entry.message
            if isinstance(message, Shown):
                shown = shown or (*message.mon_1[:1], *message.mon_2[:1])
            elif isinstance(message, Input):
                given = message
            elif isinstance(message, FrameRecord):
                sim.advance(inputs_of(given))
                if given.script:
                    given = replace(input_record(message.tick, sim.flown), script=True, changes=given.changes)
                records.append(given)
                rows.append(_numbers(encoding, given, path))
                tips.append(message.position)
                digests.update(sim.seal())
                equal = equal and sim.seal().hex()[:DIGITS] == message.sha256
                if progress is not None and message.tick % 256 == 0:
                    progress(recording.share)
    except RecordingError:
        raise
    except AftdeckError as error:
        raise RecordingError(f"{path}: cannot be flown again: {error}") from None
    if not rows:
        raise RecordingError(f"{path}: ends before its first control step; it has nothing to export", "empty")
    return Flight(
        recording,
        scenario,
        sim.cameras,
        np.array(rows),
        np.array(tips),
        tuple(records),
        digests.hexdigest() if equal else "",
        shown,
    )
