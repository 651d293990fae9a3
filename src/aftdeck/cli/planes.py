"""Command ``planes``: what decides the order of the clusters in a camera's picture."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from aftdeck.cli.app import Json, app
from aftdeck.cli.drawing import SIZE, Run, WordsOf, light_of, not_negative
from aftdeck.cli.laws import pictures_compiled_meanwhile
from aftdeck.cli.printing import print_json
from aftdeck.cli.priority import routine_lines
from aftdeck.errors import InputError
from aftdeck.lines import print_line
from aftdeck.whole_file import write_whole

if TYPE_CHECKING:
    from collections.abc import Collection

    from aftdeck.cli.moments import Moment
    from aftdeck.mainprior.explain import RoutineExplained
    from aftdeck.scenario.model import Scenario
    from aftdeck.visual.report import Explained, Node
    from aftdeck.visual.scene import VisualScene


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
    """Show the clusters, the trees of separating planes and the order chosen for a camera (the report's Figure 19).

    For cameras A to I of the report's worksite, also show what the report's own priority routine makes of the frame.
    """
    from aftdeck.cli.moments import at, source
    from aftdeck.visual.diagram import sheet
    from aftdeck.visual.report import explained
    from aftdeck.visual.scene import VisualScene

    not_negative("--time", time)
    if out is not None and (out.suffix != ".svg" or as_json):
        raise InputError(f"-o: {out} has to end in .svg, and cannot be combined with --json")
    given = source(run, words_of)
    moment = at(given, time)
    frame, title = moment.frame(), given.scenario.title
    with pictures_compiled_meanwhile():
        scene = VisualScene(given.scenario)
        if out is not None:
            write_whole(out, sheet(scene, frame, camera, light_of(given.scenario, None), title))
            return print_line(str(out))
        aim = scene.aim(frame, camera, SIZE[0] / SIZE[1])
        found = explained(scene, frame, aim)
        routine = _by_routine(given.scenario, scene, moment, camera, [entry.cluster for entry in found.table])
    if as_json:
        by_routine = {"absent": routine} if isinstance(routine, str) else _named(routine)
        print_json({**_fields(found), "mainprior": by_routine})
        return
    _print(found, f"{title}, camera {camera} at {frame.time_s:g} s")
    print_line("")
    for line in [f"The report's own routine: none. {routine}"] if isinstance(routine, str) else routine_lines(routine):
        print_line(line)


def _by_routine(
    scenario: Scenario, scene: VisualScene, moment: Moment, camera: str, shown: Collection[int]
) -> RoutineExplained | str:
    """Return what the report's priority routine makes of a frame; a sentence if it does not know the scenario."""
    from aftdeck.mainprior.explain import explained_by_routine
    from aftdeck.mainprior.routine import PriorityRoutine

    try:
        routine = PriorityRoutine(scenario, scene)
        return explained_by_routine(routine, moment.frame(), camera, shown, moment.received)
    except InputError as error:
        return str(error)


def _fields(value: Explained) -> dict[str, object]:
    return {key: _named(item) for key, item in value._asdict().items()}


def _named(value: object) -> object:
    """Return a value with all its named tuples as dicts, for JSON."""
    if isinstance(value, tuple) and hasattr(value, "_asdict"):
        return {key: _named(item) for key, item in value._asdict().items()}
    if isinstance(value, dict):
        return {key: _named(item) for key, item in value.items()}
    return [_named(item) for item in value] if isinstance(value, tuple) else value


def _print(found: Explained, title: str) -> None:
    """Print what decides the order of a picture."""
    print_line(title)
    print_line("")
    print_line(
        f"{len(found.clusters)} clusters, from {found.solids} solids, of which {found.overlapping_solids} pairs in one "
        "frame overlap"
    )
    print_line("")
    print_line("Clusters: number, part, frame")
    for k, (part, frame) in enumerate(found.clusters):
        print_line(f"  {k:3d}  {part:28s} {frame}")
    print_line("")
    if found.listed is None:
        print_line(
            "Permanent list: none, because the camera moves, its eye has moved by pan or tilt, or the list has a "
            "cycle; trees and planes decide"
        )
    else:
        print_line("Permanent list of the clusters in the camera's frame, highest priority first:")
        print_line("  " + "  ".join(found.row))
        print_line(
            f"  Z: the trees of {', '.join(entry.frame for entry in found.roots)}, as one block"
            if found.roots
            else "  the other clusters have no common place: they are before and behind a listed cluster"
        )
    for frame, nodes in found.trees.items():
        if len(nodes) > 1:
            print_line("")
            print_line(f"Tree in {frame}: plane N . P = D in metres; the side with the eye comes first")
            for node in nodes:
                print_line("  " + "  " * node.depth + _text(node))
    for plane in found.bisectors:
        verb, bend = "separates" if plane.valid else "does not separate", math.degrees(plane.bend)
        print_line("")
        print_line(f"The plane through the pin at a bend of {bend:.1f} deg {verb} {plane.first} and {plane.second}")
    print_line("")
    print_line("Priority output table, highest priority first:")
    for entry in found.table:
        if entry.new_frame:
            print_line(f"  L vector of {entry.frame}")
        print_line(f"    {entry.cluster:3d}  {entry.part}")
    print_line("")
    by_plane = found.compared - found.ranked
    print_line(
        f"{found.compared} pairs overlap in the picture: {found.ranked} compared by a list or a tree, {by_plane} by a "
        f"plane between the two; {found.cuts} cuts"
    )
    if found.overlapping is not None:
        print_line(f"{found.overlapping[0]} and {found.overlapping[1]} overlap in space; their order is uncertain")


def _text(node: Node) -> str:
    if node.plane is None:
        return "cluster " + ", ".join(map(str, node.clusters))
    x, y, z = (round(part, 3) + 0.0 for part in node.normal)  # without minus zero
    distance = round(node.distance, 3) + 0.0
    return f"plane {node.plane}: N = ({x:.3f}, {y:.3f}, {z:.3f}), D = {distance:.3f}; eye {node.eye:+.3f}"
