"""Appearance of an arm: the shapes in each of its moving frames, and its cameras."""

from __future__ import annotations

import functools
from collections.abc import Iterator
from typing import NamedTuple

import msgspec

from aftdeck.arms.blocks import Block, blocks_of
from aftdeck.arms.fairings import fairings_of
from aftdeck.arms.load import ArmModel
from aftdeck.arms.model import BoxBody, ChainArmFile, HeadingArmFile, PrismBody
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
    shapes: tuple[Shape, ...]
    details: tuple[Shape, ...] = ()
    """Shapes that only decorate the arm. Only the station's page draws them. They cannot be lamps."""

    def __post_init__(self) -> None:
        """Reject a lamp among the details (ValueError)."""
        without_lamps(self.details)


class ShapesFile(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Contents of an arm's shape file."""

    body: tuple[_Frame, ...]
    camera: tuple[CameraFile, ...]
    drive: tuple[DriveFile, ...] = ()


def shapes_of(model: ArmModel) -> ArmShapes:
    """Return an arm's shapes and cameras from its shape file.

    For a concept arm without a shape file, the shapes are computed from the arm's dimensions, and for a chain they are
    its collision bodies. Without a shape file, an arm of the family of the Shuttle's arm has no shapes.

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
        return ArmShapes({body.name: body.shapes for body in file.body}, details, cameras)
    if isinstance(model.source, ChainArmFile):
        return ArmShapes(_as_covered(model.source, model.frames), dict.fromkeys(model.frames, ()), ())
    if not isinstance(model.source, HeadingArmFile):
        return ArmShapes(dict.fromkeys(model.frames, ()), dict.fromkeys(model.frames, ()), ())
    blocks = blocks_of(model.source, model.linkage.frames)
    fairings = fairings_of(model.source, model.linkage.frames)
    return ArmShapes(
        {frame: tuple(_box(block) for block in blocks if block.frame == frame) for frame in model.frames},
        {frame: fairings.get(frame, ()) for frame in model.frames},
        (),
    )


@functools.lru_cache(maxsize=8)
def _file(source: Text) -> ShapesFile:
    """Return the contents of a shape file, which are immutable and can therefore be cached."""
    return parse(ShapesFile, source)


def _as_covered(file: ChainArmFile, frames: tuple[str, ...]) -> dict[str, tuple[Shape, ...]]:
    """Return the collision bodies of a chain as shapes, by frame: what is drawn is what collides."""
    return {frame: tuple(_shape(body) for body in file.bodies if body.frame == frame) for frame in frames}


def _shape(body: BoxBody | PrismBody) -> Shape:
    """Return a collision body as a shape to draw; a cylinder for a prism, which encloses it."""
    at, rotation = plain_vector(body.position), plain_vector(body.rotation)
    if isinstance(body, BoxBody):
        return Box(material="padding", position=at, rotation=rotation, size=plain_vector(body.size))
    length, radius = float(body.length), float(body.radius)
    return Cylinder(material="boom", position=at, rotation=rotation, axis=body.axis, length=length, radius=radius)


def _box(block: Block) -> Box:
    """Return a block as a box to draw."""
    (x, y, z), (to_x, to_y, to_z) = block.low, block.high
    return Box(
        material=block.material,
        position=(0.5 * (x + to_x), 0.5 * (y + to_y), 0.5 * (z + to_z)),
        size=(to_x - x, to_y - y, to_z - z),
    )


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
