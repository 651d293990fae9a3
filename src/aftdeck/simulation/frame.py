"""Frame: the record of one step, for the station, a recording, a study or a policy.

Each field is declared only here: type, description, unit, axes in which the field is expressed, and recorded decimals.
The session file, its schema and its documentation are derived from these declarations.
"""

from __future__ import annotations

from typing import Annotated, Literal, NamedTuple

import msgspec

from aftdeck.bodies.cameras import Setting
from aftdeck.told import told
from aftdeck.worksite.report import Work

Vec3 = tuple[float, float, float]
Rows = tuple[Vec3, Vec3, Vec3]
"""Rotation as the rows of the matrix whose columns are the axes. In files a rotation is a quaternion, w, x, y, z."""
Six = tuple[float, float, float, float, float, float]
Level = Literal["info", "caution", "warning"]
Sequence = Literal["idle", "checking", "ready", "in progress"]

FREE, PAST_REACH, PAST_SOFT, AT_HARD = 0, 1, 2, 3
"""Zones of a joint."""


class Event(msgspec.Struct, frozen=True, gc=False):
    """Event of a step, as a line of the log."""

    time_s: Annotated[float, told("simulated time", "s")]
    kind: Annotated[str, told("what it is about")]
    level: Annotated[Level, told("how urgent")]
    text: Annotated[str, told("for people")]


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
    """Limit that acted in a step."""

    kind: Annotated[LimitKind, told("which kind")]
    joint: Annotated[int, told("0 to 5; -1: no single joint is concerned")]
    text: Annotated[str, told("for people")]


Cause = Literal["", "reach", "seat", "switch", "contact", "limit", "miss", "time"]
"""Cause of a FAIL of CMD CK.

In this order: no failure; the target is out of reach; a seat holds the payload; BRAKES or SAFING is on; a contact; a
stop, a singularity or another limit of the steering; the motion misses its target; the motion takes too long.
"""


class Check(msgspec.Struct, frozen=True):
    """Verdict of CMD CK, from a rehearsal of the motion to a target."""

    good: Annotated[bool, told("GOOD, not FAIL")]
    text: Annotated[str, told("`GOOD: 83 s` or `FAIL: elbow pitch meets its soft stop 12 s from here`")]
    seconds: Annotated[float, told("GOOD: how long the motion takes; FAIL: when it fails", "s")] = 0.0
    cause: Annotated[Cause, told("why it fails; empty: it does not")] = ""
    joints: Annotated[
        Six | None, told("the joint angles that mode 1 flies to; null in modes 2 and 3, and where it fails", "rad")
    ] = None


class WayOut(msgspec.Struct, frozen=True, gc=False):
    """Command that leads away from a singularity or a joint's limit, or out of the contacts that inhibit the arm."""

    cause: Annotated[str, told("`elbow` (a singularity), a joint's name, or `contact`")]
    text: Annotated[str, told("for people: `THC -X`, `RHC +pitch`, `SINGLE elbow pitch -`")]
    stick: Annotated[Literal["translation", "rotation", "joint", "telescope"], told("which stick or switch")]
    axis: Annotated[int, told("axis 0 to 2 of the stick, or the joint")]
    sign: Annotated[int, told("+1 or -1")]
    position: Annotated[str, told("panel position to enter first; empty: the stick acts in the present one")] = ""


class Goal(msgspec.Struct, frozen=True, gc=False):
    """Target of an automatic mode (pose of frame 7), and the distance, angle and time that remain."""

    position: Annotated[Vec3, told("of the tip there", "m", "L")]
    rotation: Annotated[Rows, told("attitude of frame 7 there", "1", "L")]
    distance: Annotated[float, told("what is left", "m")]
    angle: Annotated[float, told("what is left", "rad")]
    remaining_s: Annotated[
        float,
        told("ETA - TP; 0 when not under way, and while modes 1 and 3 still bring the arm to rest", "s"),
    ]


class Times(msgspec.Struct, frozen=True, gc=False):
    """Times of the phase under way, as in JSC-12628, counted from the beginning of the phase.

    A phase begins when an automatic motion sets off, a phase of the script begins, or a panel position is entered.
    """

    tp_s: Annotated[float, told("TP: how long it has lasted", "s")] = 0.0
    eta_s: Annotated[
        float | None,
        told("ETA: when it ends, estimated in the automatic modes, given in a script's others; null: unknown", "s"),
    ] = None
    etap_s: Annotated[
        float | None,
        told("ETAP: when the rotation would end if it went as fast as permitted; in modes 2 and 3, else null", "s"),
    ] = None


class Placed(NamedTuple):
    """Pose of a body."""

    position: Annotated[Vec3, told("its centre", "m", "L")]
    orientation: Annotated[Rows, told("its attitude", "1", "L")]


class Frame(msgspec.Struct, frozen=True, gc=False):
    """State after a control step, with the inputs flown and the limits that acted. The tip is coordinate frame 7."""

    tick: Annotated[int, told("control steps done")]
    time_s: Annotated[float, told("simulated time: tick x control period", "s")]
    phase: Annotated[str, told("the script's phase; empty when flown by hand")]
    by: Annotated[Literal["hand", "script"], told("who flew this step")]
    mode: Annotated[str, told("panel position entered")]
    law: Annotated[int, told("the report's mode number flown, 1 to 8; 0 TEST, 9 DIRECT, 10 MASTER")]
    law_choice: Annotated[Literal["position", "closed loop", "open loop"], told("switch beside OPR CMD and AUTO 1-4")]
    payload_axes: Annotated[bool, told("switch beside ORB LD")]
    rate_hold: Annotated[bool, told("RATE HOLD keeps a stick command")]
    position_hold: Annotated[bool, told("POSITION HOLD is on")]
    brakes: Annotated[bool, told("BRAKES are on: the joints stand")]
    safing: Annotated[bool, told("SAFING: zero joint rates are commanded")]
    joint: Annotated[int, told("selected joint, 0 to 5")]
    rate: Annotated[Literal["coarse", "vernier"], told("rate setting")]
    sequence: Annotated[Sequence, told("CHECKING, READY and IN PROG of the automatic modes")]
    point: Annotated[int, told("AUTO 1-4: the point, from 1, that is flown to or comes next; 0 in other modes")]
    points: Annotated[int, told("AUTO 1-4: how many there are")]
    check: Annotated[Check | None, told("CMD CK of the present target")]
    translation: Annotated[Vec3, told("THC as flown, in [-1, 1]", "1", "control", 7)]
    rotation: Annotated[Vec3, told("RHC as flown, in [-1, 1]", "1", "control", 7)]
    drive: Annotated[float, told("DRIVE as flown, in [-1, 1]", "1", decimals=7)]
    angles: Annotated[Six, told("joint angles, measured", "rad")]
    rates: Annotated[Six, told("joint rates, measured", "rad/s")]
    angles_commanded: Annotated[Six, told("where the commanded rates would have brought the joints", "rad")]
    rates_commanded: Annotated[Six, told("joint rates, commanded", "rad/s")]
    rate_limits: Annotated[Six, told("joint rate limits in force", "rad/s")]
    zones: Annotated[
        tuple[int, int, int, int, int, int],
        told("per joint: 0 free, 1 past the reach limit, 2 past the soft stop, 3 at the hard stop"),
    ]
    position: Annotated[Vec3, told("of the tip", "m", "L")]
    orientation: Annotated[Rows, told("attitude of frame 7", "1", "L")]
    wrist_pitch: Annotated[
        Rows | None,
        told(
            "T_B5: attitude of the wrist-pitch frame 5 in the orbiter's body axes; the concept arm's: of its lower "
            "arm's frame; null in a recording that does not tell it",
            "1",
            "orbiter",
        ),
    ]
    resolution: Annotated[Vec3, told("point of resolution: the payload's in ORB LD and PL, else the tip", "m", "L")]
    payload: Annotated[Placed | None, told("the payload in the grasp")]
    attached: Annotated[
        int, told("which of the scenario's own payloads (`Scenario.own_payloads`) that is, from 1; 0: none of them")
    ]
    twist: Annotated[Six, told("angular velocity, then velocity of the point of resolution", "rad/s, m/s", "L", 7)]
    twist_commanded: Annotated[Six, told("what RATLMT left of the commanded twist", "rad/s, m/s", "L", 7)]
    twist_demanded: Annotated[Six, told("what the mode asked for, before every limit", "rad/s, m/s", "L", 7)]
    por_limits: Annotated[
        tuple[float, float], told("speed and angular rate of the point of resolution, in force", "m/s, rad/s")
    ]
    ratio: Annotated[float, told("what RATLMT left of the demand, 0 to 1", "1", decimals=7)]
    limits: Annotated[tuple[Limit, ...], told("limits that acted in this step")]
    singularity: Annotated[Vec3, told("signed distances: shoulder, elbow, wrist", "1", decimals=7)]
    singular: Annotated[tuple[str, ...], told("singularities nearer than the arm's threshold")]
    ways_out: Annotated[
        tuple[WayOut, ...],
        told(
            "for each singularity that is near and each joint past a limit: what leads away from it; while a contact "
            "inhibits the arm, only what leads out of the contact"
        ),
    ]
    goal: Annotated[Goal | None, told("target of an automatic mode")]
    times: Annotated[Times, told("TP, ETA and ETAP")]
    work: Annotated[Work, told("contacts, captures, and where the worksite's things are")]
    events: Annotated[tuple[Event, ...], told("what happened in this step")]
    views: Annotated[
        tuple[Setting, ...],
        told(
            "pan, tilt and field of view of the cameras that turn, in the order of `scenario.cameras.cameras_of`", "rad"
        ),
    ]
    sha256: Annotated[str, told("SHA-256 of the state behind all this, to the last digit")]
