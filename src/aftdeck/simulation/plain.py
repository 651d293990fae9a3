"""Conversion of inputs to plain values: numbers, arrays and texts of any library become Python's own types.

`Simulation.advance` converts all inputs before it checks them; the converted values are checked, flown, delayed and
recorded. Digests, saved states and recordings encode plain values only. A stick value of -0.0 becomes 0.0, because both
mean the same deflection but have different digests.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from functools import lru_cache
from operator import is_
from typing import Any, TypeGuard, cast, get_args, get_type_hints

import msgspec

from aftdeck.errors import InputError
from aftdeck.files import place, plain_value
from aftdeck.plain_values import few_numbers, flag, items, number, numbers, text, whole_number
from aftdeck.scenario.changes import as_toml, parse_key
from aftdeck.scenario.disturbance import MOST_DISTURBANCES, Disturbance
from aftdeck.scenario.in_flight import MOST_CHANGES
from aftdeck.scenario.target import Target
from aftdeck.simulation.camera_drives import CameraDrive
from aftdeck.simulation.inputs import EXPECTED, NO_OTHERS, STICKS, Inputs, others
from aftdeck.tuples import MOST_JOINTS, Rows, Vec3
from aftdeck.units import short

GREATEST_SEED = 2**53
"""Greatest seed: JSON and JavaScript represent no greater integer exactly."""
_FLOAT = {float}
_AXES = 3


def plain_inputs(inputs: object) -> Inputs:
    """Return the inputs with plain values. If all values are plain already, return the same object.

    Args:
        inputs: inputs from a caller, with values of any types.

    Raises:
        InputError: a value has no plain value of its field's type; the message begins with the name of the field.
    """
    if type(inputs) is Inputs and _all_plain(inputs):
        return inputs
    if not isinstance(inputs, Inputs):
        raise InputError(f"inputs: got {short(inputs)}, expected Inputs")
    values: dict[str, Any] = {
        name: _converted(inputs, name, "", EXPECTED[name], convert) for name, convert in _CONVERT.items()
    }
    return Inputs(**values)


def only_moves(inputs: object) -> TypeGuard[Inputs]:
    """Return whether inputs have plain values, and move sticks within their travel and nothing else.

    Such inputs need no other check. This test is quick, and its result is True in most steps.
    """
    if type(inputs) is not Inputs or not all(map(is_, others(inputs), NO_OTHERS)):
        return False
    if type(inputs.changes) is not dict or inputs.changes:
        return False
    sticks = _plain_sticks(inputs)
    return sticks is not None and all([-1.0 <= deflection <= 1.0 for deflection in sticks])


def plain_target(target: object) -> Target:
    """Return the target with plain floats; raise an exception of any type if it has none."""
    if not isinstance(target, Target):
        raise TypeError
    rows = tuple(numbers(row, 3) for row in items(target.rotation, (3, 3)))
    joints = None if target.joints is None else few_numbers(target.joints, MOST_JOINTS)
    return Target(cast("Vec3", numbers(target.position, 3)), cast("Rows", rows), joints)


def whole(value: object, name: str) -> int:
    """Return a seed of any integer type as a Python int.

    Raises:
        InputError: the value is not an integer from 0 to `GREATEST_SEED`, or is a bool; the message names the argument.
    """
    try:
        plain = whole_number(value)
    except Exception as error:  # methods of a foreign object may raise anything
        raise InputError(f"{name}: got {short(value)}, expected an integer") from error
    if not 0 <= plain <= GREATEST_SEED:
        raise InputError(f"{name}: got {short(plain)}, expected an integer from 0 to {GREATEST_SEED}")
    return plain


def _all_plain(inputs: Inputs) -> bool:
    """Return whether the inputs are plain and have no target, master angles, camera, disturbances or changes.

    This test is quick, and its result is True in most steps.
    """
    values = msgspec.structs.astuple(inputs)
    if not _plain_types(*map(type, values)) or inputs.disturbances or inputs.changes:
        return False
    return _plain_sticks(inputs) is not None


def _plain_sticks(inputs: Inputs) -> tuple[float, ...] | None:
    """Return the deflections of all sticks; None if one of them is not plain."""
    translation, rotation, orbiter = inputs.translation, inputs.rotation, inputs.orbiter
    if not (type(translation) is type(rotation) is type(orbiter) is tuple):
        return None
    sticks = (*translation, *rotation, *orbiter, inputs.drive, inputs.telescope)
    plain = (
        len(translation) == len(rotation) == len(orbiter) == _AXES
        and set(map(type, sticks)) == _FLOAT
        and -1.0 not in [math.copysign(1.0, deflection) for deflection in sticks if not deflection]
    )
    return sticks if plain else None


@lru_cache(maxsize=256)
def _plain_types(*kinds: type) -> bool:
    """Return whether each field of `Inputs` has a plain type, and target, master angles and camera are None."""
    return all(kind in allowed for kind, allowed in zip(kinds, _PLAIN_TYPES, strict=True))


def _converted(holder: object, name: str, within: str, expected: str, convert: Callable[[Any], object]) -> object:
    """Return the plain value of an attribute.

    Args:
        holder: the object with the attribute.
        name: name of the attribute.
        within: name of the holder and a point, for the error message; "" for `Inputs`.
        expected: what is allowed, for the error message.
        convert: function that returns the plain value.

    Raises:
        InputError: the attribute has no plain value.
    """
    given: object = None
    try:
        given = getattr(holder, name)
        return convert(given)
    except InputError:
        raise
    except Exception as error:  # methods of a foreign object may raise anything
        raise InputError(f"{within}{name}: got {short(given)}, expected {expected}") from error


def _deflection(value: object) -> float:
    """Return a stick's deflection as a float that is never -0.0."""
    return number(value) + 0.0


def _deflections(values: object) -> tuple[float, ...]:
    return tuple(_deflection(value) for value in items(values, (3,)))


def _optional(convert: Callable[[Any], object]) -> Callable[[object], object]:
    return lambda value: None if value is None else convert(value)


_DRIVE: Mapping[str, tuple[Callable[[Any], object], str]] = {
    "camera": (text, "the name of a camera"),
    **dict.fromkeys(("pan", "tilt", "zoom"), (_deflection, "a number in [-1, 1]")),
    "slow": (flag, "True or False"),
}
"""Conversion of each field of `CameraDrive`, and what is allowed."""


def _plain_drive(camera: object) -> CameraDrive:
    if not isinstance(camera, CameraDrive):
        raise TypeError
    values = [_converted(camera, name, "camera.", expected, convert) for name, (convert, expected) in _DRIVE.items()]
    return CameraDrive(*cast("Any", values))


_DISTURBANCE: Mapping[str, tuple[Callable[[Any], object], str]] = {
    "on": (text, "the name of a body"),
    **dict.fromkeys(("force", "torque"), (lambda values: numbers(values, 3), "3 numbers")),
    "frame": (text, "the name of a coordinate frame"),
    "at": (_optional(lambda values: numbers(values, 3)), "3 coordinates, or None"),
}
"""Conversion of each field of `Disturbance`, and what is allowed."""


def _plain_disturbances(given: object) -> tuple[Disturbance, ...]:
    if not isinstance(given, tuple | list) or len(given) > MOST_DISTURBANCES:
        raise TypeError
    return tuple(_plain_disturbance(one) for one in given)


def _plain_disturbance(given: object) -> Disturbance:
    if not isinstance(given, Disturbance):
        raise TypeError
    fields = [
        _converted(given, name, "disturbances: ", expected, convert)
        for name, (convert, expected) in _DISTURBANCE.items()
    ]
    return Disturbance(*cast("Any", fields))


def _plain_changes(given: object) -> dict[str, str]:
    if not isinstance(given, Mapping) or len(given) > MOST_CHANGES:
        raise TypeError
    return {place(parse_key(text(key))): _plain_value(value) for key, value in given.items()}


def _plain_value(value: Any) -> str:
    """Return a value of a file as text, as it stands after KEY=."""
    plain = plain_value(value)
    if isinstance(plain, str):
        return text(plain)
    if not isinstance(plain, bool | int | float | list | tuple | dict):
        raise TypeError
    return as_toml(plain)


def _conversions() -> Mapping[str, tuple[Callable[[Any], object], set[type]]]:
    """Return for each field of `Inputs` its conversion, and the types of the values that need none."""
    found: dict[str, tuple[Callable[[Any], object], set[type]]] = {}
    for name, hint in get_type_hints(Inputs).items():
        kind, *none = get_args(hint) if type(None) in get_args(hint) else (hint,)
        convert, plain = _conversion(name, kind)
        found[name] = (_optional(convert), {plain, type(None)}) if none else (convert, {plain})
    return found


def _conversion(name: str, kind: object) -> tuple[Callable[[Any], object], type]:
    """Return the conversion of a field of `Inputs`, and the type of a value that needs none."""
    if name in STICKS:
        return (_deflection, float) if STICKS[name] == 1 else (_deflections, tuple)
    if name in _OWN:
        return _OWN[name], {"disturbances": tuple, "changes": dict}.get(name, type(None))
    if kind is bool:
        return flag, bool
    return (whole_number, int) if kind is int else (text, str)


_OWN: Mapping[str, Callable[[Any], object]] = {
    "master": lambda angles: few_numbers(angles, MOST_JOINTS),
    "target": plain_target,
    "camera": _plain_drive,
    "disturbances": _plain_disturbances,
    "changes": _plain_changes,
}
"""Conversion of the fields that hold more than one value; the quick test accepts only None there, or no item."""
_CONVERT = {name: convert for name, (convert, _) in _conversions().items()}
_PLAIN_TYPES = [kinds for _, kinds in _conversions().values()]
