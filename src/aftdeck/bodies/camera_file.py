"""Types of the cameras and drives in a worksite file or in an arm's shape file. These files give values with units."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated

import msgspec

from aftdeck.bodies.cameras import Camera, Drive, Kind, Pane, Travel, along, setting, square
from aftdeck.bounds import DIRECTION
from aftdeck.files import Problem
from aftdeck.units import Angle, AngularRate, Length

Direction = tuple[Annotated[float, DIRECTION], Annotated[float, DIRECTION], Annotated[float, DIRECTION]]
"""Direction in the axes of a body, of any length above zero."""


class TravelFile(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Range and rates of one drive."""

    least: Angle
    greatest: Angle
    rate: AngularRate
    slow: AngularRate | None = None

    def __post_init__(self) -> None:
        """Raise ValueError if `Travel` rejects the values."""
        self.travel()

    def travel(self) -> Travel:
        """Return these values as a `Travel`, in SI units."""
        slow = None if self.slow is None else float(self.slow)
        return Travel(float(self.least), float(self.greatest), float(self.rate), slow)


class DriveFile(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Pan and tilt unit with its lens; several cameras may name the same drive."""

    name: str
    source: str
    """Source of the values, or ``assumed``."""
    lens: Length = Length(0.0)
    """Distance of the lens ahead of the intersection of the pan and tilt axes."""
    pan: TravelFile | None = None
    tilt: TravelFile | None = None
    zoom: TravelFile | None = None


class PaneFile(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A window's opening."""

    distance: Length
    """Distance from the eye to the opening."""
    width: Length
    height: Length

    def __post_init__(self) -> None:
        """Raise ValueError if `Pane` rejects the values."""
        self.pane()

    def pane(self) -> Pane:
        """Return these values as a `Pane`, in SI units."""
        return Pane(float(self.distance), float(self.width), float(self.height))


class CameraFile(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Camera with its initial setting. Fields without a description are described in `Camera`."""

    name: str
    title: str
    body: str
    position: tuple[Length, Length, Length]
    boresight: Direction
    up: Direction
    field_of_view: Angle
    source: str
    """Source of the values, or ``assumed``."""
    drive: str | None = None
    """Name of the drive that moves the camera; None if the camera is fixed."""
    zero: Direction | None = None
    """Direction of zero pan and tilt; its component along `up` is removed. None to use the boresight."""
    kind: Kind = "camera"
    pane: PaneFile | None = None
    """Opening of a window; None for any other kind."""
    inside: str = ""

    def __post_init__(self) -> None:
        """Raise ValueError if `Camera` rejects the values, or if `zero` has zero length or is parallel to `up`."""
        self._camera(None)
        if along(self.zero or self.boresight, self.up):
            raise ValueError(f"camera {self.name}: zero and up have to be different directions")

    def _camera(self, drive: Drive | None) -> Camera:
        x, y, z = map(float, self.position)
        pane = None if self.pane is None else self.pane.pane()
        angle = float(self.field_of_view)
        return Camera(
            self.name,
            self.title,
            self.body,
            (x, y, z),
            self.boresight,
            self.up,
            angle,
            drive,
            self.kind,
            pane,
            self.inside,
        )

    def camera(self, drives: Sequence[DriveFile]) -> Camera:
        """Return the camera with its drive.

        Raises:
            ValueError: no drive has the name in `drive`, the initial setting is outside the drive's ranges, or a camera
                of this kind cannot have a drive.
        """
        if self.drive is None:
            return self._camera(None)
        file = next((drive for drive in drives if drive.name == self.drive), None)
        if file is None:
            choices = ", ".join(drive.name for drive in drives) or "none"
            raise ValueError(f"camera {self.name}: no drive {self.drive!r}; the drives are: {choices}")
        pan, tilt, zoom = (None if part is None else part.travel() for part in (file.pan, file.tilt, file.zoom))
        camera = self._camera(Drive(square(self.zero or self.boresight, self.up), float(file.lens), pan, tilt, zoom))
        start = setting(camera)
        for name, travel, angle in zip(start._fields, (pan, tilt, zoom), start, strict=True):
            if travel is not None and not travel.least <= angle <= travel.greatest:
                raise ValueError(
                    f"camera {self.name} starts with a {name} of {angle:.4g} rad; the range of drive "
                    f"{self.drive!r} is {travel.least:.4g} to {travel.greatest:.4g} rad"
                )
        return camera


def cameras_of(files: Sequence[CameraFile], drives: Sequence[DriveFile]) -> tuple[tuple[Camera, ...], list[Problem]]:
    """Return the valid cameras of a file, and a problem, with its place in the file, for each invalid camera."""
    cameras, problems = [], []
    for i, file in enumerate(files):
        try:
            cameras.append(file.camera(drives))
        except ValueError as error:
            problems.append(Problem(("camera", i), str(error)))
    return tuple(cameras), problems
