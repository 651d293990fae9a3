"""Between the worksite's values and the session file's messages, both ways."""

from __future__ import annotations

from typing import cast

import numpy as np

from aftdeck.frames import Rows, quaternion, rotation_of
from aftdeck.recording.told import Numbers
from aftdeck.recording.work_records import CargoRecord, ConditionRecord, HandRecord, NearRecord, WorkRecord
from aftdeck.worksite.alarm import CLEAR
from aftdeck.worksite.conditions import Condition, Unit
from aftdeck.worksite.report import Cargo, Hand, Near, Six, Vec3, Work

DECIMALS = 5
"""Of lengths, speeds and directions of the worksite: a hundredth of a millimetre."""
FINE = 9
"""Of where payloads are."""


def work_record(work: Work) -> WorkRecord:
    """What the file keeps of the worksite."""
    hand = work.hand
    return WorkRecord(
        task=work.task,
        nearest=None if work.nearest is None else _near_record(work.nearest),
        contacts=tuple(_near_record(near) for near in work.contacts),
        arm_inhibit=work.arm_inhibit,
        finger_inhibit=work.finger_inhibit,
        inhibits=work.inhibits,
        pursuit=work.pursuit,
        conditions=tuple(_condition_record(c) for c in work.conditions),
        hand=HandRecord(
            hand.switch,
            round(hand.opening, DECIMALS),
            _maybe(hand.spacing),
            _maybe(hand.carriage),
            hand.flags,
            hand.mode,
            hand.rigid,
        ),
        stand_m=None if work.stand is None else round(work.stand, FINE),
        orbiter_m=_rounded(work.orbiter, FINE),
        orbiter_m_s=_rounded(work.orbiter_velocity, FINE),
        cargo=tuple(_cargo_record(cargo) for cargo in work.cargo),
        master_rad=None if work.master is None else _rounded(work.master, FINE),
        clearance_level=work.clearance_level,
    )


def work_of(record: WorkRecord) -> Work:
    """The recorded worksite."""
    hand = record.hand
    return Work(
        task=record.task,
        nearest=None if record.nearest is None else _near_of(record.nearest),
        clearance_level=record.clearance_level or CLEAR,
        contacts=tuple(_near_of(near) for near in record.contacts),
        arm_inhibit=record.arm_inhibit,
        finger_inhibit=record.finger_inhibit,
        inhibits=record.inhibits,
        pursuit=record.pursuit,
        conditions=tuple(
            Condition(c.name, c.holds, c.value, c.limit, cast("Unit", c.unit), c.margin, c.text)
            for c in record.conditions
        ),
        hand=Hand(hand.switch, hand.opening, hand.spacing_m, hand.carriage, hand.flags, hand.mode, hand.rigid),
        stand=record.stand_m,
        orbiter=cast("Vec3", record.orbiter_m),
        orbiter_velocity=cast("Vec3", record.orbiter_m_s),
        cargo=tuple(_cargo_of(cargo) for cargo in record.cargo),
        master=cast("Six | None", record.master_rad),
    )


def _near_record(near: Near) -> NearRecord:
    return NearRecord(
        near.a,
        near.b,
        round(near.clearance, DECIMALS),
        round(near.closing, DECIMALS),
        _rounded(near.point_a),
        _rounded(near.point_b),
        _rounded(near.normal),
        round(near.distance, DECIMALS),
        near.essential,
        (near.feature_a, near.feature_b) if near.feature_a else (),
    )


def _near_of(record: NearRecord) -> Near:
    a, b = record.features or ("", "")
    return Near(
        record.a,
        record.b,
        record.clearance_m,
        record.closing_m_s,
        cast("Vec3", record.point_m),
        cast("Vec3", record.other_m),
        cast("Vec3", record.normal),
        record.distance_m,
        record.essential,
        a,
        b,
    )


def _condition_record(c: Condition) -> ConditionRecord:
    value, limit, margin = (round(x, DECIMALS) for x in (c.value, c.limit, c.margin))
    return ConditionRecord(c.name, c.holds, value, limit, c.unit, margin, c.text)


def _cargo_record(cargo: Cargo) -> CargoRecord:
    return CargoRecord(
        cargo.name,
        _rounded(cargo.position, FINE),
        _rounded(quaternion(np.array(cargo.orientation)), FINE),
        _rounded(cargo.velocity, FINE),
        cargo.held,
        cargo.seat,
    )


def _cargo_of(record: CargoRecord) -> Cargo:
    rows: Rows = rotation_of(cast("tuple[float, float, float, float]", record.rotation))
    place, velocity = cast("Vec3", record.position_m), cast("Vec3", record.velocity_m_s)
    return Cargo(record.name, place, rows, velocity, record.held, record.seat)


def _rounded(values: Numbers, decimals: int = DECIMALS) -> Numbers:
    return tuple([round(value, decimals) for value in values])


def _maybe(value: float | None) -> float | None:
    return None if value is None else round(value, DECIMALS)
