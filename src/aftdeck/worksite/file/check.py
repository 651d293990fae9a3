"""Checks of a worksite as a whole: names, parts and their frames, cameras inside solids, and the bay's walls."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from aftdeck.arrays import Array
from aftdeck.bodies.cameras import Camera
from aftdeck.bodies.hexahedron import CORNERS, NX, D, pack
from aftdeck.bodies.solid import Solid
from aftdeck.files import Problem, Where
from aftdeck.frames import Pose
from aftdeck.worksite.body import Body
from aftdeck.worksite.file.schema import WorksiteFile
from aftdeck.worksite.model import Bay
from aftdeck.worksite.payload import Payload

ARM = "arm."
"""Prefix of the names of an arm's frames. This module does not check whether a camera's frame exists on the arm,
because the arm is known only in a scenario."""
FRAMES = ("orbiter", "space")
_WALL = 0.05
"""Greatest allowed distance between the surface of a wall's solids and the end of the bay's inside [m]. It is not zero,
because the hexahedra that cover a tube's wall extend into the tube."""
_HAIR = 1e-6
"""Allowance for rounding in the comparison of a solid's distance with the distance of its bounding box [m]."""


def misnamed(file: WorksiteFile) -> Iterator[Problem]:
    """Yield problems with names and with the first body.

    The problems are: there is no body; the first body cannot give the scene frame; a name is used twice or is reserved
    for the arm's frames; a table refers to an item that does not exist.
    """
    if not file.body:
        yield Problem(("body",), "no body is listed; the first body gives the scene frame")
    elif file.body[0].fixed_to != "orbiter" or any(file.body[0].position) or any(file.body[0].rotation):
        yield Problem(
            ("body", 0),
            "the first body gives the scene frame; it has to be fixed to the orbiter, with zero position and rotation",
        )
    bodies = [body.name for body in file.body]
    payloads = [payload.name for payload in file.cargo]
    for kind, items in (("body", file.body), ("seat", file.seat), ("camera", file.camera), ("drive", file.drive)):
        yield from _repeated(kind, [item.name for item in items], ())
    yield from _repeated("cargo", payloads, (*bodies, *FRAMES))
    for i, name in enumerate(payloads):
        if name.startswith(ARM):
            yield Problem(("cargo", i), f"{name!r}: names that begin with {ARM!r} are reserved for the arm's frames")
    for i, seat in enumerate(file.seat):
        if seat.body not in bodies:
            yield Problem(("seat", i, "body"), f"{seat.body!r} is not a body; bodies are: {', '.join(bodies)}")
    for i, camera in enumerate(file.camera):
        if camera.body not in (*bodies, *payloads) and not camera.body.startswith(ARM):
            choices = ", ".join((*bodies, *payloads))
            yield Problem(("camera", i, "body"), f"{camera.body!r} is not a body; bodies are: {choices}")
    yield from _housing_problems(file)


def _housing_problems(file: WorksiteFile) -> Iterator[Problem]:
    """Yield problems with housings.

    The problems are: a housing is for a drive that is not listed, or for a drive that already has a housing; a camera
    that is inside a part has a housing too.
    """
    drives, housed = [drive.name for drive in file.drive], [housing.drive for housing in file.housing]
    for i, drive in enumerate(housed):
        if drive not in drives:
            choices = ", ".join(drives) or "none"
            yield Problem(("housing", i, "drive"), f"{drive!r} is not a drive; drives are: {choices}")
        if drive in housed[:i]:
            yield Problem(("housing", i, "drive"), f"the drive {drive!r} already has a housing")
    for i, camera in enumerate(file.camera):
        if camera.drive in housed and camera.inside:
            what = f"its drive {camera.drive!r} has a housing, so the camera cannot be inside {camera.inside!r}"
            yield Problem(("camera", i, "inside"), what)


def inside_nothing(file: WorksiteFile, parts: Collection[str]) -> Iterator[Problem]:
    """Yield a problem for each camera of the worksite that is inside a part that does not exist.

    `parts` are those of the worksite and of its payloads. The parts of an arm are known only in a scenario.
    """
    for i, camera in enumerate(file.camera):
        if camera.inside and camera.inside not in parts and not camera.body.startswith(ARM):
            yield Problem(("camera", i, "inside"), f"{camera.inside!r} is not a part; parts are: {', '.join(parts)}")


def _repeated(kind: str, names: Sequence[str], taken: Sequence[str]) -> Iterator[Problem]:
    """Yield a problem for each name that is repeated in `names` after its first occurrence, or that is in `taken`."""
    for i, name in enumerate(names):
        if name in (*names[:i], *taken):
            yield Problem((kind, i), f"the name {name!r} is taken; names have to differ")


def parts_in_two_frames(listed: Sequence[tuple[Where, Sequence[Solid]]]) -> Iterator[Problem]:
    """Yield a problem, with its location in the file, for each part that has solids in two frames.

    All solids of a part have to move together.
    """
    homes: dict[str, str] = {}
    for where, solids in listed:
        for part, frame in dict.fromkeys((solid.part, solid.frame) for solid in solids):
            if homes.setdefault(part, frame) != frame:
                yield Problem(
                    where, f"the part {part!r} has solids in {homes[part]} and in {frame}; a part has one frame"
                )


def blind_cameras(
    cameras: Mapping[int, Camera],
    bodies: Sequence[Body],
    solids: Sequence[Solid],
    payloads: Sequence[Payload],
    clearance: float,
) -> Iterator[Problem]:
    """Yield a problem for each camera that is inside a solid, or nearer to a solid than `clearance` [m].

    The keys of `cameras` are indices in the file. A camera on a body is checked against the solids of all bodies, at
    their poses at the start. A camera on a payload is checked against the payload's own solids. A camera is not checked
    against the part that contains it by design (`Camera.housing`). The function does not check cameras on the arm, eyes
    behind windows whose cabin the file does not name, or solids that come near a camera during a run.
    """
    still = {body.name: body.pose for body in bodies}
    own = {payload.name: payload.solids for payload in payloads}
    for i, camera in cameras.items():
        if camera.kind == "window" and not camera.inside:
            continue
        pose = still.get(camera.body)
        near = solids if pose else own.get(camera.body, ())
        place = _in_scene(pose, camera.position) if pose else np.array(camera.position)
        for solid in _within(clearance, place, near):
            room = distance(place, solid.vertices)
            if solid.part != camera.housing and not room > clearance:
                where = f"{room:.3g} m from" if room > 0.0 else "in"
                what = f"camera {camera.name} is {where} {solid.part}; it has to be more than {clearance:.3g} m away"
                yield Problem(("camera", i, "position"), what)


def _within(reach: float, point: Array, solids: Sequence[Solid]) -> list[Solid]:
    """Return the solids whose axis-aligned bounding boxes are at most `reach` + `_HAIR` [m] from a point."""
    if not solids:
        return []
    vertices = np.array([solid.vertices for solid in solids])
    beyond = np.maximum(np.maximum(vertices.min(axis=1) - point, point - vertices.max(axis=1)), 0.0)
    close = np.linalg.norm(beyond, axis=1) <= reach + _HAIR
    return [solid for solid, is_close in zip(solids, close, strict=True) if is_close]


def bay_without_walls(bay: Bay, solids: Sequence[Solid]) -> Iterator[Problem]:
    """Yield a problem for each side of the bay's inside that has no wall of the orbiter. The top is not checked."""
    bodies = [pack(solid.vertices) for solid in solids if solid.frame == "orbiter"]
    low, high = np.array(bay.low), np.array(bay.high)
    across = np.linspace(low + (high - low) / 10.0, high - (high - low) / 10.0, 5)
    for axis, name in enumerate("xyz"):
        for end, out in ((low, -_WALL), (high, _WALL)):
            if name == "z" and out > 0.0:
                continue
            places = [across[:, k] for k in range(3)]
            places[axis] = end[axis : axis + 1]
            points = np.stack(np.meshgrid(*places), axis=-1).reshape(-1, 3)
            aside = out * np.eye(3)[axis]
            beyond, within = _in_any(points + aside, bodies), _in_any(points - aside, bodies)
            if (beyond & ~within).any():
                continue
            what = f"the inside ends at {end[axis]:.4g} m, but no wall of the orbiter begins there"
            yield Problem(("bay", name), what)


def _in_any(points: Array, bodies: Sequence[Array]) -> NDArray[np.bool_]:
    """Return for each of the points (n, 3) whether it is inside at least one of the bodies, as an array (n,)."""
    found = np.zeros(len(points), bool)
    for body in bodies:
        found |= (points @ body[NX:D].reshape(3, 6) <= body[D:]).all(axis=1)
    return found


def _in_scene(pose: Pose, position: Sequence[float]) -> Array:
    return np.asarray(pose.rotation @ np.array(position) + pose.position)


def distance(point: Array, vertices: Array) -> float:
    """Return the distance of a point (3,) from a hexahedron (8, 3) [m]; 0 inside."""
    body = pack(vertices)
    normals, distances = body[NX:D].reshape(3, 6).T, body[D:]
    heights = normals @ point - distances
    if (heights <= 0.0).all():
        return 0.0
    return min(
        _from_face(point - height * normal, height, vertices[face[[0, 1, 3, 2]]])
        for face, normal, height in zip(CORNERS, normals, heights, strict=True)
        if height > 0.0
    )


def depth_in(point: Array, vertices: Array) -> float:
    """Return the depth of a point (3,) below the nearest face plane of a hexahedron (8, 3) [m]; negative outside."""
    body = pack(vertices)
    return -float((body[NX:D].reshape(3, 6).T @ point - body[D:]).max())


def _from_face(foot: Array, height: float, rim: Array) -> float:
    """Return the distance of a point from a face [m].

    Args:
        foot: (3,) foot of the perpendicular from the point to the face's plane [m].
        height: height of the point above the plane [m].
        rim: (4, 3) the face's vertices, in order around it [m].
    """
    edges = np.roll(rim, -1, axis=0) - rim
    sides = np.cross(edges, foot - rim)
    if (sides @ sides.sum(axis=0) >= 0.0).all():
        return height
    share = np.clip(((foot - rim) * edges).sum(axis=1) / (edges**2).sum(axis=1), 0.0, 1.0)
    from_rim = np.linalg.norm(rim + share[:, None] * edges - foot, axis=1).min()
    return float(np.hypot(from_rim, height))
