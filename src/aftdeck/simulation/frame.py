"""Frame: the record of one step, for the station, a recording, a study or a policy.

Each field is declared only here: type, description, unit, coordinate frame of the components, and number of recorded
decimals. The recording, its schema and its documentation are derived from these declarations.
"""

from __future__ import annotations

from typing import Annotated, Literal, NamedTuple, get_args

import msgspec

from aftdeck.bodies.cameras import Setting
from aftdeck.field_meta import field_meta
from aftdeck.matrices import length
from aftdeck.tuples import Joints, Rows, Six, Vec3
from aftdeck.worksite.report import Motion, Work

Level = Literal["info", "caution", "warning"]
Sequence = Literal["idle", "checking", "ready", "in progress"]

FREE, PAST_REACH, PAST_SOFT, AT_HARD = 0, 1, 2, 3
"""Zones of a joint: inside all limits, beyond the reach limit, beyond the soft stop, at the hard stop."""


class Event(msgspec.Struct, frozen=True, gc=False):
    """Event of a step, as a line of the log."""

    time_s: Annotated[float, field_meta("simulated time", "s")]
    kind: Annotated[str, field_meta("kind of event, such as `mode` or `contact`")]
    level: Annotated[Level, field_meta("urgency")]
    text: Annotated[str, field_meta("text for the operator")]


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

    kind: Annotated[LimitKind, field_meta("kind of limit")]
    joint: Annotated[int, field_meta("joint to which the limit applies, from 0; -1 if the limit applies to no joint")]
    text: Annotated[str, field_meta("text for the operator")]


Cause = Literal["", "reach", "seat", "switch", "contact", "limit", "miss", "time"]
"""Cause of CMD CK's verdict FAIL.

The values mean, in this order: no failure; the target is out of reach; a berth holds the payload; BRAKES or SAFING is
on; a contact ends the motion; a stop, a singularity or another limit of the steering ends the motion; the motion misses
its target; the motion takes too long.
"""


class Check(msgspec.Struct, frozen=True):
    """Verdict of CMD CK, from a rehearsal of the motion to a target."""

    good: Annotated[bool, field_meta("true for GOOD, false for FAIL")]
    text: Annotated[
        str, field_meta("verdict as displayed: `GOOD: 83 s` or `FAIL: elbow pitch reaches its soft stop, after 12 s`")
    ]
    seconds: Annotated[
        float, field_meta("GOOD: duration of the motion; FAIL: time from the start of the motion to the failure", "s")
    ] = 0.0
    cause: Annotated[Cause, field_meta("cause of a FAIL; empty for GOOD")] = ""
    joints: Annotated[
        Joints | None,
        field_meta("GOOD in mode 1: joint angles at the target; null in modes 2 and 3, and for FAIL", "rad"),
    ] = None


class WayOut(msgspec.Struct, frozen=True, gc=False):
    """Command that leads away from a singularity or joint limit, or out of contacts that inhibit the arm."""

    cause: Annotated[
        str, field_meta("cause of the escape direction: `elbow` (a singularity), a joint's name, or `contact`")
    ]
    text: Annotated[str, field_meta("text for the operator: `THC -X`, `RHC +pitch`, `SINGLE elbow pitch -`")]
    stick: Annotated[Literal["translation", "rotation", "joint", "telescope"], field_meta("stick or switch to deflect")]
    axis: Annotated[int, field_meta("axis of the stick, 0 to 2, or number of the joint")]
    sign: Annotated[int, field_meta("direction: +1 or -1")]
    position: Annotated[
        str, field_meta("panel position to select first; empty if the stick acts in the present position")
    ] = ""


class Goal(msgspec.Struct, frozen=True, gc=False):
    """Target of an automatic mode (pose of frame 7), and the remaining distance, angle and time."""

    position: Annotated[Vec3, field_meta("position of the tip at the target", "m", "L")]
    rotation: Annotated[Rows, field_meta("attitude of frame 7 at the target", "1", "L")]
    distance: Annotated[float, field_meta("remaining distance", "m")]
    angle: Annotated[float, field_meta("remaining rotation", "rad")]
    remaining_s: Annotated[
        float,
        field_meta(
            "ETA - TP; 0 if no motion is in progress, or while the arm slows to rest before a motion in mode 1 or 3",
            "s",
        ),
    ]


class Times(msgspec.Struct, frozen=True, gc=False):
    """Times of the present phase (JSC-12628's term), counted from the beginning of the phase.

    Such a phase begins with an automatic motion, a phase of the script, the selection of a panel position or a
    re-initialisation.
    """

    tp_s: Annotated[float, field_meta("TP: time since the beginning of the phase", "s")] = 0.0
    eta_s: Annotated[
        float | None,
        field_meta(
            "ETA: end of the phase; an estimate in automatic modes, else the duration of the script's phase; null if "
            "unknown",
            "s",
        ),
    ] = None
    etap_s: Annotated[
        float | None,
        field_meta(
            "ETAP: time at which the rotation would end without the translation, with the angular rate limit; null in "
            "all modes except 2 and 3",
            "s",
        ),
    ] = None


class Placed(NamedTuple):
    """Pose of a body."""

    position: Annotated[Vec3, field_meta("position of the body's centre", "m", "L")]
    orientation: Annotated[Rows, field_meta("attitude of the body", "1", "L")]


class Force(msgspec.Struct, frozen=True, gc=False):
    """Force between two parts in contact, in one control step."""

    a: Annotated[str, field_meta("first part")]
    b: Annotated[str, field_meta("second part")]
    force: Annotated[
        Vec3, field_meta("mean force on the second part; times the control period, the impulse", "N", "L", decimals=3)
    ]
    position: Annotated[Vec3, field_meta("point at which it acts", "m", "L")]
    greatest: Annotated[
        float | None,
        field_meta(
            "greatest force within the control step; null in files of earlier versions, whose `force` is that at "
            "its end",
            "N",
            decimals=3,
        ),
    ] = None

    @property
    def peak(self) -> float:
        """Greatest force within the control step, as far as it is known [N]."""
        return length(self.force) if self.greatest is None else self.greatest


Holder = Literal["end effector", "orbiter", "space"]
"""What can hold a payload."""
HOLDERS: tuple[Holder, ...] = get_args(Holder)
"""All holders, in the order of the columns of `Bodies.held`."""


class Holding(msgspec.Struct, frozen=True, gc=False):
    """Force by which something holds a payload of the worksite."""

    payload: Annotated[str, field_meta("name of the payload")]
    by: Annotated[Holder, field_meta("what holds the payload")]
    force: Annotated[float, field_meta("force at the payload's centre, at the end of the step", "N", decimals=3)]
    greatest: Annotated[
        float | None,
        field_meta(
            "greatest force within the control step, if solids are near each other, else that at its end; null in "
            "files of earlier versions",
            "N",
            decimals=3,
        ),
    ] = None

    @property
    def peak(self) -> float:
        """Greatest force within the control step, as far as it is known [N]."""
        return self.force if self.greatest is None else self.greatest


class Bend(msgspec.Struct, frozen=True, gc=False):
    """How far a part of the arm is bent: the motion of its end relative to the straight part.

    Its components are in the frame that carries the part: L for the base, the frame of the joint for a boom.
    """

    part: Annotated[str, field_meta("name of the part: `base`, `upper_boom` or `lower_boom`")]
    displacement: Annotated[Vec3, field_meta("displacement of the part's end", "m", "part")]
    rotation: Annotated[Vec3, field_meta("rotation vector of the part's end", "rad", "part")]


class Wrench(msgspec.Struct, frozen=True, gc=False):
    """Disturbance that acts on a body in one control step, in the axes that L has when the step begins."""

    body: Annotated[str, field_meta("what it acts on: `tip`, `orbiter`, or the name of a payload")]
    force: Annotated[Vec3, field_meta("mean force on the body", "N", "L", decimals=3)]
    torque: Annotated[
        Vec3, field_meta("mean torque on the body in addition to that of the force", "N m", "L", decimals=3)
    ]
    position: Annotated[Vec3, field_meta("point at which the force acts", "m", "L")]


class Dynamics(msgspec.Struct, frozen=True, gc=False):
    """Motion of the bodies behind the joints: what the encoders do not show, on a plant with masses.

    Fields of `Frame` about the arm follow from the measured angles; the fields here follow from the bodies.
    """

    position: Annotated[Vec3, field_meta("true position of the tip", "m", "L")]
    orientation: Annotated[Rows, field_meta("true attitude of frame 7", "1", "L")]
    miss: Annotated[
        tuple[float, float] | None,
        field_meta("true distance and angle of the tip from the target; null if there is none", "m, rad"),
    ]
    torques: Annotated[
        Joints, field_meta("torque of motor or brake about each joint, at the end of the step", "N m", decimals=3)
    ]
    overdriven: Annotated[
        tuple[int, ...], field_meta("joints, from 0, that turn against a motor or brake at its greatest torque")
    ]
    orbiter: Annotated[Placed, field_meta("pose of L, relative to its pose at the start of the run", "m, 1", "L")]
    fired: Annotated[
        Six, field_meta("time for which the orbiter's jets have fired, about and along forward, starboard, down", "s")
    ]
    contacts: Annotated[tuple[Force, ...], field_meta("forces between parts in contact")]
    holds: Annotated[tuple[Holding, ...], field_meta("forces that hold the worksite's payloads")]
    bends: Annotated[tuple[Bend, ...], field_meta("bends of base and booms; empty if the arm is rigid")]
    disturbances: Annotated[tuple[Wrench, ...], field_meta("forces and torques that disturb bodies")] = ()


class Frame(msgspec.Struct, frozen=True, gc=False):
    """State after a control step, with the inputs and limits that acted. The tip is coordinate frame 7."""

    tick: Annotated[int, field_meta("number of control steps done")]
    time_s: Annotated[float, field_meta("simulated time: tick x control period", "s")]
    phase: Annotated[str, field_meta("name of the script's phase; empty with manual inputs")]
    by: Annotated[Literal["hand", "script"], field_meta("source of this step's inputs")]
    mode: Annotated[str, field_meta("mode: selected panel position")]
    law: Annotated[int, field_meta("number of the steering law: 1 to 8 as in the report, 0 TEST, 9 DIRECT, 10 MASTER")]
    law_choice: Annotated[
        Literal["position", "closed loop", "open loop"],
        field_meta("position of the switch that selects the steering law of OPR CMD and AUTO 1-4"),
    ]
    payload_axes: Annotated[bool, field_meta("whether the switch beside ORB LD selects rotation about payload axes")]
    rate_hold: Annotated[bool, field_meta("whether RATE HOLD keeps a stick command")]
    position_hold: Annotated[bool, field_meta("whether POSITION HOLD is on")]
    brakes: Annotated[bool, field_meta("whether BRAKES are on")]
    safing: Annotated[bool, field_meta("whether SAFING commands zero joint rates")]
    joint: Annotated[int, field_meta("selected joint, from 0")]
    rate: Annotated[Literal["coarse", "vernier"], field_meta("rate setting")]
    sequence: Annotated[Sequence, field_meta("state of an automatic mode; `checking` while CMD CK runs")]
    point: Annotated[int, field_meta("AUTO 1-4: number of the present or next point, from 1; 0 in other modes")]
    points: Annotated[int, field_meta("AUTO 1-4: total number of points; 0 in other modes")]
    check: Annotated[Check | None, field_meta("result of CMD CK for the present target; null if there is none")]
    translation: Annotated[Vec3, field_meta("THC deflection that acted, in [-1, 1]", "1", "control", 7)]
    rotation: Annotated[Vec3, field_meta("RHC deflection that acted, in [-1, 1]", "1", "control", 7)]
    drive: Annotated[float, field_meta("DRIVE deflection that acted, in [-1, 1]", "1", decimals=7)]
    angles: Annotated[Joints, field_meta("joint angles, measured", "rad")]
    rates: Annotated[Joints, field_meta("joint rates, measured", "rad/s")]
    angles_commanded: Annotated[Joints, field_meta("joint angles that the commanded rates alone would give", "rad")]
    rates_commanded: Annotated[Joints, field_meta("joint rates, commanded", "rad/s")]
    rate_limits: Annotated[Joints, field_meta("joint rate limits in force", "rad/s")]
    zones: Annotated[
        tuple[int, ...],
        field_meta("for each joint: 0 free, 1 beyond the reach limit, 2 beyond the soft stop, 3 at the hard stop"),
    ]
    position: Annotated[Vec3, field_meta("position of the tip", "m", "L")]
    orientation: Annotated[Rows, field_meta("attitude of frame 7", "1", "L")]
    wrist_pitch: Annotated[
        Rows | None,
        field_meta(
            "T_B5: attitude of the wrist-pitch frame 5 in the orbiter's body axes; on the concept arm, attitude of "
            "the lower arm's frame; null in a recording that does not contain it",
            "1",
            "orbiter",
        ),
    ]
    resolution: Annotated[
        Vec3, field_meta("position of the point of resolution: the payload's in ORB LD and PL, else the tip", "m", "L")
    ]
    payload: Annotated[Placed | None, field_meta("payload in the grasp; null if the grasp is empty")]
    attached: Annotated[
        int,
        field_meta(
            "if the payload in the grasp is one of `Scenario.own_payloads`, its number, from 1; 0 for any other "
            "payload, and for an empty grasp"
        ),
    ]
    twist: Annotated[Six, field_meta("angular velocity, and velocity of the point of resolution", "rad/s, m/s", "L", 7)]
    twist_commanded: Annotated[Six, field_meta("twist after RATLMT's limits", "rad/s, m/s", "L", 7)]
    twist_demanded: Annotated[Six, field_meta("twist that the mode demands, before all limits", "rad/s, m/s", "L", 7)]
    por_limits: Annotated[
        tuple[float, float],
        field_meta("speed limit and angular rate limit of the point of resolution in this step", "m/s, rad/s"),
    ]
    ratio: Annotated[float, field_meta("fraction of the demand that RATLMT permits, 0 to 1", "1", decimals=7)]
    limits: Annotated[tuple[Limit, ...], field_meta("limits that were active in this step")]
    singularity: Annotated[
        tuple[float, ...],
        field_meta(
            "signed distances from the arm's singularities: shoulder, elbow, wrist; or only rank", "1", decimals=7
        ),
    ]
    singular: Annotated[tuple[str, ...], field_meta("singularities nearer than the arm's threshold")]
    ways_out: Annotated[
        tuple[WayOut, ...],
        field_meta(
            "escape direction from each singularity in `singular` and each joint beyond a limit; while a contact "
            "inhibits the arm, only the escape direction from the contact"
        ),
    ]
    goal: Annotated[Goal | None, field_meta("target of an automatic mode; null if there is none")]
    times: Annotated[Times, field_meta("TP, ETA and ETAP")]
    work: Annotated[Work, field_meta("state of the worksite: contacts, captures and payloads")]
    events: Annotated[tuple[Event, ...], field_meta("events of this step")]
    views: Annotated[
        tuple[Setting, ...],
        field_meta(
            "pan, tilt and field of view of the driven cameras, in the order of `scenario.all_cameras.cameras_of`",
            "rad",
        ),
    ]
    sha256: Annotated[str, field_meta("SHA-256 of the exact state")]
    dynamics: Annotated[
        Dynamics | None, field_meta("motion of the bodies; null on the kinematic plant, where the encoders show it")
    ] = None
    motions: Annotated[
        tuple[Motion, ...], field_meta("mechanisms in motion: latches, snares, carriage, prong, telescope")
    ] = ()
    changes: Annotated[
        tuple[str, ...], field_meta("changes in flight that are in force, each as KEY=VALUE; empty if there are none")
    ] = ()
