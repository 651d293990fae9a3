"""Commands that fly: ``fly``, ``run``; and those that look at scenarios and arms."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated

import typer

from aftdeck.cli.app import Host, Json, NoBrowser, Port, ScenarioName, Seed, app
from aftdeck.cli.printing import Progress, print_complaint, print_json, print_summary, print_table
from aftdeck.errors import AftdeckError, InputError


@app.command(
    epilog="Examples: aftdeck fly first-flight --port 8340; aftdeck fly loaded --record flights; "
    "aftdeck fly loaded --record flights --participant P07 --condition 'delay 2 s'"
)
def fly(
    scenario: ScenarioName = "first-flight",
    host: Host = "127.0.0.1",
    port: Port = 8340,
    record: Annotated[Path | None, typer.Option(metavar="DIR", help="Record each flight into this folder.")] = None,
    participant: Annotated[
        str | None, typer.Option(metavar="CODE", help="Who takes part; each recording says so. Goes with --record.")
    ] = None,
    condition: Annotated[
        str | None, typer.Option(metavar="TEXT", help="The trial's condition; each recording says so, too.")
    ] = None,
    foxglove: Annotated[
        int | None, typer.Option(metavar="PORT", help="Let Foxglove attach here and watch, usually 8765.")
    ] = None,
    no_browser: NoBrowser = False,
    demo: Annotated[bool, typer.Option("--demo", help="Let the script fly until a stick moves.")] = False,
    seed: Seed = None,
) -> None:
    """Fly a scenario by hand in the browser."""
    from aftdeck.recording.trial import trial
    from aftdeck.scenario.load import load_scenario
    from aftdeck.station.serve import serve

    for name, text in (("--participant", participant), ("--condition", condition)):
        if text is not None and record is None:
            raise InputError(f"{name} goes with --record DIR: it is written into each recording, and nowhere else")
    taking_part = trial(participant, condition)
    serve(
        load_scenario(scenario),
        seed,
        host=host,
        port=port,
        open_browser=not no_browser,
        demo=demo,
        record=record,
        trial=taking_part,
        viewers=foxglove,
    )


@app.command(epilog="Examples: aftdeck run sts-400-closed --json; aftdeck run uncradle --out uncradle.mcap")
def run(
    scenario: ScenarioName,
    out: Annotated[Path | None, typer.Option(help="Record everything into this session file (.mcap).")] = None,
    words: Annotated[
        Path | None, typer.Option(metavar="FILE", help="Write the 1972 report's channels and frame words (JSON lines).")
    ] = None,
    as_json: Json = False,
    seed: Seed = None,
) -> None:
    """Fly a scenario's script without a screen and sum it up.

    Exit code 1 where it ended in a fault.
    """
    from aftdeck.scenario.load import load_scenario
    from aftdeck.simulation.run import run as fly_script

    loaded = load_scenario(scenario)
    if words is not None:
        from aftdeck.simulation.report_words import check_words, write_words

        if out is not None and out.resolve() == words.resolve():
            raise InputError(f"--out and --words both name {words}; each needs a file of its own")
        check_words(loaded, words)
    lost: AftdeckError | None = None
    with Progress(loaded.title) as progress:
        if out is None:
            summary = fly_script(loaded, seed, keep_frames=False, progress=progress).summary
        else:
            from aftdeck.recording.index import Index
            from aftdeck.recording.run import UnrecordedRunError, record

            try:
                summary = record(loaded, out, seed, progress=progress, index=Index(), unlisted=print_complaint).summary
            except UnrecordedRunError as error:
                summary, lost = error.run.summary, error
    if words is not None:
        write_words(loaded, words, seed)
    if as_json:
        print_json(summary, indent=2)
    else:
        print_summary(summary)
    if lost is not None:
        raise lost
    if summary.ended == "fault":
        raise typer.Exit(1)


@app.command(short_help="Check a scenario file: every error at once.", epilog="Example: aftdeck check my-scenario.toml")
def check(scenario: ScenarioName, as_json: Json = False) -> None:
    """Check a scenario file: every error at once, each with its place."""
    from aftdeck.errors import ScenarioError
    from aftdeck.scenario.load import load_scenario

    problems: tuple[str, ...] = ()
    try:
        loaded = load_scenario(scenario)
        if any(start.grasped for start in (loaded.start, *loaded.parts.values())):
            from aftdeck.simulation.run import Simulation

            Simulation(loaded)  # whether the hand could have taken it so shows only where everything stands
    except AftdeckError as error:
        problems = error.problems if isinstance(error, ScenarioError) else (str(error),)
    if as_json:
        print_json({"scenario": scenario, "problems": problems})
    else:
        for problem in problems:
            print(problem, file=sys.stderr)
        if not problems:
            print(f"{scenario}: good. {loaded.title}, arm {loaded.arm.name}, {len(loaded.phases)} phases.")
    if problems:
        raise typer.Exit(2)


@app.command(epilog="Example: aftdeck scenarios --json")
def scenarios(as_json: Json = False) -> None:
    """List the built-in scenarios."""
    from aftdeck.scenario.load import built_in, load_scenario

    loaded = [load_scenario(name) for name in built_in()]
    rows = [{"name": s.name, "title": s.title, "arm": s.arm.name, "text": s.description} for s in loaded]
    print_table(rows, ("name", "title", "arm", "text"), as_json)


@app.command(epilog="Example: aftdeck arms --json")
def arms(as_json: Json = False) -> None:
    """List the built-in arms."""
    from aftdeck.arms.load import built_in, load_model

    models = [load_model(name) for name in built_in()]
    rows = [{"name": m.name, "title": m.title, "joints": ", ".join(m.joints)} for m in models]
    print_table(rows, ("name", "title", "joints"), as_json)
