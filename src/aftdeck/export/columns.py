"""Columns of an action: the inputs of one control step as numbers, and back without loss.

A column is 0 where its stick is centred or its switch is not set. Numbers are float64, because a recording holds the
exact deflections of the sticks.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Container, Mapping, Sequence, Sized
from typing import Any, NamedTuple

import numpy as np

from aftdeck.arrays import Array
from aftdeck.errors import InputError
from aftdeck.scenario.target import Target
from aftdeck.simulation.camera_drives import CameraDrive
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.readings.panel import MODE_NUMBERS
from aftdeck.table import Column
from aftdeck.units import short


class Field(NamedTuple):
    """Field of `Inputs`, and its columns.

    Attributes:
        name: name of the field.
        columns: its columns.
        numbers: returns the numbers of a value.
        value: returns the value of numbers.
        held: whether it acts for as long as it is held; otherwise it acts once, in the step in which it is set.
    """

    name: str
    columns: tuple[Column, ...]
    numbers: Callable[[Any], Sequence[float]]
    value: Callable[[Sequence[float]], Any]
    held: bool = False


SCRIPT = Column("script", "", "1: the scenario's script supplies the inputs; the other columns then show its inputs.")

_STICKS: Mapping[str, tuple[tuple[str, str], ...]] = {
    "translation": tuple((f"thc_{axis}", f"THC along axis {k} of the sticks.") for k, axis in enumerate("xyz", 1)),
    "rotation": tuple(
        (f"rhc_{axis}", f"RHC about axis {k} of the sticks.") for k, axis in enumerate(("roll", "pitch", "yaw"), 1)
    ),
    "drive": (("drive", "SINGLE/DIRECT DRIVE switch."),),
    "telescope": (("telescope", "Drive of the telescope: longer (+) or shorter (-)."),),
    "orbiter": tuple(
        (f"orbiter_{axis}", f"Translation of the orbiter {way}.")
        for axis, way in zip("xyz", ("forward", "to starboard", "down"), strict=True)
    ),
}
"""Columns of each stick, each with its definition."""

_ON_OFF: Mapping[object, int] = {True: 1, False: -1}
_SWITCHES: Mapping[str, tuple[str, Mapping[object, int]]] = {
    "mode": ("MODE rotary.", MODE_NUMBERS),
    "rate": ("Rate setting.", {"coarse": 1, "vernier": -1}),
    "law": ("Steering law of OPR CMD and AUTO 1-4.", {"position": 1, "closed loop": 2, "open loop": 3}),
    "payload_axes": ("Switch beside ORB LD: rotation about payload axes.", _ON_OFF),
    "position_hold": ("POSITION HOLD.", _ON_OFF),
    "brakes": ("BRAKES.", _ON_OFF),
    "safing": ("SAFING.", _ON_OFF),
    "effector": ("End effector switch.", {"close": 1, "open": -1, "stop": 2}),
    "effector_mode": ("END EFFECTOR MODE.", {"auto": 1, "manual": -1}),
    "rigid": ("END EFFECTOR MAN CONTR.", {"rigid": 1, "derigid": -1, "off": 2}),
    "latch": ("LATCH or UNLATCH of a berth.", {"latch": 1, "unlatch": -1}),
    "initialise": (
        "Re-initialisation.",
        {"full problem": 1, "acquisition": 2, "extraction": 3, "manoeuvring": 4},
    ),
}
"""Number of each position of each switch; 0 leaves the switch as it is. These numbers never change."""

_BUTTONS: Mapping[str, str] = {
    "rate_hold": "RATE HOLD is pressed.",
    "proceed": "PROCEED.",
    "stop": "STOP.",
}


def _stick(name: str) -> Field:
    columns = tuple(Column(column, "", f"{text} In [-1, 1].") for column, text in _STICKS[name])
    if len(columns) == 1:
        return Field(name, columns, lambda value: (value,), lambda numbers: numbers[0], held=True)
    return Field(name, columns, lambda value: value, tuple, held=True)


def _joint(joints: int) -> Field:
    return _switch("joint", "JOINT rotary, by the index of the joint, from 0.", {k: k + 1 for k in range(joints)})


def _switch(name: str, text: str, codes: Mapping[object, int]) -> Field:
    listed = ", ".join(f"{code}: {_position(value)}" for value, code in codes.items())
    values = {code: value for value, code in codes.items()} | {0: None}

    def numbers(value: object) -> tuple[float]:
        if value is None:
            return (0.0,)
        if value not in codes:
            raise InputError(f"{name}: {short(value)} has no number in a dataset; there are {listed}")
        return (float(codes[value]),)

    def position(given: Sequence[float]) -> object:
        return values[_code(name, given[0], values, f"0 or {listed}")]

    return Field(name, (Column(name, "", f"{text} {listed}."),), numbers, position)


def _code(name: str, number: float, allowed: Container[int], words: str) -> int:
    """Return the nearest whole number of a column.

    Raises:
        InputError: it is not allowed.
    """
    code = round(number) if math.isfinite(number) else None
    if code is None or code not in allowed:
        raise InputError(f"{name}: got {number:g}, expected {words}")
    return code


def _position(value: object) -> str:
    return {True: "on", False: "off"}.get(value, str(value)) if isinstance(value, bool) else str(value)


def _button(name: str) -> Field:
    column = Column(name, "", f"1: {_BUTTONS[name]}")
    return Field(name, (column,), lambda value: (float(value),), lambda numbers: numbers[0] > 0.5)  # noqa: PLR2004


def _target(joints: int) -> Field:
    columns = (
        Column("target", "", "A target is keyed in: 1 as a pose, 2 as a pose with its joint angles."),
        *(Column(f"target_{axis}", "m", f"Its position in L, {axis}.") for axis in "xyz"),
        *(
            Column(f"target_r{i}{j}", "", f"Its attitude in L: row {i}, column {j} of the matrix.")
            for i in (1, 2, 3)
            for j in (1, 2, 3)
        ),
        *(Column(f"target_joint_{k}", "rad", f"Its angle of joint {k}.") for k in range(1, joints + 1)),
    )

    def numbers(value: Target | None) -> Sequence[float]:
        if value is None:
            return (0.0,) * len(columns)
        kind, angles = (1.0, (0.0,) * joints) if value.joints is None else (2.0, value.joints)
        return (kind, *value.position, *(x for row in value.rotation for x in row), *angles)

    def target(n: Sequence[float]) -> Target | None:
        kind = _code("target", n[0], (0, 1, 2), "0, 1 or 2")
        if kind == 0:
            return None
        rows = (n[4], n[5], n[6]), (n[7], n[8], n[9]), (n[10], n[11], n[12])
        return Target((n[1], n[2], n[3]), rows, None if kind == 1 else tuple(n[13 : 13 + joints]))

    return Field("target", columns, numbers, target)


def _master(joints: int) -> Field:
    columns = (
        Column("master", "", "1: the master arm has these joint angles."),
        *(Column(f"master_joint_{k}", "rad", f"Its angle of joint {k}.") for k in range(1, joints + 1)),
    )
    return Field(
        "master",
        columns,
        lambda value: (0.0,) * len(columns) if value is None else (1.0, *value),
        lambda numbers: tuple(numbers[1:]) if _code("master", numbers[0], (0, 1), "0 or 1") else None,
        held=True,
    )


def _camera(driven: Sequence[str]) -> Field:
    columns = (
        Column("camera", "", "Camera whose drive is commanded: its number among the cameras with a drive, from 1."),
        *(Column(f"camera_{name}", "", f"Its {name} switch, in [-1, 1].") for name in ("pan", "tilt", "zoom")),
        Column("camera_slow", "", "1: at the low speed."),
    )

    def numbers(value: CameraDrive | None) -> Sequence[float]:
        if value is None:
            return (0.0,) * len(columns)
        return (1.0 + driven.index(value.camera), value.pan, value.tilt, value.zoom, float(value.slow))

    def drive(given: Sequence[float]) -> CameraDrive | None:
        number = _code("camera", given[0], range(len(driven) + 1), f"0 or a camera's number up to {len(driven)}")
        pan, tilt, zoom, slow = given[1:]
        return CameraDrive(driven[number - 1], pan, tilt, zoom, slow > 0.5) if number else None  # noqa: PLR2004

    return Field("camera", columns, numbers, drive, held=True)


def _no_action(name: str, nothing: Callable[[], object]) -> Field:
    """Return a field without columns, because it is no action of the operator; `nothing` returns its empty value."""

    def numbers(value: Sized) -> Sequence[float]:
        if value:
            raise InputError(f"{name}: those of the inputs have no numbers in a dataset; let the scenario plan them")
        return ()

    return Field(name, (), numbers, lambda _: nothing())


def _script() -> Field:
    return Field("script", (SCRIPT,), lambda value: (float(value),), lambda numbers: bool(numbers[0]))


class Encoding:
    """Encoding of a scenario's inputs.

    Attributes:
        fields: fields of `Inputs`, in their order.
        columns: columns of all fields; the last one is `SCRIPT`.
        names: their names.
    """

    def __init__(self, driven: Sequence[str], joints: int) -> None:
        """Take the names of the cameras that have a drive, in their order, and the number of the arm's joints."""
        made = {name: _stick(name) for name in _STICKS}
        made |= {name: _switch(name, *of) for name, of in _SWITCHES.items()} | {"joint": _joint(joints)}
        made |= {name: _button(name) for name in _BUTTONS}
        made |= {"target": _target(joints), "master": _master(joints), "camera": _camera(driven)}
        made |= {"disturbances": _no_action("disturbances", tuple), "changes": _no_action("changes", dict)}
        made |= {"script": _script()}
        self.fields = tuple(made[name] for name in Inputs.__struct_fields__)
        self.columns = tuple(column for field in self.fields for column in field.columns)
        self.names = tuple(column.name for column in self.columns)

    def encode(self, inputs: Inputs) -> list[float]:
        """Return the numbers of all columns for the inputs of a step.

        Raises:
            InputError: a text has no number: a mode that no panel has.
        """
        numbers: list[float] = []
        for field in self.fields:
            numbers += field.numbers(getattr(inputs, field.name))
        return numbers

    def decode(self, numbers: Sequence[float], *, held_only: bool = False) -> Inputs | None:
        """Return the inputs of numbers for all columns; None if the script supplies them.

        Args:
            numbers: a number for each column.
            held_only: whether only sticks, camera drives and the master arm act: what is held over several steps.

        Raises:
            InputError: a switch has no position of this number.
        """
        if _code(SCRIPT.name, numbers[-1], (0, 1), "0 or 1"):
            return None
        values, at = {}, 0
        for field in self.fields:
            end = at + len(field.columns)
            if field.held or not held_only:
                values[field.name] = field.value(numbers[at:end])
            at = end
        return Inputs(**values)

    def index(self, names: Sequence[str]) -> list[int]:
        """Return the indices of columns.

        Raises:
            InputError: a column does not exist, or is named twice.
        """
        for k, name in enumerate(names):
            if name not in self.names or name in names[:k]:
                raise InputError(f"columns: got {short(name)}, expected different names of {', '.join(self.names)}")
        return [self.names.index(name) for name in names]

    def completed(self, names: Sequence[str], numbers: Array) -> Array:
        """Return numbers (n, columns) for all columns, from those (n, names) of some; the others are 0."""
        whole = np.zeros((len(numbers), len(self.names)))
        whole[:, self.index(names)] = numbers
        return whole
