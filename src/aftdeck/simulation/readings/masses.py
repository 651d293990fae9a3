"""Readings on plants with masses: torques, forces, bends, loads inside the arm, motion of the bodies."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from operator import attrgetter
from typing import Any

from aftdeck.matrices import length
from aftdeck.plant.readings import CUTS, Load, Readings
from aftdeck.scenario.disturbance import ORBITER, TIP
from aftdeck.scenario.model import Scenario
from aftdeck.scenario.payload import PART
from aftdeck.simulation.frame import HOLDERS, Bend, Dynamics, Force, Holding, Placed, Wrench
from aftdeck.simulation.log import joint_label
from aftdeck.simulation.readings.quantity import Quantity
from aftdeck.simulation.readings.reading import XYZ, Known, Needs, Reading, Recorded, Strip, Value, pose, shown

JETS = tuple(f"{how}_{axis}" for how in ("about", "along") for axis in ("forward", "starboard", "down"))
"""Axes of the orbiter's jets: torques about, then forces along."""
_CUTS = dict(zip(CUTS, ("root of upper boom", "root of lower boom", "end effector"), strict=True))
"""Words for each place at which gauges measure a load."""
_PARTS = ("base", "upper_boom", "lower_boom")
"""Parts that bend, as `Bend.part` names them."""
_ROUNDED = 1e-3
"""Torque below its limit at which it counts as at the limit [N m]: a recording rounds torques by half of it."""
_CONTACT = "greatest contact"
_NO_CONTACT = Force("", "", (0.0, 0.0, 0.0), (math.nan, math.nan, math.nan))
_ORBITER = "L, relative to its pose at the start of the run"


def _bodies(s: Known) -> Dynamics:
    assert s.frame.dynamics is not None, "a reading of a plant with masses"
    return s.frame.dynamics


def _at(path: str, n: int) -> Callable[[Known], Any]:
    """Return the function that returns one of several things of a step."""
    get = attrgetter(path)
    return lambda s: get(s)[n]


def _about(owner: str, group: str, needs: Needs = "masses") -> dict[str, Any]:
    return {"owner": owner, "group": group, "needs": needs}


def _with_masses(*readings: Reading) -> tuple[Reading, ...]:
    """Return readings, marked as of a plant with masses."""
    return tuple(reading if reading.needs else reading._replace(needs="masses") for reading in readings)


def _torque_limits(s: Known) -> Sequence[float]:
    """Return the greatest torque of each motor, or of each brake if the brakes are on."""
    servo = s.scenario.arm.model.servo
    assert servo is not None, "a reading of a plant with masses"
    limits: list[float] = (servo.holding_torque if s.frame.brakes else servo.torque_limit).tolist()
    return limits


def _of_limit(s: Known) -> float:
    return max(abs(torque) / limit for torque, limit in zip(_bodies(s).torques, _torque_limits(s), strict=True))


def _at_limit(s: Known) -> list[bool]:
    limits = _torque_limits(s)
    return [abs(torque) >= limit - _ROUNDED for torque, limit in zip(_bodies(s).torques, limits, strict=True)]


def _when(s: Known, joint: str) -> str:
    at = f"at {s.frame.time_s:.2f} s"
    return f"{joint_label(joint)}, {at}" if joint else at


def _contact(s: Known) -> Force:
    """Return the contact with the greatest mean force; without a contact, no force at no place."""
    return max(_bodies(s).contacts, key=lambda touch: length(touch.force), default=_NO_CONTACT)


def _pair(s: Known) -> str:
    contact = _contact(s)
    return f"{contact.a} on {contact.b}" if contact.a else ""


FORCES = _with_masses(
    Reading(
        "torque_of_limit",
        "torque of motor or brake, as a fraction of its greatest torque",
        _of_limit,
        quantity="part of limit",
        title="Joint torque",
        strip=Strip(limit=1.0, shown=True),
    ),
    Reading(
        "contact_force",
        "force between two parts in contact",
        lambda s: max([one.peak for one in _bodies(s).contacts], default=0.0),
        quantity="force",
        strip=Strip(),
        metrics=(Recorded("greatest", "peak_contact_force", "Peak contact force"),),
    ),
    Reading(
        "contact_forces",
        "sum of the mean forces of all contacts",
        lambda s: math.fsum(math.hypot(*one.force) for one in _bodies(s).contacts),
        quantity="force",
        metrics=(
            Recorded(
                "integral",
                "contact_impulse",
                "Contact impulse",
                "Sum over all contacts and control steps of mean force times duration.",
                "impulse",
            ),
        ),
    ),
    Reading(
        "holding_force",
        "force with which the end effector or a berth held a payload",
        lambda s: max([one.peak for one in _bodies(s).holds], default=0.0),
        quantity="force",
        strip=Strip(),
        metrics=(Recorded("greatest", "peak_holding_force", "Peak holding force"),),
    ),
)
"""Readings of torques and forces."""


def _loads() -> Iterator[Reading]:
    """Yield the readings of the gauges in the arm."""
    for k, (cut, where) in enumerate(_CUTS.items()):
        about = _about(cut, "loads", "gauges") | {"at": _at("gauges.loads", k)}
        for field, parts in (("force", XYZ), ("moment", XYZ), ("peak_force", ())):
            yield shown(Load, field, f"{cut}_{field}", parts, **about)
        sentence = f"Greatest moment inside the arm, {where} (docs/series.md). Needs gauges."
        peak = Recorded("greatest", f"peak_moment_{cut}", f"Peak moment, {where}", sentence, detail=_when)
        yield shown(Load, "peak_moment", f"{cut}_peak_moment", metrics=(peak,), **about)


def _bend(part: str, field: str, quantity: Quantity, title: str, how: str) -> Reading:
    """Return the reading of how far a part is displaced or turned by its bending."""

    def size(s: Known) -> float | None:
        return next((math.hypot(*getattr(bend, field)) for bend in _bodies(s).bends if bend.part == part), None)

    words = joint_label(part)
    definition = f"{field} of the end of the {words} by its {how}"
    metrics = (Recorded("greatest", f"peak_bend_{part}", f"{title}, {words}", detail=_when),)
    return Reading(f"{part}_{field}", definition, size, (), quantity, metrics=metrics)


LOADS = _with_masses(
    *pose(Dynamics, "true_tip", group="true_tip"),
    shown(
        Dynamics,
        "torques",
        "torque",
        "joints",
        metrics=(
            Recorded(
                "greatest",
                "peak_torque",
                "Peak torque",
                "Greatest torque of motor or brake about joint {k} at the end of a step; the force [N] if it slides.",
                detail=_when,
            ),
        ),
        group="torques",
    ),
    Reading(
        "torque_limit",
        "at the greatest torque of the motor, or at the holding torque of the brake",
        _at_limit,
        "joints",
        metrics=(
            Recorded(
                "time",
                "torque_limit_time",
                "At torque limit",
                "Time in which the motor of joint {k} was at its greatest torque, or its brake at the holding torque.",
                "seconds",
                detail=lambda _, joint: joint_label(joint),
            ),
        ),
    ),
    *_loads(),
    *(_bend(part, "displacement", "gap", "Peak bend", "bending") for part in _PARTS[1:]),
    *(_bend(part, "rotation", "angle", "Peak bend angle", "bending and torsion") for part in _PARTS),
    *pose(Placed, "orbiter", attrgetter("frame.dynamics.orbiter"), owner=_ORBITER, group="orbiter"),
    shown(Dynamics, "fired", "jets", JETS, group="jets"),
    shown(Force, "force", "contact_vector", XYZ, at=_contact, **_about(_CONTACT, "contacts"), column="contact_force"),
    shown(Force, "position", "contact", XYZ, at=_contact, **_about(_CONTACT, "contacts")),
    Reading("contact_pair", f"{_CONTACT}: its parts", _pair, (), "words", group="contacts"),
    shown(Readings, "orbiter_turn_rate", "orbiter_turn_rate", XYZ, needs="gauges", group="orbiter_rates"),
    shown(Readings, "orbiter_velocity", "orbiter_velocity", XYZ, needs="gauges", group="orbiter_rates"),
)
"""Readings of torques, of loads in the arm, and of the bodies' motion."""


def of_bodies(scenario: Scenario) -> Iterator[Reading]:
    """Yield the readings of the parts that bend, and of forces on the payloads of the worksite and their motion."""
    for n, flexure in enumerate(scenario.flexures):
        about = _about(flexure.part, "bends") | {"column": f"bend_{flexure.part}", "at": _at("frame.dynamics.bends", n)}
        for field in ("displacement", "rotation"):
            yield shown(Bend, field, f"bend_{flexure.part}_{field}", XYZ, **about)
    payloads = [(payload.name, f"payload_{n}") for n, payload in enumerate(scenario.payloads, 1)]
    for payload, name in payloads:
        for by in HOLDERS:
            about = _about(f"{payload}, {by}", "holds") | {"of": _held(payload, by)}
            yield shown(Holding, "force", f"{name}_held_by_{by.replace(' ', '_')}", **about)
    for body, name in ((TIP, TIP), (ORBITER, ORBITER), *(payloads or [(PART, PART)])):
        for field in ("force", "torque"):
            about = _about(body, "disturbances") | {"of": _disturbing(body, field)}
            yield shown(Wrench, field, f"{name}_disturbing_{field}", XYZ, **about)
    for n, (payload, name) in enumerate(payloads):
        about = _about(payload, "payload_rates", "gauges") | {"of": _at("gauges.payload_turn_rates", n)}
        yield shown(Readings, "payload_turn_rates", f"{name}_turn_rate", XYZ, **about)


def _held(payload: str, by: str) -> Value:
    return lambda s: next((one.force for one in _bodies(s).holds if (one.payload, one.by) == (payload, by)), 0.0)


def _disturbing(body: str, field: str) -> Value:
    """Return the value of a reading: the sum of the forces or torques that disturb a body."""

    def total(s: Known) -> Sequence[float]:
        own = [getattr(wrench, field) for wrench in _bodies(s).disturbances if wrench.body == body]
        return [math.fsum(column) for column in zip(*own, strict=True)] if own else (0.0, 0.0, 0.0)

    return total
