"""Views of all clusters along an axis of the scene, with the planes of a tree: Figure 20 of the report."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array
from aftdeck.matrices import product
from aftdeck.simulation.frame import Frame
from aftdeck.visual.outlines import MOST_POINTS, convex_hull
from aftdeck.visual.report import Explained
from aftdeck.visual.scene import Aim, VisualScene
from aftdeck.visual.svg import text_element

SIZE = (430, 330)
"""Size of a view [pixels]."""
FAINT, EYE, PLANE = "#6f757d", "#f2c14e", "#7fb2e5"
"""Colours of outlines, of the eye, and of planes."""
_AHEAD = 34.0
"""Length of the line from the eye in the direction of view [pixels]."""
_EDGE_ON = 1e-6
"""Difference from 1 of the length of a normal in the view, up to which the plane is seen edge-on."""


class View(NamedTuple):
    """Direction of a view.

    Attributes:
        name: its name.
        axes: axes of the scene, 0 to 2, to the right and down the paper.
        down: whether the second axis points down the paper, 1.0, or up, -1.0.
    """

    name: str
    axes: tuple[int, int]
    down: float

    def flat(self, points: Array) -> Array:
        """Return points or directions (..., 3) of the scene on the paper (..., 2)."""
        return np.asarray(points[..., list(self.axes)] * [1.0, self.down])


VIEWS = (View("from above", (0, 1), -1.0), View("from port", (0, 2), -1.0))


def view_elements(scene: VisualScene, frame: Frame, aim: Aim, found: Explained, view: View) -> Iterator[str]:
    """Yield the elements of a view; its upper left corner is the origin.

    Planes of the orbiter's tree that are seen edge-on are drawn as lines.
    """
    poses, clusters = scene.frames_at(frame), scene.clusters
    outlines = [
        view.flat(product(cluster.body.points, poses[f, 3:].reshape(3, 3).T) + poses[f, :3])
        for cluster, f in zip(clusters.clusters, clusters.frame.tolist(), strict=True)
    ]
    eye = view.flat(aim.position)
    points = np.concatenate([*outlines, eye[None]])
    low, high = points.min(axis=0), points.max(axis=0)
    scale = float(((np.array(SIZE) - [20, 50]) / (high - low)).min())

    def placed(at: Array) -> Array:
        return np.asarray((at - 0.5 * (low + high)) * scale + [SIZE[0] / 2, SIZE[1] / 2 + 10])

    yield f'<rect width="{SIZE[0]}" height="{SIZE[1]}" fill="#000"/>'
    for outline in outlines:
        yield f'<path d="{path(placed(hull(outline)))}Z" fill="none" stroke="{FAINT}"/>'
    for node in found.trees.get("orbiter", ()):
        normal = view.flat(np.array(node.normal))
        if node.plane is not None and abs(float(np.hypot(*normal)) - 1.0) < _EDGE_ON:
            along = np.array([-normal[1], normal[0]]) * float((high - low).max())
            ends = np.array([normal * node.distance - along, normal * node.distance + along])
            yield f'<path d="{path(placed(ends))}" stroke="{PLANE}" stroke-dasharray="5 4"/>'
    for k, outline in enumerate(outlines):
        x, y = placed(outline.mean(axis=0)).tolist()
        yield text_element(x, y + 4, str(k), size=11, anchor="middle")
    at = placed(eye)
    x, y = at.tolist()
    yield f'<path d="{path(np.array([at, at + _AHEAD * view.flat(aim.axes[2])]))}" stroke="{EYE}" stroke-width="2"/>'
    yield f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4" fill="{EYE}"/>'
    yield text_element(8, 18, f"{view.name}; planes of the orbiter's tree dashed")


def path(points: Array) -> str:
    """Return the path through points (n, 2)."""
    return "M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in points.tolist())


def hull(points: Array) -> Array:
    """Return the convex hull (m, 2) of points (n, 2)."""
    found = np.empty((MOST_POINTS, 2))
    return np.asarray(found[: convex_hull(points.copy(), len(points), found)])
