"""TABLE I of the Remote Manipulator Simulation: conversion of inputs to its thirteen channels, and back.

The channels hold the inputs of one control step: the master arm's six angles and seven switches. Some of our commands
have no channel (for example rate setting, latches, the orbiter's translation); `Reading.unsaid` names every such
command.
"""

from __future__ import annotations

from typing import Literal, NamedTuple, cast

from aftdeck.errors import InputError
from aftdeck.historical.frame_words import Direction, direction_of
from aftdeck.historical.input_channels import FULL_SCALE, STATION, CameraMotion, OperatorInputs, Start, Station
from aftdeck.scenario.schema import Part
from aftdeck.simulation.camera_drives import CameraDrive
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.state import State
from aftdeck.steering.layout import MASTER

MODE = "MASTER"
"""Mode in which the arm follows the channels' angles."""
NOT_CONNECTED: Station = "E"
"""Station that channel 12 holds if the commanded camera has no level in TABLE I: station E, with level 0 V."""

_MOTIONS: dict[tuple[float, float], CameraMotion] = {
    (1.0, 0.0): "+pan",
    (-1.0, 0.0): "-pan",
    (0.0, 0.0): "none",
    (0.0, 1.0): "+tilt",
    (0.0, -1.0): "-tilt",
}
"""Setting of channel 10 for each pair of pan and tilt switches."""
_DRIVES = {motion: switches for switches, motion in _MOTIONS.items()}
_PARTS: dict[Part, Start] = {"full problem": "full problem", "acquisition": "mode 1", "extraction": "mode 2 or 3"}
"""Setting of channel 2. TABLE I has a single level for modes 2 and 3: the run starts in mode 2, then enters mode 3."""
_STARTS = {start: part for part, start in _PARTS.items()}
_PRONG: dict[Direction, Literal["stop", "close", "open"]] = {0: "stop", 1: "close", -1: "open"}
PRONG_DIRECTIONS = {switch: direction for direction, switch in _PRONG.items()}
"""Direction of the prong's motion for each position of its switch."""
_MOMENTARY = (
    "translation", "rotation", "drive", "target", "rate_hold", "position_hold", "proceed", "stop", "latch", "orbiter",
)  # fmt: skip
"""Inputs that have no channel, and act only in the step in which they are sent."""
_NEUTRAL = Inputs()


class Reading(NamedTuple):
    """Inputs of one control step, as settings of the channels of TABLE I.

    Attributes:
        inputs: settings of the channels.
        unsaid: names of the commands in this step that have no channel. If there are any, a run with the channels as
            inputs may differ from this run.
    """

    inputs: OperatorInputs
    unsaid: tuple[str, ...]


def reading_of(flight: Flight, state: State, flown: Inputs) -> Reading:
    """Return the inputs `flown` of a step as settings of the channels; `state` is the state after the step.

    In MASTER the channels hold the master arm's angles after the step, whether a device or the sticks moved the master
    arm. In other modes the channels hold the angles of the arm itself.
    """
    unsaid = _without_channel(flight, state, flown)
    mastered = state.panel.mode == MODE
    angles = (state.command[MASTER : MASTER + 6] if mastered else state.plant.angles).tolist()
    clamped = [min(max(angle, -FULL_SCALE), FULL_SCALE) for angle in angles]
    camera = flown.camera or CameraDrive(state.panel.camera)
    motion = _MOTIONS.get((camera.pan, camera.tilt), "none")
    start = _PARTS.get(flown.initialise or "full problem", "mode 2 or 3")
    settings = OperatorInputs(
        initialise=flown.initialise is not None,
        start=start,
        angles=cast("tuple[float, float, float, float, float, float]", tuple(clamped)),
        telescope=direction_of(flown.telescope),
        camera=motion,
        zoom=direction_of(camera.zoom),
        station=cast("Station", state.panel.camera) if state.panel.camera in STATION else NOT_CONNECTED,
        prong=PRONG_DIRECTIONS[state.worksite.switch],
    )
    inexact = clamped != angles or any(angle / FULL_SCALE * FULL_SCALE != angle for angle in clamped)
    unsaid += ["master"] if inexact else []
    unsaid += ["telescope"] if flown.telescope != settings.telescope else []
    turned = (*_DRIVES[motion], float(settings.zoom))
    unsaid += ["camera"] if (camera.pan, camera.tilt, camera.zoom) != turned or (camera.slow and any(turned)) else []
    unsaid += ["station"] if state.panel.camera not in ("", settings.station) else []
    unsaid += ["initialise"] if flown.initialise not in (None, _STARTS[start]) else []
    return Reading(settings, tuple(unsaid))


def inputs_from(settings: OperatorInputs, switch: str, cameras: tuple[str, ...]) -> Inputs:
    """Return the inputs of one step from the settings of the thirteen channels.

    Args:
        settings: settings of the channels.
        switch: position of the prong's switch before the step.
        cameras: names of the cameras that have a drive. If the station is not one of these names, the
            inputs contain no camera command.

    Raises:
        InputError: the channels move a camera without a drive.
    """
    pan, tilt = _DRIVES[settings.camera]
    drive = CameraDrive(settings.station, pan, tilt, float(settings.zoom))
    exists = settings.station in cameras
    if not exists and (settings.camera != "none" or settings.zoom != 0):
        raise InputError(
            f"channels 10 to 12 move camera {settings.station}, which has no drive; cameras with a drive: "
            f"{', '.join(cameras) or 'none'}"
        )
    prong = _PRONG[settings.prong]
    return Inputs(
        mode=MODE,
        master=settings.angles,
        telescope=float(settings.telescope),
        effector=prong if prong != switch or settings.initialise else None,
        initialise=_STARTS[settings.start] if settings.initialise else None,
        camera=drive if exists else None,
    )


def _without_channel(flight: Flight, state: State, flown: Inputs) -> list[str]:
    """Return the names of the commands without a channel that act in this step, whether sent now or earlier."""
    panel, worksite, scenario = state.panel, state.worksite, flight.scenario
    other_mode = flown.mode not in (None, MODE)
    rejected = flown.effector not in (None, "stop") and state.script.attached > 0
    lasting = {
        "script": state.by_script,
        "mode": panel.mode != MODE or other_mode,
        "joint": panel.joint != 0,
        "rate": panel.rate != scenario.rate,
        "law": panel.law != scenario.law,
        "payload_axes": panel.payload_axes != scenario.payload_axes,
        "position_hold": panel.position_hold != scenario.position_hold,
        "brakes": panel.brakes,
        "safing": panel.safing,
        # the scenario fixes the payload to the arm, so a press of the prong's switch is rejected; channel 13 holds
        # the position of the switch and cannot express the press
        "effector": rejected,
        "effector_mode": worksite.effector_mode != "auto",
        "rigid": worksite.rigid != "off",
    }
    momentary = [name for name in _MOMENTARY if getattr(flown, name) != getattr(_NEUTRAL, name)]
    return list(dict.fromkeys([*(name for name, acts in lasting.items() if acts), *momentary]))
