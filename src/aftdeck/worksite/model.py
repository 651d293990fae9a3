"""The worksite: the bodies that stand round the arm, and the cameras fixed to them."""

from __future__ import annotations

import msgspec

from aftdeck.bodies.cameras import Camera
from aftdeck.shapes import Shape


class Body(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A rigid body of the worksite."""

    name: str
    """As cameras and the scene name it: ``orbiter``."""
    shapes: tuple[Shape, ...]
    """What it looks like, in its own frame."""


class Worksite(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A place of work. The first body's own frame is the scene frame."""

    name: str
    title: str
    bodies: tuple[Body, ...]
    cameras: tuple[Camera, ...]
    text: str
    """The file, as it was read."""
