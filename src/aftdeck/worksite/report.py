"""Record of the worksite after one control step: contacts, conditions of capture, end effector, payloads and orbiter.

Measurements between bodies are recorded to a hundredth of a millimetre, directions to five decimals.
"""

from __future__ import annotations

from typing import Annotated, Literal

import msgspec

from aftdeck.field_meta import field_meta
from aftdeck.tuples import Joints, Rows, Vec3
from aftdeck.worksite.conditions import Condition
from aftdeck.worksite.watch.alarm import Level

COARSE = 5
"""Decimals of measurements between bodies."""


class Near(msgspec.Struct, frozen=True, gc=False):
    """Two monitored parts."""

    a: Annotated[str, field_meta("name of the first part: `lower boom`")]
    b: Annotated[str, field_meta("name of the second part")]
    clearance: Annotated[float, field_meta("distance of the two parts; negative if they overlap", "m", decimals=COARSE)]
    closing: Annotated[
        float,
        field_meta(
            "speed at which the two closest points approach each other; negative if they separate",
            "m/s",
            decimals=COARSE,
        ),
    ]
    point_a: Annotated[Vec3, field_meta("closest point of the first part", "m", "L", COARSE)]
    point_b: Annotated[Vec3, field_meta("closest point of the second part", "m", "L", COARSE)]
    normal: Annotated[
        Vec3,
        field_meta(
            "unit normal of a plane between the two parts, from `a` to `b`; zero if the parts are in contact",
            "1",
            "L",
            COARSE,
        ),
    ]
    distance: Annotated[
        float,
        field_meta("distance of that plane from the origin; 0 if the parts are in contact", "m", "L", COARSE),
    ]
    essential: Annotated[
        bool, field_meta("whether a contact of the two parts belongs to the task and therefore inhibits nothing")
    ] = False
    feature_a: Annotated[
        str, field_meta("feature of `a` that touches `b`: `vertex 3`; empty if the parts are not in contact")
    ] = ""
    feature_b: Annotated[str, field_meta("feature of `b` that touches `a`; empty if the parts are not in contact")] = ""


class Cargo(msgspec.Struct, frozen=True, gc=False):
    """A payload of the worksite."""

    name: Annotated[str, field_meta("name of the payload")]
    position: Annotated[Vec3, field_meta("position of the payload's centre", "m", "L")]
    orientation: Annotated[Rows, field_meta("orientation of the payload's axes", "1", "L")]
    velocity: Annotated[Vec3, field_meta("velocity of the payload's centre", "m/s", "L")]
    held: Annotated[bool, field_meta("whether the end effector holds the payload")]
    seat: Annotated[str, field_meta("berth to which the payload is fixed; empty if it is not fixed to a berth")]


class Hand(msgspec.Struct, frozen=True, gc=False):
    """The end effector."""

    switch: Annotated[Literal["stop", "close", "open"], field_meta("position of the end effector's switch")]
    opening: Annotated[
        float, field_meta("opening of the prong or the snares, from 0 (closed) to 1 (open)", "1", decimals=COARSE)
    ]
    spacing: Annotated[
        float | None,
        field_meta("distance from the prong to the fixed finger; null on an arm without a prong", "m", decimals=COARSE),
    ]
    carriage: Annotated[
        float | None,
        field_meta(
            "position of the carriage, from 0 (extended) to 1 (retracted); null on an arm without a carriage",
            "1",
            decimals=COARSE,
        ),
    ]
    flags: Annotated[tuple[str, ...], field_meta("flags that are lit on the panel: `CAPTURE`, `RIGID`")]
    mode: Annotated[Literal["auto", "manual"], field_meta("position of END EFFECTOR MODE")] = "auto"
    rigid: Annotated[Literal["off", "rigid", "derigid"], field_meta("position of END EFFECTOR MAN CONTR")] = "off"


class Motion(msgspec.Struct, frozen=True, gc=False):
    """A mechanism in motion."""

    text: Annotated[str, field_meta("mechanism and what it does: `latches close`, `snares open`")]
    remaining_s: Annotated[float, field_meta("time in which the mechanism reaches its end position", "s", decimals=3)]


class Objective(msgspec.Struct, frozen=True, gc=False):
    """Action that becomes possible at the present position of the end effector once the conditions hold."""

    action: Annotated[
        Literal["acquire", "capture", "dock", "insert", "berth"], field_meta("kind of action that becomes possible")
    ]
    text: Annotated[
        str, field_meta("the action as a text for the operator: `acquire payload`, `berth in the Cargo bay`")
    ]


class Work(msgspec.Struct, frozen=True, gc=False):
    """The worksite after a step."""

    task: Annotated[
        int, field_meta("task phase, the report's MODE: 1 acquisition, 2 extraction, 3 manoeuvring, 4 docked")
    ]
    nearest: Annotated[
        Near | None,
        field_meta(
            "monitored pair with the minimum clearance; null if no pair is monitored. A pair that the task brings "
            "into contact is left out, because the conditions report its distance"
        ),
    ]
    clearance_level: Annotated[
        Level, field_meta("alarm level of the minimum clearance, from the scenario's thresholds")
    ]
    contacts: Annotated[tuple[Near, ...], field_meta("pairs that touch or overlap")]
    arm_inhibit: Annotated[bool, field_meta("whether a contact inhibits the arm")]
    finger_inhibit: Annotated[bool, field_meta("whether a contact inhibits the finger")]
    inhibits: Annotated[tuple[str, ...], field_meta("reasons for which the arm or the finger is inhibited")]
    objective: Annotated[
        Objective | None,
        field_meta("action that becomes possible once the conditions hold; null if no action is near"),
    ]
    conditions: Annotated[tuple[Condition, ...], field_meta("conditions of capture, docking or latching")]
    hand: Annotated[Hand, field_meta("state of the end effector")]
    stand: Annotated[float | None, field_meta("length of the telescope; null on an arm without a telescope", "m")]
    orbiter: Annotated[Vec3, field_meta("displacement of the orbiter since the start", "m", "L")]
    orbiter_velocity: Annotated[Vec3, field_meta("velocity of the orbiter", "m/s", "L")]
    cargo: Annotated[tuple[Cargo, ...], field_meta("state of each payload of the worksite")]
    master: Annotated[
        Joints | None, field_meta("joint angles of the master arm; null in modes other than MASTER", "rad")
    ]
