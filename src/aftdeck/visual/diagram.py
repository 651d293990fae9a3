"""Sheet that shows what decides the order of a picture: numbered picture, views, trees and table, as an SVG.

It corresponds to Figures 19 (priority trees) and 20 (model and separation planes) of the final report of the Remote
Manipulator Simulation.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from aftdeck.scenario.light import LightCondition
from aftdeck.simulation.frame import Frame
from aftdeck.visual.picture import Picture, picture_of
from aftdeck.visual.report import Explained, Node, explained
from aftdeck.visual.scene import VisualScene
from aftdeck.visual.svg import DEFINITIONS, FONT, PAPER, elements, text_element
from aftdeck.visual.views import EYE, FAINT, PLANE, SIZE, VIEWS, view_elements

PICTURE = (480, 360)
"""Size of the picture [pixels]."""
GAP = 24
"""Distance between the parts of the sheet [pixels]."""
LINE = 17
"""Distance of two lines of text [pixels]."""
COLUMN = 390
"""Width of a column of text [pixels]."""
LEAF, LEVEL = 34, 44
"""Distances between the leaves, and between the levels of a tree [pixels]."""
MOST_LEAVES = 40
"""Greatest number of clusters of a tree that is drawn."""


def sheet(scene: VisualScene, frame: Frame, camera: str, light: LightCondition, title: str) -> str:
    """Return the sheet of a camera as the text of an SVG file.

    Args:
        scene: the scenario's visual scene.
        frame: the frame.
        camera: name of the camera.
        light: direction and strength of the light.
        title: title of the scenario; camera and time follow it on the sheet.

    Raises:
        InputError: there is no such camera.
        SimulationError: the camera is inside a body, or the bodies cannot be put in order.
    """
    aim = scene.aim(frame, camera, PICTURE[0] / PICTURE[1])
    found, picture = explained(scene, frame, aim), picture_of(scene, frame, camera, PICTURE, "colour", light)
    width = picture.width + len(VIEWS) * (SIZE[0] + GAP) + 2 * GAP
    parts = [text_element(GAP, GAP + 8, f"{title}, camera {camera} at {frame.time_s:.2f} s", size=17)]
    legend = "trees of separating planes: a bold branch leads to the side with the eye"
    parts.append(text_element(width - GAP, GAP + 8, legend, anchor="end"))
    y = 2 * GAP + 6
    parts += [_at(GAP, y), *elements(picture), *_numbers(picture), "</g>"]
    for k, view in enumerate(VIEWS):
        x = 2 * GAP + picture.width + k * (SIZE[0] + GAP)
        parts += [f'<svg x="{x}" y="{y}" width="{SIZE[0]}" height="{SIZE[1]}">']
        parts += [*view_elements(scene, frame, aim, found, view), "</svg>"]
    y += max(picture.height, SIZE[1]) + GAP
    x, tallest = GAP, 0
    omitted: list[str] = []
    for name, nodes in found.trees.items():
        leaves, depth = sum(len(node.clusters) for node in nodes), max(node.depth for node in nodes)
        if leaves > MOST_LEAVES:
            omitted.append(f"tree of {name} omitted: {leaves} clusters")
        if not 1 < leaves <= MOST_LEAVES:
            continue
        across = max(leaves * LEAF, 10 * len(name)) + GAP
        if x + across > width and x > GAP:
            x, y, tallest = GAP, y + tallest, 0
        parts += [_at(x, y), *_tree(name, nodes), "</g>"]
        x, tallest = x + across, max(tallest, (depth + 2) * LEVEL + GAP)
    y += tallest
    columns = _columns(found)
    columns[-1] += omitted
    for k, column in enumerate(columns):
        parts += [text_element(GAP + k * COLUMN, y + LINE * (n + 1), line) for n, line in enumerate(column)]
    height = y + LINE * max(map(len, columns)) + GAP
    size = f'width="{width}" height="{height}" viewBox="0 0 {width} {height}"'
    opening = f'<svg xmlns="http://www.w3.org/2000/svg" {size} {FONT}>'
    paper = f'<rect width="{width}" height="{height}" fill="{PAPER}"/>'
    return "\n".join([opening, DEFINITIONS, paper, *parts, "</svg>"]) + "\n"


def _at(x: float, y: float) -> str:
    return f'<g transform="translate({x:g},{y:g})">'


def _numbers(picture: Picture) -> Iterator[str]:
    """Yield the number of each cluster in the picture, at the middle of its largest polygon."""
    best: dict[int, tuple[float, float, float]] = {}
    for q, owner in enumerate(picture.owner.tolist()):
        corners = picture.points[picture.begins[q] : picture.begins[q + 1]]
        after = np.roll(corners, -1, axis=0)
        area = abs(float(np.sum(corners[:, 0] * after[:, 1] - after[:, 0] * corners[:, 1])))
        if area > best.get(owner, (0.0, 0.0, 0.0))[0]:
            x, y = corners.mean(axis=0).tolist()
            best[owner] = area, x, y
    yield '<g stroke="#000" stroke-width="3" paint-order="stroke">'
    for owner, (_, x, y) in best.items():
        yield text_element(x, y + 4, str(owner), anchor="middle")
    yield "</g>"


def _tree(name: str, nodes: tuple[Node, ...]) -> Iterator[str]:
    """Yield the elements of a tree: a circle for each plane, a box for each leaf; the eye's side is at the left."""
    yield text_element(0, 12, name)
    places: list[tuple[float, float]] = []
    _arrange(nodes, 0, 0.0, places)
    waiting: list[tuple[int, int]] = []
    for k, node in enumerate(nodes):
        x, y = places[k]
        while waiting and nodes[waiting[-1][0]].depth >= node.depth:
            waiting.pop()
        if waiting:
            father, sons = waiting[-1]
            fx, fy = places[father]
            nearer = sons == 0
            waiting[-1] = father, sons + 1
            colour, wide = (EYE, 3) if nearer else (FAINT, 1)
            yield f'<path d="M{fx:.1f} {fy + 12:.1f}L{x:.1f} {y - 12:.1f}" stroke="{colour}" stroke-width="{wide}"/>'
        if node.plane is None:
            half = 13 + (len(node.clusters) - 1) * LEAF / 2
            box = f'x="{x - half:.1f}" y="{y - 12:.1f}" width="{2 * half:.1f}" height="24"'
            yield f'<rect {box} fill="none" stroke="{FAINT}"/>'
            yield text_element(x, y + 4, " ".join(map(str, node.clusters)), anchor="middle")
        else:
            yield f'<circle cx="{x:.1f}" cy="{y:.1f}" r="12" fill="none" stroke="{PLANE}"/>'
            yield text_element(x, y + 4, str(node.plane), anchor="middle", fill=PLANE)
            waiting.append((k, 0))


def _arrange(nodes: tuple[Node, ...], k: int, left: float, places: list[tuple[float, float]]) -> tuple[int, float]:
    """Append the places of node `k` and its descendants; return the node after them, and the right end of the leaves.

    Args:
        nodes: nodes in the order of the trace.
        k: number of the node.
        left: left end of the leaves [pixels].
        places: the middle of each node before `k` [pixels].
    """
    node, y = nodes[k], 40.0 + nodes[k].depth * LEVEL
    if node.plane is None:
        right = left + len(node.clusters) * LEAF
        places.append((0.5 * (left + right), y))
        return k + 1, right
    places.append((0.0, y))
    first = k + 1
    second, middle = _arrange(nodes, first, left, places)
    after, right = _arrange(nodes, second, middle, places)
    places[k] = 0.5 * (places[first][0] + places[second][0]), y
    return after, right


def _columns(found: Explained) -> list[list[str]]:
    """Return the columns of text: clusters, then the priority output table."""
    clusters = ["Clusters: number, part, frame"]
    clusters += [f"{k:3d}  {part[:22]:22s} {frame}" for k, (part, frame) in enumerate(found.clusters)]
    table = ["Priority output table, highest first"]
    for entry in found.table:
        if entry.new_frame:
            table.append(f"  L vector of {entry.frame}")
        table.append(f"{entry.cluster:7d}  {entry.part}")
    notes = ["Order"]
    if found.listed is not None:
        rows = (" ".join(found.row[k : k + 12]) for k in range(0, len(found.row), 12))
        notes += ["permanent list, Z: all others", *rows]
    notes += [
        f"{found.compared} pairs compared",
        f"{found.ranked} of them by a list or a tree",
        f"{found.cuts} cuts",
        *(f"pin plane {'valid' if p.valid else 'not valid'}: {p.first}, {p.second}" for p in found.bisectors),
    ]
    if found.overlapping is not None:
        notes.append(f"{found.overlapping[0]} and {found.overlapping[1]} overlap in space: their order is uncertain")
    return [clusters, table, notes]
