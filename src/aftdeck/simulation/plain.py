"""Conversion of inputs to plain values: numbers, arrays and texts of NumPy become Python's own types.

`Simulation.advance` converts all inputs, because digests, saved states and recordings encode plain values only. A stick
value of -0.0 becomes 0.0, because both mean the same deflection but have different digests.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from numbers import Integral
from operator import index
from typing import Any, cast, get_type_hints

import msgspec

from aftdeck.errors import InputError
from aftdeck.scenario.target import Target
from aftdeck.simulation.camera_drives import CameraDrive
from aftdeck.simulation.inputs import POSITIONS, Inputs

_STICKS = ("translation", "rotation", "orbiter")
_SWITCHES = ("drive", "telescope")
_FLOAT, _QUICK = {float}, {tuple, float, str, bool, int, type(None)}
_TEXTS_AND_FLAGS = tuple(
    name for name, hint in get_type_hints(Inputs).items() if name in POSITIONS or hint is bool or name == "mode"
)


def plain_inputs(inputs: Inputs) -> Inputs:
    """Return the inputs with plain values. If all values are plain already, return the same object.

    Args:
        inputs: inputs from a caller, already accepted by `Inputs.check`.
    """
    if _all_plain(inputs):
        return inputs
    changed: dict[str, Any] = {}
    for name in _STICKS:
        if not _are_plain(getattr(inputs, name)):
            changed[name] = tuple(_deflection(value) for value in getattr(inputs, name))
    for name in _SWITCHES:
        if not _is_plain(getattr(inputs, name)):
            changed[name] = _deflection(getattr(inputs, name))
    for name in _TEXTS_AND_FLAGS:
        value = getattr(inputs, name)
        if value is not None and type(value) is not str and type(value) is not bool:
            changed[name] = str(value) if isinstance(value, str) else bool(value)
    if inputs.joint is not None and type(inputs.joint) is not int:
        changed["joint"] = int(inputs.joint)
    if inputs.master is not None and not _are_floats(inputs.master):
        changed["master"] = _floats(inputs.master)
    if inputs.target is not None:
        changed["target"] = plain_target(inputs.target)
    if inputs.camera is not None:
        changed["camera"] = _plain_drive(inputs.camera)
    return msgspec.structs.replace(inputs, **changed) if changed else inputs


def plain_target(target: Target) -> Target:
    """Return the target with plain floats."""
    position, joints = _floats(target.position), None if target.joints is None else _floats(target.joints)
    rows = tuple(_floats(row) for row in target.rotation)
    return Target(cast("Any", position), cast("Any", rows), cast("Any", joints))


def whole(value: object, name: str) -> int:
    """Return an integer of any type as a Python int.

    Raises:
        InputError: the value is not an integer, or is a bool; the message names the argument.
    """
    if isinstance(value, bool) or not isinstance(value, Integral):
        raise InputError(f"{name}: got {value!r}, expected an integer")
    return index(cast("Any", value))


def _all_plain(inputs: Inputs) -> bool:
    """Return whether the inputs are plain and have no target, master angles or camera.

    This test is quick, and its result is True in most steps.
    """
    numbers = (*inputs.translation, *inputs.rotation, *inputs.orbiter, inputs.drive, inputs.telescope)
    return (
        inputs.master is None
        and type(inputs.joint) is not bool
        and set(map(type, numbers)) == _FLOAT
        and set(map(type, msgspec.structs.astuple(inputs))) <= _QUICK
        and -1.0 not in [math.copysign(1.0, number) for number in numbers if not number]
    )


def _plain_drive(camera: CameraDrive) -> CameraDrive:
    return CameraDrive(
        str(camera.camera),
        _deflection(camera.pan),
        _deflection(camera.tilt),
        _deflection(camera.zoom),
        bool(camera.slow),
    )


def _deflection(value: Any) -> float:
    """Return a stick's deflection as a float that is never -0.0."""
    return float(value) + 0.0


def _is_plain(value: object) -> bool:
    return type(value) is float and (value != 0.0 or math.copysign(1.0, value) > 0.0)


def _are_plain(values: object) -> bool:
    return type(values) is tuple and all(map(_is_plain, values))


def _are_floats(values: object) -> bool:
    return type(values) is tuple and all(type(value) is float for value in values)


def _floats(values: Iterable[Any]) -> tuple[float, ...]:
    return tuple(float(value) for value in values)
