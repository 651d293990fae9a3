"""Output of the command ``planes``."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from aftdeck.lines import print_line

if TYPE_CHECKING:
    from aftdeck.visual.report import Explained, Node


def named(value: object) -> object:
    """Return a value with all its named tuples as dicts, for JSON."""
    if isinstance(value, tuple) and hasattr(value, "_asdict"):
        return {key: named(item) for key, item in value._asdict().items()}
    if isinstance(value, dict):
        return {key: named(item) for key, item in value.items()}
    return [named(item) for item in value] if isinstance(value, tuple) else value


def print_planes(found: Explained, title: str) -> None:
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
            "  Z: place of all other clusters as one block"
            if found.place is not None
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
