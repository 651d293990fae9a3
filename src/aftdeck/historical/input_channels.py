"""The operator's thirteen input channels, TABLE I, in units of V.

Switches have levels: encoding writes the exact level, decoding takes the nearest one. The six joint angles of the
master arm are proportional ("scaling set by analog adjustments"), with 8 rad at 1 V. The scale is a power of two, so
that encoding and decoding lose no bit of an angle. Source: the final report of the Remote Manipulator Simulation,
TABLE I; the levels of channels 10 and G are read as 1/2 V where the scan shows 3 V.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import isfinite
from typing import Final, Literal, NamedTuple, TypeVar, get_args

from aftdeck.errors import InputError
from aftdeck.historical.frame_words import Way

_T = TypeVar("_T")

Start = Literal["full problem", "mode 1", "mode 2 or 3"]
CameraMotion = Literal["+pan", "-pan", "none", "+tilt", "-tilt"]
Station = Literal["A", "B", "C", "D", "E", "F", "G", "H"]
Angles = tuple[float, float, float, float, float, float]

CHANNELS = 13
JOINTS = ("HO", "PO", "P1", "H2", "P2", "R2")
FULL_SCALE: Final = 8.0
"""Joint angle at 1 V [rad]; our choice: more than a whole turn."""
NOISE: Final = 0.125
"""Allowed excess of a channel beyond -1 to 1 V [V]: half the least step between levels (assumed)."""

RUN: Mapping[bool, float] = {False: 0.0, True: 1.0}
START: Mapping[Start, float] = {"full problem": 0.0, "mode 1": 1.0, "mode 2 or 3": -1.0}
WAY: Mapping[Way, float] = {0: 0.0, 1: 1.0, -1: -1.0}
CAMERA: Mapping[CameraMotion, float] = {"+pan": 1.0, "-pan": 0.5, "none": 0.0, "+tilt": -0.5, "-tilt": -1.0}
STATION: Mapping[Station, float] = {
    "A": 1.0,
    "B": 0.75,
    "C": 0.5,
    "D": 0.25,
    "E": 0.0,
    "F": -0.25,
    "G": -0.5,
    "H": -1.0,
}
assert set(STATION) == set(get_args(Station))


class OperatorInputs(NamedTuple):
    """The operator's settings on all channels.

    Attributes:
        initialise: channel 1: True to initialise, False to run.
        start: channel 2: the state to initialise to.
        angles: channels 3 to 8: HO, PO, P1, H2, P2, R2 of the master arm [rad], from -8 to 8.
        telescope: channel 9: 1 longer, -1 shorter, 0 stop.
        camera: channel 10.
        zoom: channel 11: 1 in, -1 out, 0 none.
        station: channel 12: A to H; later stations have no level.
        prong: channel 13: 1 close, -1 open, 0 stop.
    """

    initialise: bool
    start: Start
    angles: Angles
    telescope: Way
    camera: CameraMotion
    zoom: Way
    station: Station
    prong: Way


def encode_inputs(inputs: OperatorInputs) -> tuple[float, ...]:
    """Return the voltages of the thirteen channels [V].

    Raises:
        InputError: a setting has no level, or an angle is beyond the scale; names the channel.
    """
    angles = []
    for channel, (name, angle) in enumerate(zip(JOINTS, inputs.angles, strict=True), 3):
        if not abs(angle) <= FULL_SCALE:
            raise InputError(f"channel {channel}, {name}, is {angle:g} rad; it holds -{FULL_SCALE:g} to {FULL_SCALE:g}")
        angles.append(angle / FULL_SCALE)
    return (
        _level(RUN, inputs.initialise, "channel 1, initialise"),
        _level(START, inputs.start, "channel 2, start"),
        *angles,
        _level(WAY, inputs.telescope, "channel 9, telescope"),
        _level(CAMERA, inputs.camera, "channel 10, camera"),
        _level(WAY, inputs.zoom, "channel 11, zoom"),
        _level(STATION, inputs.station, "channel 12, camera position"),
        _level(WAY, inputs.prong, "channel 13, prong"),
    )


def decode_inputs(volts: Sequence[float]) -> OperatorInputs:
    """Return the operator's settings from the voltages of the thirteen channels [V].

    Each switch takes the nearest level, or the upper of two levels that are equally near.

    Raises:
        InputError: the number of channels is wrong, or a voltage is not finite or is beyond the scale.
    """
    if len(volts) != CHANNELS:
        raise InputError(f"the operator has {CHANNELS} channels; {len(volts)} are given")
    for channel, value in enumerate(volts, 1):
        if not isfinite(value):
            raise InputError(f"channel {channel} is {value:g} V; it has to be finite")
        if abs(value) > 1.0 + NOISE:
            raise InputError(f"channel {channel} is {value:g} V; it has to be -1 to 1 V, to within {NOISE:g} V")
    ho, po, p1, h2, p2, r2 = (value * FULL_SCALE for value in volts[2:8])
    return OperatorInputs(
        initialise=_nearest(RUN, volts[0]),
        start=_nearest(START, volts[1]),
        angles=(ho, po, p1, h2, p2, r2),
        telescope=_nearest(WAY, volts[8]),
        camera=_nearest(CAMERA, volts[9]),
        zoom=_nearest(WAY, volts[10]),
        station=_nearest(STATION, volts[11]),
        prong=_nearest(WAY, volts[12]),
    )


def _level(levels: Mapping[_T, float], setting: _T, name: str) -> float:
    if setting not in levels:
        raise InputError(f"{name}: {setting!r} has no level; there are: {', '.join(map(str, levels))}")
    return levels[setting]


def _nearest(levels: Mapping[_T, float], value: float) -> _T:
    return min(levels, key=lambda setting: (abs(levels[setting] - value), -levels[setting]))
