"""The station's wire protocol: every message between server and page, defined here and nowhere else.

Messages are JSON objects whose ``type`` names the struct; the page's TypeScript is generated from these
types (``make generate``). All quantities are SI and radians. *panel* components are X = -Xo, Y = Yo,
Z = -Zo with pitch, yaw, roll applied in that order; *scene* is x aft, y starboard, z up with its origin at
Xo 942, Yo 0, Zo 400 in. Quaternions are wxyz.
"""

from __future__ import annotations

from typing import Annotated, Literal

import msgspec

from aftdeck.bodies.cameras import Camera
from aftdeck.scenario.light import LightCondition, Lighting
from aftdeck.shapes import Shape
from aftdeck.simulation.frame import LimitKind
from aftdeck.station.curves import Lane, Strip

PROTOCOL = 3
"""Version of this protocol; a page that speaks another one is refused in the handshake."""

MAX_MESSAGE_BYTES = 16_384
"""Longest message accepted from a page [bytes]: `Controllers` with full mappings; others have under 400."""

Vec3 = tuple[float, float, float]
Six = tuple[float, float, float, float, float, float]
Quat = tuple[float, float, float, float]
Rate = Literal["coarse", "vernier"]
LawChoice = Literal["position", "closed loop", "open loop"]
Level = Literal["info", "caution", "warning"]
EffectorSwitch = Literal["stop", "close", "open"]
ProblemPart = Literal["full problem", "acquisition", "extraction", "manoeuvring"]
ControllerKind = Literal["keyboard", "pad", "thc pad", "rhc pad", "thc joystick", "rhc joystick", "spacemouse", "touch"]
Binding = Annotated[str, msgspec.Meta(pattern=r"^[A-Za-z0-9+]{1,16} [A-Za-z0-9+ -]{1,16}$")]
Offset = Annotated[float, msgspec.Meta(ge=-0.3, le=0.3)]
Seq = Annotated[int, msgspec.Meta(ge=0, le=2**53 - 1)]
"""Number of a page's message: a whole number that JavaScript carries exactly."""
Name = Annotated[str, msgspec.Meta(max_length=64)]
Monitor = Annotated[tuple[Name, ...], msgspec.Meta(min_length=1, max_length=2)]
"""Names of the cameras that a monitor shows: one, or two halves from the left."""


class _Message(msgspec.Struct, frozen=True, forbid_unknown_fields=True, tag_field="type"):
    """A frozen, tagged message that refuses unknown fields."""


# --- page to server ---------------------------------------------------------------------------------------


class Hello(_Message, frozen=True, tag="hello"):
    """First message of a page: the protocol that it speaks."""

    protocol: int
    shows: bool = False
    """A second window, or a page too narrow to fly from: it shows the flight and is nobody's hands (`TakeSeat`)."""
    strips: bool = False
    """It draws strips: it is sent the flight's last minutes, too."""


class Sticks(_Message, frozen=True, tag="sticks"):
    """Where the hand controllers stand, after deadband and expo, each axis in [-1, 1].

    Sent whenever they change and at least every 0.2 s while they are deflected or RATE HOLD keeps a rate: sticks
    that have been silent for 0.5 s return to zero, and nobody is held to be at the controls (`HandsOff`).
    """

    seq: Seq
    """Grows with every message of a page; an older one is refused."""
    translation: Vec3
    """THC: +X, +Y, +Z of the present control frame."""
    rotation: Vec3
    """RHC: roll about +X, pitch about +Y, yaw about +Z of the present control frame."""
    drive: float
    """SINGLE/DIRECT DRIVE switch: + or - for the selected joint (modes SINGLE and DIRECT)."""
    telescope: float = 0.0
    """The stand: + longer, - shorter, in [-1, 1]."""
    orbiter: Vec3 = (0.0, 0.0, 0.0)
    """Translation of the orbiter: forward, starboard, down, each in [-1, 1]."""


class EnterMode(_Message, frozen=True, tag="enter_mode"):
    """Turn the MODE rotary to a position and press ENTER."""

    seq: Seq
    mode: str
    """A panel position, as `ModeInfo.position`."""


class SelectJoint(_Message, frozen=True, tag="select_joint"):
    """Turn the JOINT rotary."""

    seq: Seq
    joint: int
    """0 to 5, in the order of `Welcome.joints`."""


class SelectRate(_Message, frozen=True, tag="select_rate"):
    """Set the COARSE/VERNIER switch."""

    seq: Seq
    rate: Rate


class SetTarget(_Message, frozen=True, tag="set_target"):
    """Key in the end position and attitude of OPR CMD (SPEC 94 items 18-23), in panel components."""

    seq: Seq
    position: Vec3
    """X, Y, Z [m]."""
    attitude: Vec3
    """Pitch, yaw, roll [rad]."""


class SelectLaw(_Message, frozen=True, tag="select_law"):
    """Set the switch beside OPR CMD and AUTO 1-4: which of the report's modes 1 to 3 they fly."""

    seq: int
    law: LawChoice


class PayloadAxes(_Message, frozen=True, tag="payload_axes"):
    """Set the switch beside ORB LD: rotate in payload axes (mode 7) or in orbiter axes (mode 4)."""

    seq: int
    on: bool


class RateHold(_Message, frozen=True, tag="rate_hold"):
    """Press RATE HOLD: keep the present stick command; pressed again, let it go."""

    seq: int


class PositionHold(_Message, frozen=True, tag="position_hold"):
    """Set POSITION HOLD: with sticks at rest, keep position and attitude."""

    seq: int
    on: bool


class AskSticks(_Message, frozen=True, tag="ask_sticks"):
    """A page that watches wants to fly; the one that flies gives or keeps within 10 s."""

    seq: Seq


class GiveSticks(_Message, frozen=True, tag="give_sticks"):
    """Give the sticks, which are at rest, to the page that asks."""

    seq: Seq


class KeepSticks(_Message, frozen=True, tag="keep_sticks"):
    """Keep the sticks; the page that asks is told."""

    seq: Seq


class SetName(_Message, frozen=True, tag="set_name"):
    """What the person at this page is called from now on, to the other pages and in the log."""

    seq: Seq
    name: str
    """One line of 24 characters at most; empty: the page goes by its number again."""


class LeaveSeat(_Message, frozen=True, tag="leave_seat"):
    """The page has become too narrow to fly from: it shows the flight from now on, and the next page flies."""

    seq: Seq


class TakeSeat(_Message, frozen=True, tag="take_seat"):
    """The page is wide enough to fly from again: it flies if nobody else does, and else watches."""

    seq: Seq


class HandsOff(_Message, frozen=True, tag="hands_off"):
    """Nobody is at the controls: sticks at rest, RATE HOLD let go, POSITION HOLD on; a sequence goes on."""

    seq: Seq
    cause: Literal["page hidden", "device lost"]


class SetBrakes(_Message, frozen=True, tag="brakes"):
    """Set BRAKES: on, every joint stands at once."""

    seq: Seq
    on: bool


class SetSafing(_Message, frozen=True, tag="safing"):
    """Set SAFING: on, zero joint rates are commanded; off is its CANCEL."""

    seq: Seq
    on: bool


class LookAhead(_Message, frozen=True, tag="look_ahead"):
    """How far to look ahead."""

    seq: Seq
    seconds: Annotated[float, msgspec.Meta(ge=2.0, le=20.0)]
    """[s]"""


class Proceed(_Message, frozen=True, tag="proceed"):
    """AUTO SEQ switch to PROCEED."""

    seq: Seq


class Stop(_Message, frozen=True, tag="stop"):
    """AUTO SEQ switch to STOP; sticks go to zero too."""

    seq: Seq


class SetEffector(_Message, frozen=True, tag="effector"):
    """Put the end effector's switch: the prong closes or opens; the snares capture or release."""

    seq: Seq
    switch: EffectorSwitch


class SetEffectorMode(_Message, frozen=True, tag="effector_mode"):
    """END EFFECTOR MODE of the snares: the whole sequence, or the snares alone."""

    seq: Seq
    mode: Literal["auto", "manual"]


class SetRigid(_Message, frozen=True, tag="rigid"):
    """END EFFECTOR MAN CONTR: the carriage alone, in manual."""

    seq: Seq
    rigid: Literal["off", "rigid", "derigid"]


class PressLatch(_Message, frozen=True, tag="latch"):
    """Hold the payload in its seat (retention latches, docking port), or let it go."""

    seq: Seq
    latch: Literal["latch", "unlatch"]


class SetMaster(_Message, frozen=True, tag="master"):
    """Put the master arm, which MASTER follows."""

    seq: Seq
    angles: Six
    """[rad]"""


class Initialise(_Message, frozen=True, tag="initialise"):
    """Put arm and payload back to where a part of the problem begins."""

    seq: Seq
    part: ProblemPart


class Restart(_Message, frozen=True, tag="restart"):
    """Put the scenario back to its first instant."""

    seq: Seq


class FlyScenario(_Message, frozen=True, tag="fly_scenario"):
    """Leave this flight and fly another scenario; what is recorded of this one is finished and kept."""

    seq: Seq
    number: Annotated[int, msgspec.Meta(ge=0)]
    """Its place in `Scenarios.scenarios`."""


class DriveCamera(_Message, frozen=True, tag="drive_camera"):
    """The switches that turn a camera, each in [-1, 1]; sent and forgotten as `Sticks` are."""

    seq: Seq
    camera: Name
    pan: float
    """To the right in the picture."""
    tilt: float
    """Upwards."""
    zoom: float
    """In, to a narrower field of view."""
    slow: bool
    """At the low speed, where the drive has two."""


class Shown(_Message, frozen=True, tag="shown"):
    """What the page measures of itself and shows, told once a second and when it changes; for recording and strips."""

    seq: Seq
    latency_ms: Annotated[float, msgspec.Meta(ge=0.0, le=1e6)] | None
    """Stick to picture, 95th percentile of the last 10 s [ms]."""
    monitors: Annotated[tuple[Monitor, ...], msgspec.Meta(max_length=2)] = ()
    """What MON 1 and MON 2 show."""


class SetLight(_Message, frozen=True, tag="set_light"):
    """How the light shall stand from now on, as a whole; it is no input of the flight, and is recorded."""

    seq: Seq
    lighting: Lighting


class ControllerInUse(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A device that moves the hand controllers, and what each part of it is put to."""

    kind: ControllerKind
    name: Annotated[str, msgspec.Meta(min_length=1, max_length=80)]
    """As the browser calls it."""
    deadband: Annotated[float, msgspec.Meta(ge=0.0, le=0.5)]
    """Part of an axis' travel about its centre that counts as zero."""
    expo: Annotated[float, msgspec.Meta(ge=0.0, le=1.0)]
    """0 straight, 1 the cube: (1 - expo) x + expo x**3 of what is left beyond the deadband."""
    bindings: Annotated[tuple[Binding, ...], msgspec.Meta(max_length=64)]
    """What is pressed or moved, and what it does: ``KeyW +X``, ``a1 -X``, ``b9+b12 +telescope``."""
    centres: Annotated[tuple[Offset, ...], msgspec.Meta(max_length=16)]
    """Where each axis rests, as the operator has confirmed; beyond the last: 0."""


class Controllers(_Message, frozen=True, tag="controllers"):
    """The hand controllers in use, told when the page begins to fly and whenever they change; for the recording."""

    seq: Seq
    controllers: Annotated[tuple[ControllerInUse, ...], msgspec.Meta(max_length=5)]


FromPage = (
    Sticks
    | Shown
    | Controllers
    | DriveCamera
    | SetLight
    | EnterMode
    | SelectJoint
    | SelectRate
    | SelectLaw
    | PayloadAxes
    | RateHold
    | PositionHold
    | AskSticks
    | GiveSticks
    | KeepSticks
    | SetName
    | LeaveSeat
    | TakeSeat
    | HandsOff
    | LookAhead
    | SetBrakes
    | SetSafing
    | SetTarget
    | Proceed
    | Stop
    | Restart
    | FlyScenario
    | SetEffector
    | SetEffectorMode
    | SetRigid
    | PressLatch
    | SetMaster
    | Initialise
)


# --- server to page ---------------------------------------------------------------------------------------


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


class Welcome(_Message, frozen=True, tag="welcome"):
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


class Scenarios(_Message, frozen=True, tag="scenarios"):
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


class Role(_Message, frozen=True, tag="role"):
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


class Lamp(msgspec.Struct, frozen=True):
    """A lit lamp and its cause."""

    name: str
    """``SINGULAR``, ``REACH LIM``, ``SOFT STOP``, ``RATE LIM`` ..., as on the spine."""
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


class Frame(_Message, frozen=True, tag="frame"):
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


class Events(_Message, frozen=True, tag="events"):
    """New log lines, oldest first; none is ever skipped."""

    events: tuple[Event, ...]


class Refused(_Message, frozen=True, tag="refused"):
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


class Recent(_Message, frozen=True, tag="recent"):
    """To a window that draws strips: at first the flight's last minutes, then what is new."""

    strips: tuple[Strip, ...]
    """Every strip, its curves without a point: a flight begins, and what was told is over. Empty: it goes on."""
    samples: tuple[Sample, ...]
    lanes: tuple[Lane, ...]
    """Of the last minutes, when something in them has begun, else none; the last stretch of each goes on."""


FromServer = Welcome | Scenarios | Role | Frame | Events | Recent | Refused
