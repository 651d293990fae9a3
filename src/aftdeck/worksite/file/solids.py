"""Construction of a body's convex hexahedra, and of the shapes that draw them, from the solids in its file."""

from __future__ import annotations

from collections.abc import Iterable
from typing import assert_never

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.cover import prism, tube_wall
from aftdeck.bodies.hexahedron_check import hexahedra
from aftdeck.bodies.solid import Solid
from aftdeck.errors import InputError
from aftdeck.frames import Pose, endori
from aftdeck.matrices import product
from aftdeck.shapes import Hexahedron, Material, Shape
from aftdeck.tuples import Vec3
from aftdeck.worksite.file.solid_file import (
    BlockFile,
    BoxFile,
    HexahedronFile,
    PlateFile,
    PrismFile,
    SolidFile,
    TubeWallFile,
)

CORNERS = np.array([(v >> 1 & 1, v >> 2 & 1, v & 1) for v in range(8)], dtype=np.float64)
"""(8, 3) vertices of the unit cube, numbered as those of a hexahedron."""
_REFLECTED = np.array([v ^ 4 for v in range(8)])
"""(8,) indices of vertices. If a hexahedron is reflected in y = 0, vertex v of the result is the image of the original
vertex _REFLECTED[v]."""
_ACROSS = {"x": (2, 0, 1), "y": (0, 2, 1), "z": (0, 1, 2)}
"""For each possible axis of a plate's normal: the indices of x, y and z in the tuple (first, second, across)."""


def solids_of(file: SolidFile) -> dict[str, Array]:
    """Return the parts that an entry of the file makes, each with its hexahedra (n, 8, 3) in the body's axes [m].

    Raises:
        InputError: the hexahedra are not convex; the message names the part and the vertex.
    """
    placed = moved(_own(file), Pose(np.array(file.position, dtype=np.float64), endori(*file.rotation)))
    if not file.mirror:
        return {file.part: checked(placed, file.part)}
    reflected = placed[:, _REFLECTED] * [1.0, -1.0, 1.0]
    starboard, port = (placed, reflected) if placed[..., 1].mean() > 0.0 else (reflected, placed)
    parts = {f"{file.part} port": port, f"{file.part} starboard": starboard}
    return {part: checked(bodies, part) for part, bodies in parts.items()}


def checked(bodies: Array, part: str) -> Array:
    """Check that hexahedra (n, 8, 3) are convex, make the array read-only and return it.

    Raises:
        InputError: a hexahedron is not convex; the message names the part and the vertex.
    """
    count = len(bodies)
    hexahedra(bodies, [part] if count == 1 else [f"{part}, hexahedron {k + 1} of {count}" for k in range(count)])
    bodies.flags.writeable = False
    return bodies


def moved(bodies: Array, pose: Pose) -> Array:
    """Convert hexahedra (n, 8, 3) [m] from their own frame to another frame.

    `pose` is the pose of the hexahedra's own frame in the other frame.
    """
    return np.asarray(product(bodies, pose.rotation.T) + pose.position)


def as_solids(part: str, frame: str, bodies: Iterable[Array]) -> tuple[Solid, ...]:
    """Return hexahedra as solids of a part."""
    return tuple(Solid(part, frame, vertices) for vertices in bodies)


def drawn(bodies: Iterable[Array], material: Material) -> tuple[Shape, ...]:
    """Return shapes that draw hexahedra; the shapes have the vertices of the hexahedra."""
    return tuple(Hexahedron(material=material, vertices=tuple(map(_point, vertices))) for vertices in bodies)


def _point(vertex: Array) -> Vec3:
    x, y, z = vertex.tolist()
    return x, y, z


def _own(file: SolidFile) -> Array:
    """Return the hexahedra (n, 8, 3) of a solid in its own axes [m]."""
    match file:
        case BlockFile():
            return _block(file)[None]
        case BoxFile():
            return ((CORNERS - 0.5) * np.array(file.size, dtype=np.float64))[None]
        case PlateFile():
            return _plate(file)[None]
        case HexahedronFile():
            return np.array(file.vertices, dtype=np.float64)[None]
        case TubeWallFile():
            return tube_wall(
                file.radius,
                file.thickness,
                file.length,
                radius_end=file.radius_end,
                axis=file.axis,
                start=file.start,
                sweep=file.sweep,
                count=file.count,
            )
        case PrismFile():
            return prism(
                file.radius, file.length, radius_end=file.radius_end, axis=file.axis, sides=file.sides, turn=file.turn
            )
        case _:
            assert_never(file)


def _block(file: BlockFile) -> Array:
    near, far = (file.y, file.z), (file.y_end or file.y, file.z_end or file.z)
    for axis, (low, high) in (("x", file.x), *zip("yzyz", (*near, *far), strict=True)):
        if not low < high:
            raise InputError(f"{file.part}: {axis} is from {low:g} to {high:g} m; the first has to be less")
    vertices = np.empty((8, 3))
    for v, (x, y, z) in enumerate(CORNERS.astype(int)):
        across, up = far if x else near
        vertices[v] = file.x[x], across[y], up[z]
    return vertices


def _plate(file: PlateFile) -> Array:
    """Return the vertices (8, 3) of a plate [m].

    The corners of its outline, in counter-clockwise order, become the corners (-, -), (+, -), (+, +), (-, +) in the
    first two axes.
    """
    outline = np.array(file.outline, dtype=np.float64)
    following = outline[[1, 2, 3, 0]]
    area = float(np.sum(outline[:, 0] * following[:, 1] - following[:, 0] * outline[:, 1]))
    counter_clockwise = (area > 0.0) != (file.normal == "y")  # the rotation from x to z about y is negative
    if not counter_clockwise:
        outline = outline[::-1]
    vertices = np.empty((8, 3))
    for v, (first, second, across) in enumerate(CORNERS.astype(int)):
        u, w = outline[(0, 1, 3, 2)[first + 2 * second]]
        vertices[v] = u, w, file.thickness * (across - 0.5)
    return vertices[:, _ACROSS[file.normal]]
