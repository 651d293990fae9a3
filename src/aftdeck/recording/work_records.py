"""What a session file keeps of the worksite after a step.

Lengths are kept to a hundredth of a millimetre, directions to five decimals: replays compute exact ones.
"""

from __future__ import annotations

from typing import Annotated, Literal

from aftdeck.recording.told import Message, Numbers, told


class NearRecord(Message, frozen=True):
    """Two watched parts."""

    a: Annotated[str, told("a part")]
    b: Annotated[str, told("the other part")]
    clearance_m: Annotated[float, told("their distance; negative where they overlap", "m")]
    closing_m_s: Annotated[float, told("speed at which the closest points approach", "m/s")]
    point_m: Annotated[Numbers, told("the first part's closest point", "m", "L")]
    other_m: Annotated[Numbers, told("the second part's closest point", "m", "L")]
    normal: Annotated[Numbers, told("of a plane between them; zero where they collide", "1", "L")]
    distance_m: Annotated[float, told("of that plane from the origin", "m", "L")]
    essential: Annotated[bool, told("made to touch: inhibits nothing")]
    features: Annotated[tuple[str, ...], told("what touches of each; empty where apart")]


class ConditionRecord(Message, frozen=True):
    """A condition of a capture, a docking or a latching."""

    name: Annotated[str, told("which")]
    holds: Annotated[bool, told("whether it holds")]
    value: Annotated[float, told("what is measured, in `unit`")]
    limit: Annotated[float, told("what it is held against, in `unit`")]
    unit: Annotated[str, told("m, rad, m/s, or empty")]
    margin: Annotated[float, told("by how much it holds, or fails where negative, in `unit`")]
    text: Annotated[str, told("for people")]


class HandRecord(Message, frozen=True):
    """The end effector."""

    switch: Annotated[Literal["stop", "close", "open"], told("how its switch stands")]
    opening: Annotated[float, told("0 closed to 1 open: prong or snares", "1")]
    spacing_m: Annotated[float | None, told("prong to fixed finger", "m")]
    carriage: Annotated[float | None, told("0 extended to 1 rigid", "1")]
    flags: Annotated[tuple[str, ...], told("lit on the panel")]
    mode: Annotated[Literal["auto", "manual"], told("END EFFECTOR MODE")]
    rigid: Annotated[Literal["off", "rigid", "derigid"], told("END EFFECTOR MAN CONTR")]


class CargoRecord(Message, frozen=True):
    """A payload of the worksite."""

    name: Annotated[str, told("which")]
    position_m: Annotated[Numbers, told("its centre", "m", "L")]
    rotation: Annotated[Numbers, told("attitude, quaternion w x y z", "1", "L")]
    velocity_m_s: Annotated[Numbers, told("of its centre", "m/s", "L")]
    held: Annotated[bool, told("in the grasp")]
    seat: Annotated[str, told("where it is fixed; empty: nowhere")]


class WorkRecord(Message, frozen=True):
    """The worksite after one control step."""

    task: Annotated[int, told("the report's mode: 1 acquisition, 2 extraction, 3 manoeuvring, 4 docked")]
    nearest: Annotated[
        NearRecord | None,
        told("watched pair with the least clearance, but for the hand and a payload that it is lined up with"),
    ]
    contacts: Annotated[tuple[NearRecord, ...], told("pairs that touch or overlap")]
    arm_inhibit: Annotated[bool, told("the arm is inhibited")]
    finger_inhibit: Annotated[bool, told("the finger is inhibited")]
    inhibits: Annotated[tuple[str, ...], told("why, and what frees it")]
    pursuit: Annotated[str, told("what the conditions are for; empty: nothing")]
    conditions: Annotated[tuple[ConditionRecord, ...], told("of capture, docking or latching")]
    hand: Annotated[HandRecord, told("the end effector")]
    stand_m: Annotated[float | None, told("length of the telescope", "m")]
    orbiter_m: Annotated[Numbers, told("how far the orbiter has moved", "m", "L")]
    orbiter_m_s: Annotated[Numbers, told("its velocity", "m/s", "L")]
    cargo: Annotated[tuple[CargoRecord, ...], told("the worksite's payloads")]
    master_rad: Annotated[Numbers | None, told("the master arm's joint angles", "rad")]
    clearance_level: Annotated[
        Literal["info", "caution", "warning"] | None,
        told("what the clearance of `nearest` calls for; null in files made before it was told"),
    ] = None
