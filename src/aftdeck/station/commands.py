"""What a page asks for: held against what there is, and as the simulation's inputs."""

from __future__ import annotations

from collections.abc import Callable, Collection

import msgspec

from aftdeck.errors import CommandError
from aftdeck.frames import Pose
from aftdeck.scenario.light import Lighting
from aftdeck.scenario.target import target_at
from aftdeck.simulation.inputs import Inputs
from aftdeck.station import from_page, to_page

FARTHEST = 1000.0
"""Greatest component of a keyed-in position that is looked at [m]; the arm itself reaches 16 m."""
MOST_TURNED = 100.0
"""Greatest angle of a keyed-in attitude that is looked at [rad]."""

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
"""Messages that put one switch: its name among the inputs, and the message's field that says where."""


def travel(sticks: from_page.Sticks) -> tuple[float, ...]:
    """Every stick and switch that springs back."""
    return (*sticks.translation, *sticks.rotation, sticks.drive, sticks.telescope, *sticks.orbiter)


def check_sticks(sticks: from_page.Sticks) -> None:
    """Raises `CommandError` for a stick beyond its travel."""
    if not all(-1.0 <= s <= 1.0 for s in travel(sticks)):
        raise CommandError("sticks lie between -1 and 1; this message was not flown")


def check_camera(message: from_page.DriveCamera, welcome: to_page.Welcome) -> None:
    """Raises `CommandError` for a camera that cannot be turned, or a switch beyond its travel."""
    driven = [camera.name for camera in welcome.cameras if camera.drive is not None]
    if message.camera not in driven:
        there = ", ".join(driven) or "none"
        raise CommandError(f"no camera {message.camera!r} can be turned here: there are {there}")
    if not all(-1.0 <= s <= 1.0 for s in (message.pan, message.tilt, message.zoom)):
        raise CommandError("a camera's pan, tilt and zoom lie between -1 and 1; this message was not flown")


def check_shown(message: from_page.Shown, welcome: to_page.Welcome) -> None:
    """Raises `CommandError` for a camera that there is not."""
    _check_names("camera", [name for monitor in message.monitors for name in monitor], _cameras(welcome))


def check_light(lighting: Lighting, welcome: to_page.Welcome) -> None:
    """Raises `CommandError` for a condition, a lamp or a camera that there is not."""
    _check_names("condition of light", [lighting.condition], [condition.name for condition in welcome.conditions])
    _check_names("lamp", lighting.lamps, welcome.lamps)
    _check_names("camera", [locked.camera for locked in lighting.locked], _cameras(welcome))


def check_switch(message: from_page.FromPage, welcome: to_page.Welcome) -> None:
    """Raises `CommandError` for a switch position that does not exist, or a target beyond all reason."""
    match message:
        case from_page.SelectJoint(joint=joint) if not 0 <= joint < len(welcome.joints):
            raise CommandError(f"joints are numbered 0 to {len(welcome.joints) - 1}, got {joint}")
        case from_page.EnterMode(mode=mode) if mode not in {m.position for m in welcome.modes}:
            known = ", ".join(m.position for m in welcome.modes)
            raise CommandError(f"no mode {mode!r} can be entered here: there are {known}")
        case from_page.SetTarget(position=position, attitude=attitude) if not (
            all(abs(x) <= FARTHEST for x in position) and all(abs(x) <= MOST_TURNED for x in attitude)
        ):
            raise CommandError(
                f"a target lies within {FARTHEST:g} m of the panel's origin and is turned by {MOST_TURNED:g} rad at "
                f"most, got {position} m, {attitude} rad"
            )
        case _:
            pass


def inputs_of(
    sticks: from_page.Sticks, message: from_page.FromPage | None, target: Callable[[from_page.SetTarget], Pose]
) -> Inputs:
    """One step's inputs: sticks, and a message that puts a switch.

    Args:
        sticks: of the page that flies.
        message: what the page asks for in this step, checked before.
        target: gives a keyed-in target, panel components, as frame 7 in L.
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
            return msgspec.structs.replace(inputs, target=target_at(target(message)))
        case from_page.Proceed():
            return msgspec.structs.replace(inputs, proceed=True)
        case from_page.Stop():
            return Inputs(stop=True, effector="stop")
        case _:
            return inputs


def _cameras(welcome: to_page.Welcome) -> list[str]:
    return [camera.name for camera in welcome.cameras]


def _check_names(kind: str, wanted: Collection[str], there: Collection[str]) -> None:
    unknown = [name for name in wanted if name not in there]
    if unknown:
        raise CommandError(f"there is no {kind} {unknown[0]!r}: there are {', '.join(there) or 'none'}")
