"""All that a reader may know of one instant: the station, a recording, a study, a policy."""

from __future__ import annotations

from typing import Literal

import msgspec

from aftdeck.bodies.cameras import Setting
from aftdeck.worksite.report import Work

Vec3 = tuple[float, float, float]
Six = tuple[float, float, float, float, float, float]
Level = Literal["info", "caution", "warning"]
Sequence = Literal["idle", "checking", "ready", "in progress"]

FREE, PAST_REACH, PAST_SOFT, AT_HARD = 0, 1, 2, 3
"""Zones of a joint."""


class Event(msgspec.Struct, frozen=True, gc=False):
    """Something that happened, for the log."""

    time_s: float
    kind: str
    level: Level
    text: str


LimitKind = Literal[
    "joint rate",
    "soft stop",
    "hard stop",
    "singularity",
    "joint acceleration",
    "POR translation",
    "POR rotation",
    "POR acceleration",
    "seat",
    "contact",
    "switch",
]


class Limit(msgspec.Struct, frozen=True, gc=False):
    """A limit that acted in a step."""

    kind: LimitKind
    joint: int
    """0 to 5; -1 where no single joint is concerned."""
    text: str


Cause = Literal["", "reach", "seat", "switch", "contact", "limit", "miss", "time"]
"""Why CMD CK fails: not at all; the target is out of reach; a seat holds the payload; BRAKES or SAFING; a contact; a
stop, a singularity or another limit of the steering; the motion ends beside its target; it takes too long."""


class Check(msgspec.Struct, frozen=True):
    """CMD CK: what a rehearsal of the motion to a target found."""

    good: bool
    text: str
    """``GOOD: 83 s`` or ``FAIL: elbow pitch meets its soft stop 12 s from here``."""
    seconds: float = 0.0
    """GOOD: how long the motion takes; FAIL: when it fails [s]."""
    cause: Cause = ""
    joints: Six | None = None
    """The joint angles that mode 1 flies to [rad]; None in modes 2 and 3, and where it fails."""


class WayOut(msgspec.Struct, frozen=True, gc=False):
    """How to leave a singularity or a joint's stop."""

    cause: str
    """``elbow`` (a singularity) or a joint's name."""
    text: str
    """For people: ``THC -X``, ``RHC +pitch``, ``SINGLE elbow pitch -``."""
    stick: Literal["translation", "rotation", "joint"]
    axis: int
    """Axis 0 to 2 of the stick, or the joint."""
    sign: int


class Goal(msgspec.Struct, frozen=True, gc=False):
    """An automatic mode's target, frame 7 in L, and what is left to it."""

    position: Vec3
    """[m]"""
    rotation: tuple[Vec3, Vec3, Vec3]
    """Rows."""
    distance: float
    """[m]"""
    angle: float
    """[rad]"""
    remaining_s: float
    """ETA - TP [s]; 0 when not under way, and while modes 1 and 3 still bring the arm to rest."""


class Times(msgspec.Struct, frozen=True, gc=False):
    """JSC-12628's times of the phase under way, counted from its beginning.

    A phase is an automatic motion from where it sets off, else a phase of the script, else a panel position entered.
    """

    tp_s: float = 0.0
    """TP: how long it has lasted [s]."""
    eta_s: float | None = None
    """ETA: when it ends, as estimated in the automatic modes and given in a script's others [s]; None: unknown."""
    etap_s: float | None = None
    """ETAP: when the rotation would end if it went as fast as permitted [s]; in modes 2 and 3, else None."""


class Frame(msgspec.Struct, frozen=True, gc=False):
    """The state after a control step, the inputs that it flew and what acted in it.

    Vectors are in L, the longeron frame, unless said otherwise; the tip is frame 7.
    """

    tick: int
    """Control steps done."""
    time_s: float
    """tick * control period."""
    phase: str
    """The script's phase; empty when flown by hand."""
    by: Literal["hand", "script"]
    mode: str
    """Panel position entered."""
    law: int
    """The report's mode number flown, 1 to 8; 0 TEST, 9 DIRECT."""
    law_choice: Literal["position", "closed loop", "open loop"]
    """Switch beside OPR CMD and AUTO 1-4."""
    payload_axes: bool
    """Switch beside ORB LD."""
    rate_hold: bool
    """RATE HOLD keeps a stick command."""
    position_hold: bool
    """POSITION HOLD is on."""
    brakes: bool
    """BRAKES are on: the joints stand."""
    safing: bool
    """SAFING: zero joint rates are commanded."""
    joint: int
    """Selected joint, 0 to 5."""
    rate: Literal["coarse", "vernier"]
    sequence: Sequence
    """CHECKING, READY and IN PROG of the automatic modes."""
    point: int
    """AUTO 1-4: the point, from 1, that is flown to or comes next; 0 in other modes."""
    points: int
    """AUTO 1-4: how many there are."""
    check: Check | None
    """CMD CK of the present target."""
    translation: Vec3
    """THC as flown."""
    rotation: Vec3
    """RHC as flown."""
    drive: float
    angles: Six
    """Measured [rad]."""
    rates: Six
    """Measured [rad/s]."""
    angles_commanded: Six
    """Where the commanded rates would have brought the arm [rad]."""
    rates_commanded: Six
    """[rad/s]"""
    rate_limits: Six
    """In force [rad/s]."""
    zones: tuple[int, int, int, int, int, int]
    """Per joint: 0 free, 1 past the reach limit, 2 past the soft stop, 3 at the hard stop."""
    position: Vec3
    """Tip [m]."""
    orientation: tuple[Vec3, Vec3, Vec3]
    """Rows of the matrix whose columns are frame 7's axes."""
    wrist_pitch: tuple[Vec3, Vec3, Vec3] | None
    """T_B5: rows of the matrix from the wrist-pitch frame 5 to the orbiter's body axes; the concept arm's: its lower
    arm's frame. None: of a recording that does not tell it."""
    resolution: Vec3
    """The point of resolution [m]: the payload's in ORB LD and PL, else the tip."""
    payload: tuple[Vec3, tuple[Vec3, Vec3, Vec3]] | None
    """Centre [m] and axes (rows) of the payload in the grasp."""
    attached: int
    """Which of the scenario's own payloads (`Scenario.own_payloads`) that is, from 1; 0: none of them."""
    twist: Six
    """Angular velocity [rad/s], then velocity of the point of resolution [m/s]."""
    twist_commanded: Six
    """What RATLMT left of the commanded twist."""
    twist_demanded: Six
    """What the mode asked for, before every limit."""
    por_limits: tuple[float, float]
    """Speed [m/s] and angular rate [rad/s] of the point of resolution, in force."""
    ratio: float
    """What RATLMT left of the demand, 0 to 1."""
    limits: tuple[Limit, ...]
    """Limits that acted in this step."""
    singularity: Vec3
    """Signed distances: shoulder, elbow, wrist."""
    singular: tuple[str, ...]
    """Names of the singularities nearer than the arm's threshold."""
    ways_out: tuple[WayOut, ...]
    """For each singularity that is near and each joint past a limit: what leads away from it."""
    goal: Goal | None
    times: Times
    """TP, ETA and ETAP."""
    work: Work
    """Contacts, captures, and where the worksite's things are."""
    events: tuple[Event, ...]
    """What happened in this step."""
    views: tuple[Setting, ...]
    """Where the drives of the cameras stand that have any, in the order of `scenario.cameras.cameras_of`."""
    sha256: str
    """Of all this and the state behind it, to the last digit."""
