"""A run without a screen into a session file."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from aftdeck.errors import RecordingError
from aftdeck.recording.index import Index
from aftdeck.recording.trial import NO_TRIAL, Trial
from aftdeck.recording.writer import Recorder
from aftdeck.scenario.load import load_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.plain import whole
from aftdeck.simulation.run import Run, Simulation, run


class UnrecordedRunError(RecordingError):
    """A run that went to its end, and whose recording did not.

    Attributes:
        run: as `record` would have returned it.
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
    inputs: Callable[[Simulation], Inputs | None] | None = None,
    changes: tuple[str, ...] = (),
    progress: Callable[[float], None] | None = None,
    stepped: Callable[[Simulation], None] | None = None,
    index: Index | None = None,
    unlisted: Callable[[str], None] | None = None,
) -> Run:
    """Fly a scenario's script, or given inputs, to the end and write everything into a session file.

    Args:
        scenario: a scenario, a built-in name or a path.
        out: the file to make; its folder is made where it is missing.
        seed: in place of the scenario's.
        trial: who takes part, and under which condition.
        inputs: asked before every step for a person's inputs, as in `simulation.run.run`.
        changes: KEY=VALUE, where the scenario differs from its text.
        progress: told now and then how much of the longest duration has gone, 0 to 1.
        stepped: called after every step with the simulation.
        index: list to keep the file in.
        unlisted: told why the file is not in the list, where it could not be put there.

    Returns:
        The run with its last frame; the file holds all.

    Raises:
        RecordingError: a file that exists already or cannot be written.
        UnrecordedRunError: a disk that became full; the file holds what was flown before, the error the run.
    """
    loaded = scenario if isinstance(scenario, Scenario) else load_scenario(scenario)
    own_seed = loaded.seed if seed is None else whole(seed, "seed")
    recorder = Recorder(Path(out), loaded, own_seed, changes=changes, trial=trial, index=index)

    def keep(sim: Simulation) -> None:
        recorder.step(sim.given, sim.look())
        recorder.wait_for_room()
        if stepped is not None:
            stepped(sim)

    try:
        done = run(loaded, seed, inputs=inputs, keep_frames=False, progress=progress, stepped=keep)
    except BaseException:
        recorder.close("stopped")
        raise
    recorder.close(done.summary.ended, done.summary)
    if recorder.failure:
        raise UnrecordedRunError(recorder.failure, done)
    if recorder.unlisted and unlisted is not None:
        unlisted(recorder.unlisted)
    return done
