"""Camera drives: a command moves one camera for one step, at the rates and within the limits of its drive.

The settings of all cameras are one tuple, which is replaced only when a camera moves. A step without a command
therefore needs no computation.
"""

from __future__ import annotations

import math

import msgspec

from aftdeck.bodies.cameras import Camera, Setting, Travel
from aftdeck.errors import InputError
from aftdeck.scenario.all_cameras import cameras_of, first_setting
from aftdeck.scenario.camera_settings import misfit
from aftdeck.scenario.model import Scenario


class CameraDrive(msgspec.Struct, frozen=True, gc=False):
    """Switches that drive one camera in one step; after the step they are at zero again."""

    camera: str
    """Name of the camera."""
    pan: float = 0.0
    """Pan switch in [-1, 1]; positive to the right in the picture."""
    tilt: float = 0.0
    """Tilt switch in [-1, 1]; positive upwards."""
    zoom: float = 0.0
    """Zoom switch in [-1, 1]; positive zooms in, to a narrower field of view."""
    slow: bool = False
    """Whether to use the low speed, if the drive has two speeds."""


Views = tuple[Setting, ...]
"""Drive settings of the cameras that have a drive, in the order of `Cameras.names`; part of the state."""


class Cameras:
    """Cameras of a scenario that have a drive.

    Attributes:
        names: names of these cameras, in the order of `scenario.all_cameras.cameras_of`.
        first: drive settings of these cameras at the start.
    """

    def __init__(self, scenario: Scenario) -> None:
        self._driven = [camera for camera in cameras_of(scenario) if camera.drive is not None]
        self.names = tuple(camera.name for camera in self._driven)
        self.first: Views = tuple(first_setting(scenario, camera) for camera in self._driven)

    def check(self, command: CameraDrive) -> None:
        """Check that a command names a camera with a drive and that its switches are within their range.

        Raises:
            InputError: the camera does not exist or has no drive, or a switch is outside [-1, 1] or not finite.
        """
        if command.camera not in self.names:
            driven = ", ".join(self.names) or "none"
            raise InputError(f"camera {command.camera!r} cannot be moved; cameras with a drive: {driven}")
        switches = {"pan": command.pan, "tilt": command.tilt, "zoom": command.zoom}
        for name, switch in switches.items():
            if not (math.isfinite(switch) and -1.0 <= switch <= 1.0):
                raise InputError(f"camera.{name}: got {switch}, expected a number in [-1, 1]")

    @property
    def axes(self) -> list[tuple[object, ...]]:
        """For each of these cameras, its name and whether its drive pans, tilts and zooms."""
        drives = [(one.name, one.drive) for one in self._driven]
        return [(name, *(getattr(drive, part) is not None for part in Setting._fields)) for name, drive in drives]

    def misfit(self, name: str, at: Setting) -> str:
        """Return why a camera's drive cannot have a setting; "" if it can. What the drive does not move is free."""
        drive = self._driven[self.names.index(name)].drive
        moved = () if drive is None else [part for part in Setting._fields if getattr(drive, part) is not None]
        found = [misfit(drive, part, getattr(at, part)) for part in moved if drive is not None]
        return next(filter(None, found), "")

    def driven(self, views: Views, command: CameraDrive, period: float) -> Views:
        """Return the drive settings after one step with a command; the step lasts `period` [s].

        If the command changes nothing, the result is `views` itself.
        """
        if command.camera not in self.names:
            return views
        i = self.names.index(command.camera)
        now = driven_setting(self._driven[i], views[i], command, period)
        return views if now == views[i] else (*views[:i], now, *views[i + 1 :])


def driven_setting(camera: Camera, at: Setting, command: CameraDrive, period: float) -> Setting:
    """Return a camera's setting after one step with a command; the step lasts `period` [s]."""
    drive = camera.drive
    if drive is None:
        return at
    return Setting(
        _along(drive.pan, at.pan, command.pan, command.slow, period),
        _along(drive.tilt, at.tilt, command.tilt, command.slow, period),
        _along(drive.zoom, at.zoom, -command.zoom, command.slow, period),
    )


def _along(travel: Travel | None, at: float, switch: float, slow: bool, period: float) -> float:
    """Return a drive's angle [rad] one step later; it stays within the drive's stops."""
    if travel is None or switch == 0.0:
        return at
    rate = travel.slow if slow and travel.slow is not None else travel.rate
    return min(max(at + switch * rate * period, travel.least), travel.greatest)
