"""Commands ``render`` and ``planes``: pictures of cameras without a GPU, and the order of the clusters in them."""

from __future__ import annotations

import re
import sys
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from aftdeck.cli.app import Json, app
from aftdeck.cli.planes import named, print_planes
from aftdeck.cli.printing import print_json
from aftdeck.errors import InputError, SimulationError
from aftdeck.lines import print_error, print_line

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from aftdeck.scenario.light import LightCondition
    from aftdeck.scenario.model import Scenario
    from aftdeck.simulation.frame import Frame
    from aftdeck.visual.page import Page
    from aftdeck.visual.picture import Look

Run = Annotated[
    str,
    typer.Argument(
        metavar="SCENARIO|RECORDING|WORDS",
        help="A scenario, whose script is run; a recording (.mcap); or the 1972 report's frame words (.jsonl).",
    ),
]
WordsOf = Annotated[
    str | None,
    typer.Option("--words-of", metavar="SCENARIO", help="Scenario of the frame words; default: concept-1972."),
]
ALL = "all"
"""Value of --camera for a contact sheet of all cameras."""
SIZE = (800, 600)
"""Default size of a picture [pixels]."""
SHEET = (480, 360)
"""Size of the picture in the sheet of `planes` [pixels]."""
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
    _not_negative("--time", time)
    _not_negative("--every", step)
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
    frames = iter((at(given, time or 0.0),)) if step is None else every(given, step, None if numbered else most)
    pages = _pages(given.scenario, frames, camera, drawn_size, look, _light(given.scenario, light), alone=step is None)
    if numbered:
        count = 0
        for count, page in enumerate(pages, 1):
            _write(_numbered(out, numbered, count), _encoded([page], out.suffix, 1.0, run))
        print_line(f"{out}: {count} pictures")
        return
    kept = list(pages)
    _write(out, _encoded(kept, out.suffix, step or 1.0, run))
    print_line(f"{out}: {len(kept)} pictures" if step is not None else str(out))


@app.command(
    short_help="Show what decides which body hides which in a camera's picture.",
    epilog="Examples: aftdeck planes concept-1972 --camera A; "
    "aftdeck planes run.mcap --camera F --time 40 -o planes.svg",
)
def planes(
    run: Run,
    camera: Annotated[str, typer.Option(metavar="NAME", help="Camera.")],
    time: Annotated[float, typer.Option(metavar="SECONDS", help="Time of the picture.")] = 0.0,
    words_of: WordsOf = None,
    out: Annotated[
        Path | None, typer.Option("-o", "--out", metavar="FILE", help="Draw all this into a file (.svg) instead.")
    ] = None,
    as_json: Json = False,
) -> None:
    """Show the clusters, the trees of separating planes and the order chosen for a camera (the report's Figure 19)."""
    from aftdeck.cli.moments import at, source
    from aftdeck.visual.diagram import sheet
    from aftdeck.visual.picture import picture_of
    from aftdeck.visual.report import explained
    from aftdeck.visual.scene import VisualScene

    _not_negative("--time", time)
    if out is not None and (out.suffix != ".svg" or as_json):
        raise InputError(f"-o: {out} has to end in .svg, and cannot be combined with --json")
    given = source(run, words_of)
    frame = at(given, time)
    _announce_compilation()
    scene = VisualScene(given.scenario)
    aim, title = scene.aim(frame, camera, SIZE[0] / SIZE[1]), f"{given.scenario.title}, camera {camera}"
    found = explained(scene, frame, aim)
    if out is not None:
        picture = picture_of(scene, frame, camera, SHEET, "colour", _light(given.scenario, None))
        _write(out, sheet(scene, frame, aim, found, picture, f"{title} at {frame.time_s:g} s").encode())
        print_line(str(out))
    elif as_json:
        print_json(named(found))
    else:
        print_planes(found, f"{title} at {frame.time_s:g} s")


def _announce_compilation() -> None:
    """Tell the user in a terminal if the laws of the pictures have to be compiled first."""
    from aftdeck.law import compiled_before

    if sys.stderr.isatty() and not compiled_before("visual"):
        print_error("compiling the laws that draw pictures; this takes a minute or two, once for each version")


def _not_negative(option: str, value: float | None) -> None:
    if value is not None and not 0.0 <= value < float("inf"):
        raise InputError(f"{option}: got {value:g}, expected seconds, at least 0")


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

    _announce_compilation()
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


def _encoded(pages: list[Page], ending: str, step_s: float, name: str) -> bytes:
    from aftdeck.visual.png import animated_png, png
    from aftdeck.visual.svg import animated_svg, svg

    if ending == ".png":
        return png(pages[0]) if len(pages) == 1 else animated_png(pages, step_s)
    text = svg(pages[0], name) if len(pages) == 1 else animated_svg(pages, step_s, name)
    return text.encode()


def _light(scenario: Scenario, name: str | None) -> LightCondition:
    from aftdeck.scenario.light import conditions

    wanted = scenario.lighting.condition if name is None else name
    for condition in conditions():
        if condition.name == wanted:
            return condition
    raise InputError(f"--light: no light condition {wanted!r}: there are {', '.join(c.name for c in conditions())}")


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


def _write(path: Path, content: bytes) -> None:
    try:
        path.write_bytes(content)
    except OSError as error:
        raise InputError(f"cannot write {path}: {error.strerror}") from error
