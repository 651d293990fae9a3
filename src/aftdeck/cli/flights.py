"""Commands ``fly``, ``run``, ``check``, ``scenarios`` and ``arms``."""

from __future__ import annotations

import sys
from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from aftdeck.cli.app import Host, Json, Names, NoBrowser, PlantName, Port, ScenarioName, Seed, app
from aftdeck.cli.printing import print_cautions, print_json, print_summary, print_table
from aftdeck.errors import AftdeckError, InputError
from aftdeck.lines import print_error, print_line
from aftdeck.progress_bar import ProgressBar

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    from aftdeck.files import Changes, Problem
    from aftdeck.scenario.model import Scenario
    from aftdeck.simulation.inputs import Inputs
    from aftdeck.simulation.run import Simulation
    from aftdeck.simulation.summary import Summary


@app.command(
    epilog="Examples: aftdeck fly first-flight --port 8340; aftdeck fly loaded --plant flexible; "
    "aftdeck fly loaded --record flights --participant P07 --condition 'delay 2 s'; "
    "aftdeck fly --policy examples/learn/reach.npz; aftdeck fly srms-berth --operator perfect"
)
def fly(
    scenario: Annotated[
        str | None,
        typer.Argument(
            metavar="SCENARIO",
            help="A built-in name or a path to a .toml file; first-flight if none is given and no --policy.",
        ),
    ] = None,
    host: Host = "127.0.0.1",
    port: Port = 8340,
    names: Names = None,
    record: Annotated[Path | None, typer.Option(metavar="DIR", help="Record each run into this folder.")] = None,
    participant: Annotated[
        str | None, typer.Option(metavar="CODE", help="Participant code, stored in each recording. Requires --record.")
    ] = None,
    condition: Annotated[
        str | None,
        typer.Option(metavar="TEXT", help="Condition of the trial, stored in each recording. Requires --record."),
    ] = None,
    foxglove: Annotated[
        int | None, typer.Option(metavar="PORT", help="Let Foxglove attach to the run at this port, usually 8765.")
    ] = None,
    no_browser: NoBrowser = False,
    demo: Annotated[bool, typer.Option("--demo", help="Run the script until a stick moves.")] = False,
    policy: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="Fly a trained policy of a learning environment until a stick moves."),
    ] = None,
    operator: Annotated[
        str | None,
        typer.Option(
            metavar="KIND", help="Fly the task with a synthetic operator, perfect or human, until a stick moves."
        ),
    ] = None,
    plant: PlantName = None,
    seed: Seed = None,
    console: Annotated[
        bool,
        typer.Option("--console", help="Read lines for the console here: print and set values while the run lasts."),
    ] = False,
) -> None:
    """Start the station and operate a scenario in the browser."""
    from aftdeck.cli.autopilots import operator_flight, policy_flight
    from aftdeck.recording.trial import trial
    from aftdeck.scenario.load import find_scenario, parse_scenario
    from aftdeck.station.server.serve import serve

    for name, text in (("--participant", participant), ("--condition", condition)):
        if text is not None and record is None:
            raise InputError(f"{name} requires --record DIR, because it is stored in the recordings")
    if demo + (policy is not None) + (operator is not None) > 1:
        raise InputError("--demo, --policy and --operator each name what flies; use one of them")
    if record is not None and condition is None and (policy is not None or operator is not None):
        condition = f"operator {operator}" if policy is None else f"policy {policy.name}"
    own_trial = trial(participant, condition)
    autopilots = None
    if policy is not None:
        load, autopilots = policy_flight(policy, scenario, seed, plant)
    else:
        source = find_scenario(scenario or "first-flight")
        autopilots = None if operator is None else operator_flight(operator, seed)

        def load() -> Scenario:
            return parse_scenario(*source, _plant(plant))

    def load_with_cautions() -> Scenario:
        loaded = load()
        if autopilots is not None and autopilots(loaded) is None:
            raise InputError(f"--operator: {loaded.name} has no steps ([[step]]) that an operator could follow")
        print_cautions(_cautions(loaded))
        return loaded

    serve(
        load_with_cautions,
        seed,
        host=host,
        port=port,
        names=tuple(names or ()),
        open_browser=not no_browser,
        demo=demo,
        autopilots=autopilots,
        record=record,
        trial=own_trial,
        viewers=foxglove,
        console=console,
    )


@app.command(
    epilog="Examples: aftdeck run sts-400-closed --json; aftdeck run uncradle --out uncradle.mcap; "
    "aftdeck run concept-1972 --channels flown.jsonl; aftdeck run concept-1972 --operator human --out flight.mcap; "
    "aftdeck run concept-1972-script --vcu blocks.jsonl"
)
def run(
    scenario: ScenarioName,
    out: Annotated[Path | None, typer.Option(help="Record the run into this file (.mcap).")] = None,
    channels: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE",
            help="Read the inputs from this file: the 1972 report's channels, one line of JSON for each step.",
        ),
    ] = None,
    operator: Annotated[
        str | None,
        typer.Option(
            metavar="KIND",
            help="Fly the steps of the scenario's task with a synthetic operator, perfect or human.",
        ),
    ] = None,
    words: Annotated[
        Path | None, typer.Option(metavar="FILE", help="Write the 1972 report's channels and frame words (JSON lines).")
    ] = None,
    vcu: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="Write the 1972 report's blocks for the scene generator (JSON lines)."),
    ] = None,
    plant: PlantName = None,
    as_json: Json = False,
    seed: Seed = None,
) -> None:
    """Run a scenario's script headless and print a summary.

    With --channels, the inputs come from the file of channels and not from the script; with --operator, from a
    synthetic operator.

    The exit code is 1 if the run ended in a fault.
    """
    from aftdeck.cli.laws import compiled_meanwhile
    from aftdeck.scenario.load import load_scenario

    _check_different({"--out": out, "--words": words, "--vcu": vcu})
    if channels is not None and operator is not None:
        raise InputError("--channels and --operator both give the inputs; use one of them")
    loaded = load_scenario(scenario, _plant(plant))
    print_cautions(_cautions(loaded))
    if channels is None and operator is None and not loaded.phases:
        print_error(
            f"{loaded.name} has no script: it runs {loaded.duration:g} s without inputs; "
            f"operate it with `aftdeck fly {scenario}`"
        )
    warm_up, files = _laws(with_vcu=vcu is not None)
    with compiled_meanwhile(warm_up, loaded, files=files, bar=False):
        summary, recording_error = _run(loaded, out, channels, operator, words, vcu, seed)
    if as_json:
        print_json(summary, indent=2)
    else:
        print_summary(summary, loaded.arm.model.slides)
    if recording_error is not None:
        raise recording_error
    if summary.ended == "fault":
        raise typer.Exit(1)


def _run(
    scenario: Scenario,
    out: Path | None,
    channels: Path | None,
    operator: str | None,
    words: Path | None,
    vcu: Path | None,
    seed: int | None,
) -> tuple[Summary, AftdeckError | None]:
    """Run a scenario with the arguments of `run`.

    Returns:
        The summary, and the error that ended the recording (None if no error did).
    """
    from aftdeck.recording.index import Index
    from aftdeck.recording.run import UnrecordedRunError, record
    from aftdeck.recording.trial import Trial
    from aftdeck.simulation.run import run as run_scenario

    inputs: Callable[[Simulation], Inputs | None] | None = None
    if operator is not None:
        from aftdeck.operators.pilot import pilot
        from aftdeck.operators.spec import spec_of

        inputs = pilot(scenario, spec_of(operator), scenario.seed if seed is None else seed)
    if channels is not None:
        from aftdeck.cli.words import operator_by

        scenario, inputs = operator_by(scenario, channels)
    with ExitStack() as open_files:
        writers: list[Callable[[Simulation], None]] = []
        if words is not None:
            from aftdeck.cli.words import writing

            writers.append(open_files.enter_context(writing(scenario, words)))
        if vcu is not None:
            from aftdeck.cli.words import writing_blocks

            writers.append(open_files.enter_context(writing_blocks(scenario, vcu)))

        def write_all(simulation: Simulation) -> None:
            for write in writers:
                write(simulation)

        stepped = write_all if writers else None
        progress = open_files.enter_context(ProgressBar(scenario.title))
        if out is None:
            done = run_scenario(scenario, seed, inputs=inputs, keep_frames=False, progress=progress, stepped=stepped)
            return done.summary, None
        try:
            done = record(
                scenario,
                out,
                seed,
                trial=Trial(condition="" if operator is None else f"operator {operator}"),
                inputs=inputs,
                progress=progress,
                stepped=stepped,
                index=Index(),
                unlisted=print_error,
            )
        except UnrecordedRunError as error:
            return error.run.summary, error
        return done.summary, None


def _laws(*, with_vcu: bool) -> tuple[Callable[[Scenario], None], int | None]:
    """Return the call that compiles the laws of a run, and the number of their files; None for the usual number."""
    if not with_vcu:
        from aftdeck.simulation.warm import warm_up

        return warm_up, None
    from aftdeck.mainprior import warm

    return warm.warm_up, warm.FILES


def _check_different(files: Mapping[str, Path | None]) -> None:
    """Raise `InputError` if two options name the same file."""
    seen: dict[Path, str] = {}
    for option, path in files.items():
        if path is not None:
            other = seen.setdefault(path.resolve(), option)
            if other != option:
                raise InputError(f"{other} and {option} name the same file {path}; name different files")


def _plant(name: str | None) -> Changes:
    """Return the change of a scenario's plant; no change if `name` is None."""
    return {} if name is None else {("plant",): name}


def _cautions(scenario: Scenario, surveyed: Sequence[Problem] = ()) -> tuple[str, ...]:
    """Return a scenario's own cautions and the problems found by `survey`, each as a sentence."""
    from aftdeck.files import sentences

    return tuple(sentences([*scenario.cautions, *surveyed], f"{scenario.name}.toml", scenario.text))


@app.command(short_help="Check a scenario file and list all errors.", epilog="Example: aftdeck check my-scenario.toml")
def check(scenario: ScenarioName, as_json: Json = False) -> None:
    """Check a scenario file: list all errors with their locations, and cautions from sampled poses."""
    from aftdeck.errors import ScenarioError
    from aftdeck.scenario.load import load_scenario

    problems: tuple[str, ...] = ()
    cautions: tuple[str, ...] = ()
    try:
        loaded = load_scenario(scenario)
        from aftdeck.simulation.survey.pairs import survey
        from aftdeck.task.step_cameras import turned_pictures

        cautions = _cautions(loaded, [*survey(loaded), *turned_pictures(loaded)])
    except AftdeckError as error:
        problems = error.problems if isinstance(error, ScenarioError) else (str(error),)
    if as_json:
        print_json({"scenario": scenario, "problems": problems, "cautions": cautions})
    else:
        for problem in problems:
            print_line(problem, sys.stderr)
        print_cautions(cautions)
        if not problems:
            print_line(f"{scenario}: good. {loaded.title}, arm {loaded.arm.name}, {len(loaded.phases)} phases.")
    if problems:
        raise typer.Exit(2)


@app.command(epilog="Example: aftdeck scenarios --json")
def scenarios(as_json: Json = False) -> None:
    """List the built-in scenarios."""
    from aftdeck.scenario.load import built_in, load_scenario

    loaded = [load_scenario(name) for name in built_in()]
    columns = ("name", "group", "minutes", "title", "arm", "text")
    rows = [
        dict(zip(columns, (s.name, s.group, s.minutes, s.title, s.arm.name, s.description), strict=True))
        for s in loaded
    ]
    print_table(rows, columns, as_json)


@app.command(epilog="Example: aftdeck arms --json")
def arms(as_json: Json = False) -> None:
    """List the built-in arms."""
    from aftdeck.arms.load import built_in, load_model

    models = [load_model(name) for name in built_in()]
    rows = [{"name": m.name, "title": m.title, "joints": ", ".join(m.joints)} for m in models]
    print_table(rows, ("name", "title", "joints"), as_json)
