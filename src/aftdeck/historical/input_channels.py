"""The operator's thirteen input channels of TABLE I, as voltages [V].

A switch has one voltage level for each position. Encoding writes the exact level; decoding selects the nearest level.
The six joint angles of the master arm are proportional to their voltages ("scaling set by analog adjustments"), with
8 rad at 1 V. This scale is a power of two, so that encoding and decoding preserve every bit of an angle. Source: the
final report of the Remote Manipulator Simulation, TABLE I. For channel 10 and for station G, the report's scan shows
3 V; we assume that this means 1/2 V.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import isfinite
from typing import Final, Literal, NamedTuple, TypeVar, get_args

from aftdeck.errors import InputError
from aftdeck.historical.frame_words import Direction

_T = TypeVar("_T")

Start = Literal["full problem", "mode 1", "mode 2 or 3"]
CameraMotion = Literal["+pan", "-pan", "none", "+tilt", "-tilt"]
Station = Literal["A", "B", "C", "D", "E", "F", "G", "H"]
Angles = tuple[float, float, float, float, float, float]

CHANNELS = 13
JOINTS = ("HO", "PO", "P1", "H2", "P2", "R2")
FULL_SCALE: Final = 8.0
"""Joint angle at 1 V [rad]. We chose this value; it is more than one revolution."""
NOISE: Final = 0.125
"""Amount by which a voltage may be below -1 V or above 1 V [V]: half the least step between levels (assumed)."""

RUN: Mapping[bool, float] = {False: 0.0, True: 1.0}
START: Mapping[Start, float] = {"full problem": 0.0, "mode 1": 1.0, "mode 2 or 3": -1.0}
DIRECTION: Mapping[Direction, float] = {0: 0.0, 1: 1.0, -1: -1.0}
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
        start: channel 2: full problem, mode 1, or mode 2 or 3; the run is initialised to the start of the full problem
            or of the named mode.
        angles: channels 3 to 8: HO, PO, P1, H2, P2, R2 of the master arm [rad], from -8 to 8.
        telescope: channel 9: 1 longer, -1 shorter, 0 stop.
        camera: channel 10: pan or tilt of the camera.
        zoom: channel 11: 1 in, -1 out, 0 none.
        station: channel 12: camera station, A to H; no voltage level stands for any of the other stations.
        prong: channel 13: 1 close, -1 open, 0 stop.
    """

    initialise: bool
    start: Start
    angles: Angles
    telescope: Direction
    camera: CameraMotion
    zoom: Direction
    station: Station
    prong: Direction


def encode_inputs(inputs: OperatorInputs) -> tuple[float, ...]:
    """Return the voltages of the thirteen channels [V].

    Raises:
        InputError: a setting has no level, or an angle is beyond the scale. The message names the channel.
    """
    angles = []
    for channel, (name, angle) in enumerate(zip(JOINTS, inputs.angles, strict=True), 3):
        if not abs(angle) <= FULL_SCALE:
            raise InputError(
                f"channel {channel}, {name}, is {angle:g} rad; the range of the channel is -{FULL_SCALE:g} to "
                f"{FULL_SCALE:g} rad"
            )
        angles.append(angle / FULL_SCALE)
    return (
        _level(RUN, inputs.initialise, "channel 1, initialise"),
        _level(START, inputs.start, "channel 2, start"),
        *angles,
        _level(DIRECTION, inputs.telescope, "channel 9, telescope"),
        _level(CAMERA, inputs.camera, "channel 10, camera"),
        _level(DIRECTION, inputs.zoom, "channel 11, zoom"),
        _level(STATION, inputs.station, "channel 12, camera position"),
        _level(DIRECTION, inputs.prong, "channel 13, prong"),
    )


def decode_inputs(volts: Sequence[float]) -> OperatorInputs:
    """Return the operator's settings from the voltages of the thirteen channels [V].

    Each switch is set to the nearest level. If two levels are equally near, the upper level is used.

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
        telescope=_nearest(DIRECTION, volts[8]),
        camera=_nearest(CAMERA, volts[9]),
        zoom=_nearest(DIRECTION, volts[10]),
        station=_nearest(STATION, volts[11]),
        prong=_nearest(DIRECTION, volts[12]),
    )


def _level(levels: Mapping[_T, float], setting: _T, name: str) -> float:
    if setting not in levels:
        raise InputError(f"{name}: {setting!r} has no level; settings with a level: {', '.join(map(str, levels))}")
    return levels[setting]


def _nearest(levels: Mapping[_T, float], value: float) -> _T:
    return min(levels, key=lambda setting: (abs(levels[setting] - value), -levels[setting]))
