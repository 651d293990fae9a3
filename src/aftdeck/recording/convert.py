"""Between the simulation's values and the session file's messages, both ways."""

from __future__ import annotations

from collections.abc import Sequence
from typing import cast

import msgspec
import numpy as np

from aftdeck.bodies.cameras import Setting
from aftdeck.frames import Rows, quaternion, rotation_of
from aftdeck.recording.convert_work import work_of, work_record
from aftdeck.recording.records import (
    CameraRecord,
    EventRecord,
    FrameRecord,
    GoalRecord,
    Input,
    LightRecord,
    LimitRecord,
    LockRecord,
    TimesRecord,
    WayOutRecord,
)
from aftdeck.recording.told import Numbers
from aftdeck.scenario.light import Lighting, LockedExposure
from aftdeck.scenario.target import Target
from aftdeck.simulation.cameras import CameraDrive
from aftdeck.simulation.frame import Check, Event, Frame, Goal, Limit, Six, Times, Vec3, WayOut
from aftdeck.simulation.inputs import Inputs

DECIMALS = 9
"""Of lengths, angles and joint rates in a recorded frame: nanometres and nanoradians."""
COARSER = 7
"""Of sticks, twists, and what has no unit."""
DIGITS = 16
"""Of the digest kept beside a frame."""


def input_record(tick: int, inputs: Inputs | None) -> Input:
    """The inputs of a step; None: the script flew it."""
    if inputs is None:
        return Input(tick, script=True)
    target = inputs.target
    return Input(
        tick,
        translation=_floats(inputs.translation),
        rotation=_floats(inputs.rotation),
        drive=float(inputs.drive),
        mode=inputs.mode,
        joint=inputs.joint,
        rate=inputs.rate,
        target_position=None if target is None else _floats(target.position),
        target_rotation=None if target is None else _floats([x for row in target.rotation for x in row]),
        target_joints=None if target is None or target.joints is None else _floats(target.joints),
        law=inputs.law,
        payload_axes=inputs.payload_axes,
        rate_hold=inputs.rate_hold,
        position_hold=inputs.position_hold,
        brakes=inputs.brakes,
        safing=inputs.safing,
        proceed=inputs.proceed,
        stop=inputs.stop,
        effector=inputs.effector,
        effector_mode=inputs.effector_mode,
        rigid=inputs.rigid,
        latch=inputs.latch,
        telescope=float(inputs.telescope),
        orbiter=_floats(inputs.orbiter),
        master=None if inputs.master is None else _floats(inputs.master),
        initialise=inputs.initialise,
        camera=None if inputs.camera is None else _camera_record(inputs.camera),
    )


def inputs_of(record: Input) -> Inputs | None:
    """What was flown, exactly."""
    if record.script:
        return None
    target = None
    if record.target_position is not None and record.target_rotation is not None:
        r = record.target_rotation
        rows = cast("Rows", (r[:3], r[3:6], r[6:]))
        target = Target(cast("Vec3", record.target_position), rows, cast("Six | None", record.target_joints))
    return Inputs(
        translation=cast("Vec3", record.translation),
        rotation=cast("Vec3", record.rotation),
        drive=record.drive,
        mode=record.mode,
        joint=record.joint,
        rate=record.rate,
        target=target,
        law=record.law,
        payload_axes=record.payload_axes,
        rate_hold=record.rate_hold,
        position_hold=record.position_hold,
        brakes=record.brakes,
        safing=record.safing,
        proceed=record.proceed,
        stop=record.stop,
        effector=record.effector,
        effector_mode=record.effector_mode,
        rigid=record.rigid,
        latch=record.latch,
        telescope=record.telescope,
        orbiter=cast("Vec3", record.orbiter),
        master=cast("Six | None", record.master),
        initialise=record.initialise,
        camera=None if record.camera is None else CameraDrive(*msgspec.structs.astuple(record.camera)),
    )


def frame_record(frame: Frame, wall_s: float, latency_ms: float | None) -> FrameRecord:
    """What the file keeps of a frame."""
    goal, payload = frame.goal, frame.payload
    return FrameRecord(
        tick=frame.tick,
        time_s=frame.time_s,
        wall_s=round(wall_s, 6),
        latency_ms=latency_ms,
        sha256=frame.sha256[:DIGITS],
        phase=frame.phase,
        by=frame.by,
        mode=frame.mode,
        law=frame.law,
        law_choice=frame.law_choice,
        payload_axes=frame.payload_axes,
        rate_hold=frame.rate_hold,
        position_hold=frame.position_hold,
        brakes=frame.brakes,
        safing=frame.safing,
        joint=frame.joint,
        rate=frame.rate,
        sequence=frame.sequence,
        point=frame.point,
        points=frame.points,
        check=frame.check.text if frame.check else "",
        translation=_rounded(frame.translation, COARSER),
        rotation=_rounded(frame.rotation, COARSER),
        drive=round(frame.drive, COARSER),
        angles_rad=_rounded(frame.angles),
        rates_rad_s=_rounded(frame.rates),
        angles_commanded_rad=_rounded(frame.angles_commanded),
        rates_commanded_rad_s=_rounded(frame.rates_commanded),
        rate_limits_rad_s=_rounded(frame.rate_limits),
        zones=frame.zones,
        tip_m=_rounded(frame.position),
        tip_rotation=_attitude(frame.orientation),
        point_m=_rounded(frame.resolution),
        payload_m=_rounded(payload[0]) if payload else None,
        payload_rotation=_attitude(payload[1]) if payload else None,
        twist=_rounded(frame.twist, COARSER),
        twist_commanded=_rounded(frame.twist_commanded, COARSER),
        twist_demanded=_rounded(frame.twist_demanded, COARSER),
        por_limits=_rounded(frame.por_limits),
        ratio=round(frame.ratio, COARSER),
        limits=tuple(LimitRecord(limit.kind, limit.joint, limit.text) for limit in frame.limits),
        singularity=_rounded(frame.singularity, COARSER),
        singular=frame.singular,
        ways_out=tuple(WayOutRecord(w.cause, w.text, w.stick, w.axis, w.sign) for w in frame.ways_out),
        goal=None if goal is None else _goal_record(goal),
        work=work_record(frame.work),
        events=tuple(EventRecord(e.time_s, e.kind, e.level, e.text) for e in frame.events),
        views=tuple([round(angle, DECIMALS) for view in frame.views for angle in view]),
        times=_times_record(frame.times),
        attached=frame.attached,
        wrist_pitch=None if frame.wrist_pitch is None else _attitude(frame.wrist_pitch),
    )


def frame_of(record: FrameRecord) -> Frame:
    """The recorded frame, to nine decimals."""
    goal = record.goal
    payload = None
    if record.payload_m is not None and record.payload_rotation is not None:
        payload = (cast("Vec3", record.payload_m), _rows(record.payload_rotation))
    return Frame(
        tick=record.tick,
        time_s=record.time_s,
        phase=record.phase,
        by=record.by,
        mode=record.mode,
        law=record.law,
        law_choice=record.law_choice,
        payload_axes=record.payload_axes,
        rate_hold=record.rate_hold,
        position_hold=record.position_hold,
        brakes=record.brakes,
        safing=record.safing,
        joint=record.joint,
        rate=record.rate,
        sequence=record.sequence,
        point=record.point,
        points=record.points,
        check=Check(record.check.startswith("GOOD"), record.check) if record.check else None,
        translation=cast("Vec3", record.translation),
        rotation=cast("Vec3", record.rotation),
        drive=record.drive,
        angles=cast("Six", record.angles_rad),
        rates=cast("Six", record.rates_rad_s),
        angles_commanded=cast("Six", record.angles_commanded_rad),
        rates_commanded=cast("Six", record.rates_commanded_rad_s),
        rate_limits=cast("Six", record.rate_limits_rad_s),
        zones=cast("tuple[int, int, int, int, int, int]", record.zones),
        position=cast("Vec3", record.tip_m),
        orientation=_rows(record.tip_rotation),
        resolution=cast("Vec3", record.point_m),
        payload=payload,
        twist=cast("Six", record.twist),
        twist_commanded=cast("Six", record.twist_commanded),
        twist_demanded=cast("Six", record.twist_demanded),
        por_limits=cast("tuple[float, float]", record.por_limits),
        ratio=record.ratio,
        limits=tuple(msgspec.convert(msgspec.to_builtins(limit), Limit) for limit in record.limits),
        singularity=cast("Vec3", record.singularity),
        singular=record.singular,
        ways_out=tuple(WayOut(w.cause, w.text, w.stick, w.axis, w.sign) for w in record.ways_out),
        goal=None if goal is None else _goal_of(goal),
        work=work_of(record.work),
        events=tuple(Event(e.time_s, e.kind, e.level, e.text) for e in record.events),
        sha256=record.sha256,
        attached=_attached(record),
        times=Times(*msgspec.structs.astuple(record.times)),
        wrist_pitch=None if record.wrist_pitch is None else _rows(record.wrist_pitch),
        views=tuple([Setting(*record.views[i : i + 3]) for i in range(0, len(record.views), 3)]),
    )


def _attached(record: FrameRecord) -> int:
    """Files made before had one payload of the scenario's own at most."""
    if record.attached is not None:
        return record.attached
    return int(record.payload_m is not None and not any(cargo.held for cargo in record.work.cargo))


def light_record(time_s: float, lighting: Lighting) -> LightRecord:
    """How the light stands from a time on."""
    locked = tuple([LockRecord(lock.camera, lock.stops) for lock in lighting.locked])
    return LightRecord(time_s, lighting.condition, lighting.lamps, locked)


def lighting_of(record: LightRecord) -> Lighting:
    """The light of a recorded message."""
    locked = tuple([LockedExposure(lock.camera, lock.stops) for lock in record.locked])
    return Lighting(record.condition, record.lamps, locked)


def _camera_record(drive: CameraDrive) -> CameraRecord:
    return CameraRecord(drive.camera, float(drive.pan), float(drive.tilt), float(drive.zoom), drive.slow)


def _times_record(times: Times) -> TimesRecord:
    eta, etap = (None if time is None else round(time, DECIMALS) for time in (times.eta_s, times.etap_s))
    return TimesRecord(round(times.tp_s, DECIMALS), eta, etap)


def _goal_record(goal: Goal) -> GoalRecord:
    left = (round(value, DECIMALS) for value in (goal.distance, goal.angle, goal.remaining_s))
    return GoalRecord(_rounded(goal.position), _attitude(goal.rotation), *left)


def _goal_of(goal: GoalRecord) -> Goal:
    place, attitude = cast("Vec3", goal.position_m), _rows(goal.rotation)
    return Goal(place, attitude, goal.distance_m, goal.angle_rad, goal.remaining_s)


def _floats(values: Sequence[float]) -> Numbers:
    """Python's own numbers, whatever a caller's are."""
    return tuple([float(value) for value in values])


def _rounded(values: Numbers, decimals: int = DECIMALS) -> Numbers:
    return tuple([round(value, decimals) for value in values])


def _attitude(rows: Rows) -> Numbers:
    return _rounded(quaternion(np.array(rows)))


def _rows(attitude: Numbers) -> Rows:
    return rotation_of(cast("tuple[float, float, float, float]", attitude))
