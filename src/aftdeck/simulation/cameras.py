"""The cameras' drives in flight: a command turns one camera for one step, at its drive's rates, within its limits.

A step without a command costs nothing: the settings are one tuple, made anew only when a camera moves.
"""

from __future__ import annotations

import math

import msgspec

from aftdeck.bodies.cameras import Camera, Setting, Travel, setting
from aftdeck.errors import InputError
from aftdeck.scenario.cameras import cameras_of
from aftdeck.scenario.model import Scenario


class CameraDrive(msgspec.Struct, frozen=True, gc=False):
    """The switches that turn a camera, in one step; they spring back."""

    camera: str
    """Which camera, by its name."""
    pan: float = 0.0
    """In [-1, 1]; positive to the right in the picture."""
    tilt: float = 0.0
    """In [-1, 1]; positive upwards."""
    zoom: float = 0.0
    """In [-1, 1]; positive in, to a narrower field of view."""
    slow: bool = False
    """At the low speed, where the drive has two."""


Views = tuple[Setting, ...]
"""Where the drives stand of the cameras that have one, in the order of `Cameras.names`: a part of the state."""


class Cameras:
    """The cameras of a scenario that have a drive.

    Attributes:
        names: of these cameras, in the order of `scenario.cameras.cameras_of`.
        first: where their drives stand at the start.
    """

    def __init__(self, scenario: Scenario) -> None:
        self._driven = [camera for camera in cameras_of(scenario) if camera.drive is not None]
        self.names = tuple(camera.name for camera in self._driven)
        self.first: Views = tuple(setting(camera) for camera in self._driven)

    def check(self, command: CameraDrive) -> None:
        """Refuse what no switch can give.

        Raises:
            InputError: a camera that is none or has no drive, a switch outside [-1, 1] or not finite.
        """
        if command.camera not in self.names:
            there = ", ".join(self.names) or "none"
            raise InputError(f"no camera {command.camera!r} can be turned here: there are {there}")
        switches = (command.pan, command.tilt, command.zoom)
        if not all(math.isfinite(s) and -1.0 <= s <= 1.0 for s in switches):
            raise InputError(f"a camera's pan, tilt and zoom lie in [-1, 1], got {switches}")

    def driven(self, views: Views, command: CameraDrive, period: float) -> Views:
        """Return where the drives stand after one step of `period` [s]; a camera without one stays."""
        if command.camera not in self.names:
            return views
        i = self.names.index(command.camera)
        now = moved(self._driven[i], views[i], command, period)
        return views if now == views[i] else (*views[:i], now, *views[i + 1 :])


def moved(camera: Camera, at: Setting, command: CameraDrive, period: float) -> Setting:
    """A camera's setting after one step of a command, `period` [s] long."""
    drive = camera.drive
    if drive is None:
        return at
    return Setting(
        _along(drive.pan, at.pan, command.pan, command.slow, period),
        _along(drive.tilt, at.tilt, command.tilt, command.slow, period),
        _along(drive.zoom, at.zoom, -command.zoom, command.slow, period),
    )


def _along(travel: Travel | None, at: float, switch: float, slow: bool, period: float) -> float:
    """An angle [rad] one step later; it ends exactly at its stop."""
    if travel is None or switch == 0.0:
        return at
    rate = travel.slow if slow and travel.slow is not None else travel.rate
    return min(max(at + switch * rate * period, travel.least), travel.greatest)
