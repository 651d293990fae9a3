"""Checks of the commands from a page, and their conversion to inputs of the simulation."""

from __future__ import annotations

from collections.abc import Collection, Sequence

import msgspec
import numpy as np

from aftdeck.arms.by_joint import implausible
from aftdeck.bodies.cameras import Camera
from aftdeck.errors import CommandError
from aftdeck.kinematics.arm import Arm
from aftdeck.matrices import lengths
from aftdeck.recording.records import ControllerRecord
from aftdeck.scenario.light import Lighting
from aftdeck.scenario.target import target_at
from aftdeck.simulation.inputs import Inputs
from aftdeck.station.messages import from_page
from aftdeck.station.messages.welcome import Welcome

MAX_COMPONENT = 1000.0
"""Largest magnitude of a component of a keyed-in position [m]; the arm reaches 16 m."""
MAX_ANGLE = 100.0
"""Largest magnitude of an angle of a keyed-in attitude [rad]."""

LEAST_SINE = 1e-3
"""Least sine of the angle between an eye's direction of view and its direction upwards, both unit vectors."""

_SWITCHES: dict[type, tuple[str, str]] = {
    from_page.EnterMode: ("mode", "mode"),
    from_page.SelectJoint: ("joint", "joint"),
    from_page.SelectLaw: ("law", "law"),
    from_page.SelectRate: ("rate", "rate"),
    from_page.PayloadAxes: ("payload_axes", "on"),
    from_page.PositionHold: ("position_hold", "on"),
    from_page.SetBrakes: ("brakes", "on"),
    from_page.SetSafing: ("safing", "on"),
    from_page.SetEffector: ("effector", "switch"),
    from_page.SetEffectorMode: ("effector_mode", "mode"),
    from_page.SetRigid: ("rigid", "rigid"),
    from_page.PressLatch: ("latch", "latch"),
    from_page.SetMaster: ("master", "angles"),
    from_page.Initialise: ("initialise", "part"),
}
"""Messages that set one switch. For each: the field of `Inputs`, and the field of the message that holds the value."""


def travel(sticks: from_page.Sticks | from_page.Pulse) -> tuple[float, ...]:
    """Return the deflections of all sticks, and of all switches that spring back to their centre."""
    return (*sticks.translation, *sticks.rotation, sticks.drive, sticks.telescope, *sticks.orbiter)


def check_sticks(sticks: from_page.Sticks) -> None:
    """Raise `CommandError` if a deflection is not between -1 and 1."""
    if not all(-1.0 <= s <= 1.0 for s in travel(sticks)):
        raise CommandError("sticks must be between -1 and 1; this message was rejected")


def check_camera(message: from_page.DriveCamera, welcome: Welcome) -> None:
    """Raise `CommandError` if the camera does not exist or has no drive, or if pan, tilt or zoom is not in [-1, 1]."""
    driven = [camera.name for camera in welcome.cameras if camera.drive is not None]
    if message.camera not in driven:
        names = ", ".join(driven) or "none"
        raise CommandError(f"camera {message.camera!r} cannot be moved; cameras with a drive: {names}")
    if not all(-1.0 <= s <= 1.0 for s in (message.pan, message.tilt, message.zoom)):
        raise CommandError("pan, tilt and zoom must be between -1 and 1; this message was rejected")


def check_shown(message: from_page.Shown, welcome: Welcome) -> None:
    """Raise `CommandError` if a camera does not exist."""
    _check_names("camera", [name for monitor in message.monitors for name in monitor], _cameras(welcome))


def check_polygons(message: from_page.ShowPolygons, welcome: Welcome) -> None:
    """Raise `CommandError` if a camera does not exist, or cannot be directed by the page."""
    check_pictures(message.pictures, welcome.cameras)


def check_pictures(pictures: Sequence[from_page.PolygonPicture], cameras: Sequence[Camera]) -> None:
    """Raise `CommandError` if a picture's camera does not exist, or cannot be directed by the page."""
    _check_names("camera", [picture.camera for picture in pictures], [camera.name for camera in cameras])
    free = [camera.name for camera in cameras if camera.kind == "engineering"]
    _check_names("engineering view", [picture.camera for picture in pictures if picture.eye is not None], free)
    for picture in pictures:
        if picture.eye is not None and lengths(np.cross(picture.eye.ahead, picture.eye.up)) < LEAST_SINE:
            raise CommandError("the direction of view and the direction upwards have to differ, and not be zero")


def check_light(lighting: Lighting, welcome: Welcome) -> None:
    """Raise `CommandError` if a light condition, a lamp or a camera does not exist."""
    _check_names("light condition", [lighting.condition], [condition.name for condition in welcome.conditions])
    _check_names("lamp", lighting.lamps, welcome.lamps)
    _check_names("camera", [locked.camera for locked in lighting.locked], _cameras(welcome))


def check_switch(message: from_page.FromPage, welcome: Welcome) -> None:
    """Raise `CommandError` if a switch position does not exist or a target exceeds `MAX_COMPONENT` or `MAX_ANGLE`.

    The axes of a pulse have to be -1, 0 or 1.
    """
    match message:
        case from_page.Pulse() if not all(s in (-1.0, 0.0, 1.0) for s in travel(message)):
            raise CommandError(f"the axes of a pulse must be -1, 0 or 1, got {travel(message)}")
        case from_page.SelectJoint(joint=joint) if not 0 <= joint < len(welcome.joints):
            raise CommandError(f"joints are numbered 0 to {len(welcome.joints) - 1}, got {joint}")
        case from_page.SetMaster(angles=angles) if len(angles) != len(welcome.joints):
            raise CommandError(f"the master arm has {len(welcome.joints)} joints, got {len(angles)} angles")
        case from_page.SetMaster(angles=angles) if why := implausible([j.slides for j in welcome.joints], angles):
            raise CommandError(f"master arm: {why}")
        case from_page.EnterMode(mode=mode) if mode not in {m.position for m in welcome.modes}:
            known = ", ".join(m.position for m in welcome.modes)
            raise CommandError(f"unknown mode {mode!r}; allowed: {known}")
        case from_page.SetTarget(position=position, attitude=attitude) if not (
            all(abs(x) <= MAX_COMPONENT for x in position) and all(abs(x) <= MAX_ANGLE for x in attitude)
        ):
            raise CommandError(
                f"components of a target must be at most {MAX_COMPONENT:g} m and {MAX_ANGLE:g} rad, got {position} m, "
                f"{attitude} rad"
            )
        case _:
            pass


def inputs_of(sticks: from_page.Sticks, message: from_page.FromPage | None, arm: Arm) -> Inputs:
    """Return the inputs of one step: the sticks, and at most one message that sets a switch.

    Args:
        sticks: deflections from the page in control.
        message: checked command of the page for this step; None if no command waits.
        arm: the arm; it converts a keyed-in target from panel components to the pose of frame 7 in L.
    """
    inputs = Inputs(
        translation=sticks.translation,
        rotation=sticks.rotation,
        drive=sticks.drive,
        telescope=sticks.telescope,
        orbiter=sticks.orbiter,
    )
    if type(message) in _SWITCHES:
        field, value = _SWITCHES[type(message)]
        return msgspec.structs.replace(inputs, **{field: getattr(message, value)})
    match message:
        case from_page.RateHold():
            return msgspec.structs.replace(inputs, rate_hold=True)
        case from_page.SetTarget():
            return msgspec.structs.replace(inputs, target=target_at(arm.from_panel(message.position, message.attitude)))
        case from_page.Proceed():
            return msgspec.structs.replace(inputs, proceed=True)
        case from_page.Stop():
            return Inputs(stop=True, effector="stop")
        case _:
            return inputs


def controller_records(message: from_page.Controllers) -> tuple[ControllerRecord, ...]:
    """Return the hand controllers in use, in the form in which they are recorded."""
    return tuple(
        ControllerRecord(used.kind, used.name, used.deadband, used.expo, used.bindings, used.centres)
        for used in message.controllers
    )


def _cameras(welcome: Welcome) -> list[str]:
    return [camera.name for camera in welcome.cameras]


def _check_names(kind: str, names: Collection[str], known: Collection[str]) -> None:
    unknown = [name for name in names if name not in known]
    if unknown:
        raise CommandError(f"unknown {kind} {unknown[0]!r}; known: {', '.join(known) or 'none'}")
