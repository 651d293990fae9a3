"""Cameras and their drives as a worksite's or an arm's file lists them, in quantities."""

from __future__ import annotations

from collections.abc import Sequence

import msgspec

from aftdeck.bodies.cameras import Camera, Drive, Kind, Pane, Travel, Vec3, along, setting, square
from aftdeck.files import Problem
from aftdeck.units import Angle, AngularRate, Length


class TravelFile(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """The range and the rates of one drive."""

    least: Angle
    greatest: Angle
    rate: AngularRate
    slow: AngularRate | None = None

    def __post_init__(self) -> None:
        """Refuse what `Travel` refuses (ValueError)."""
        self.travel()

    def travel(self) -> Travel:
        """The same, as the scene has it."""
        slow = None if self.slow is None else float(self.slow)
        return Travel(float(self.least), float(self.greatest), float(self.rate), slow)


class DriveFile(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A kind of pan and tilt unit with its lens, which several cameras may have."""

    name: str
    source: str
    """Where its numbers come from, or ``assumed``."""
    lens: Length = Length(0.0)
    """How far the lens stands ahead of where the axes of pan and tilt meet."""
    pan: TravelFile | None = None
    tilt: TravelFile | None = None
    zoom: TravelFile | None = None


class PaneFile(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A window's opening."""

    distance: Length
    """From the eye to it."""
    width: Length
    height: Length

    def __post_init__(self) -> None:
        """Refuse what `Pane` refuses (ValueError)."""
        self.pane()

    def pane(self) -> Pane:
        """The same, as the scene has it."""
        return Pane(float(self.distance), float(self.width), float(self.height))


class CameraFile(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A camera, as it is set at the start; the fields are those of `Camera`."""

    name: str
    title: str
    body: str
    position: tuple[Length, Length, Length]
    boresight: Vec3
    up: Vec3
    field_of_view: Angle
    source: str
    """Where its numbers come from, or ``assumed``."""
    drive: str | None = None
    """Name of the drive that turns it; None: it is fixed."""
    zero: Vec3 | None = None
    """Direction in which pan and tilt are zero; None: the boresight. It is made square to `up`."""
    kind: Kind = "camera"
    pane: PaneFile | None = None
    """Of a window: its opening."""

    def __post_init__(self) -> None:
        """Refuse what `Camera` refuses, and a zero direction that is none (ValueError)."""
        self._camera(None)
        if along(self.zero or self.boresight, self.up):
            raise ValueError(f"camera {self.name}'s zero and up have to be two different directions")

    def _camera(self, drive: Drive | None) -> Camera:
        x, y, z = map(float, self.position)
        pane = None if self.pane is None else self.pane.pane()
        angle = float(self.field_of_view)
        return Camera(
            self.name, self.title, self.body, (x, y, z), self.boresight, self.up, angle, drive, self.kind, pane
        )

    def camera(self, drives: Sequence[DriveFile]) -> Camera:
        """The camera with its drive.

        Raises:
            ValueError: none of the drives has that name, the camera starts outside of its ranges, or it is no
                camera that could have a drive.
        """
        if self.drive is None:
            return self._camera(None)
        file = next((drive for drive in drives if drive.name == self.drive), None)
        if file is None:
            there = ", ".join(drive.name for drive in drives) or "none"
            raise ValueError(f"camera {self.name}'s drive {self.drive!r} is not listed; there are: {there}")
        pan, tilt, zoom = (None if part is None else part.travel() for part in (file.pan, file.tilt, file.zoom))
        camera = self._camera(Drive(square(self.zero or self.boresight, self.up), float(file.lens), pan, tilt, zoom))
        start = setting(camera)
        for name, travel, angle in zip(start._fields, (pan, tilt, zoom), start, strict=True):
            if travel is not None and not travel.least <= angle <= travel.greatest:
                raise ValueError(
                    f"camera {self.name} starts with a {name} of {angle:.4g} rad; its drive {self.drive!r} goes from "
                    f"{travel.least:.4g} to {travel.greatest:.4g}"
                )
        return camera


def cameras_of(files: Sequence[CameraFile], drives: Sequence[DriveFile]) -> tuple[tuple[Camera, ...], list[Problem]]:
    """The cameras of a file, and why, with its place in the file, for each one that cannot be had."""
    cameras, problems = [], []
    for i, file in enumerate(files):
        try:
            cameras.append(file.camera(drives))
        except ValueError as error:
            problems.append(Problem(("camera", i), str(error)))
    return tuple(cameras), problems
