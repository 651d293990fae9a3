"""What can be wrong with a worksite as a whole: names, and cameras that stand in something."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from aftdeck.arrays import Array
from aftdeck.bodies.cameras import Camera
from aftdeck.bodies.hexahedron import CORNERS, NX, D, pack
from aftdeck.bodies.solid import Solid
from aftdeck.files import Problem, Where
from aftdeck.frames import Pose
from aftdeck.worksite.model import Bay, Body, Cargo
from aftdeck.worksite.schema import WorksiteFile

ARM = "arm."
"""What the names of an arm's frames begin with; whether a camera's frame is one of the arm's, a scenario has to say."""
FRAMES = ("orbiter", "space")
_WALL = 0.05
"""How far from where the bay's inside ends its walls may begin [m]: those of a tube cover it from outside."""


def misnamed(file: WorksiteFile) -> Iterator[Problem]:
    """No body, a first one that is not the scene, names used twice, and names of what is not there."""
    if not file.body:
        yield Problem(("body",), "none is listed; the first one gives the scene frame")
    elif file.body[0].fixed_to != "orbiter" or any(file.body[0].position) or any(file.body[0].rotation):
        yield Problem(
            ("body", 0), "the first body gives the scene frame: it is fixed to the orbiter, in no other place"
        )
    bodies = [body.name for body in file.body]
    cargoes = [cargo.name for cargo in file.cargo]
    for kind, items in (("body", file.body), ("seat", file.seat), ("camera", file.camera), ("drive", file.drive)):
        yield from _repeated(kind, [item.name for item in items], ())
    yield from _repeated("cargo", cargoes, (*bodies, *FRAMES))
    for i, name in enumerate(cargoes):
        if name.startswith(ARM):
            yield Problem(("cargo", i), f"{name!r}: names that begin with {ARM!r} are those of the arm's frames")
    for i, seat in enumerate(file.seat):
        if seat.body not in bodies:
            yield Problem(("seat", i, "body"), f"{seat.body!r} is no body; there are: {', '.join(bodies)}")
    for i, camera in enumerate(file.camera):
        if camera.body not in (*bodies, *cargoes) and not camera.body.startswith(ARM):
            there = ", ".join((*bodies, *cargoes))
            yield Problem(("camera", i, "body"), f"{camera.body!r} is no body; there are: {there}")
    yield from _homeless(file, bodies)


def _homeless(file: WorksiteFile, bodies: Sequence[str]) -> Iterator[Problem]:
    """Housings of drives that are not listed, and cameras that would have one where no body carries it."""
    drives, housed = [drive.name for drive in file.drive], [housing.drive for housing in file.housing]
    for i, drive in enumerate(housed):
        if drive not in drives:
            there = ", ".join(drives) or "none"
            yield Problem(("housing", i, "drive"), f"{drive!r} is no drive; there are: {there}")
        if drive in housed[:i]:
            yield Problem(("housing", i, "drive"), f"the drive {drive!r} has a housing already")
    for i, camera in enumerate(file.camera):
        if camera.drive in housed and camera.body not in bodies:
            what = f"its drive {camera.drive!r} has a housing, which stands on a body; {camera.body!r} is none"
            yield Problem(("camera", i, "drive"), what)


def _repeated(kind: str, names: Sequence[str], taken: Sequence[str]) -> Iterator[Problem]:
    """Names that others before them have, or that are taken."""
    for i, name in enumerate(names):
        if name in (*names[:i], *taken):
            yield Problem((kind, i), f"the name {name!r} is taken; names have to differ")


def parts_in_two_frames(listed: Sequence[tuple[Where, Sequence[Solid]]]) -> Iterator[Problem]:
    """Parts that stand in two frames, of the solids that are listed at each place: a part moves as one."""
    homes: dict[str, str] = {}
    for where, solids in listed:
        for part, frame in dict.fromkeys((solid.part, solid.frame) for solid in solids):
            if homes.setdefault(part, frame) != frame:
                yield Problem(where, f"the part {part!r} stands in {homes[part]} and in {frame}; a part has one frame")


def blind_cameras(
    cameras: Mapping[int, Camera],
    bodies: Sequence[Body],
    solids: Sequence[Solid],
    cargoes: Sequence[Cargo],
    clearance: float,
) -> Iterator[Problem]:
    """Cameras that stand in a solid, or nearer to one than a clearance [m]; `cameras` by their index in the file.

    A camera on a body is held against all bodies' solids, as they stand at the start; one on a cargo against the
    cargo's own. What a camera is itself made of is called after it (``camera A``) and left out. Cameras on the arm,
    eyes behind windows, and what comes near a camera in flight, are not looked at.
    """
    still = {body.name: body.pose for body in bodies}
    own = {cargo.name: cargo.solids for cargo in cargoes}
    for i, camera in cameras.items():
        if camera.kind == "window":
            continue
        pose = still.get(camera.body)
        near = solids if pose else own.get(camera.body, ())
        place = _in_scene(pose, camera.position) if pose else np.array(camera.position)
        for solid in near:
            room = distance(place, solid.vertices)
            if solid.part != f"camera {camera.name}" and not room > clearance:
                where = f"{room:.3g} m from" if room > 0.0 else "in"
                what = (
                    f"camera {camera.name} stands {where} {solid.part}; it has to be more than {clearance:.3g} m away"
                )
                yield Problem(("camera", i, "position"), what)


def bay_without_walls(bay: Bay, solids: Sequence[Solid]) -> Iterator[Problem]:
    """Sides of the bay's inside, but for its top, that do not end where solids of the orbiter's begin."""
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
            what = f"the inside ends at {end[axis]:.4g} m, where no wall of the orbiter's begins"
            yield Problem(("bay", name), what)


def _in_any(points: Array, bodies: Sequence[Array]) -> NDArray[np.bool_]:
    """(n,) whether points (n, 3) are in one of the bodies."""
    found = np.zeros(len(points), bool)
    for body in bodies:
        found |= (points @ body[NX:D].reshape(3, 6) <= body[D:]).all(axis=1)
    return found


def _in_scene(pose: Pose, position: Sequence[float]) -> Array:
    return np.asarray(pose.rotation @ np.array(position) + pose.position)


def distance(point: Array, vertices: Array) -> float:
    """How far a point (3,) is from a hexahedron (8, 3) [m]; 0 inside."""
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
    """How far a point (3,) has to go to leave a hexahedron (8, 3) [m]; negative outside."""
    body = pack(vertices)
    return -float((body[NX:D].reshape(3, 6).T @ point - body[D:]).max())


def _from_face(foot: Array, height: float, rim: Array) -> float:
    """Distance from a face, given the foot of the plumb line on its plane, its height, and the rim (4, 3) [m]."""
    ways = np.roll(rim, -1, axis=0) - rim
    sides = np.cross(ways, foot - rim)
    if (sides @ sides.sum(axis=0) >= 0.0).all():
        return height
    share = np.clip(((foot - rim) * ways).sum(axis=1) / (ways**2).sum(axis=1), 0.0, 1.0)
    beside = np.linalg.norm(rim + share[:, None] * ways - foot, axis=1).min()
    return float(np.hypot(beside, height))
