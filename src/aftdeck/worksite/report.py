"""Record of the worksite at one instant: contacts, conditions of capture, and positions of everything.

Measurements between bodies are recorded to a hundredth of a millimetre, directions to five decimals.
"""

from __future__ import annotations

from typing import Annotated, Literal

import msgspec

from aftdeck.field_meta import field_meta
from aftdeck.worksite.conditions import Condition
from aftdeck.worksite.watch.alarm import Level

Vec3 = tuple[float, float, float]
Rows = tuple[Vec3, Vec3, Vec3]
Six = tuple[float, float, float, float, float, float]


COARSE = 5
"""Decimals of measurements between bodies."""


class Near(msgspec.Struct, frozen=True, gc=False):
    """Two monitored parts."""

    a: Annotated[str, field_meta("name of the first part: `lower boom`")]
    b: Annotated[str, field_meta("name of the second part")]
    clearance: Annotated[float, field_meta("distance of the two parts; negative if they overlap", "m", decimals=COARSE)]
    closing: Annotated[
        float, field_meta("speed at which the two closest points approach each other", "m/s", decimals=COARSE)
    ]
    point_a: Annotated[Vec3, field_meta("closest point of the first part", "m", "L", COARSE)]
    point_b: Annotated[Vec3, field_meta("closest point of the second part", "m", "L", COARSE)]
    normal: Annotated[
        Vec3,
        field_meta("unit normal of a plane between the two, from a to b; zero if they touch", "1", "L", COARSE),
    ]
    distance: Annotated[float, field_meta("distance of that plane from the origin", "m", "L", COARSE)]
    essential: Annotated[bool, field_meta("whether the contact belongs to the task, so that it inhibits nothing")] = (
        False
    )
    feature_a: Annotated[str, field_meta("feature of a that touches b: `vertex 3`; empty if they are apart")] = ""
    feature_b: Annotated[str, field_meta("feature of b that touches a")] = ""


class Cargo(msgspec.Struct, frozen=True, gc=False):
    """A payload of the worksite."""

    name: Annotated[str, field_meta("name of the payload")]
    position: Annotated[Vec3, field_meta("position of its centre", "m", "L")]
    orientation: Annotated[Rows, field_meta("orientation of its axes", "1", "L")]
    velocity: Annotated[Vec3, field_meta("velocity of its centre", "m/s", "L")]
    held: Annotated[bool, field_meta("whether the end effector holds it")]
    seat: Annotated[str, field_meta("berth that it is fixed to; empty if it is not fixed")]


class Hand(msgspec.Struct, frozen=True, gc=False):
    """The end effector."""

    switch: Annotated[Literal["stop", "close", "open"], field_meta("position of its switch")]
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
            "position of the carriage, from 0 (extended) to 1 (rigid); null on an arm without a carriage",
            "1",
            decimals=COARSE,
        ),
    ]
    flags: Annotated[tuple[str, ...], field_meta("flags that are lit on the panel: `CAPTURE`, `RIGID`")]
    mode: Annotated[Literal["auto", "manual"], field_meta("position of END EFFECTOR MODE")] = "auto"
    rigid: Annotated[Literal["off", "rigid", "derigid"], field_meta("position of END EFFECTOR MAN CONTR")] = "off"


class Objective(msgspec.Struct, frozen=True, gc=False):
    """Action of the end effector that its present position makes possible."""

    action: Annotated[
        Literal["acquire", "capture", "dock", "insert", "berth"], field_meta("action that becomes possible")
    ]
    text: Annotated[str, field_meta("text for the operator: `acquire payload`, `berth in the Cargo bay`")]


class Work(msgspec.Struct, frozen=True, gc=False):
    """The worksite after a step."""

    task: Annotated[
        int, field_meta("task phase, the report's MODE: 1 acquisition, 2 extraction, 3 manoeuvring, 4 docked")
    ]
    nearest: Annotated[
        Near | None,
        field_meta(
            "monitored pair with the minimum clearance, without pairs that the task brings together (the conditions "
            "report those); null if no pair is monitored"
        ),
    ]
    clearance_level: Annotated[Level, field_meta("alarm level of that clearance, by the scenario's thresholds")]
    contacts: Annotated[tuple[Near, ...], field_meta("pairs that touch or overlap")]
    arm_inhibit: Annotated[bool, field_meta("whether a contact inhibits the arm")]
    finger_inhibit: Annotated[bool, field_meta("whether a contact inhibits the finger")]
    inhibits: Annotated[tuple[str, ...], field_meta("reasons for which the arm or the finger is inhibited")]
    objective: Annotated[
        Objective | None,
        field_meta("action that becomes possible once the conditions hold; null if nothing is near enough"),
    ]
    conditions: Annotated[tuple[Condition, ...], field_meta("conditions of capture, docking or latching")]
    hand: Annotated[Hand, field_meta("state of the end effector")]
    stand: Annotated[float | None, field_meta("length of the telescope; null on an arm without a telescope", "m")]
    orbiter: Annotated[Vec3, field_meta("distance that the orbiter has moved", "m", "L")]
    orbiter_velocity: Annotated[Vec3, field_meta("velocity of the orbiter", "m/s", "L")]
    cargo: Annotated[tuple[Cargo, ...], field_meta("state of each payload of the worksite")]
    master: Annotated[Six | None, field_meta("joint angles of the master arm; null in modes other than MASTER", "rad")]
