"""Messages from the server to a page, and the structures in them."""

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
    """Rigid body to draw; its pose is in `Frame.poses`, at the body's index in `Welcome.bodies`."""

    name: str
    shapes: tuple[Shape, ...]


class StandInfo(msgspec.Struct, frozen=True):
    """Telescope that an arm stands on: its length and its rate."""

    least: float
    """[m]"""
    greatest: float
    rate: float
    """[m/s]"""


class WorkInfo(msgspec.Struct, frozen=True):
    """Equipment of the worksite, and thresholds of its clearances."""

    hand: Literal["prong", "snares"]
    """Kind of the arm's end effector."""
    stand: StandInfo | None
    """Telescope of the arm; null if the arm stands on none."""
    cargo: tuple[str, ...]
    """Names of the payloads; each payload has a body of the same name."""
    seats: tuple[str, ...]
    """Titles, for display, of the seats where payloads can be fixed."""
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


class ScenarioInfo(msgspec.Struct, frozen=True):
    """Scenario that this station can run."""

    name: str
    title: str
    text: str
    """Task of the operator, in a sentence or two."""
    given: bool
    """True for the user's own file; the others are built in."""


class Scenarios(WireMessage, frozen=True, tag="scenarios"):
    """Scenarios that this station can run: sent on connection and whenever something in the message changes."""

    scenarios: tuple[ScenarioInfo, ...]
    flown: int
    """Number of the scenario that is running."""
    coming: int | None
    """Number of the scenario that is being prepared; null if there is none.

    The sticks are at zero meanwhile. When the scenario runs, every page gets a new `Welcome`.
    """


class NamedPage(msgspec.Struct, frozen=True):
    """Page at which a person has given a name."""

    number: int
    name: str
    """Name as the other pages get it: the page's number is appended if two pages have the same name."""


class Role(WireMessage, frozen=True, tag="role"):
    """Role of this page, and which page is in control: sent on connection and whenever it changes."""

    flying: bool
    watchers: int
    """Number of observers: pages with a seat, without the one in control."""
    number: int
    """Number of this page, from 1; 0 if it only shows the run."""
    flier: int
    """Number of the page in control; 0 if there is none."""
    asking: int
    """Number of the page that asks for the sticks; 0 if there is none."""
    name: str
    """Name as it was given at this page; empty if none was given."""
    names: tuple[NamedPage, ...]
    """Names of all pages that have one, this page included."""


class Limit(msgspec.Struct, frozen=True):
    """A limit that acted in this step."""

    kind: LimitKind
    joint: int
    """0 to 5, or -1 if the limit does not concern a single joint."""
    text: str
    """Text for display: ``elbow pitch at its rate limit``."""


FlightLamp = Literal["SINGULAR", "REACH LIM", "SOFT STOP", "RATE LIM", "CLEARANCE", "DERIGIDIZE", "RELEASE"]
"""Lamps that the simulation lights; the page has others of its own, and a place for each."""


class Lamp(msgspec.Struct, frozen=True):
    """A lit lamp and its cause."""

    name: FlightLamp
    level: Level
    text: str
    """Cause: ``elbow 0.12`` for SINGULAR."""


class Check(msgspec.Struct, frozen=True):
    """Result of CMD CK: a rehearsal of the motion to a target."""

    good: bool
    text: str


class WayOut(msgspec.Struct, frozen=True):
    """Escape direction: command that leads away from a singularity or from a joint's limit."""

    cause: str
    """``shoulder``, ``elbow``, ``wrist`` (a singularity) or a joint's name."""
    text: str
    """Text for display: ``THC −X``, ``RHC +pitch``, ``SINGLE elbow pitch −``."""
    stick: Literal["translation", "rotation", "joint"]
    axis: int
    sign: int


class Resolution(msgspec.Struct, frozen=True):
    """Point of resolution, in panel components."""

    position: Vec3
    """X, Y, Z [m]."""
    attitude: Vec3
    """Pitch, yaw, roll [rad], each in [0, 2 pi)."""
    velocity: Vec3
    """Rate of X, Y, Z [m/s]."""
    turn_rate: Vec3
    """Angular velocity about panel pitch, yaw, roll axes [rad/s]."""


class Aim(msgspec.Struct, frozen=True):
    """Target of an automatic mode, in panel components, and what remains of the motion to it."""

    position: Vec3
    attitude: Vec3
    distance: float
    """Distance from the tip to the target [m]."""
    angle: float
    """Angle between the present attitude and the target's [rad]."""
    remaining_s: float
    """Estimated time to go [s]; 0 if the motion is not in progress."""


class Near(msgspec.Struct, frozen=True):
    """Two monitored parts; points and directions are in the scene."""

    a: str
    b: str
    clearance: float
    """Distance of the two parts [m]; negative if they overlap."""
    closing: float
    """Speed at which the closest points approach [m/s]."""
    point_a: Vec3
    point_b: Vec3
    plane: Vec3
    """Point of the plane between the two parts, halfway between the closest points."""
    normal: Vec3
    """Unit normal of this plane, from a to b; zero if the parts collide."""
    essential: bool
    """True if the task requires the two parts to touch; the contact then inhibits nothing."""


class Condition(msgspec.Struct, frozen=True):
    """Condition of a capture, a docking or a latching."""

    name: str
    holds: bool
    value: float
    """Measured value, in `unit`: m, rad, m/s, or a plain number."""
    limit: float
    unit: str
    margin: float
    """Margin by which the condition holds, in `unit`; negative if it fails."""
    text: str
    """Text for display: ``palm 2.5 in above the bar, 0 to 0.75 in allowed``."""


class HandFrame(msgspec.Struct, frozen=True):
    """State of the end effector."""

    switch: EffectorSwitch
    opening: float
    """Opening of the prong or of the snares, from 0 closed to 1 open."""
    spacing: float | None
    """Distance from the prong to the fixed finger [m]; null if the arm has none."""
    carriage: float | None
    """Position of the carriage, from 0 extended to 1 rigid; null if the arm has none."""
    flags: tuple[str, ...]
    """Flags that are lit: ``CAPTURE``, ``CLOSE``, ``RIGID``, ``EXTEND``, ``OPEN``, ``DERIGID``."""
    mode: Literal["auto", "manual"]
    """END EFFECTOR MODE of the snares."""
    rigid: Literal["off", "rigid", "derigid"]
    """END EFFECTOR MAN CONTR of the snares."""


class CargoFrame(msgspec.Struct, frozen=True):
    """Payload of the worksite; its pose is the pose of its body."""

    name: str
    held: bool
    seat: str
    """Title of the seat that the payload is fixed to, as in `WorkInfo.seats`; empty if there is none."""
    speed: float
    """Speed of its centre relative to the arm's base [m/s]."""


class WorkFrame(msgspec.Struct, frozen=True):
    """State of the worksite: clearances, contacts, captures, the end effector and the payloads."""

    task: int
    """The report's mode: 1 acquisition, 2 extraction, 3 manoeuvring, 4 docked."""
    nearest: Near | None
    clearance_level: Level
    """Alarm level of the clearance of `nearest`, by the scenario's thresholds."""
    contacts: tuple[Near, ...]
    arm_inhibit: bool
    finger_inhibit: bool
    inhibits: tuple[str, ...]
    """Reasons why the arm or the finger is inhibited, and what frees it."""
    pursuit: str
    """Purpose of the conditions: ``acquire payload``; empty if nothing is near enough."""
    conditions: tuple[Condition, ...]
    hand: HandFrame
    stand: float | None
    """Length of the telescope [m]; null if the arm stands on none."""
    orbiter: Vec3
    """Displacement of the orbiter: forward, starboard, down [m]."""
    orbiter_velocity: Vec3
    """Velocity of the orbiter along the same axes [m/s]."""
    cargo: tuple[CargoFrame, ...]
    master: Six | None
    """Joint angles of the master arm [rad]; null in modes other than MASTER."""
    fixture: float | None
    """Distance from the empty snares to their position at the nearest grapple fixture [m].

    Null if the arm has no snares, a payload is held, or no payload has a grapple fixture.
    """
    to_fixture: Vec3 | None
    """Vector of this distance, along the axes that the sticks act along [m]; null also in modes without sticks."""


class Ahead(msgspec.Struct, frozen=True):
    """Look-ahead: state of the arm in some seconds with the present stick command.

    It is computed every 10 control steps: five times a second with the default control period.
    """

    seconds: float
    """Time span of the look-ahead [s]."""
    held: bool
    """True for the present stick command; false if the sticks are centred: the last axis used, at full deflection."""
    moves: bool
    """True if the arm is then at another place than now."""
    clearance: float | None
    """Smallest clearance then [m]; null if no pair is monitored."""
    a: str
    """`a` and `b`: the two parts with this clearance; empty if no pair is monitored."""
    b: str
    contact_s: float | None
    """Time to the first contact found on the way [s]; null if none is found."""
    stopping: float
    """Distance that the tip still moves if the sticks are released now [m]."""
    joint: int
    """Joint nearest to a reach limit then, 0 to 5."""
    room: float
    """Angle from this joint to that limit then [rad]; negative past the limit."""
    poses: tuple[float, ...]
    """Seven numbers for each body of `Welcome.ghost`, as in `Frame.poses`."""


class Frame(WireMessage, frozen=True, tag="frame"):
    """All data that the page shows of one instant; the newest frame counts, and older ones may be skipped."""

    tick: int
    time_s: float
    stick_seq: int
    """`seq` of the last `Sticks` that this step has taken; the page uses it to time stick-to-picture."""
    flown_seq: int
    """`seq` of the last `Sticks` that this step has flown, after the command delay; -1 if none, or the script flew."""
    recording_s: float | None
    """Simulated time in the recording so far [s]; null if the run is not recorded."""
    phase: str
    """Name of the script's phase; empty in manual flight."""
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
    """AUTO 1-4: number of the present or the next point, from 1; 0 in other modes."""
    points: int
    check: Check | None
    """CMD CK of the present target."""
    translation: Vec3
    rotation: Vec3
    drive: float
    """`translation`, `rotation` and `drive`: the sticks as this step has flown them."""
    joints: Six
    """Joint angles, measured [rad]."""
    joints_commanded: Six
    """Joint angles to which the commanded rates would have brought the joints [rad]."""
    rates: Six
    """Joint rates, measured [rad/s]."""
    rates_commanded: Six
    rate_limits: Six
    """Joint rate limits in force in this mode [rad/s]."""
    zones: tuple[int, int, int, int, int, int]
    """Per joint: 0 free, 1 past the reach limit, 2 past the soft stop, 3 at the hard stop."""
    actual: Resolution
    commanded: Resolution
    por_limits: tuple[float, float]
    """Limits in force of POR translation [m/s] and POR rotation [rad/s]."""
    payload: int
    """PL ID of the captured payload, as in `Welcome.payloads`; 0 if there is none."""
    por_offset: Vec3
    """Vector from the tip to the point of resolution of ORB LD and PL, in the end effector's axes [m]."""
    limits: tuple[Limit, ...]
    """Limits that act in this step."""
    singularity: Vec3
    """Signed normalised distances of shoulder, elbow and wrist, 0 at the singularity."""
    ways_out: tuple[WayOut, ...]
    """Escape directions, for each singularity that is near and each joint past a limit."""
    lamps: tuple[Lamp, ...]
    aim: Aim | None
    work: WorkFrame
    ahead: Ahead | None
    """Newest look-ahead; null if none was made yet."""
    axes: Quat
    """Axes of the control frame in the scene, for the frame axes in the pictures."""
    poses: tuple[float, ...]
    """Seven numbers for each body, in the order of `Welcome.bodies`: x, y, z [m], w, x, y, z, in the scene."""
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


class Preparing(WireMessage, frozen=True, tag="preparing"):
    """Line of progress while the station prepares its first session; comes before the welcome."""

    text: str


class Refused(WireMessage, frozen=True, tag="refused"):
    """Rejection of a message or command, with the reason in a sentence for the operator."""

    seq: int
    """`seq` of the message; -1 if the message could not be read, or if the rejection concerns no single message."""
    text: str


class Sample(msgspec.Struct, frozen=True):
    """Values of all strips at one instant."""

    time_s: float
    values: tuple[float | None, ...]
    """Values of all curves, strip after strip; null where a curve has no value."""
    worst: str
    """Joint nearest to its rate limit; empty at rest."""


class Recent(WireMessage, frozen=True, tag="recent"):
    """Data for a window that draws strips: first the last minutes of the run, then only new data."""

    strips: tuple[Strip, ...]
    """All strips, with curves that have no points: a run begins, and the data sent before is no longer valid.

    Empty while the run continues.
    """
    samples: tuple[Sample, ...]
    lanes: tuple[Lane, ...]
    """Lanes of the last minutes if a stretch has begun, otherwise empty; the last stretch of each lane continues."""


FromServer = Preparing | Welcome | Scenarios | Role | Frame | Events | Recent | Refused
