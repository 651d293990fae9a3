"""Command ``export``."""

from __future__ import annotations

import re
from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from aftdeck.cli.app import Json, app
from aftdeck.cli.laws import pictures_compiled_meanwhile
from aftdeck.cli.printing import print_json
from aftdeck.errors import InputError
from aftdeck.lines import print_error, print_line
from aftdeck.progress_bar import ProgressBar

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from aftdeck.export.about import Episode
    from aftdeck.export.flight import Flight
    from aftdeck.export.plan import Plan


@app.command(
    short_help="Export recorded runs to a dataset for learners.",
    epilog="Examples: aftdeck export run.mcap --lerobot flights; "
    "aftdeck export P07-*.mcap --lerobot P07 --camera WR --camera ELB --size 224x224; "
    "aftdeck export run.mcap --minari flights-v0 --fps 50",
)
def export(
    files: Annotated[list[Path], typer.Argument(metavar="RECORDING...", help="Recordings (.mcap).")],
    lerobot: Annotated[
        Path | None, typer.Option(metavar="DIR", help="Write a LeRobotDataset v3.0 into this new folder.")
    ] = None,
    minari: Annotated[
        Path | None,
        typer.Option(metavar="DIR", help="Write a Minari dataset into this new folder, such as flights-v0."),
    ] = None,
    cameras: Annotated[
        list[str] | None,
        typer.Option(
            "--camera",
            metavar="NAME",
            help="Camera whose pictures are drawn again. Repeatable. Default with --lerobot: those on the monitors.",
        ),
    ] = None,
    no_pictures: Annotated[bool, typer.Option("--no-pictures", help="Draw no pictures.")] = False,
    size: Annotated[
        str | None, typer.Option(metavar="WxH", help="Size of a picture in pixels; default: 320x240.")
    ] = None,
    fps: Annotated[
        float | None,
        typer.Option(metavar="RATE", help="Samples in a second; the control rate is a multiple of it. Default: 10."),
    ] = None,
    columns: Annotated[
        str | None,
        typer.Option(
            metavar="NAME,...",
            help="Columns of the actions. Default: the hand controllers' and all others that a run uses.",
        ),
    ] = None,
    task: Annotated[
        str | None, typer.Option(metavar="TEXT", help="The task, for learners. Default: the scenario's title.")
    ] = None,
    as_json: Json = False,
) -> None:
    """Export recorded runs to a dataset for learners: an episode for each run, with pictures drawn again.

    Each run is simulated again, and the dataset's numbers are flown and compared with the recorded flight.
    docs/export.md lists all columns.
    """
    from aftdeck.export.pictures import SIZE, usual_cameras
    from aftdeck.export.plan import plan

    if (lerobot is None) == (minari is None):
        raise InputError("export needs either --lerobot DIR or --minari DIR")
    if no_pictures and (cameras or size):
        raise InputError("--no-pictures cannot be combined with --camera and --size")
    if minari is not None and size and not cameras:
        raise InputError("--size needs --camera: without it, a Minari dataset has no pictures")
    folder, write = _writer(lerobot, minari)
    pixels = SIZE if size is None else _size(size)
    flights = _read(files)
    drawn: Sequence[str] = cameras or ()
    if lerobot is not None and not cameras and not no_pictures:
        drawn = usual_cameras(flights[0])
    chosen = plan(
        flights, fps=fps, columns=None if columns is None else columns.split(","), cameras=drawn, size=pixels, task=task
    )
    with ExitStack() as meanwhile:
        if chosen.pictures:
            meanwhile.enter_context(pictures_compiled_meanwhile(bar=False))
        progress = meanwhile.enter_context(ProgressBar(f"{folder}"))
        episodes = write(flights, folder, chosen, progress)
    if as_json:
        print_json({"folder": str(folder), "plan": chosen, "episodes": episodes}, indent=2)
    else:
        _print(folder, chosen, episodes)
    if not all(episode.inputs_equal for episode in episodes):
        raise typer.Exit(1)


def _writer(
    lerobot: Path | None, minari: Path | None
) -> tuple[Path, Callable[[Sequence[Flight], Path, Plan, Callable[[float], None] | None], list[Episode]]]:
    """Return the folder and the writer; raise `InputError` if its library is missing or the folder exists."""
    from aftdeck.export.written import check_new_folder
    from aftdeck.extra import needed

    if lerobot is not None:
        from aftdeck.export.lerobot import write_lerobot

        check_new_folder(lerobot)
        needed("lerobot", "lerobot")
        return lerobot, write_lerobot
    assert minari is not None
    from aftdeck.export.minari import check_name, write_minari

    check_new_folder(minari)
    check_name(minari)
    needed("minari", "minari")
    return minari, write_minari


def _read(files: Sequence[Path]) -> list[Flight]:
    from aftdeck.export.flight import read_flight

    flights = []
    for file in files:
        with ProgressBar(f"reading {file}") as progress:
            flights.append(read_flight(file, progress))
    return flights


def _size(text: str) -> tuple[int, int]:
    found = re.fullmatch(r"(\d{1,5})x(\d{1,5})", text)
    if found is None:
        raise InputError(f"--size: got {text!r}, expected width x height in pixels, such as 320x240")
    return int(found[1]), int(found[2])


def _print(folder: Path, plan: Plan, episodes: Sequence[Episode]) -> None:
    count, samples = len(episodes), sum(episode.samples for episode in episodes)
    shown = ", ".join(plan.pictures.values()) or "none"
    print_line(f"{folder}: {count} {'episode' if count == 1 else 'episodes'}, {samples} samples, {plan.fps:g} a second")
    print_line(f"  action    {', '.join(plan.action)}")
    print_line(f"  pictures  {shown}")
    for episode in episodes:
        result = "success" if episode.success else "no success"
        print_line(f"  {episode.recording}: {episode.samples} samples, {result}; {_comparison(episode)}")
        if not episode.inputs_equal:
            print_error(
                f"{episode.recording}: the digests of its frames differ from those that this version computes; "
                "`aftdeck replay` shows the differences"
            )


def _comparison(episode: Episode) -> str:
    """Return how the flights by the dataset's numbers agree with the recorded one, as text."""
    if episode.action_equal:
        return "its actions give the recorded flight"
    exact = "its inputs give the recorded flight"
    if not episode.inputs_equal:
        exact = f"its inputs give a flight up to {episode.inputs_apart_m:.2g} m apart"
    if episode.action_apart_m is None:
        return f"{exact}; its actions cannot be flown alone"
    return f"{exact}; the flight by its actions alone is up to {episode.action_apart_m:.2g} m away"
