"""The welcome: everything that stays the same while a scenario runs, from the joints' limits to the shapes to draw."""

from __future__ import annotations

from typing import Literal

import msgspec

from aftdeck.bodies.cameras import Camera
from aftdeck.scenario.light import LightCondition
from aftdeck.shapes import Shape
from aftdeck.station.messages.kinds import ProblemPart, Six, Vec3, WireMessage


class JointInfo(msgspec.Struct, frozen=True):
    """One joint of the arm: names, limits [rad] and rate limits [rad/s]."""

    name: str
    """Name in the arm file: ``shoulder_yaw``."""
    label: str
    """Name on the page: ``Sho yaw``."""
    stick: str
    """Axis of the hand controllers that turns this joint of the master arm: ``THC Y``."""
    hard: tuple[float, float]
    soft: tuple[float, float]
    reach: tuple[float, float]
    coarse: float
    vernier: float
    servo: float


class ModeInfo(msgspec.Struct, frozen=True):
    """One position of the MODE rotary."""

    position: str
    """Name as printed on the panel: ``ORB UNL``."""
    laws: tuple[int, ...]
    """The report's mode numbers that the position can fly, the default first; 0 TEST, 9 DIRECT, 10 MASTER."""
    title: str
    """Motion that it flies, in a few words: ``tip along its own axes``."""
    kind: Literal["automatic", "manual", "single", "test", "master"]
    point: str
    """Point that it moves: ``tip``, ``payload``."""
    enabled: bool
    """True if this scenario has what the position needs, such as the stored points of AUTO 1-4.

    A position that moves a payload also needs a captured payload.
    """
    axes: str
    """Axes that the sticks act along: ``orbiter axes``."""
    axis_names: tuple[str, str, str]
    """Meaning of + for the three axes of the THC: ``+X fwd``, ``+Y stbd``, ``+Z down``."""


class BodyInfo(msgspec.Struct, frozen=True):
    """Rigid body to draw; its pose is in `Display.poses`, at the body's index in `Welcome.bodies`."""

    name: str
    shapes: tuple[Shape, ...]


class StandInfo(msgspec.Struct, frozen=True):
    """Telescope that an arm stands on: its length and its rate."""

    least: float
    """[m]"""
    greatest: float
    rate: float
    """[m/s]"""


class SeatInfo(msgspec.Struct, frozen=True):
    """Seat where a payload can be fixed."""

    name: str
    """Name in a frame: `Cargo.seat`."""
    title: str
    """Name for display."""


class WorkInfo(msgspec.Struct, frozen=True):
    """Equipment of the worksite, and thresholds of its clearances."""

    hand: Literal["prong", "snares"]
    """Kind of the arm's end effector."""
    stand: StandInfo | None
    """Telescope of the arm; null if the arm stands on none."""
    cargo: tuple[str, ...]
    """Names of the payloads; each payload has a body of the same name."""
    seats: tuple[SeatInfo, ...]
    """Seats where payloads can be fixed."""
    parts: tuple[ProblemPart, ...]
    """Parts of the problem at which the operator can re-initialise."""
    caution: float
    """Clearance below which the page shows a caution [m]."""
    warning: float
    """Clearance below which the page shows a warning [m]."""


class PayloadInfo(msgspec.Struct, frozen=True):
    """Row of the payload table (SPEC 94 item 3): limits that the steering obeys with this payload captured."""

    id: int
    """PL ID; 0 if no payload is held."""
    name: str
    mass: float
    """[kg]"""
    translation: tuple[float, float]
    """Speed limit of the point of resolution, coarse and vernier [m/s]."""
    rotation: tuple[float, float]
    """Angular rate limit of the point of resolution, coarse and vernier [rad/s]."""
    coarse: Six
    """Joint rate limits in SINGLE, DIRECT and MASTER, coarse; `vernier` has those of vernier [rad/s]."""
    vernier: Six


class StoredPoint(msgspec.Struct, frozen=True):
    """Prestored point of AUTO 1-4, in panel components."""

    position: Vec3
    """X, Y, Z [m]."""
    attitude: Vec3
    """Pitch, yaw, roll [rad], each in [0, 2 pi)."""
    pause: bool
    """True if the sequence waits for PROCEED at this point; false for a fly-by point."""


class StoredSequence(msgspec.Struct, frozen=True):
    """Points that one of AUTO 1-4 flies through (SPEC 94 items 13-16)."""

    position: str
    """As `ModeInfo.position`."""
    points: tuple[StoredPoint, ...]


class Welcome(WireMessage, frozen=True, tag="welcome"):
    """Answer to `Hello`, sent again when the scenario changes: data that stays the same in a session."""

    protocol: int
    version: str
    scenario: str
    title: str
    text: str
    """Task of the operator in this scenario, in a sentence or two."""
    arm: str
    control_period_s: float
    command_delay_s: float
    """Time from a command to its arrival at the arm [s]."""
    telemetry_delay_s: float
    """Delay with which the page shows figures, lamps and log [s]."""
    camera_delay_s: float
    """Delay with which the page shows pictures [s]."""
    units: Literal["ft-in", "SI"]
    """Units of the panel's read-outs, as the arm file prefers them."""
    joints: tuple[JointInfo, ...]
    modes: tuple[ModeInfo, ...]
    bodies: tuple[BodyInfo, ...]
    ghost: tuple[int, ...]
    """Indices of the bodies whose poses are in `Ahead.poses`."""
    cameras: tuple[Camera, ...]
    work: WorkInfo
    conditions: tuple[LightCondition, ...]
    """Light conditions that can be selected: directions of sun and Earth."""
    lamps: tuple[str, ...]
    """Switches of the lamps that this scenario has."""
    payloads: tuple[PayloadInfo, ...]
    """Payload table by PL ID, from 0."""
    sequences: tuple[StoredSequence, ...]
    singular: float
    """Normalised distance from a singularity below which the page shows a caution."""
    phases: tuple[str, ...] = ()
    """Names of the script's phases in order, as in `Frame.phase`.

    Empty if the scenario has none, or if the session does not begin with the script.
    """
