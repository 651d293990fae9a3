"""Headless run with a recording."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from aftdeck.errors import RecordingError
from aftdeck.recording.convert import shown_record
from aftdeck.recording.index import Index
from aftdeck.recording.trial import NO_TRIAL, Trial
from aftdeck.recording.writer import Recorder
from aftdeck.scenario.load import load_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.plain import whole
from aftdeck.simulation.run import Run, Simulation, run


class UnrecordedRunError(RecordingError):
    """Error: the recording of a run failed, but the run itself reached its end.

    Attributes:
        run: the run that `record` would have returned.
    """

    def __init__(self, message: str, run: Run) -> None:
        super().__init__(message)
        self.run = run


def record(
    scenario: Scenario | str | Path,
    out: str | Path,
    seed: int | None = None,
    *,
    trial: Trial = NO_TRIAL,
    shown: tuple[tuple[str, ...], ...] | None = None,
    inputs: Callable[[Simulation], Inputs | None] | None = None,
    progress: Callable[[float], None] | None = None,
    stepped: Callable[[Simulation], None] | None = None,
    gauged: bool = False,
    index: Index | None = None,
    unlisted: Callable[[str], None] | None = None,
) -> Run:
    """Run a scenario to its end, with its script or with manual inputs, and record the run.

    Args:
        scenario: a scenario, the name of a built-in scenario, or a path.
        out: file to create; its folder is created if it is missing.
        seed: seed of the run; None selects the scenario's seed.
        trial: participant and condition.
        shown: cameras on each monitor during the whole run; None if there are no monitors.
        inputs: function that is called before every step and returns manual inputs, as in `simulation.run.run`.
        progress: called repeatedly with the fraction of the maximum duration that has passed, 0 to 1.
        stepped: called with the simulation after every step.
        gauged: as for `Simulation`; the recording is the same.
        index: list of recordings to which the file is added.
        unlisted: called with the reason if the file could not be added to the list.

    Returns:
        The run with its last frame only; the file has all frames.

    Raises:
        RecordingError: the file exists already or cannot be written.
        UnrecordedRunError: recording stopped before everything was written, for example on a full disk. The file has
            the steps written until then; the error's attribute `run` contains the run.
    """
    loaded = scenario if isinstance(scenario, Scenario) else load_scenario(scenario)
    own_seed = loaded.seed if seed is None else whole(seed, "seed")
    recorder = Recorder(Path(out), loaded, own_seed, trial=trial, index=index)
    if shown is not None:
        recorder.put(shown_record(0.0, shown))

    def record_step(sim: Simulation) -> None:
        recorder.step(sim.given, sim.look())
        recorder.take_turns()
        if stepped is not None:
            stepped(sim)

    try:
        done = run(
            loaded, seed, inputs=inputs, keep_frames=False, progress=progress, stepped=record_step, gauged=gauged
        )
    except BaseException:
        recorder.close("stopped")
        raise
    recorder.close(done.summary.ended, done.summary)
    if recorder.failure:
        raise UnrecordedRunError(recorder.failure, done)
    if recorder.unlisted and unlisted is not None:
        unlisted(recorder.unlisted)
    return done
