"""Messages from a page to the server, and the structs in them."""

from __future__ import annotations

from typing import Annotated, Literal

import msgspec

from aftdeck.scenario.light import Lighting
from aftdeck.scenario.schema import Plant
from aftdeck.station.messages.kinds import (
    Binding,
    ControllerKind,
    EffectorSwitch,
    LawChoice,
    Monitor,
    Name,
    Offset,
    ProblemPart,
    Rate,
    Seq,
    WireMessage,
)
from aftdeck.tuples import Joints, Vec3


class Hello(WireMessage, frozen=True, tag="hello"):
    """First message of a page, with the protocol version that the page uses."""

    protocol: int
    shows: bool = False
    """True for a secondary window or a page that is too narrow: it cannot take control.

    A page that becomes wide enough sends `TakeSeat`; it can then take control.
    """
    strips: bool = False
    """True if the page draws strips: the server then also sends `Recent` messages."""


class Sticks(WireMessage, frozen=True, tag="sticks"):
    """Deflections of the hand controllers, after deadband and expo, each axis in [-1, 1].

    The page sends them whenever they change. While a stick is deflected or RATE HOLD is on, it sends them at least
    every 0.2 s. After 0.5 s without a message the server centres the sticks and treats the controls as unattended
    (`HandsOff`).
    """

    seq: Seq
    """Sequence number. The server rejects a message if its number is not greater than the previous message's number."""
    translation: Vec3
    """THC: +X, +Y, +Z of the present control frame."""
    rotation: Vec3
    """RHC: roll about +X, pitch about +Y, yaw about +Z of the present control frame."""
    drive: float
    """DRIVE switch, in [-1, 1]; it moves the selected joint in SINGLE and DIRECT."""
    telescope: float = 0.0
    """Telescope: + longer, - shorter, in [-1, 1]."""
    orbiter: Vec3 = (0.0, 0.0, 0.0)
    """Translation of the orbiter: forward, starboard, down, each in [-1, 1]."""


class Pulse(WireMessage, frozen=True, tag="pulse"):
    """Deflect sticks for one pulse, which moves the arm by a small fixed distance or angle: each axis is -1, 0 or 1.

    The fields are those of `Sticks`. The server computes the deflection and its duration.
    """

    seq: Seq
    translation: Vec3
    rotation: Vec3
    drive: float
    telescope: float
    orbiter: Vec3


class EnterMode(WireMessage, frozen=True, tag="enter_mode"):
    """Turn the MODE rotary to a position and press ENTER."""

    seq: Seq
    mode: str
    """Position of the rotary, as in `ModeInfo.position`."""


class SelectJoint(WireMessage, frozen=True, tag="select_joint"):
    """Turn the JOINT rotary."""

    seq: Seq
    joint: int
    """Number of the joint, from 0, in the order of `Welcome.joints`."""


class SelectRate(WireMessage, frozen=True, tag="select_rate"):
    """Set the COARSE/VERNIER switch."""

    seq: Seq
    rate: Rate


class SetTarget(WireMessage, frozen=True, tag="set_target"):
    """Key in the end position and attitude of OPR CMD (SPEC 94 items 18-23), in panel components."""

    seq: Seq
    position: Vec3
    """X, Y, Z [m]."""
    attitude: Vec3
    """Pitch, yaw, roll [rad]."""


class SelectLaw(WireMessage, frozen=True, tag="select_law"):
    """Set the switch beside OPR CMD and AUTO 1-4, which selects their steering law (1 to 3)."""

    seq: int
    law: LawChoice


class PayloadAxes(WireMessage, frozen=True, tag="payload_axes"):
    """Set the switch beside ORB LD: rotate about payload axes (steering law 7) or orbiter axes (steering law 4)."""

    seq: int
    on: bool


class RateHold(WireMessage, frozen=True, tag="rate_hold"):
    """Press RATE HOLD: keep the present stick command, or cancel RATE HOLD if it is on."""

    seq: int


class PositionHold(WireMessage, frozen=True, tag="position_hold"):
    """Set POSITION HOLD: keep position and attitude while the sticks are centred."""

    seq: int
    on: bool


class Drawn(WireMessage, frozen=True, tag="drawn"):
    """Tell that the page has drawn its first pictures of the run: a run that waits for them goes on."""

    seq: Seq


class Announce(WireMessage, frozen=True, tag="announce"):
    """Announce a clearance problem that the operator or an observer has noticed; it is logged and recorded."""

    seq: Seq


class AskSticks(WireMessage, frozen=True, tag="ask_sticks"):
    """Ask for control of the arm. The request expires if the page in control does not answer within 10 s."""

    seq: Seq


class GiveSticks(WireMessage, frozen=True, tag="give_sticks"):
    """Give the sticks, which must be centred, to the page that asks for them."""

    seq: Seq


class KeepSticks(WireMessage, frozen=True, tag="keep_sticks"):
    """Keep the sticks; the server informs the page that asks for them."""

    seq: Seq


class SetName(WireMessage, frozen=True, tag="set_name"):
    """Set the name of the person at this page, for the other pages and for the log."""

    seq: Seq
    name: str
    """One line of at most 24 characters; empty removes the name."""


class LeaveSeat(WireMessage, frozen=True, tag="leave_seat"):
    """Give up control and the right to ask for it: the page has become too narrow, and now only shows the run.

    If this page was in control, the page that connected first takes control.
    """

    seq: Seq


class TakeSeat(WireMessage, frozen=True, tag="take_seat"):
    """Allow this page to take control: it has become wide enough.

    If no page is in control, this page takes control; otherwise it observes.
    """

    seq: Seq


class HandsOff(WireMessage, frozen=True, tag="hands_off"):
    """Leave the controls unattended: the server centres the sticks, cancels RATE HOLD and sets POSITION HOLD.

    A sequence in progress continues.
    """

    seq: Seq
    cause: Literal["page hidden", "device lost"]


class SetBrakes(WireMessage, frozen=True, tag="brakes"):
    """Set or release BRAKES, which stop every joint immediately."""

    seq: Seq
    on: bool


class SetSafing(WireMessage, frozen=True, tag="safing"):
    """Set or cancel SAFING, which commands zero joint rates."""

    seq: Seq
    on: bool


class LookAhead(WireMessage, frozen=True, tag="look_ahead"):
    """Set the time span of the look-ahead."""

    seq: Seq
    seconds: Annotated[float, msgspec.Meta(ge=2.0, le=20.0)]
    """Time span [s]."""


class TurnStep(WireMessage, frozen=True, tag="turn_step"):
    """Go to the next step of the task without completing the present one, or back to the previous step."""

    seq: Seq
    to: Literal["next", "previous"]


class Proceed(WireMessage, frozen=True, tag="proceed"):
    """Set the AUTO SEQ switch to PROCEED."""

    seq: Seq


class Stop(WireMessage, frozen=True, tag="stop"):
    """Set the AUTO SEQ switch to STOP. This also sets the sticks to zero and stops the end effector."""

    seq: Seq


class SetEffector(WireMessage, frozen=True, tag="effector"):
    """Set the end effector switch: the prong closes or opens; the snares capture or release."""

    seq: Seq
    switch: EffectorSwitch


class SetEffectorMode(WireMessage, frozen=True, tag="effector_mode"):
    """Set END EFFECTOR MODE of the snares: auto runs the whole sequence; manual moves the snares alone."""

    seq: Seq
    mode: Literal["auto", "manual"]


class SetRigid(WireMessage, frozen=True, tag="rigid"):
    """Set END EFFECTOR MAN CONTR of the snares: in manual mode, this switch moves the carriage alone."""

    seq: Seq
    rigid: Literal["off", "rigid", "derigid"]


class PressLatch(WireMessage, frozen=True, tag="latch"):
    """Latch or unlatch the payload in its berth (bay or docking port)."""

    seq: Seq
    latch: Literal["latch", "unlatch"]


class SetMaster(WireMessage, frozen=True, tag="master"):
    """Set the joint angles of the master arm, which the arm follows in MASTER."""

    seq: Seq
    angles: Joints
    """Joint angles of the master arm [rad]; lengths of joints that slide [m]."""


class Initialise(WireMessage, frozen=True, tag="initialise"):
    """Re-initialise arm and payload at a task phase."""

    seq: Seq
    part: ProblemPart


class Restart(WireMessage, frozen=True, tag="restart"):
    """Restart the scenario from its beginning."""

    seq: Seq


class FlyScenario(WireMessage, frozen=True, tag="fly_scenario"):
    """Run another scenario, or the same one on another plant.

    The server completes and keeps the recording of the present run.
    """

    seq: Seq
    number: Annotated[int, msgspec.Meta(ge=0)]
    """Index in `Scenarios.scenarios`."""
    plant: Plant | None = None
    """Plant; null for that of the scenario's file."""
    demo: bool = False
    """Whether the script flies the first run, until the operator moves a stick or sends a command."""


class DriveCamera(WireMessage, frozen=True, tag="drive_camera"):
    """Set the switches that drive a camera, each in [-1, 1]. The server centres them 0.5 s after the last message."""

    seq: Seq
    camera: Name
    pan: float
    """+ to the right in the picture."""
    tilt: float
    """+ upwards."""
    zoom: float
    """+ zooms in, to a narrower field of view."""
    slow: bool
    """True for the low speed, if the drive has two speeds."""


class Shown(WireMessage, frozen=True, tag="shown"):
    """Report the measured latency and the displayed cameras, for the recording and the strips.

    The page sends this message once a second and when a monitor changes its camera.
    """

    seq: Seq
    latency_ms: Annotated[float, msgspec.Meta(ge=0.0, le=1e6)] | None
    """Time from stick to picture, 95th percentile of the last 10 s [ms]; null if not measured."""
    monitors: Annotated[tuple[Monitor, ...], msgspec.Meta(max_length=2)] = ()
    """Cameras that MON 1 and MON 2 show."""


MAX_PICTURES = 64
"""Greatest number of pictures in the look of 1972 for which a page asks."""
Coordinate = Annotated[float, msgspec.Meta(ge=-1e4, le=1e4)]
Cosine = Annotated[float, msgspec.Meta(ge=-1.0, le=1.0)]


class FreeEye(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Eye of an engineering view, which each page directs by itself; in the scene."""

    position: tuple[Coordinate, Coordinate, Coordinate]
    """Position [m]."""
    ahead: tuple[Cosine, Cosine, Cosine]
    """Direction of view."""
    up: tuple[Cosine, Cosine, Cosine]
    """Direction that is upwards in the picture; it differs from `ahead`."""
    field_of_view: Annotated[float, msgspec.Meta(gt=0.0, lt=3.0)]
    """Horizontal field of view [rad]."""


class PolygonPicture(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Picture of a camera in the look of 1972."""

    camera: Name
    aspect: Annotated[float, msgspec.Meta(ge=0.5, le=4.0)]
    """Width of the picture divided by its height; the server may draw more above and below the picture."""
    eye: FreeEye | None = None
    """Eye of an engineering view; null for a view as the scenario has it."""


class ShowPolygons(WireMessage, frozen=True, tag="show_polygons"):
    """Ask for `Polygons` of these cameras, until the next such message; every page may ask.

    The page asks again after each welcome.
    """

    seq: Seq
    pictures: Annotated[tuple[PolygonPicture, ...], msgspec.Meta(max_length=MAX_PICTURES)]


class SetLight(WireMessage, frozen=True, tag="set_light"):
    """Set the complete lighting. It is recorded, but it is not an input of the simulation."""

    seq: Seq
    lighting: Lighting


class ControllerInUse(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Device that moves the hand controllers: its settings, and the functions of its keys, buttons and axes."""

    kind: ControllerKind
    name: Annotated[str, msgspec.Meta(min_length=1, max_length=80)]
    """Name that the browser reports."""
    deadband: Annotated[float, msgspec.Meta(ge=0.0, le=0.5)]
    """Fraction of an axis' travel, about its centre, that counts as zero."""
    expo: Annotated[float, msgspec.Meta(ge=0.0, le=1.0)]
    """0 linear, 1 cubic. The output is (1 - expo) x + expo x**3, where x is the deflection beyond the deadband."""
    bindings: Annotated[tuple[Binding, ...], msgspec.Meta(max_length=96)]
    """Key, button or axis, and its function: ``KeyW +X``, ``a1 -X``, ``b9+b12 +telescope``."""
    centres: Annotated[tuple[Offset, ...], msgspec.Meta(max_length=16)]
    """Rest position of each axis, as the operator has confirmed it; an axis without an entry rests at 0."""


class Controllers(WireMessage, frozen=True, tag="controllers"):
    """Report the devices in use, for the recording.

    The page sends this message when it takes control, and when the devices or their settings change.
    """

    seq: Seq
    controllers: Annotated[tuple[ControllerInUse, ...], msgspec.Meta(max_length=5)]


class TypeLine(WireMessage, frozen=True, tag="type_line"):
    """Type a line on the console, the report's typewriter: `Typed` answers it."""

    seq: Seq
    line: Annotated[str, msgspec.Meta(max_length=2000)]


class CompleteLine(WireMessage, frozen=True, tag="complete_line"):
    """Ask how the last word of a line on the console can go on: `Completed` answers it."""

    seq: Seq
    line: Annotated[str, msgspec.Meta(max_length=2000)]


FromPage = (
    Sticks
    | Drawn
    | Shown
    | ShowPolygons
    | Announce
    | Controllers
    | DriveCamera
    | SetLight
    | Pulse
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
    | TurnStep
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
    | TypeLine
    | CompleteLine
)
