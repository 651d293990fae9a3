"""Appearance of an arm: the shapes in each of its moving frames, and its cameras."""

from __future__ import annotations

import functools
from collections.abc import Iterator
from typing import NamedTuple

import msgspec

from aftdeck.arms.body_file import BlockBody, BodyFile, BoxBody
from aftdeck.arms.load import ArmModel
from aftdeck.bodies.camera_file import CameraFile, DriveFile, cameras_of
from aftdeck.bodies.cameras import Camera
from aftdeck.errors import ScenarioError
from aftdeck.files import Problem, Text, parse, sentences
from aftdeck.shapes import Box, Cylinder, Shape, without_lamps
from aftdeck.tuples import plain_vector


class ArmShapes(NamedTuple):
    """Drawn shapes and cameras of an arm."""

    bodies: dict[str, tuple[Shape, ...]]
    """Shapes by the name of their frame, in the order from the foot to the tip."""
    details: dict[str, tuple[Shape, ...]]
    """Shapes that only decorate the arm (`worksite.model.Body.details`), by the same names."""
    cameras: tuple[Camera, ...]


class _Frame(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Moving frame as listed in the file."""

    name: str
    shapes: tuple[Shape, ...] | None = None
    """Drawn shapes; without them, the collision bodies of the frame are drawn."""
    details: tuple[Shape, ...] = ()
    """Shapes that only decorate the arm. Only the station's page draws them. They cannot be lamps."""

    def __post_init__(self) -> None:
        """Reject a lamp among the details (ValueError)."""
        without_lamps(self.details)


class ShapesFile(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Contents of an arm's shape file."""

    body: tuple[_Frame, ...]
    camera: tuple[CameraFile, ...] = ()
    drive: tuple[DriveFile, ...] = ()


def shapes_of(model: ArmModel) -> ArmShapes:
    """Return an arm's shapes and cameras from its shape file; without a shape file, its collision bodies as shapes.

    Raises:
        ScenarioError: a shape or camera is invalid, or the file does not list the arm's frames in order. The message
            names the place in the file.
    """
    if model.shapes is not None:
        file = _file(model.shapes)
        cameras, problems = cameras_of(file.camera, file.drive)
        problems += _problems(file, model.frames)
        if problems:
            raise ScenarioError(sentences(problems, *model.shapes))
        details = {body.name: body.details for body in file.body}
        return ArmShapes(_as_bodies(model) | _drawn(file), details, cameras)
    return ArmShapes(_as_bodies(model), dict.fromkeys(model.frames, ()), ())


def _drawn(file: ShapesFile) -> dict[str, tuple[Shape, ...]]:
    """Return the shapes of a file by their frames, for each frame for which the file has some."""
    return {body.name: body.shapes for body in file.body if body.shapes is not None}


@functools.lru_cache(maxsize=8)
def _file(source: Text) -> ShapesFile:
    """Return the contents of a shape file, which are immutable and can therefore be cached."""
    return parse(ShapesFile, source)


def _as_bodies(model: ArmModel) -> dict[str, tuple[Shape, ...]]:
    """Return the collision bodies of an arm as shapes, by frame: what is drawn is what collides."""
    bodies = model.source.bodies
    return {frame: tuple(_shape(body) for body in bodies if body.frame == frame) for frame in model.frames}


def _shape(body: BodyFile) -> Shape:
    """Return a collision body as a shape to draw; a cylinder for a prism, which encloses it."""
    if isinstance(body, BlockBody):
        (x, y, z), (to_x, to_y, to_z) = plain_vector(body.low), plain_vector(body.high)
        centre, size = (0.5 * (x + to_x), 0.5 * (y + to_y), 0.5 * (z + to_z)), (to_x - x, to_y - y, to_z - z)
        return Box(material=body.material, position=centre, size=size)
    at, rotation = plain_vector(body.position), plain_vector(body.rotation)
    if isinstance(body, BoxBody):
        return Box(material="padding", position=at, rotation=rotation, size=plain_vector(body.size))
    length, radius = float(body.length), float(body.radius)
    return Cylinder(material="boom", position=at, rotation=rotation, axis=body.axis, length=length, radius=radius)


def _problems(file: ShapesFile, frames: tuple[str, ...]) -> Iterator[Problem]:
    """Yield a problem if the file does not list the arm's frames in order.

    Also yield a problem for each camera on an unknown frame.
    """
    allowed = ", ".join(frames)
    names = tuple(body.name for body in file.body)
    if names != frames:
        what = f"the frames have to be, in order, {allowed}; got {', '.join(names) or 'none'}"
        yield Problem(("body",), what)
    for i, camera in enumerate(file.camera):
        if camera.body not in frames:
            what = f"{camera.body!r} is not a frame of the arm; the frames are: {allowed}"
            yield Problem(("camera", i, "body"), what)
