"""Frame block: the 32 words that RMS-VS's program sent to its scene generator in each control step, TABLE II.

The first word is the control word. A word has 24 bits; here it is an integer from 0 to 2**24 - 1. Bit 0 is the most
significant bit, which is the sign of a number (probable, because XDS computers number bits in this order). A number at
scale Bn is in two's complement, with the binary point n bits after the sign. The range of such numbers is
[-2**n, 2**n), in steps of 2**(n - 23). Source: the final report of the Remote Manipulator Simulation. Assumed: sines
and cosines at B1, distances in feet, the order of sines and cosines, and the codes of the stations I, P1, P2, CAE2 and
W.
"""

from __future__ import annotations

from collections.abc import Sequence, Sized
from math import atan2, cos, hypot, isfinite, sin
from numbers import Real
from operator import index
from typing import Any, Literal, NamedTuple

from aftdeck.errors import InputError
from aftdeck.units import FOOT

BITS = 24
WORDS = 32
"""Number of words of a frame block."""
ANGLES = ("HO", "PO", "P1", "H2", "P2", "R2")
"""Names of the joint angles, in their order in a frame block."""
PLANES = 3
"""Number of separating planes of a frame block."""
STATIONS = {
    "A": 0b0000,
    "B": 0b0001,
    "C": 0b0010,
    "D": 0b0011,
    "E": 0b0100,
    "F": 0b1000,
    "G": 0b1001,
    "H": 0b1010,
    "I": 0b1011,
    "P1": 0b0101,
    "P2": 0b0110,
    "CAE2": 0b0111,
    "W": 0b1100,
}
"""Codes of the camera stations. For I, P1, P2, CAE2 and W we chose codes that the report does not use."""
SPARE = range(14, 18)
"""Bits of the control word that have no meaning."""
UNIT = 1e-5
"""Allowed difference between 1 and the sum of squares of an angle's sine and cosine, or of a normal's components [1]
(assumed)."""

Direction = Literal[-1, 0, 1]
"""Direction of a motion; 0 for no motion."""


class ControlWord(NamedTuple):
    """Control word: commands and flags for the scene generator, TABLE II.

    Attributes:
        mode: task phase: 1 acquisition, 2 extraction, 3 manoeuvring, 4 docked.
        station: camera station: A to I, P1, P2, CAE2, W.
        initialise: True in a step that initialises the run.
        telescope: 1 longer, -1 shorter, 0 stopped.
        pan: 1, -1 or 0. Pan and tilt share one sign bit, so they cannot have opposite signs.
        tilt: 1, -1 or 0.
        zoom: 1 in, -1 out, 0 none.
        prong: 1 closing, -1 opening, 0 stopped.
        finger_inhibited: True if the finger's motion is inhibited.
        arm_inhibited: True if the arm's motion is inhibited.
    """

    mode: Literal[1, 2, 3, 4]
    station: str
    initialise: bool = False
    telescope: Direction = 0
    pan: Direction = 0
    tilt: Direction = 0
    zoom: Direction = 0
    prong: Direction = 0
    finger_inhibited: bool = False
    arm_inhibited: bool = False


class WordPlane(NamedTuple):
    """A separating plane in the report's frame R: the points p with dot(normal, p) = distance.

    Attributes:
        normal: unit normal.
        distance: distance from R's origin along the normal [m].
    """

    normal: tuple[float, float, float]
    distance: float


class FrameBlock(NamedTuple):
    """Contents of a frame block: the data of one control step for the scene generator.

    Attributes:
        control: the control word.
        angles: HO, PO, P1, H2, P2, R2 [rad]; decoded angles are in (-pi, pi].
        planes: separating planes D1 to D3, between HEX 1 to 3 and the bar. An absent plane is None; its four words
            are 0.
    """

    control: ControlWord
    angles: tuple[float, float, float, float, float, float]
    planes: tuple[WordPlane | None, WordPlane | None, WordPlane | None]


def encode_control(control: ControlWord) -> int:
    """Return a control word as an integer of 24 bits.

    Raises:
        InputError: the mode or the station has no code, a motion is not -1, 0 or 1, a flag is not True or False, or pan
            and tilt have opposite signs.
    """
    if _integer(control.mode) not in (1, 2, 3, 4):
        raise InputError(f"the control word's mode is {control.mode!r}; it has to be the integer 1, 2, 3 or 4")
    if control.station not in tuple(STATIONS):
        raise InputError(
            f"the control word has no code for station {control.station!r}; it has codes for {', '.join(STATIONS)}"
        )
    for name in ("telescope", "pan", "tilt", "zoom", "prong"):
        motion = getattr(control, name)
        if _integer(motion) not in (-1, 0, 1):
            raise InputError(f"the control word's {name} is {motion!r}; it has to be the integer -1, 0 or 1")
    for name in ("initialise", "finger_inhibited", "arm_inhibited"):
        flag = getattr(control, name)
        if flag not in (False, True):
            raise InputError(f"the control word's {name} is {flag!r}; it has to be True or False")
    if control.pan * control.tilt < 0:
        raise InputError("the control word has one sign for pan and tilt; they cannot have opposite signs")
    bits = {
        0: control.initialise,
        1: control.telescope != 0,
        2: control.telescope > 0,
        3: control.tilt != 0,
        4: control.tilt + control.pan > 0,
        5: control.pan != 0,
        6: control.zoom != 0,
        7: control.zoom > 0,
        12: control.prong < 0,
        13: control.prong > 0,
        18: control.finger_inhibited,
        19: control.arm_inhibited,
        24 - control.mode: True,
    }
    code = STATIONS[control.station] << (BITS - 1 - 11)
    return code | sum(_bit(bit) for bit, on in bits.items() if on)


def decode_control(word: int) -> ControlWord:
    """Return the contents of a control word.

    Raises:
        InputError: the word is not an integer of 24 bits, a spare bit is set, the station code is unknown, the prong
            both opens and closes, or not exactly one mode is set.
    """
    word = _word(word, "the control word")
    on = [bool(word & _bit(bit)) for bit in range(BITS)]
    if any(on[bit] for bit in SPARE):
        raise InputError(f"the control word {word:#08x} has a spare bit set; bits 14 to 17 have to be 0")
    code = word >> (BITS - 1 - 11) & 0b1111
    station = next((name for name, known in STATIONS.items() if known == code), None)
    if station is None:
        raise InputError(f"the control word {word:#08x} has station code {code:04b}, which no station has")
    if on[12] and on[13]:
        raise InputError(f"the control word {word:#08x} opens and closes the prong at once")
    modes = [mode for mode in (1, 2, 3, 4) if on[24 - mode]]
    if len(modes) != 1:
        raise InputError(f"the control word {word:#08x} has {len(modes)} modes set; it has to have 1")
    mode: Literal[1, 2, 3, 4] = modes[0]  # type: ignore[assignment]
    return ControlWord(
        mode=mode,
        station=station,
        initialise=on[0],
        telescope=_direction(on[1], on[2]),
        pan=_direction(on[5], on[4]),
        tilt=_direction(on[3], on[4]),
        zoom=_direction(on[6], on[7]),
        prong=_direction(on[12] or on[13], on[13]),
        finger_inhibited=on[18],
        arm_inhibited=on[19],
    )


def encode_block(block: FrameBlock) -> tuple[int, ...]:
    """Return a frame block as 32 words.

    The words are: the control word; sine and cosine of each angle; normal and distance of each plane; 7 blank words.

    Raises:
        InputError: the control word cannot be encoded, the number of angles or planes is wrong, an angle is not finite,
            a number is too large for its word's scale (the message names the word), or a normal is not a unit vector.
    """
    _has(block.angles, len(ANGLES), f"a frame block has {len(ANGLES)} angles, {', '.join(ANGLES)}")
    _has(block.planes, PLANES, f"a frame block has {PLANES} separating planes")
    words = [encode_control(block.control)]
    for name, angle in zip(ANGLES, block.angles, strict=True):
        _is_number(angle, f"angle {name}")
        if not isfinite(angle):
            raise InputError(f"angle {name} is {angle:g} rad; it has to be finite")
        words += [fixed(sin(angle), 1, f"sin {name}"), fixed(cos(angle), 1, f"cos {name}")]
    for k, plane in enumerate(block.planes, 1):
        if plane is None:
            words += [0, 0, 0, 0]
            continue
        _has(plane.normal, 3, f"the normal of plane {k} has 3 components, x, y, z")
        parts = {f"normal {axis} of plane {k}": part for axis, part in zip("xyz", plane.normal, strict=True)}
        for name, part in (*parts.items(), (f"distance of plane {k}", plane.distance)):
            _is_number(part, name)
        _unit(plane.normal, f"the normal of plane {k}")
        words += [fixed(part, 0, name) for name, part in parts.items()]
        words.append(fixed(plane.distance / FOOT, 11, f"distance of plane {k} [ft]"))
    return (*words, *[0] * (WORDS - len(words)))


def decode_block(words: Sequence[int]) -> FrameBlock:
    """Return the contents of a frame block. Each blank word must have 24 bits; its value is ignored.

    Raises:
        InputError: there are not 32 words of 24 bits, the control word is invalid, two words are not the sine and
            cosine of an angle, or a normal is not a unit vector.
    """
    _has(words, WORDS, f"a frame block has {WORDS} words")
    words = [_word(word, f"word {k} of the frame block") for k, word in enumerate(words, 1)]
    turns = [number(word, 1) for word in words[1 : 1 + 2 * len(ANGLES)]]
    angles = []
    for name, s, c in zip(ANGLES, turns[::2], turns[1::2], strict=True):
        _unit((s, c), f"sine and cosine of {name}")
        angles.append(atan2(s, c))
    ho, po, p1, h2, p2, r2 = angles
    first, second, third = (_plane(words[13 + 4 * k : 17 + 4 * k], k + 1) for k in range(PLANES))
    return FrameBlock(decode_control(words[0]), (ho, po, p1, h2, p2, r2), (first, second, third))


def _plane(words: Sequence[int], k: int) -> WordPlane | None:
    """Return the k-th plane of a frame block from its four words; None if they are all 0."""
    if not any(words):
        return None
    x, y, z, distance = words
    normal = (number(x, 0), number(y, 0), number(z, 0))
    _unit(normal, f"the normal of plane {k}")
    return WordPlane(normal, number(distance, 11) * FOOT)


def fixed(value: float, scale: int, name: str) -> int:
    """Return a number at scale Bn as a word, rounded to the nearest step.

    The number 2**n (for example, a normal's component of 1 at B0) is one step too large for a word. It is therefore
    encoded as the greatest number that a word can hold.

    Raises:
        InputError: the number is not finite, or is outside [-2**n, 2**n] by more than half a step.
    """
    most, half = 2.0**scale, 1 << (BITS - 1)
    if not (isfinite(value) and abs(round(value / most * half)) <= half):
        raise InputError(f"{name} is {value:.9g}; a word at scale B{scale} holds {-most:g} to {most:g}")
    return min(round(value / most * half), half - 1) & ((1 << BITS) - 1)


def number(word: int, scale: int) -> float:
    """Return the number that a word holds at scale Bn."""
    half = 1 << (BITS - 1)
    return float((word ^ half) - half) / half * 2.0**scale


def _bit(bit: int) -> int:
    """Return a word in which only bit number `bit` is 1; bit 0 is the most significant bit."""
    return 1 << (BITS - 1 - bit)


def direction_of(number: float) -> Direction:
    """Return the sign of a number: 1, 0 or -1."""
    return 1 if number > 0.0 else -1 if number < 0.0 else 0


def _direction(moves: bool, forwards: bool) -> Direction:
    if not moves:
        return 0
    return 1 if forwards else -1


def _integer(given: Any) -> int | None:
    """Return a value as an integer if it is a Python or NumPy integer; None for any other value."""
    try:
        return index(given)
    except TypeError:
        return None


def _word(given: object, name: str) -> int:
    word = _integer(given)
    if word is None or not 0 <= word < 1 << BITS:
        raise InputError(f"{name} is {given!r}; it has to be an integer of {BITS} bits, 0 to {(1 << BITS) - 1}")
    return word


def _is_number(given: object, name: str) -> None:
    if not isinstance(given, Real):
        raise InputError(f"{name} is {given!r}; it has to be a number")


def _has(given: Sized, count: int, rule: str) -> None:
    if len(given) != count:
        raise InputError(f"{rule}; {len(given)} are given")


def _unit(parts: Sequence[float], name: str) -> None:
    size = hypot(*parts)
    if not abs(size * size - 1.0) <= UNIT:
        raise InputError(f"{name}: the sum of squares is {size * size:.7g}; it has to be 1 to within {UNIT:g}")
