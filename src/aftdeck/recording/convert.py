"""Conversion between the simulation's values and the messages of a recording, both ways."""

from __future__ import annotations

from collections.abc import Sequence

from msgspec.structs import astuple

from aftdeck.recording.codec import as_read
from aftdeck.recording.records import FrameRecord, Input, LightRecord, LockRecord, Shown
from aftdeck.scenario.light import Lighting, LockedExposure
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.plain import plain_inputs

DIGITS = 16
"""Number of hexadecimal digits in a frame's record, taken from the beginning of the frame's digest."""
_SHA256 = Frame.__struct_fields__.index("sha256")


def input_record(tick: int, inputs: Inputs | None) -> Input:
    """Return the record of a step's inputs; `inputs` is None for a scripted step."""
    return Input(tick=tick, script=True) if inputs is None else Input(*astuple(plain_inputs(inputs)), tick=tick)


def inputs_of(record: Input) -> Inputs | None:
    """Return the exact inputs of a recorded step; None for a scripted step without changes in flight."""
    scripted = record.script and not record.changes
    return None if scripted else Inputs(*[getattr(record, name) for name in Inputs.__struct_fields__])


def frame_record(frame: Frame, wall_s: float, latency_ms: float | None) -> FrameRecord:
    """Return a frame's record, with exact values; `codec.encode` rounds them."""
    values = list(astuple(frame))
    values[_SHA256] = frame.sha256[:DIGITS]
    return FrameRecord(*values, wall_s=wall_s, latency_ms=latency_ms)


def as_recorded(frame: Frame) -> FrameRecord:
    """Return a frame with the values that a reader of its recording gets, without wall time and latency."""
    return as_read(frame_record(frame, 0.0, None))


def light_record(time_s: float, lighting: Lighting) -> LightRecord:
    """Return the record of the lighting from `time_s` [s] on."""
    locked = tuple([LockRecord(lock.camera, lock.stops) for lock in lighting.locked])
    return LightRecord(time_s, lighting.condition, lighting.lamps, locked)


def shown_record(time_s: float, monitors: Sequence[tuple[str, ...]]) -> Shown:
    """Return the record of the cameras on the monitors from `time_s` [s] on; a monitor that is not given has none."""
    mon_1, mon_2 = (*monitors, (), ())[:2]
    return Shown(time_s, mon_1, mon_2)


def lighting_of(record: LightRecord) -> Lighting:
    """Return the lighting of a record."""
    locked = tuple([LockedExposure(lock.camera, lock.stops) for lock in record.locked])
    return Lighting(record.condition, record.lamps, locked)
