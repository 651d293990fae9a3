"""Re-run of a recording with changes in its scenario, and the differences between the two runs."""

from __future__ import annotations

import hashlib
from collections.abc import Iterator
from pathlib import Path

import msgspec

from aftdeck.errors import InputError, RecordingError
from aftdeck.recording.bundle import scenario_of
from aftdeck.recording.compare import Comparison, Difference, EventChange, Greatest
from aftdeck.recording.convert import as_recorded, inputs_of
from aftdeck.recording.index import Index
from aftdeck.recording.reader import Recording
from aftdeck.recording.records import FrameRecord
from aftdeck.recording.replay import Progress
from aftdeck.recording.resample import resampled
from aftdeck.recording.trial import Trial
from aftdeck.recording.writer import Recorder
from aftdeck.scenario.changes import parse_change
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation


class Outcome(msgspec.Struct, frozen=True):
    """Differences between a recorded run and its re-run with changes."""

    changes: tuple[str, ...]
    ended_before: str
    ended_after: str
    time_before_s: float
    time_after_s: float
    compared: int
    """Number of times at which both runs have a frame."""
    first: Difference | None
    """First difference between frames; None if all compared frames are equal. Events are compared separately."""
    greatest_tip_m: Greatest
    """Greatest distance between the true positions of the tips: with masses, not what the encoders measure."""
    greatest_joint_rad: Greatest
    joint: str
    """Name of the joint whose angle differs most; empty if no angle differs."""
    joint_slides: bool
    """Whether this joint slides; its difference is then in m."""
    tip_at_end_m: float
    events: tuple[EventChange, ...]
    frames_sha256: str


def rerun(
    path: str | Path,
    changes: tuple[str, ...],
    out: Path | None = None,
    progress: Progress | None = None,
    index: Index | None = None,
) -> Outcome:
    """Re-run a recording's inputs with changes in its scenario.

    A scripted re-run continues until the script ends in the re-run. A manual re-run ends where the recording ends. With
    another control period, each step merges the inputs recorded since the step before (`resample`).

    Args:
        path: the recording.
        changes: changes, each as ``KEY=VALUE``; ``seed=N`` changes the seed.
        out: file for the recording of the re-run; None: the re-run is not recorded.
        progress: called repeatedly with the fraction of the recording that has been re-run, 0 to 1.
        index: list of recordings to which `out` is added.

    Raises:
        InputError: a change is not ``KEY=VALUE``, or names a location that the scenario does not have, or a recorded
            change in flight is not possible with the changes.
        ScenarioError: the changed scenario is not valid.
        RecordingError: `path` is not a recording, is damaged or has no control step, or `out` cannot be written.
    """
    recording = Recording(path)
    opening = recording.opening
    if next(Recording(path).steps(), None) is None:
        raise RecordingError(f"{path}: ends before its first step; there is nothing to re-run", "empty")
    parsed = [parse_change(change) for change in changes]
    scenario = scenario_of(opening, dict(parsed))
    seed = scenario.seed if any(where == ("seed",) for where, _ in parsed) else opening.seed
    sim = Simulation(scenario, seed)
    trial = Trial(opening.participant, opening.condition)
    recorder = None if out is None else Recorder(out, scenario, seed, trial=trial, index=index)
    frames = hashlib.sha256()

    def new_frames() -> Iterator[FrameRecord]:
        for inputs, frame in _steps_again(recording, sim):
            frames.update(bytes.fromhex(frame.sha256))
            if recorder is not None:
                recorder.step(inputs, frame)
                recorder.take_turns()
            if progress is not None and frame.tick % 256 == 0:
                progress(recording.share)
            yield as_recorded(frame)

    recorded = Recording(path)
    comparison = Comparison(opening.joints)
    model = sim.scenario.arm.model
    sliding = [joint for joint, slides in zip(model.joints, model.slides, strict=True) if slides]
    try:
        comparison.follow((record for _, record in recorded.steps()), new_frames())
    finally:
        if recorder is not None:
            recorder.close(sim.ended or "stopped")
    if recorder is not None and recorder.failure:
        raise RecordingError(recorder.failure)
    return Outcome(
        changes=changes,
        ended_before=recorded.ended or "cut",
        ended_after=sim.ended or "stopped",
        time_before_s=recorded.time_s,
        time_after_s=sim.frame.time_s if sim.frame else 0.0,
        compared=comparison.compared,
        first=comparison.first,
        greatest_tip_m=comparison.tip,
        greatest_joint_rad=comparison.joint,
        joint=comparison.joint_name,
        joint_slides=comparison.joint_name in sliding,
        tip_at_end_m=comparison.tip_at_end,
        events=comparison.events,
        frames_sha256=frames.hexdigest(),
    )


def _steps_again(recording: Recording, sim: Simulation) -> Iterator[tuple[Inputs | None, Frame]]:
    """Yield the inputs and the frame of each step of the re-run; a script runs until it ends in the re-run."""
    scripted = False
    old, new = recording.opening.control_period_s, sim.scenario.control_period
    for record in resampled((record for record, _ in recording.steps()), old, new):
        inputs, scripted = inputs_of(record), record.script
        try:
            frame = sim.step(inputs)
        except InputError as error:
            raise InputError(f"at {record.tick * new:g} s, recorded inputs are not possible: {error}") from None
        yield inputs, frame
        if scripted and sim.ended:
            return
    while scripted and not sim.ended:
        yield None, sim.step()
