"""Quantities in files: a bare number is in SI units, a string contains its unit (``"2 ft/s"``, ``"19.48 deg"``).

A decoded quantity is a float in SI units. Its class determines which units a file may use.
"""

from __future__ import annotations

import functools
import math
import re
import reprlib
from collections.abc import Iterator
from typing import ClassVar

from aftdeck.bounds import COORDINATE, ROTATION, Bounds
from aftdeck.unit_sizes import size_of, symbols

INCH = 0.0254
"""One inch [m], exact."""
FOOT = 0.3048
"""One foot [m], exact."""
POUND = 0.45359237
"""One pound [kg], exact."""


class _Repr(reprlib.Repr):
    """Short repr, also of integers with more digits than Python converts to text."""

    def repr_int(self, x: int, level: int) -> str:
        """Return an integer's repr, or a description of a long one."""
        return repr(x) if x.bit_length() <= _LONGEST_INTEGER else f"an integer of {x.bit_length()} bits"


_LONGEST_INTEGER = 128
"""Greatest number of bits of an integer that an error message repeats."""
_REPR = _Repr()
_REPR.maxstring = _REPR.maxother = 100
_NUMBER_AND_UNIT = re.compile(
    r"\s*(?P<number>[-+]?(\d+(\.\d*)?|\.\d+)([eE][-+]?\d+)?)\s*(?P<unit>[A-Za-z]+(\s*[/*]\s*[A-Za-z]+)*)\s*"
)


def short(given: object) -> str:
    """Return the repr of a value of any type for an error message, shortened if it is long or deeply nested."""
    try:
        return _REPR.repr(given)
    except Exception:  # methods of a foreign object may raise anything
        return f"an object of the type {type(given).__name__}"


def with_article(noun: str) -> str:
    """Return a noun with its indefinite article, `a` or `an`."""
    return f"{'an' if noun.startswith('a') else 'a'} {noun}"


class Quantity(float):
    """A number in SI units. In a file it may also have another unit. Each subclass has one physical dimension."""

    noun: ClassVar[str] = ""
    unit: ClassVar[str] = ""
    example: ClassVar[str] = ""
    bounds: ClassVar[Bounds]
    """Plausible range of a field of this type that declares no range of its own."""

    @classmethod
    def read(cls, given: object) -> Quantity:
        """Return the quantity that a file gives as a number (SI) or as a string with a unit.

        Raises:
            ValueError: `given` is neither a number nor such a string, or is NaN or infinite.
        """
        if isinstance(given, bool) or not isinstance(given, int | float | str):
            raise ValueError(f"expected a number in {cls.unit} or a string such as {cls.example!r}, got {short(given)}")
        try:
            value = cls._parse(given) if isinstance(given, str) else float(given)
        except OverflowError:
            value = math.inf
        if not math.isfinite(value):
            raise ValueError(f"expected a finite number in {cls.unit}, got {short(given)}")
        return cls(value)

    @classmethod
    @functools.lru_cache(maxsize=2000)  # a file repeats its sizes, and is read twice: to be checked and converted
    def _parse(cls, text: str) -> float:
        match = _NUMBER_AND_UNIT.fullmatch(text)
        size = _size(match["unit"], cls.unit) if match else None
        if match and size is not None:
            return float(match["number"]) * size
        raise ValueError(
            f"{short(text)} is not {with_article(cls.noun)}: write a number in {cls.unit}, or a number with its unit, "
            f"such as {cls.example!r}{_allowed(cls.unit)}"
        )


class Length(Quantity):
    """Length: any unit of length in files, [m] in the program."""

    noun, unit, example = "length", "m", "12 in"
    bounds = COORDINATE


class Angle(Quantity):
    """Angle: any unit of angle in files, [rad] in the program."""

    noun, unit, example = "angle", "rad", "19.48 deg"
    bounds = ROTATION


class Speed(Quantity):
    """Speed: any unit of speed in files, [m/s] in the program."""

    noun, unit, example = "speed", "m/s", "2 ft/s"
    bounds = Bounds(-100.0, 100.0, "at 100 m/s an object leaves the worksite within seconds")


class AngularRate(Quantity):
    """Angular rate: any unit of angular rate in files, [rad/s] in the program."""

    noun, unit, example = "angular rate", "rad/s", "4.76 deg/s"
    bounds = Bounds(-10.0, 10.0, "the Shuttle's joints turn at 0.09 rad/s at most, small arms at about 1 rad/s")


class Acceleration(Quantity):
    """Acceleration: any unit of acceleration in files, [m/s2] in the program."""

    noun, unit, example = "acceleration", "m/s/s", "0.5 ft/s/s"
    bounds = Bounds(-100.0, 100.0, "10 g break what is in orbit")


class AngularAcceleration(Quantity):
    """Angular acceleration: any unit of angular acceleration in files, [rad/s2] in the program."""

    noun, unit, example = "angular acceleration", "rad/s/s", "1.2 deg/s/s"
    bounds = Bounds(-100.0, 100.0, "at 100 rad/s/s a joint is at its greatest plausible rate after 0.1 s")


class Mass(Quantity):
    """Mass: any unit of mass in files, [kg] in the program."""

    noun, unit, example = "mass", "kg", "32000 lb"
    bounds = Bounds(0.0, 1e6, "the heaviest structure in orbit, the ISS, has 420,000 kg")


class MomentOfInertia(Quantity):
    """Moment of inertia: any unit of it in files, [kg m2] in the program."""

    noun, unit, example = "moment of inertia", "kg*m*m", "2 kg*m*m"
    bounds = Bounds(0.0, 1e10, "the ISS has about 1e8 kg m2")


class Force(Quantity):
    """Force: any unit of force in files, [N] in the program."""

    noun, unit, example = "force", "N", "870 lbf"
    bounds = Bounds(-1e7, 1e7, "an engine of the orbiter gives 2e6 N")


class Torque(Quantity):
    """Torque: any unit of torque in files, [N m] in the program."""

    noun, unit, example = "torque", "N*m", "770 ft*lbf"
    bounds = Bounds(-1e7, 1e7, "the Shuttle's joints give about 1,000 N m")


class AngularStiffness(Quantity):
    """Stiffness of a joint: any unit of it in files, [N m/rad] in the program."""

    noun, unit, example = "angular stiffness", "N*m/rad", "9e5 N*m/rad"
    bounds = Bounds(0.0, 1e12, "the Shuttle's gearboxes have about 1e6 N m/rad")


class AngularDamping(Quantity):
    """Torque per angular rate: any unit of it in files, [N m s/rad] in the program."""

    noun, unit, example = "angular damping", "N*m*s/rad", "1e6 N*m*s/rad"
    bounds = Bounds(0.0, 1e12, "the Shuttle's servos have about 1e6 N m s/rad")


class LinearDamping(Quantity):
    """Force per speed: any unit of it in files, [N s/m] in the program."""

    noun, unit, example = "linear damping", "N*s/m", "1e4 N*s/m"
    bounds = Bounds(0.0, 1e12, "the drive of a telescope has about 1e4 N s/m")


class LinearStiffness(Quantity):
    """Stiffness of a joint that slides: any unit of it in files, [N/m] in the program."""

    noun, unit, example = "stiffness", "N/m", "1e6 N/m"
    bounds = Bounds(0.0, 1e12, "a rod of steel of 1 cm and 1 m has 2e7 N/m")


class FlexuralRigidity(Quantity):
    """Rigidity of a beam, EI or GJ: any unit of it in files, [N m2] in the program."""

    noun, unit, example = "rigidity of a beam", "N*m*m", "4e6 N*m*m"
    bounds = Bounds(0.0, 1e15, "the Shuttle's booms have about 4e6 N m2")


class Time(Quantity):
    """Time: any unit of time in files, [s] in the program."""

    noun, unit, example = "time", "s", "20 ms"
    bounds = Bounds(0.0, 86_400.0, "a run lasts a day at most")


class OfJoint(Quantity):
    """Quantity of a joint: with an angle if the joint turns, with a length if it slides."""

    kinds: ClassVar[tuple[type[Quantity], type[Quantity]]]
    """The quantity of a joint that turns, and that of one that slides."""
    slides: bool | None = None
    """Whether the file's unit is that of a joint that slides; None for a bare number."""

    def __init_subclass__(cls) -> None:
        """Name both units; example and bounds are those of a joint that turns, unless the subclass has its own."""
        turning, sliding = cls.kinds
        cls.unit, cls.example = f"{turning.unit} or {sliding.unit}", turning.example
        if "bounds" not in vars(cls):
            cls.bounds = turning.bounds

    @classmethod
    def read(cls, given: object) -> Quantity:
        """Return the quantity that a file gives; arguments and errors as for `Quantity.read`."""
        if not isinstance(given, str):
            return super().read(given)
        match = _NUMBER_AND_UNIT.fullmatch(given)
        for kind in cls.kinds:
            if match and _size(match["unit"], kind.unit) is not None:
                found = cls(kind.read(given))
                found.slides = kind is cls.kinds[1]
                return found
        turning, sliding = cls.kinds
        raise ValueError(
            f"{short(given)} is neither {with_article(turning.noun)} nor {with_article(sliding.noun)}; write a number "
            f"in {cls.unit}, or a number with its unit, such as {turning.example!r} or {sliding.example!r}"
        )


class Coordinate(OfJoint):
    """Coordinate of a joint: an angle [rad], or a length if it slides [m]."""

    noun, kinds = "coordinate of a joint", (Angle, Length)
    bounds = Bounds(-200.0, 200.0, "ten revolutions are 63 rad, and the longest arms measure 20 m")


class CoordinateRate(OfJoint):
    """Rate of a joint: an angular rate [rad/s], or a speed if it slides [m/s]."""

    noun, kinds = "rate of a joint", (AngularRate, Speed)


class JointEffort(OfJoint):
    """Torque at a joint [N m], or force if it slides [N]."""

    noun, kinds = "torque or force at a joint", (Torque, Force)


class JointDamping(OfJoint):
    """Torque for each rad/s of a joint's rate [N m s/rad], or force for each m/s if it slides [N s/m]."""

    noun, kinds = "damping of a joint", (AngularDamping, LinearDamping)


class JointStiffness(OfJoint):
    """Stiffness of a joint's gearbox [N m/rad], or that of one that slides [N/m]."""

    noun, kinds = "stiffness of a joint", (AngularStiffness, LinearStiffness)


class CoordinateAcceleration(OfJoint):
    """Acceleration of a joint: an angular acceleration [rad/s2], or an acceleration if it slides [m/s2]."""

    noun, kinds = "acceleration of a joint", (AngularAcceleration, Acceleration)


def quantities() -> Iterator[type[Quantity]]:
    """Yield the quantities that a file may have."""
    for kind in Quantity.__subclasses__():
        yield from OfJoint.__subclasses__() if kind is OfJoint else (kind,)


def _allowed(target: str) -> str:
    """Return a sentence part that lists the units for an SI unit; empty for products, which have too many."""
    unit = size_of(target)
    return f"; units are {', '.join(symbols(unit[1]))}" if unit is not None and target.isalpha() else ""


@functools.cache
def _size(unit: str, target: str) -> float | None:
    """Return the size of `unit` in the SI unit `target`; None if it is unknown or measures something else."""
    found, wanted = size_of(unit), size_of(target)
    assert wanted is not None and wanted[0] == 1.0, f"{target} is no SI unit"
    return found[0] if found is not None and found[1] == wanted[1] else None


def decode_hook(kind: type, given: object) -> object:
    """Decode a quantity; msgspec calls this for types that it does not know."""
    if issubclass(kind, Quantity):
        return kind.read(given)
    raise NotImplementedError(f"no decoder for {kind.__name__}")
