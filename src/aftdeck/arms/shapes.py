"""Read how an arm looks: the shapes that each of its moving frames carries, and its cameras."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import msgspec

from aftdeck.bodies.cameras import Camera
from aftdeck.errors import ScenarioError
from aftdeck.files import Text, parse
from aftdeck.shapes import Shape


class ArmShapes(NamedTuple):
    """How an arm looks."""

    bodies: dict[str, tuple[Shape, ...]]
    """By frame, from the foot on."""
    cameras: tuple[Camera, ...]


class _Frame(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """One moving frame as the file lists it."""

    name: str
    shapes: tuple[Shape, ...]


class _File(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """An arm's shape file as it is written."""

    body: tuple[_Frame, ...]
    camera: tuple[Camera, ...]


def shapes_of(source: Text, frames: tuple[str, ...]) -> ArmShapes:
    """Shapes and cameras of an arm.

    Args:
        source: its shape file (TOML).
        frames: its frames' names, as its `Linkage` has them.

    Raises:
        ScenarioError: shapes that cannot be drawn, or other frames; says where.
    """
    file = parse(_File, source)
    if problems := list(_problems(file, frames)):
        raise ScenarioError([f"{source.name}: {problem}" for problem in problems])
    return ArmShapes({body.name: body.shapes for body in file.body}, file.camera)


def _problems(file: _File, frames: tuple[str, ...]) -> Iterator[str]:
    """Frames that are not the arm's, and cameras on none of them."""
    allowed = ", ".join(frames)
    names = tuple(body.name for body in file.body)
    if names != frames:
        yield f"body: the frames are {', '.join(names) or 'none'}; they have to be, in order, {allowed}"
    for i, camera in enumerate(file.camera):
        if camera.body not in frames:
            yield f"camera[{i}].body: {camera.body!r} is no frame of the arm; there are: {allowed}"
