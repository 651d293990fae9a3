"""The command line's application, and the options that several commands share.

Commands are thin: they read, call, print. Libraries are imported when a command needs them.
"""

from __future__ import annotations

from typing import Annotated

import typer

app = typer.Typer(
    name="aftdeck",
    help="Aftdeck simulates a space manipulator at work: fly the Shuttle's arm, by hand or by script.",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
)

Json = Annotated[bool, typer.Option("--json", help="Print JSON, for scripts.")]
ScenarioName = Annotated[str, typer.Argument(metavar="SCENARIO", help="A built-in name or a path to a .toml file.")]
Seed = Annotated[int | None, typer.Option(help="In place of the scenario's seed.")]
Host = Annotated[str, typer.Option(help="Address to listen on.")]
Port = Annotated[int, typer.Option(help="Port to listen on; 0 takes any free one.")]
NoBrowser = Annotated[bool, typer.Option("--no-browser", help="Do not open a browser.")]


def _print_version(wanted: bool) -> None:
    if wanted:
        from aftdeck.version import __version__

        print(__version__)
        raise typer.Exit


@app.callback()
def _options(
    _version: Annotated[
        bool, typer.Option("--version", help="Print the version and stop.", is_eager=True, callback=_print_version)
    ] = False,
) -> None:
    pass
