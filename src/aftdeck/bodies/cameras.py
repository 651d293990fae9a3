"""Cameras: position, boresight, field of view, and the ranges of the drives.

Pan rotates a camera about its `up` direction; positive pan is to the right in the picture. Tilt then raises the
boresight; positive tilt is upwards. In RMS-VS, pan is called heading, and tilt is called pitch: heading rotates about
Z, which points down, and positive pitch raises the boresight.
"""

from __future__ import annotations

from math import pi
from typing import Literal, NamedTuple, get_args

import msgspec

from aftdeck.elementary import atan2, sincos
from aftdeck.matrices import length
from aftdeck.tuples import Vec3

Kind = Literal["camera", "window", "engineering"]
KINDS: tuple[Kind, ...] = get_args(Kind)
"""Kinds of cameras: a television camera, an eye behind a window, or a view for engineers, which does not represent any
hardware."""


class Travel(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Range and rates of one of a camera's drives."""

    least: float
    """Least position [rad]."""
    greatest: float
    """Greatest position [rad]."""
    rate: float
    """Rate, or the high rate of a drive with two rates [rad/s]."""
    slow: float | None = None
    """Low rate of a drive with two rates [rad/s]; None if the drive has one rate."""

    def __post_init__(self) -> None:
        """Raise ValueError if `least` is not less than `greatest`, or a rate is not above zero."""
        if not self.least < self.greatest:
            raise ValueError(
                f"least is {self.least:g} and greatest is {self.greatest:g}; least has to be less than greatest"
            )
        for name, rate in (("rate", self.rate), ("slow", self.slow)):
            if rate is not None and not rate > 0.0:
                raise ValueError(f"{name} is {rate:g}; it has to be above 0")


class Drive(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Pan and tilt unit with its lens. If `pan`, `tilt` or `zoom` is None, it stays at the camera's initial setting."""

    zero: Vec3
    """Direction of zero pan and tilt in the body's frame, perpendicular to the camera's `up`."""
    lens: float
    """Distance of the lens ahead of the intersection of the pan and tilt axes [m]."""
    pan: Travel | None
    tilt: Travel | None
    zoom: Travel | None
    """Range and rates of the horizontal field of view."""


class Pane(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Opening of a window, perpendicular to the line of sight and centred on it.

    The picture shows only objects that are beyond the opening and visible through it.
    """

    distance: float
    """Distance from the eye [m]."""
    width: float
    """Width of the opening [m]."""
    height: float
    """Height of the opening [m]."""

    def __post_init__(self) -> None:
        """Raise ValueError if a dimension is not above zero."""
        for name, size in (("distance", self.distance), ("width", self.width), ("height", self.height)):
            if not size > 0.0:
                raise ValueError(f"the pane's {name} is {size:g}; it has to be above 0")


class Camera(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Television camera, window eye or engineering view on a body, with its initial setting."""

    name: str
    """Short name on the selector, such as ``B``."""
    title: str
    """Full name, such as ``Aft bulkhead port``."""
    body: str
    """Name of the body that carries the camera."""
    position: Vec3
    """Position of the lens in the body's frame [m]."""
    boresight: Vec3
    """Direction of view in the body's frame (any length above zero)."""
    up: Vec3
    """Direction in the body's frame that is up in the picture. It is the pan axis, and it is not parallel to the
    boresight."""
    field_of_view: float
    """Horizontal field of view [rad]."""
    drive: Drive | None = None
    """Pan and tilt unit; None if the camera is fixed."""
    kind: Kind = "camera"
    pane: Pane | None = None
    """Opening of a window; None for any other kind."""
    inside: str = ""
    """Name of the part that contains the lens by design, such as the cabin around an eye behind a window; empty if this
    is a housing of the camera's own."""

    @property
    def housing(self) -> str:
        """Name of the part that contains the lens by design."""
        return self.inside or housing_of(self.name)

    def __post_init__(self) -> None:
        """Raise ValueError if the fields do not define a picture, or if `pane` or `drive` does not fit the kind."""
        if (self.kind == "window") != (self.pane is not None):
            raise ValueError(
                f"{self.name} is of kind {self.kind}; a window needs a pane, and other kinds cannot have one"
            )
        if self.kind != "camera" and self.drive is not None:
            raise ValueError(f"{self.name} is of kind {self.kind}; only the kind camera can have a drive")
        if not 0.0 < self.field_of_view < pi:
            raise ValueError(
                f"camera {self.name}'s field_of_view is {self.field_of_view:g}; it has to be between 0 and pi"
            )
        if along(self.boresight, self.up):
            raise ValueError(f"camera {self.name}: boresight and up have to be different directions")


def housing_of(name: str) -> str:
    """Return the name of the part that is the housing of a camera's own."""
    return f"camera {name}"


class Setting(NamedTuple):
    """Setting of a camera's drives.

    Attributes:
        pan: pan angle, positive to the right in the picture [rad].
        tilt: tilt angle, positive upwards [rad].
        zoom: horizontal field of view [rad].
    """

    pan: float
    tilt: float
    zoom: float


class View(NamedTuple):
    """View of a camera: the fields of `Camera` that its drives change.

    Attributes:
        position: position of the lens, in the body's frame [m].
        boresight: unit direction of view, in the body's frame.
        up: unit direction that is up in the picture, in the body's frame.
        field_of_view: horizontal field of view [rad].
    """

    position: Vec3
    boresight: Vec3
    up: Vec3
    field_of_view: float


def setting(camera: Camera) -> Setting:
    """Return the initial setting of the drives; pan in (-pi, pi], tilt in [-pi/2, pi/2]."""
    x, y, z = (_dot(camera.boresight, axis) for axis in _axes(camera))
    return Setting(atan2(y, x), atan2(z, length((x, y))), camera.field_of_view)


def view(camera: Camera, at: Setting) -> View:
    """Return the view with the drives at a setting.

    If the tilt is beyond 90 deg, the camera looks backwards, and the picture is upside down.
    """
    ahead, right, up = _axes(camera)
    (sp, cp), (st, ct) = sincos(at.pan), sincos(at.tilt)
    level = _sum((cp, ahead), (sp, right))
    boresight = _sum((ct, level), (st, up))
    lens = 0.0 if camera.drive is None else camera.drive.lens
    position = _sum((1.0, camera.position), (-lens, _unit(camera.boresight)), (lens, boresight))
    return View(position, boresight, _sum((ct, up), (-st, level)), at.zoom)


def along(a: Vec3, b: Vec3) -> bool:
    """Return whether two directions are parallel or opposite, or one of them has zero length."""
    return not length(_cross(a, b)) > 1e-9 * length(a) * length(b)


def mount(camera: Camera) -> tuple[Vec3, Vec3, Vec3]:
    """Return the axes of a camera's mount in the body's frame: ahead at zero pan and tilt, left, and up."""
    ahead, (x, y, z), up = _axes(camera)
    return ahead, (-x, -y, -z), up


def square(direction: Vec3, up: Vec3) -> Vec3:
    """Return the unit direction perpendicular to `up` that is nearest to `direction`.

    `direction` must not be parallel to `up`.
    """
    upward = _unit(up)
    return _unit(_cross(upward, _cross(direction, upward)))


def _axes(camera: Camera) -> tuple[Vec3, Vec3, Vec3]:
    """Return the unit directions ahead (zero pan and tilt), right and up, in the body's frame."""
    up = _unit(camera.up)
    ahead = square(camera.boresight if camera.drive is None else camera.drive.zero, up)
    return ahead, _cross(ahead, up), up


def _cross(a: Vec3, b: Vec3) -> Vec3:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def _dot(a: Vec3, b: Vec3) -> float:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def _unit(a: Vec3) -> Vec3:
    size = length(a)
    return a[0] / size, a[1] / size, a[2] / size


def _sum(*terms: tuple[float, Vec3]) -> Vec3:
    x, y, z = 0.0, 0.0, 0.0
    for factor, vector in terms:
        x, y, z = x + factor * vector[0], y + factor * vector[1], z + factor * vector[2]
    return x, y, z
