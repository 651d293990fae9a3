"""Cameras: where a camera stands, where it looks, how wide, and how far it can be turned.

Pan turns a camera about its `up` direction, positive to the right in its picture; tilt then raises its view, positive
upwards. That is the report's heading and pitch: heading about Z, which points down, and pitch that lifts.
"""

from __future__ import annotations

from math import atan2, cos, hypot, pi, sin
from typing import Literal, NamedTuple, get_args

import msgspec

Vec3 = tuple[float, float, float]
Kind = Literal["camera", "window", "engineering"]
KINDS: tuple[Kind, ...] = get_args(Kind)
"""What a picture can come from: a television camera; an eye behind a window; nothing that flies along."""


class Travel(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """How far and how fast one of a camera's drives goes."""

    least: float
    """[rad]"""
    greatest: float
    """[rad]"""
    rate: float
    """[rad/s]"""
    slow: float | None = None
    """Its low speed, where it has two [rad/s]."""

    def __post_init__(self) -> None:
        """Refuse a range without an inside, and rates that are not above zero (ValueError)."""
        if not self.least < self.greatest:
            raise ValueError(f"least is {self.least:g} and greatest {self.greatest:g}; least has to be less")
        for name, rate in (("rate", self.rate), ("slow", self.slow)):
            if rate is not None and not rate > 0.0:
                raise ValueError(f"{name} is {rate:g}; it has to be above 0")


class Drive(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A pan and tilt unit with its lens; what it has no drive for stays as the camera has it."""

    zero: Vec3
    """Direction in the body's frame in which pan and tilt are zero, square to the camera's `up`."""
    lens: float
    """How far the lens stands ahead of where the axes of pan and tilt meet [m]."""
    pan: Travel | None
    tilt: Travel | None
    zoom: Travel | None
    """Of the horizontal field of view."""


class Pane(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A window's opening, square to the line of sight through its middle: nothing is seen beside it or before it."""

    distance: float
    """From the eye [m]."""
    width: float
    """[m]"""
    height: float
    """[m]"""

    def __post_init__(self) -> None:
        """Refuse an opening that is none (ValueError)."""
        for name, size in (("distance", self.distance), ("width", self.width), ("height", self.height)):
            if not size > 0.0:
                raise ValueError(f"the pane's {name} is {size:g}; it has to be above 0")


class Camera(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A television camera on a body, as it is set at the start; or an eye that looks from there."""

    name: str
    """Short name on the selector: ``B``."""
    title: str
    """``Aft bulkhead port``."""
    body: str
    """Name of the body that carries it."""
    position: Vec3
    """Lens, in the body's frame [m]."""
    boresight: Vec3
    """Direction of view in the body's frame (any length above zero)."""
    up: Vec3
    """Direction in the body's frame that is up in the picture, not along the boresight; the axis of pan."""
    field_of_view: float
    """Horizontal field of view [rad]."""
    drive: Drive | None = None
    """How it can be turned; None: it is fixed."""
    kind: Kind = "camera"
    pane: Pane | None = None
    """What a window leaves open; of windows alone."""

    def __post_init__(self) -> None:
        """Refuse a camera that can make no picture, and a window without its pane (ValueError)."""
        if (self.kind == "window") != (self.pane is not None):
            raise ValueError(f"{self.name} is a {self.kind}; a window has a pane, and nothing else has one")
        if self.kind != "camera" and self.drive is not None:
            raise ValueError(f"{self.name} is a {self.kind}; only a camera has a drive")
        if not 0.0 < self.field_of_view < pi:
            raise ValueError(
                f"camera {self.name}'s field_of_view is {self.field_of_view:g}; it has to be between 0 and pi"
            )
        if along(self.boresight, self.up):
            raise ValueError(f"camera {self.name}'s boresight and up have to be two different directions")


class Setting(NamedTuple):
    """Where a camera's drives stand.

    Attributes:
        pan: [rad], positive to the right in the picture.
        tilt: [rad], positive upwards.
        zoom: horizontal field of view [rad].
    """

    pan: float
    tilt: float
    zoom: float


class View(NamedTuple):
    """What a camera shows: the parts of a `Camera` that its drives change.

    Attributes:
        position: lens, in the body's frame [m].
        boresight: unit direction of view.
        up: unit direction that is up in the picture.
        field_of_view: horizontal [rad].
    """

    position: Vec3
    boresight: Vec3
    up: Vec3
    field_of_view: float


def setting(camera: Camera) -> Setting:
    """Where the drives stand at the start; pan in (-pi, pi], tilt in [-pi/2, pi/2]."""
    x, y, z = (_dot(camera.boresight, axis) for axis in _axes(camera))
    return Setting(atan2(y, x), atan2(z, hypot(x, y)), camera.field_of_view)


def view(camera: Camera, at: Setting) -> View:
    """What the camera shows with its drives at a setting; beyond a quarter turn of tilt it looks over its back."""
    ahead, right, up = _axes(camera)
    (cp, sp), (ct, st) = ((cos(angle), sin(angle)) for angle in (at.pan, at.tilt))
    level = _sum((cp, ahead), (sp, right))
    boresight = _sum((ct, level), (st, up))
    lens = 0.0 if camera.drive is None else camera.drive.lens
    position = _sum((1.0, camera.position), (-lens, _unit(camera.boresight)), (lens, boresight))
    return View(position, boresight, _sum((ct, up), (-st, level)), at.zoom)


def along(a: Vec3, b: Vec3) -> bool:
    """Whether two directions are the same, opposite, or none."""
    return not hypot(*_cross(a, b)) > 1e-9 * hypot(*a) * hypot(*b)


def square(direction: Vec3, up: Vec3) -> Vec3:
    """The unit direction square to `up` that comes nearest to a direction which is not along it."""
    upward = _unit(up)
    return _unit(_cross(upward, _cross(direction, upward)))


def _axes(camera: Camera) -> tuple[Vec3, Vec3, Vec3]:
    """Unit directions ahead at zero pan and tilt, to the right, and up."""
    up = _unit(camera.up)
    ahead = square(camera.boresight if camera.drive is None else camera.drive.zero, up)
    return ahead, _cross(ahead, up), up


def _cross(a: Vec3, b: Vec3) -> Vec3:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def _dot(a: Vec3, b: Vec3) -> float:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def _unit(a: Vec3) -> Vec3:
    size = hypot(*a)
    return a[0] / size, a[1] / size, a[2] / size


def _sum(*terms: tuple[float, Vec3]) -> Vec3:
    x, y, z = (sum(factor * vector[k] for factor, vector in terms) for k in range(3))
    return x, y, z
