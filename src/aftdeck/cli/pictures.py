"""Command ``render``: pictures of cameras without a GPU."""

from __future__ import annotations

import re
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from aftdeck.cli.app import app
from aftdeck.cli.drawing import SIZE, Run, WordsOf, light_of, not_negative
from aftdeck.cli.laws import pictures_compiled_meanwhile
from aftdeck.errors import InputError, SimulationError
from aftdeck.lines import print_line
from aftdeck.whole_file import write_whole

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from aftdeck.scenario.light import LightCondition
    from aftdeck.scenario.model import Scenario
    from aftdeck.simulation.frame import Frame
    from aftdeck.visual.page import Page
    from aftdeck.visual.picture import Look

ALL = "all"
"""Value of --camera for a contact sheet of all cameras."""
CELL = (400, 300)
"""Default size of a picture in a contact sheet [pixels]."""
LEAST_SIZE, MOST_SIZE = 16, 8192
"""Limits of a picture's width and height [pixels]."""
MOST_PIXELS = 300_000_000
"""Greatest number of pixels of all pictures in an animated file, which is made in memory."""
SHEET_CAMERAS = 16
"""Number of cameras that is assumed for a contact sheet when its pixels are counted."""
FORMATS = (".svg", ".png")
"""Endings of the files that `render` writes."""


class LookName(StrEnum):
    """Looks of a picture."""

    colour = "colour"
    seventies = "1972"


@app.command(
    short_help="Draw the picture of a camera as SVG or PNG, without a GPU.",
    epilog="Examples: aftdeck render concept-1972 --camera A -o view.svg; "
    "aftdeck render run.mcap --camera all --time 40 -o sheet.png; "
    "aftdeck render run.mcap --camera F --every 0.5 --look 1972 -o flight.png; "
    "aftdeck render run.mcap --camera F --every 1 -o flight-###.png",
)
def render(
    run: Run,
    camera: Annotated[str, typer.Option(metavar="NAME", help="Camera, or 'all' for a contact sheet of all cameras.")],
    out: Annotated[
        Path,
        typer.Option(
            "-o",
            "--out",
            metavar="FILE",
            help="File to write: .svg or .png. With --every, '#' signs in its name are replaced by a number, and each "
            "picture gets its own file; without them, the file is animated.",
        ),
    ],
    time: Annotated[float | None, typer.Option(metavar="SECONDS", help="Time of the picture; default: 0.")] = None,
    step: Annotated[
        float | None, typer.Option("--every", metavar="SECONDS", help="Draw the whole run, a picture in each interval.")
    ] = None,
    look: Annotated[LookName, typer.Option(help="In colour, or as on the monitors of 1972.")] = LookName.colour,
    size: Annotated[
        str | None,
        typer.Option(metavar="WxH", help="Size of a picture in pixels; default: 800x600, in a sheet 400x300."),
    ] = None,
    light: Annotated[
        str | None, typer.Option(metavar="NAME", help="Light condition; default: that of the scenario.")
    ] = None,
    words_of: WordsOf = None,
) -> None:
    """Draw the picture of a camera at any time of a run.

    The picture shows the bodies that the collision program knows, each face in one colour. The faces are put in order
    by separating planes, as in the Remote Manipulator Simulation; no GPU is needed.
    """
    from aftdeck.cli.moments import at, every, source

    if time is not None and step is not None:
        raise InputError("--time and --every cannot be combined")
    not_negative("--time", time)
    not_negative("--every", step)
    if step == 0.0:
        raise InputError("--every: got 0, expected seconds, more than 0")
    if out.suffix not in FORMATS:
        raise InputError(f"-o: {out} has to end in {' or '.join(FORMATS)}")
    numbered = re.search("#+", out.name)
    if numbered and step is None:
        raise InputError(f"-o: {out} has '#' in its name, which needs --every")
    drawn_size = _size(size, CELL if camera == ALL else SIZE)
    given = source(run, words_of)
    most = max(1, MOST_PIXELS // (drawn_size[0] * drawn_size[1] * (SHEET_CAMERAS if camera == ALL else 1)))
    frames = iter((at(given, time or 0.0).frame(),)) if step is None else every(given, step, None if numbered else most)
    pages = _pages(
        given.scenario, frames, camera, drawn_size, look, light_of(given.scenario, light), alone=step is None
    )
    with pictures_compiled_meanwhile():
        if numbered:
            count = 0
            for count, page in enumerate(pages, 1):
                write_whole(_numbered(out, numbered, count), _encoded([page], out.suffix, 1.0, run))
            print_line(f"{out}: {count} pictures")
            return
        kept = list(pages)
    write_whole(out, _encoded(kept, out.suffix, step or 1.0, run))
    print_line(f"{out}: {len(kept)} pictures" if step is not None else str(out))


def _pages(
    scenario: Scenario,
    frames: Iterable[Frame],
    camera: str,
    size: tuple[int, int],
    look: LookName,
    light: LightCondition,
    *,
    alone: bool,
) -> Iterator[Page]:
    """Yield the page of each frame.

    A picture that cannot be drawn is replaced by the reason; if it stands `alone`, this is an error.
    """
    from aftdeck.visual.page import contact_sheet, single
    from aftdeck.visual.picture import failed_picture, picture_of, readouts
    from aftdeck.visual.scene import VisualScene

    scene = VisualScene(scenario)
    style: Look = "1972" if look is LookName.seventies else "colour"
    for frame in frames:
        if camera != ALL:
            try:
                yield single(picture_of(scene, frame, camera, size, style, light))
            except SimulationError as error:
                if alone:
                    raise
                yield single(failed_picture(size, style, camera, error))
            continue
        pictures = []
        for name in scene.cameras:
            try:
                pictures.append(picture_of(scene, frame, name, size, style, light, brief=True))
            except SimulationError as error:
                pictures.append(failed_picture(size, style, name, error))
        yield contact_sheet(pictures, "   ".join((scenario.title, *filter(None, readouts(frame)))))


def _encoded(pages: list[Page], ending: str, step_s: float, name: str) -> bytes | str:
    from aftdeck.visual.png import animated_png, png
    from aftdeck.visual.svg import animated_svg, svg

    if ending == ".png":
        return png(pages[0]) if len(pages) == 1 else animated_png(pages, step_s)
    return svg(pages[0], name) if len(pages) == 1 else animated_svg(pages, step_s, name)


def _size(text: str | None, default: tuple[int, int]) -> tuple[int, int]:
    if text is None:
        return default
    found = re.fullmatch(r"(\d{1,5})x(\d{1,5})", text)
    size = (int(found[1]), int(found[2])) if found else (0, 0)
    if not all(LEAST_SIZE <= length <= MOST_SIZE for length in size):
        raise InputError(
            f"--size: got {text!r}, expected width x height in pixels, such as 800x600; each is from {LEAST_SIZE} to "
            f"{MOST_SIZE}"
        )
    return size


def _numbered(out: Path, numbered: re.Match[str], count: int) -> Path:
    return out.with_name(out.name.replace(numbered[0], f"{count:0{len(numbered[0])}d}", 1))
