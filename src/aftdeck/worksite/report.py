"""Record of the worksite at one instant: contacts, conditions of capture, and positions of everything.

Measurements between bodies are recorded to a hundredth of a millimetre, directions to five decimals.
"""

from __future__ import annotations

from typing import Annotated, Literal

import msgspec

from aftdeck.told import told
from aftdeck.worksite.conditions import Condition
from aftdeck.worksite.watch.alarm import Level

Vec3 = tuple[float, float, float]
Rows = tuple[Vec3, Vec3, Vec3]
Six = tuple[float, float, float, float, float, float]


COARSE = 5
"""Decimals of measurements between bodies."""


class Near(msgspec.Struct, frozen=True, gc=False):
    """Two monitored parts."""

    a: Annotated[str, told("a part, for people: `lower boom`")]
    b: Annotated[str, told("the other part")]
    clearance: Annotated[float, told("their distance; negative where they overlap", "m", decimals=COARSE)]
    closing: Annotated[float, told("speed at which the two closest points approach", "m/s", decimals=COARSE)]
    point_a: Annotated[Vec3, told("the closest point of a", "m", "L", COARSE)]
    point_b: Annotated[Vec3, told("the closest point of b", "m", "L", COARSE)]
    normal: Annotated[
        Vec3, told("unit normal of a plane between the two, from a to b; zero where they collide", "1", "L", COARSE)
    ]
    distance: Annotated[float, told("of that plane from the origin", "m", "L", COARSE)]
    essential: Annotated[bool, told("the two are made to touch: inhibits nothing")] = False
    feature_a: Annotated[str, told("what of a touches or penetrates: `vertex 3`; empty where they are apart")] = ""
    feature_b: Annotated[str, told("the same of b")] = ""


class Cargo(msgspec.Struct, frozen=True, gc=False):
    """A payload of the worksite."""

    name: Annotated[str, told("which")]
    position: Annotated[Vec3, told("its centre", "m", "L")]
    orientation: Annotated[Rows, told("its attitude", "1", "L")]
    velocity: Annotated[Vec3, told("of its centre", "m/s", "L")]
    held: Annotated[bool, told("the end effector holds it")]
    seat: Annotated[str, told("the seat that it is fixed to; empty: none")]


class Hand(msgspec.Struct, frozen=True, gc=False):
    """The end effector."""

    switch: Annotated[Literal["stop", "close", "open"], told("how its switch stands")]
    opening: Annotated[float, told("0 closed to 1 open: of the prong, or of the snares", "1", decimals=COARSE)]
    spacing: Annotated[float | None, told("prong to fixed finger; null: this arm has none", "m", decimals=COARSE)]
    carriage: Annotated[float | None, told("0 extended to 1 rigid; null: this arm has none", "1", decimals=COARSE)]
    flags: Annotated[tuple[str, ...], told("lit on the panel: `CAPTURE`, `RIGID`")]
    mode: Annotated[Literal["auto", "manual"], told("END EFFECTOR MODE of the snares")] = "auto"
    rigid: Annotated[Literal["off", "rigid", "derigid"], told("END EFFECTOR MAN CONTR of the snares")] = "off"


class Objective(msgspec.Struct, frozen=True, gc=False):
    """What the end effector can do where it is."""

    action: Annotated[Literal["acquire", "capture", "dock", "insert", "berth"], told("which action")]
    text: Annotated[str, told("for people: `acquire payload`, `berth in the Cargo bay`")]


class Work(msgspec.Struct, frozen=True, gc=False):
    """The worksite after a step."""

    task: Annotated[int, told("the report's mode: 1 acquisition, 2 extraction, 3 manoeuvring, 4 docked")]
    nearest: Annotated[
        Near | None,
        told(
            "the watched pair with the least clearance, but for those that are, or come, together as the task needs "
            "it, of which the conditions tell (`simulation.lined_up`); null: no pair is watched"
        ),
    ]
    clearance_level: Annotated[Level, told("what that clearance calls for, by the scenario's thresholds")]
    contacts: Annotated[tuple[Near, ...], told("pairs that touch or overlap")]
    arm_inhibit: Annotated[bool, told("the arm is inhibited")]
    finger_inhibit: Annotated[bool, told("the finger is inhibited")]
    inhibits: Annotated[tuple[str, ...], told("why the arm or the finger is inhibited, and what frees it")]
    objective: Annotated[
        Objective | None, told("what can be done here, once the conditions hold; null: nothing is near enough")
    ]
    conditions: Annotated[tuple[Condition, ...], told("of capture, docking or latching")]
    hand: Annotated[Hand, told("the end effector")]
    stand: Annotated[float | None, told("length of the telescope; null: this arm stands on none", "m")]
    orbiter: Annotated[Vec3, told("how far the orbiter has moved", "m", "L")]
    orbiter_velocity: Annotated[Vec3, told("its velocity", "m/s", "L")]
    cargo: Annotated[tuple[Cargo, ...], told("the worksite's payloads")]
    master: Annotated[Six | None, told("the master arm's joint angles; null in other modes than MASTER", "rad")]
