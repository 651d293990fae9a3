"""Every message from the server to a page, and what they hold."""

from __future__ import annotations

from typing import Literal

import msgspec

from aftdeck.bodies.cameras import Camera
from aftdeck.scenario.light import LightCondition, Lighting
from aftdeck.shapes import Shape
from aftdeck.simulation.frame import LimitKind
from aftdeck.station.curves import Lane, Strip
from aftdeck.station.kinds import (
    EffectorSwitch,
    LawChoice,
    Level,
    ProblemPart,
    Quat,
    Rate,
    Six,
    Vec3,
    WireMessage,
)


class JointInfo(msgspec.Struct, frozen=True):
    """One joint of the arm flown: names, limits [rad] and rate limits [rad/s]."""

    name: str
    """As in the arm file: ``shoulder_yaw``."""
    label: str
    """As on the page: ``Sho yaw``."""
    stick: str
    """The axis of the hand controllers that turns the master arm's: ``THC Y``."""
    hard: tuple[float, float]
    soft: tuple[float, float]
    reach: tuple[float, float]
    coarse: float
    vernier: float
    servo: float


class ModeInfo(msgspec.Struct, frozen=True):
    """One position of the MODE rotary."""

    position: str
    """As printed on the panel: ``ORB UNL``."""
    laws: tuple[int, ...]
    """The report's mode numbers that it can fly, the default first; 0 TEST, 9 DIRECT, 10 MASTER."""
    title: str
    """What it flies, in a few words."""
    kind: Literal["automatic", "manual", "single", "test", "master"]
    point: str
    """The point that it moves: ``tip``, ``payload``."""
    enabled: bool
    """Whether this scenario has what it needs, as AUTO 1-4 their points. Those that move a payload need one in the
    grasp as well."""
    axes: str
    """The axes that the sticks act along: ``orbiter axes``."""
    axis_names: tuple[str, str, str]
    """What + means for the THC: ``+X fwd``, ``+Y stbd``, ``+Z down``."""


class BodyInfo(msgspec.Struct, frozen=True):
    """A rigid body to draw; its pose is found in `Frame.poses` at its index in `Welcome.bodies`."""

    name: str
    shapes: tuple[Shape, ...]


class StandInfo(msgspec.Struct, frozen=True):
    """The telescope that an arm stands on."""

    least: float
    """[m]"""
    greatest: float
    rate: float
    """[m/s]"""


class WorkInfo(msgspec.Struct, frozen=True):
    """What can be done at this worksite."""

    hand: Literal["prong", "snares"]
    """Which kind of end effector the arm has."""
    stand: StandInfo | None
    """None: the arm stands on no telescope."""
    cargo: tuple[str, ...]
    """Names of the payloads; each has a body of that name."""
    seats: tuple[str, ...]
    """Where payloads can be fixed, for people."""
    parts: tuple[ProblemPart, ...]
    """The parts of the problem that can be begun anew."""
    caution: float
    """Clearance under which the page cautions [m]."""
    warning: float
    """Clearance under which the page warns [m]."""


class PayloadInfo(msgspec.Struct, frozen=True):
    """A row of the payload table (SPEC 94 item 3): what the steering keeps to with this payload in the grasp."""

    id: int
    """PL ID; 0: nothing is held."""
    name: str
    mass: float
    """[kg]"""
    translation: tuple[float, float]
    """Greatest speed of the point of resolution, coarse and vernier [m/s]."""
    rotation: tuple[float, float]
    """The same of its rotation [rad/s]."""
    coarse: Six
    """Joint rates of SINGLE, DIRECT and MASTER [rad/s]."""
    vernier: Six


class StoredPoint(msgspec.Struct, frozen=True):
    """A prestored point of AUTO 1-4, panel components."""

    position: Vec3
    """X, Y, Z [m]."""
    attitude: Vec3
    """Pitch, yaw, roll [rad], each in [0, 2 pi)."""
    pause: bool
    """It is waited at for PROCEED; else only come near."""


class StoredSequence(msgspec.Struct, frozen=True):
    """What one of AUTO 1-4 flies through (SPEC 94 items 13-16)."""

    position: str
    """As `ModeInfo.position`."""
    points: tuple[StoredPoint, ...]


class Welcome(WireMessage, frozen=True, tag="welcome"):
    """Answer to `Hello`: all that a page needs to know once."""

    protocol: int
    version: str
    scenario: str
    title: str
    text: str
    """What the scenario asks of the operator, a sentence or two."""
    arm: str
    control_period_s: float
    command_delay_s: float
    """How long a command is under way before the arm has it [s]."""
    telemetry_delay_s: float
    """So late the page shows figures, lamps and log [s]."""
    camera_delay_s: float
    """So late it shows pictures [s]."""
    units: Literal["ft-in", "SI"]
    """The arm file's preference for the panel's read-outs."""
    joints: tuple[JointInfo, ...]
    modes: tuple[ModeInfo, ...]
    bodies: tuple[BodyInfo, ...]
    ghost: tuple[int, ...]
    """Indices of the bodies that `Frame.ahead` tells of."""
    cameras: tuple[Camera, ...]
    work: WorkInfo
    conditions: tuple[LightCondition, ...]
    """Where sun and Earth can stand."""
    lamps: tuple[str, ...]
    """Switches of the lamps that are there."""
    payloads: tuple[PayloadInfo, ...]
    """By PL ID, from 0."""
    sequences: tuple[StoredSequence, ...]
    singular: float
    """Normalised distance under which a singularity is cautioned of."""
    phases: tuple[str, ...] = ()
    """Names of the script's phases in order, as in `Frame.phase`; empty where the scenario has none."""


class ScenarioInfo(msgspec.Struct, frozen=True):
    """A scenario that this station can fly."""

    name: str
    title: str
    text: str
    """What it asks of the operator, a sentence or two."""
    given: bool
    """The user's own file; the others are built in."""


class Scenarios(WireMessage, frozen=True, tag="scenarios"):
    """What this station can fly: sent on connection and whenever something of it changes."""

    scenarios: tuple[ScenarioInfo, ...]
    flown: int
    """Number of the one that is flown."""
    coming: int | None
    """Number of the one that is made ready; the sticks rest meanwhile. Then every page is welcomed anew."""


class NamedPage(msgspec.Struct, frozen=True):
    """A page at which somebody has given a name."""

    number: int
    name: str
    """As the others are told it: with the page's number behind it where two have given the same."""


class Role(WireMessage, frozen=True, tag="role"):
    """Who flies: sent on connection and whenever it changes."""

    flying: bool
    watchers: int
    """Pages that watch, besides the one that flies."""
    number: int
    """What this page is called, from 1."""
    flier: int
    """The page that flies."""
    asking: int
    """The page that asks for the sticks; 0: none."""
    name: str
    """As it was given at this page; empty: none was."""
    names: tuple[NamedPage, ...]
    """Of all pages that have one, this one too."""


class Limit(msgspec.Struct, frozen=True):
    """A limit that acted in this step."""

    kind: LimitKind
    joint: int
    """0 to 5, or -1 where no single joint is concerned."""
    text: str
    """For people: ``elbow pitch at its rate limit``."""


FlightLamp = Literal["SINGULAR", "REACH LIM", "SOFT STOP", "RATE LIM", "CLEARANCE", "DERIGIDIZE", "RELEASE"]
"""The lamps that a flight lights; the page has others of its own, and a place for each."""


class Lamp(msgspec.Struct, frozen=True):
    """A lit lamp and its cause."""

    name: FlightLamp
    level: Level
    text: str
    """The cause: ``elbow 0.12 from straight``."""


class Check(msgspec.Struct, frozen=True):
    """CMD CK: what a rehearsal of the way to a target found."""

    good: bool
    text: str


class WayOut(msgspec.Struct, frozen=True):
    """How to leave a singularity or a joint's stop."""

    cause: str
    """``shoulder``, ``elbow``, ``wrist`` (a singularity) or a joint's name."""
    text: str
    """For people: ``THC −X``, ``RHC +pitch``, ``SINGLE elbow pitch −``."""
    stick: Literal["translation", "rotation", "joint"]
    axis: int
    sign: int


class Resolution(msgspec.Struct, frozen=True):
    """The point of resolution, panel components."""

    position: Vec3
    """X, Y, Z [m]."""
    attitude: Vec3
    """Pitch, yaw, roll [rad], each in [0, 2 pi)."""
    velocity: Vec3
    """Rate of X, Y, Z [m/s]."""
    turn_rate: Vec3
    """Angular velocity about panel pitch, yaw, roll axes [rad/s]."""


class Aim(msgspec.Struct, frozen=True):
    """The keyed-in target of an automatic mode and what is left to it."""

    position: Vec3
    attitude: Vec3
    distance: float
    """[m]"""
    angle: float
    """[rad]"""
    remaining_s: float
    """Estimated time to go [s]; 0 when not under way."""


class Near(msgspec.Struct, frozen=True):
    """Two watched parts; points and directions in the scene."""

    a: str
    b: str
    clearance: float
    """[m], negative where they overlap."""
    closing: float
    """Speed at which the closest points approach [m/s]."""
    point_a: Vec3
    point_b: Vec3
    plane: Vec3
    """A point of the plane between them, halfway."""
    normal: Vec3
    """The plane's unit normal, from a to b; zero where they collide."""
    essential: bool
    """Made to touch: inhibits nothing."""


class Condition(msgspec.Struct, frozen=True):
    """A condition of a capture, a docking or a latching."""

    name: str
    holds: bool
    value: float
    """In `unit`: m, rad, m/s, or a number."""
    limit: float
    unit: str
    margin: float
    """By how much it holds, or fails where negative, in `unit`."""
    text: str
    """For people: ``palm 2.5 in above the bar: 0 to 0.75 in``."""


class HandFrame(msgspec.Struct, frozen=True):
    """The end effector."""

    switch: EffectorSwitch
    opening: float
    """0 closed to 1 open: of the prong, or of the snares."""
    spacing: float | None
    """Prong to fixed finger [m]."""
    carriage: float | None
    """0 extended to 1 rigid."""
    flags: tuple[str, ...]
    """Lit: ``CAPTURE``, ``CLOSE``, ``RIGID``, ``EXTEND``, ``OPEN``, ``DERIGID``."""
    mode: Literal["auto", "manual"]
    """END EFFECTOR MODE of the snares."""
    rigid: Literal["off", "rigid", "derigid"]
    """END EFFECTOR MAN CONTR of the snares."""


class CargoFrame(msgspec.Struct, frozen=True):
    """A payload of the worksite; its pose is its body's."""

    name: str
    held: bool
    seat: str
    """Title of the seat that it is fixed to, as in `WorkInfo.seats`; empty: none."""
    speed: float
    """Of its centre against the arm's base [m/s]."""


class WorkFrame(msgspec.Struct, frozen=True):
    """Contacts, captures and the worksite's things."""

    task: int
    """The report's mode: 1 acquisition, 2 extraction, 3 manoeuvring, 4 docked."""
    nearest: Near | None
    clearance_level: Level
    """What the clearance of `nearest` calls for, by the scenario's thresholds."""
    contacts: tuple[Near, ...]
    arm_inhibit: bool
    finger_inhibit: bool
    inhibits: tuple[str, ...]
    """Why the arm or the finger is inhibited, and what frees it."""
    pursuit: str
    """What the conditions are for: ``acquire payload``; empty: nothing is near."""
    conditions: tuple[Condition, ...]
    hand: HandFrame
    stand: float | None
    """Length of the telescope [m]."""
    orbiter: Vec3
    """How far the orbiter has moved: forward, starboard, down [m]."""
    orbiter_velocity: Vec3
    """[m/s]"""
    cargo: tuple[CargoFrame, ...]
    master: Six | None
    """Where the master arm stands [rad]; null in other modes than MASTER."""
    fixture: float | None
    """From the empty snares to where they would be at the nearest grapple fixture [m]; null: there is none for them."""
    to_fixture: Vec3 | None
    """The same way, along the axes that the sticks move the end effector along [m]; null in modes without sticks."""


class Ahead(msgspec.Struct, frozen=True):
    """Look ahead: what the sticks as they stand would do in some seconds; told five times a second."""

    seconds: float
    """How far is looked [s]."""
    held: bool
    """The sticks as they stand; false: they rest, and this is the last axis used at full deflection."""
    moves: bool
    """Whether the arm is then elsewhere than now."""
    clearance: float | None
    """Least clearance then [m]; null: nothing is watched."""
    a: str
    """The two parts that have it."""
    b: str
    contact_s: float | None
    """When the first contact is found on the way [s]; null: none is."""
    stopping: float
    """How far the tip goes on if the sticks are let go now [m]."""
    joint: int
    """The joint nearest to a reach limit then, 0 to 5."""
    room: float
    """How far it is from that limit then; negative past it [rad]."""
    poses: tuple[float, ...]
    """Seven numbers for each body of `Welcome.ghost`, as in `Frame.poses`."""


class Frame(WireMessage, frozen=True, tag="frame"):
    """All that the page shows of one instant; newest wins, frames may be skipped."""

    tick: int
    time_s: float
    stick_seq: int
    """`seq` of the last `Sticks` that this step has taken; the page times stick-to-picture by it."""
    flown_seq: int
    """`seq` of the last `Sticks` that this step has flown, after the command delay; -1: none, or the script flew."""
    recording_s: float | None
    """How long the recording goes on already [s]; null: nothing is recorded."""
    phase: str
    """Name of the script's phase; empty when flown by hand."""
    by: Literal["hand", "script"]
    mode: str
    law: int
    """The report's mode number flown; 0 TEST, 9 DIRECT, 10 MASTER."""
    law_choice: LawChoice
    payload_axes: bool
    rate_hold: bool
    position_hold: bool
    brakes: bool
    safing: bool
    joint: int
    rate: Rate
    sequence: Literal["idle", "checking", "ready", "in progress"]
    """READY and IN PROG of the automatic modes."""
    point: int
    """AUTO 1-4: the point, from 1, that is flown to or comes next; 0 in other modes."""
    points: int
    check: Check | None
    """CMD CK of the present target."""
    translation: Vec3
    rotation: Vec3
    drive: float
    """Sticks as this step has flown them."""
    joints: Six
    """Actual [rad]."""
    joints_commanded: Six
    """Where the commanded rates would have brought them [rad]."""
    rates: Six
    """Actual [rad/s]."""
    rates_commanded: Six
    rate_limits: Six
    """In force in this mode [rad/s]."""
    zones: tuple[int, int, int, int, int, int]
    """Per joint: 0 free, 1 past the reach limit, 2 past the soft stop, 3 at the hard stop."""
    actual: Resolution
    commanded: Resolution
    por_limits: tuple[float, float]
    """POR translation [m/s] and rotation [rad/s] limits in force."""
    payload: int
    """PL ID of what is in the grasp, as in `Welcome.payloads`."""
    por_offset: Vec3
    """From the tip to the point of resolution of ORB LD and PL, in the end effector's axes [m]."""
    limits: tuple[Limit, ...]
    """Limits acting in this step."""
    singularity: Vec3
    """Shoulder, elbow, wrist: signed normalised distances, 0 at the singularity."""
    ways_out: tuple[WayOut, ...]
    """For each singularity that is near and each joint past a limit: what leads away from it."""
    lamps: tuple[Lamp, ...]
    aim: Aim | None
    work: WorkFrame
    ahead: Ahead | None
    """The newest look ahead; null: none was made yet."""
    axes: Quat
    """The control frame's axes in the scene, for the frame axes in the pictures."""
    poses: tuple[float, ...]
    """Seven numbers a body, in the order of `Welcome.bodies`: x, y, z [m], w, x, y, z in the scene."""
    views: tuple[Vec3, ...]
    """Pan, tilt and horizontal field of view [rad] of the cameras that have a drive, in the order of
    `Welcome.cameras`."""
    lighting: Lighting


class Event(msgspec.Struct, frozen=True):
    """One line of the log."""

    time_s: float
    kind: str
    level: Level
    text: str


class Events(WireMessage, frozen=True, tag="events"):
    """New log lines, oldest first; none is ever skipped."""

    events: tuple[Event, ...]


class Refused(WireMessage, frozen=True, tag="refused"):
    """A message or command that was not taken, and why, in a sentence for the operator."""

    seq: int
    """`seq` of the message, or -1 where it could not be read."""
    text: str


class Sample(msgspec.Struct, frozen=True):
    """What every strip shows of one instant."""

    time_s: float
    values: tuple[float | None, ...]
    """Of every curve, strip after strip."""
    worst: str
    """The joint that is nearest to its rate limit; empty at rest."""


class Recent(WireMessage, frozen=True, tag="recent"):
    """To a window that draws strips: at first the flight's last minutes, then what is new."""

    strips: tuple[Strip, ...]
    """Every strip, its curves without a point: a flight begins, and what was told is over. Empty: it goes on."""
    samples: tuple[Sample, ...]
    lanes: tuple[Lane, ...]
    """Of the last minutes, when something in them has begun, else none; the last stretch of each goes on."""


FromServer = Welcome | Scenarios | Role | Frame | Events | Recent | Refused
