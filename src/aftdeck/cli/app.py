"""Application of the command line, and the options that several commands share.

A command only reads its arguments, calls functions and prints. It imports libraries when it needs them.
"""

from __future__ import annotations

from typing import Annotated

import typer

app = typer.Typer(
    name="aftdeck",
    help="Simulator of a space manipulator: operate the Shuttle's arm manually or by script.",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
)

Json = Annotated[bool, typer.Option("--json", help="Print JSON.")]
ScenarioName = Annotated[str, typer.Argument(metavar="SCENARIO", help="A built-in name or a path to a .toml file.")]
Seed = Annotated[int | None, typer.Option(help="Random seed; overrides the scenario's seed.")]
PlantName = Annotated[
    str | None,
    typer.Option("--plant", help="Model of the arm: kinematic, rigid or flexible; overrides the scenario's plant."),
]
Host = Annotated[
    str,
    typer.Option(help="Address to listen on. If other machines can reach it, a page needs a key in its address."),
]
Names = Annotated[
    list[str] | None,
    typer.Option("--name", metavar="NAME", help="Host name by which other machines address this one. Repeatable."),
]
Port = Annotated[int, typer.Option(help="Port to listen on; 0 selects a free port.")]
NoBrowser = Annotated[bool, typer.Option("--no-browser", help="Do not open a browser.")]


def _print_version(requested: bool) -> None:
    if requested:
        from aftdeck.version import __version__

        print(__version__)
        raise typer.Exit


_BRIEF = ("arm", "check")
"""Commands that call laws for so short a time that plain Python is quicker than their compilation."""
_AT_ONCE = ("run", "replay", "render", "planes", "report", "export")
"""Commands that begin with plain Python, and let another process compile (`cli/laws.py`)."""


@app.callback()
def _options(
    context: typer.Context,
    _version: Annotated[
        bool, typer.Option("--version", help="Print the version and exit.", is_eager=True, callback=_print_version)
    ] = False,
) -> None:
    if context.invoked_subcommand in _BRIEF:
        from aftdeck.law import run_kept

        run_kept()
    elif context.invoked_subcommand in _AT_ONCE:
        from aftdeck.law import run_plain

        run_plain()
