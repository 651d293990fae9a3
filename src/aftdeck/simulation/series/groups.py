"""Groups of the columns of a time history. Units and descriptions are those that the shown fields declare."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from typing import NamedTuple, get_type_hints

from aftdeck.matrices import length
from aftdeck.plant.readings import CUTS, Load, Readings
from aftdeck.scenario.disturbance import ORBITER, TIP
from aftdeck.scenario.model import Scenario
from aftdeck.scenario.payload import PART
from aftdeck.simulation.frame import HOLDERS, Bend, Dynamics, Force, Frame, Holding, Placed, Wrench
from aftdeck.table import Column, with_unit
from aftdeck.tuples import Rows
from aftdeck.worksite.report import Cargo, Near

XYZ = ("x", "y", "z")
MATRIX = tuple(f"r{i}{j}" for i in "123" for j in "123")
"""Elements of an attitude's matrix: row, column."""
JETS = tuple(f"{how}_{axis}" for how in ("about", "along") for axis in ("forward", "starboard", "down"))
"""Axes of the orbiter's jets: torques about, then forces along."""
_NOTHING = math.nan

Fields = tuple[Column, ...]


class Group(NamedTuple):
    """Group of columns.

    Attributes:
        name: name of the group.
        columns: returns the columns for a scenario.
        values: returns their values in a step, from its frame and, if `gauged`, its readings.
        masses: whether there are values only on a plant with masses.
        gauged: whether the values are readings of gauges, which are neither in a frame nor in a recording.
    """

    name: str
    columns: Callable[[Scenario], Fields]
    values: Callable[[Frame, Readings | None], Sequence[float | str]]
    masses: bool = False
    gauged: bool = False


def _of(kind: type, field: str, name: str, parts: Sequence[str] = (), of: str = "", unit: str = "") -> Fields:
    """Return the columns of a declared field: one for each part, or one.

    Args:
        kind: struct or named tuple that declares the field.
        field: name of the field.
        name: beginning of the columns' names.
        parts: what distinguishes the names.
        of: what the field belongs to, for the definition.
        unit: unit in place of the declared one, if the declared one names several.
    """
    (meta,) = get_type_hints(kind, include_extras=True)[field].__metadata__
    unit = unit or meta.extra["unit"]
    frame = f" ({meta.extra['frame']})" if meta.extra["frame"] else ""
    text = f"{of}: {meta.description}{frame}" if of else f"{meta.description}{frame}"
    return tuple(
        Column(with_unit(f"{name}_{part}" if part else name, unit), "" if unit == "1" else unit, text)
        for part in parts or ("",)
    )


def _nine(rows: Rows) -> tuple[float, ...]:
    return (*rows[0], *rows[1], *rows[2])


def _pose(kind: type, name: str, of: str = "") -> Fields:
    """Return the columns of a pose: position, and matrix of the attitude."""
    return _of(kind, "position", name, XYZ, of) + _of(kind, "orientation", name, MATRIX, of)


def _joints(kind: type, field: str, name: str) -> Callable[[Scenario], Fields]:
    return lambda scenario: _of(kind, field, name, scenario.arm.joints)


def _por(_: Scenario) -> Fields:
    turn = _of(Frame, "twist", "por_turn_rate", XYZ, unit="rad/s")
    return _of(Frame, "resolution", "por", XYZ) + turn + _of(Frame, "twist", "por_velocity", XYZ, unit="m/s")


def _sticks(_: Scenario) -> Fields:
    thc, rhc = _of(Frame, "translation", "thc", XYZ), _of(Frame, "rotation", "rhc", ("roll", "pitch", "yaw"))
    return thc + rhc + _of(Frame, "drive", "drive")


def _clearance(frame: Frame, _: object) -> Sequence[float | str]:
    near = frame.work.nearest
    return (_NOTHING, "") if near is None else (near.clearance, f"{near.a} to {near.b}")


def _payloads(scenario: Scenario) -> Fields:
    return tuple(
        column
        for number, cargo in enumerate(scenario.cargo, start=1)
        for column in (
            *_pose(Cargo, f"payload_{number}", cargo.name),
            *_of(Cargo, "velocity", f"payload_{number}_velocity", XYZ, cargo.name),
            *_of(Cargo, "held", f"payload_{number}_held", of=cargo.name),
        )
    )


def _payload_values(frame: Frame, _: object) -> Sequence[float | str]:
    return [
        value
        for cargo in frame.work.cargo
        for value in (*cargo.position, *_nine(cargo.orientation), *cargo.velocity, float(cargo.held))
    ]


def _bends(scenario: Scenario) -> Fields:
    return tuple(
        column
        for part in scenario.flexures
        for column in (
            *_of(Bend, "displacement", f"bend_{part.part}", XYZ, part.part),
            *_of(Bend, "rotation", f"bend_{part.part}", XYZ, part.part),
        )
    )


def _contact(frame: Frame, _: object) -> Sequence[float | str]:
    found = max(_dynamics(frame).contacts, key=lambda touch: length(touch.force), default=None)
    if found is None:
        return (0.0, 0.0, 0.0, *(_NOTHING,) * 3, "")
    return (*found.force, *found.position, f"{found.a} on {found.b}")


def _holds(scenario: Scenario) -> Fields:
    return tuple(
        column
        for number, cargo in enumerate(scenario.cargo, start=1)
        for by in HOLDERS
        for column in _of(
            Holding, "force", f"payload_{number}_held_by_{by.replace(' ', '_')}", of=f"{cargo.name}, {by}"
        )
    )


def _hold_values(frame: Frame, _: object) -> Sequence[float | str]:
    found = {(hold.payload, hold.by): hold.force for hold in _dynamics(frame).holds}
    return [found.get((cargo.name, by), 0.0) for cargo in frame.work.cargo for by in HOLDERS]


def _disturbances(scenario: Scenario) -> Fields:
    payloads = [(cargo.name, f"payload_{number}") for number, cargo in enumerate(scenario.cargo, start=1)]
    return tuple(
        column
        for name, beginning in (*((one, one) for one in (TIP, ORBITER)), *(payloads or [(PART, PART)]))
        for column in (
            *_of(Wrench, "force", f"{beginning}_disturbing_force", XYZ, name),
            *_of(Wrench, "torque", f"{beginning}_disturbing_torque", XYZ, name),
        )
    )


def _disturbance_values(frame: Frame, _: object) -> Sequence[float | str]:
    acting, values = _dynamics(frame).disturbances, []
    for name in (TIP, ORBITER, *([cargo.name for cargo in frame.work.cargo] or [PART])):
        own = [(*one.force, *one.torque) for one in acting if one.body == name]
        values += [math.fsum(column) for column in zip(*own, strict=True)] if own else [0.0] * 6
    return values


def _loads(_: Scenario) -> Fields:
    return tuple(
        column
        for cut in CUTS
        for column in (
            *_of(Load, "force", f"{cut}_force", XYZ, cut),
            *_of(Load, "moment", f"{cut}_moment", XYZ, cut),
            *_of(Load, "peak_force", f"{cut}_peak_force", of=cut),
            *_of(Load, "peak_moment", f"{cut}_peak_moment", of=cut),
        )
    )


def _load_values(_: Frame, readings: Readings | None) -> Sequence[float | str]:
    return [
        value
        for load in _known(readings).loads
        for value in (*load.force, *load.moment, load.peak_force, load.peak_moment)
    ]


def _payload_rates(scenario: Scenario) -> Fields:
    return tuple(
        column
        for number, cargo in enumerate(scenario.cargo, start=1)
        for column in _of(Readings, "payload_turn_rates", f"payload_{number}_turn_rate", XYZ, cargo.name)
    )


def _orbiter_rates(_: Scenario) -> Fields:
    turn = _of(Readings, "orbiter_turn_rate", "orbiter_turn_rate", XYZ)
    return turn + _of(Readings, "orbiter_velocity", "orbiter_velocity", XYZ)


def _dynamics(frame: Frame) -> Dynamics:
    assert frame.dynamics is not None, "a group of a plant with masses"
    return frame.dynamics


def _known(readings: Readings | None) -> Readings:
    assert readings is not None, "a group of a plant with gauges"
    return readings


GROUPS = (
    Group("time", lambda _: _of(Frame, "time_s", "time"), lambda f, _: (f.time_s,)),
    Group(
        "phase",
        lambda _: (
            *(column._replace(kind="text") for name in ("phase", "mode") for column in _of(Frame, name, name)),
            *_of(Frame, "brakes", "brakes"),
        ),
        lambda f, _: (f.phase, f.mode, float(f.brakes)),
    ),
    Group("sticks", _sticks, lambda f, _: (*f.translation, *f.rotation, f.drive)),
    Group("angles", _joints(Frame, "angles", "angle"), lambda f, _: f.angles),
    Group("rates", _joints(Frame, "rates", "rate"), lambda f, _: f.rates),
    Group("commanded", _joints(Frame, "rates_commanded", "rate_commanded"), lambda f, _: f.rates_commanded),
    Group("tip", lambda _: _pose(Frame, "tip"), lambda f, _: (*f.position, *_nine(f.orientation))),
    Group("por", _por, lambda f, _: (*f.resolution, *f.twist)),
    Group(
        "clearance",
        lambda _: (*_of(Near, "clearance", "clearance"), Column("clearance_pair", "", "the pair", "text")),
        _clearance,
    ),
    Group("payloads", _payloads, _payload_values),
    Group(
        "true_tip",
        lambda _: _pose(Dynamics, "true_tip"),
        lambda f, _: (*_dynamics(f).position, *_nine(_dynamics(f).orientation)),
        masses=True,
    ),
    Group("torques", _joints(Dynamics, "torques", "torque"), lambda f, _: _dynamics(f).torques, masses=True),
    Group(
        "bends",
        _bends,
        lambda f, _: [value for bend in _dynamics(f).bends for value in (*bend.displacement, *bend.rotation)],
        masses=True,
    ),
    Group(
        "orbiter",
        lambda _: _pose(Placed, "orbiter", "L, relative to its pose at the start of the run"),
        lambda f, _: (*_dynamics(f).orbiter.position, *_nine(_dynamics(f).orbiter.orientation)),
        masses=True,
    ),
    Group("jets", lambda _: _of(Dynamics, "fired", "jets", JETS), lambda f, _: _dynamics(f).fired, masses=True),
    Group(
        "contacts",
        lambda _: (
            *_of(Force, "force", "contact_force", XYZ, "greatest contact"),
            *_of(Force, "position", "contact", XYZ, "greatest contact"),
            Column("contact_pair", "", "greatest contact: its parts", "text"),
        ),
        _contact,
        masses=True,
    ),
    Group("holds", _holds, _hold_values, masses=True),
    Group("disturbances", _disturbances, _disturbance_values, masses=True),
    Group("loads", _loads, _load_values, masses=True, gauged=True),
    Group(
        "orbiter_rates",
        _orbiter_rates,
        lambda _, r: (*_known(r).orbiter_turn_rate, *_known(r).orbiter_velocity),
        masses=True,
        gauged=True,
    ),
    Group(
        "payload_rates",
        _payload_rates,
        lambda _, r: [value for rates in _known(r).payload_turn_rates for value in rates],
        masses=True,
        gauged=True,
    ),
)
"""All groups, in the order of a table's columns."""


def groups_of(scenario: Scenario) -> Iterator[tuple[Group, Fields]]:
    """Yield the groups that have values in a run of a scenario, each with its columns."""
    for group in GROUPS:
        if (scenario.plant != "kinematic" or not group.masses) and (columns := group.columns(scenario)):
            yield group, columns
