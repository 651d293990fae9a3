"""Conversion of bodies to Foxglove's scene entities: boxes, cylinders and spheres; triangles for all other shapes."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable

import numpy as np
from foxglove import messages as fox

from aftdeck.arrays import Array
from aftdeck.frames import IDENTITY, Pose, quaternion
from aftdeck.matrices import product, reflects
from aftdeck.scene.colours import material_of, rgb
from aftdeck.scene.mesh import Mesh, joined, moved
from aftdeck.scene.placed import placed
from aftdeck.scene.solids import solid
from aftdeck.shapes import Axis, Box, Cylinder, Material, Sphere
from aftdeck.worksite.body import Body

GRAIN = 2.0**-10
"""Rounding increment of the corners of triangles [m]: short numbers compress well."""
_ALONG: dict[Axis, Array] = {
    "x": np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]),
    "y": np.array([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]]),
    "z": np.eye(3),
}
"""Rotations that align Foxglove's cylinder, whose axis is z, with another axis."""


def scene_update(bodies: Iterable[Body], time: fox.Timestamp) -> fox.SceneUpdate:
    """Return an update that replaces all entities by these bodies."""
    delete_all = fox.SceneEntityDeletion(timestamp=time, type=fox.SceneEntityDeletionType.All)
    return fox.SceneUpdate(deletions=[delete_all], entities=[entity(body, time) for body in bodies])


def entity(body: Body, time: fox.Timestamp) -> fox.SceneEntity:
    """Return the entity of a body, in the coordinate frame that has the body's name."""
    cubes, cylinders, spheres = [], [], []
    surfaces: dict[Material, list[Mesh]] = defaultdict(list)
    for shape, pose in placed(body.shapes):
        material = material_of(shape)
        match shape:
            case Box():
                cubes.append(fox.CubePrimitive(pose=_pose(pose), size=_vector(*shape.size), color=_colour(material)))
            case Sphere():
                size = _vector(*[2.0 * shape.radius] * 3)
                spheres.append(fox.SpherePrimitive(pose=_pose(pose), size=size, color=_colour(material)))
            case Cylinder():
                cylinders.append(_cylinder(shape, pose, _colour(material)))
            case _:
                surfaces[material].append(moved(solid(shape), pose))
    triangles = [_triangles(joined(parts), _colour(material)) for material, parts in surfaces.items()]
    return fox.SceneEntity(
        timestamp=time,
        frame_id=body.name,
        id=body.name,
        frame_locked=True,
        cubes=cubes,
        cylinders=cylinders,
        spheres=spheres,
        triangles=triangles,
    )


def _cylinder(shape: Cylinder, pose: Pose, colour: fox.Color) -> fox.CylinderPrimitive:
    end = shape.radius if shape.radius_end is None else shape.radius_end
    widest = max(shape.radius, end)
    return fox.CylinderPrimitive(
        pose=_pose(Pose(pose.position, product(pose.rotation, _ALONG[shape.axis]))),
        size=_vector(2.0 * widest, 2.0 * widest, shape.length),
        bottom_scale=shape.radius / widest,
        top_scale=end / widest,
        color=colour,
    )


def _triangles(surface: Mesh, colour: fox.Color) -> fox.TriangleListPrimitive:
    corners = (np.round(surface.vertices / GRAIN) * GRAIN).tolist()
    return fox.TriangleListPrimitive(
        pose=_pose(IDENTITY),
        points=[fox.Point3(x=x, y=y, z=z) for x, y, z in corners],
        color=colour,
        indices=surface.faces.ravel().tolist(),
    )


def _pose(pose: Pose) -> fox.Pose:
    """Return a Foxglove pose, without reflection.

    If `pose` contains a reflection, its y axis is reversed, because a quaternion can only describe a rotation. The
    picture does not change, because every shape with a reflected pose is symmetric in y.
    """
    rotation = pose.rotation * [1.0, -1.0, 1.0] if reflects(pose.rotation) else pose.rotation
    w, x, y, z = quaternion(rotation)
    return fox.Pose(position=_vector(*pose.position.tolist()), orientation=fox.Quaternion(x=x, y=y, z=z, w=w))


def _vector(x: float, y: float, z: float) -> fox.Vector3:
    return fox.Vector3(x=x, y=y, z=z)


def _colour(material: Material) -> fox.Color:
    r, g, b = rgb(material)
    return fox.Color(r=r, g=g, b=b, a=1.0)
