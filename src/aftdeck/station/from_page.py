"""Every message from a page to the server, and what they hold."""

from __future__ import annotations

from typing import Annotated, Literal

import msgspec

from aftdeck.scenario.light import Lighting
from aftdeck.station.kinds import (
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
    Six,
    Vec3,
    WireMessage,
)


class Hello(WireMessage, frozen=True, tag="hello"):
    """First message of a page: the protocol that it speaks."""

    protocol: int
    shows: bool = False
    """A second window, or a page too narrow to fly from: it shows the flight and is nobody's hands (`TakeSeat`)."""
    strips: bool = False
    """It draws strips: it is sent the flight's last minutes, too."""


class Sticks(WireMessage, frozen=True, tag="sticks"):
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


class EnterMode(WireMessage, frozen=True, tag="enter_mode"):
    """Turn the MODE rotary to a position and press ENTER."""

    seq: Seq
    mode: str
    """A panel position, as `ModeInfo.position`."""


class SelectJoint(WireMessage, frozen=True, tag="select_joint"):
    """Turn the JOINT rotary."""

    seq: Seq
    joint: int
    """0 to 5, in the order of `Welcome.joints`."""


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
    """Set the switch beside OPR CMD and AUTO 1-4: which of the report's modes 1 to 3 they fly."""

    seq: int
    law: LawChoice


class PayloadAxes(WireMessage, frozen=True, tag="payload_axes"):
    """Set the switch beside ORB LD: rotate in payload axes (mode 7) or in orbiter axes (mode 4)."""

    seq: int
    on: bool


class RateHold(WireMessage, frozen=True, tag="rate_hold"):
    """Press RATE HOLD: keep the present stick command; pressed again, let it go."""

    seq: int


class PositionHold(WireMessage, frozen=True, tag="position_hold"):
    """Set POSITION HOLD: with sticks at rest, keep position and attitude."""

    seq: int
    on: bool


class AskSticks(WireMessage, frozen=True, tag="ask_sticks"):
    """A page that watches wants to fly; the one that flies gives or keeps within 10 s."""

    seq: Seq


class GiveSticks(WireMessage, frozen=True, tag="give_sticks"):
    """Give the sticks, which are at rest, to the page that asks."""

    seq: Seq


class KeepSticks(WireMessage, frozen=True, tag="keep_sticks"):
    """Keep the sticks; the page that asks is told."""

    seq: Seq


class SetName(WireMessage, frozen=True, tag="set_name"):
    """What the person at this page is called from now on, to the other pages and in the log."""

    seq: Seq
    name: str
    """One line of 24 characters at most; empty: the page goes by its number again."""


class LeaveSeat(WireMessage, frozen=True, tag="leave_seat"):
    """The page has become too narrow to fly from: it shows the flight from now on, and the next page flies."""

    seq: Seq


class TakeSeat(WireMessage, frozen=True, tag="take_seat"):
    """The page is wide enough to fly from again: it flies if nobody else does, and else watches."""

    seq: Seq


class HandsOff(WireMessage, frozen=True, tag="hands_off"):
    """Nobody is at the controls: sticks at rest, RATE HOLD let go, POSITION HOLD on; a sequence goes on."""

    seq: Seq
    cause: Literal["page hidden", "device lost"]


class SetBrakes(WireMessage, frozen=True, tag="brakes"):
    """Set BRAKES: on, every joint stands at once."""

    seq: Seq
    on: bool


class SetSafing(WireMessage, frozen=True, tag="safing"):
    """Set SAFING: on, zero joint rates are commanded; off is its CANCEL."""

    seq: Seq
    on: bool


class LookAhead(WireMessage, frozen=True, tag="look_ahead"):
    """How far to look ahead."""

    seq: Seq
    seconds: Annotated[float, msgspec.Meta(ge=2.0, le=20.0)]
    """[s]"""


class Proceed(WireMessage, frozen=True, tag="proceed"):
    """AUTO SEQ switch to PROCEED."""

    seq: Seq


class Stop(WireMessage, frozen=True, tag="stop"):
    """AUTO SEQ switch to STOP; sticks go to zero too."""

    seq: Seq


class SetEffector(WireMessage, frozen=True, tag="effector"):
    """Put the end effector's switch: the prong closes or opens; the snares capture or release."""

    seq: Seq
    switch: EffectorSwitch


class SetEffectorMode(WireMessage, frozen=True, tag="effector_mode"):
    """END EFFECTOR MODE of the snares: the whole sequence, or the snares alone."""

    seq: Seq
    mode: Literal["auto", "manual"]


class SetRigid(WireMessage, frozen=True, tag="rigid"):
    """END EFFECTOR MAN CONTR: the carriage alone, in manual."""

    seq: Seq
    rigid: Literal["off", "rigid", "derigid"]


class PressLatch(WireMessage, frozen=True, tag="latch"):
    """Hold the payload in its seat (retention latches, docking port), or let it go."""

    seq: Seq
    latch: Literal["latch", "unlatch"]


class SetMaster(WireMessage, frozen=True, tag="master"):
    """Put the master arm, which MASTER follows."""

    seq: Seq
    angles: Six
    """[rad]"""


class Initialise(WireMessage, frozen=True, tag="initialise"):
    """Put arm and payload back to where a part of the problem begins."""

    seq: Seq
    part: ProblemPart


class Restart(WireMessage, frozen=True, tag="restart"):
    """Put the scenario back to its first instant."""

    seq: Seq


class FlyScenario(WireMessage, frozen=True, tag="fly_scenario"):
    """Leave this flight and fly another scenario; what is recorded of this one is finished and kept."""

    seq: Seq
    number: Annotated[int, msgspec.Meta(ge=0)]
    """Its place in `Scenarios.scenarios`."""


class DriveCamera(WireMessage, frozen=True, tag="drive_camera"):
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


class Shown(WireMessage, frozen=True, tag="shown"):
    """What the page measures of itself and shows, told once a second and when it changes; for recording and strips."""

    seq: Seq
    latency_ms: Annotated[float, msgspec.Meta(ge=0.0, le=1e6)] | None
    """Stick to picture, 95th percentile of the last 10 s [ms]."""
    monitors: Annotated[tuple[Monitor, ...], msgspec.Meta(max_length=2)] = ()
    """What MON 1 and MON 2 show."""


class SetLight(WireMessage, frozen=True, tag="set_light"):
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


class Controllers(WireMessage, frozen=True, tag="controllers"):
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
