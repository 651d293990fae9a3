"""Disturbances: forces and torques on tip, payloads or orbiter, as inputs of a step or planned by a scenario."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import msgspec

from aftdeck.bounds import COORDINATE, Bounds
from aftdeck.scenario.payload import PART
from aftdeck.scenario.poses import FRAMES
from aftdeck.scenario.problems import Problems
from aftdeck.scenario.schema import DisturbanceSpec, Plant, ScenarioFile
from aftdeck.tuples import Vec3, plain_vector
from aftdeck.units import Force, Torque
from aftdeck.worksite.model import OrbiterMotion

TIP, ORBITER, SPACE = "tip", "orbiter", "space"
"""Bodies and coordinate frames that every scenario has, besides its payloads."""
ZERO = (0.0, 0.0, 0.0)
MOST_DISTURBANCES = 64
"""Greatest number of disturbances in a step's inputs (assumed)."""
_ROUNDING = 1e-9
"""Share of a control period that comes from rounding [1]."""


class Disturbance(msgspec.Struct, frozen=True):
    """Force and torque on a body, constant during a control step in the axes that `frame` has when the step begins."""

    on: str
    """Body: ``tip``, ``orbiter``, the name of a payload of the worksite, or ``payload`` for the payload that the
    scenario itself attaches."""
    force: Vec3 = ZERO
    """Force [N]."""
    torque: Vec3 = ZERO
    """Torque in addition to that of the force [N m]."""
    frame: str = ORBITER
    """Axes of force and torque: ``orbiter``, ``panel``, ``L``, ``space`` (the axes of L at the start of the run, which
    do not turn), ``tip`` (frame 7), or those of a payload, by its name."""
    at: Vec3 | None = None
    """Point at which the force acts [m]: of a payload, from its centre in its axes; of the tip, from the tip in frame
    7; of the orbiter, in the orbiter frame. None for the tip itself, or the centre of mass of the others."""


class Planned(NamedTuple):
    """Disturbance that a scenario plans.

    Attributes:
        disturbance: the disturbance.
        begin: time at which it begins [s].
        end: time at which it ends [s].
    """

    disturbance: Disturbance
    begin: float
    end: float

    def share(self, time: float, period: float) -> float:
        """Return the share of a control period, from `time` [s] on, in which it acts, 0 to 1.

        Force and torque times this share act during the whole period, so that the impulse is exact.
        """
        share = (min(self.end, time + period) - max(self.begin, time)) / period
        return 0.0 if share < _ROUNDING else 1.0 if share > 1.0 - _ROUNDING else share


class Disturbable(NamedTuple):
    """What disturbances can act on in a scenario.

    Attributes:
        plant: its plant.
        orbiter: motion of its orbiter.
        payloads: names of its payloads.
    """

    plant: Plant
    orbiter: OrbiterMotion
    payloads: tuple[str, ...]

    @property
    def movable(self) -> tuple[str, ...]:
        """Names of the bodies that a force can move."""
        return (TIP, *(() if self.orbiter == "fixed" else (ORBITER,)), *self.payloads)

    def problem(self, given: Disturbance) -> tuple[str, str] | None:
        """Return the field of a disturbance that does not suit the scenario, and why; None if all do."""
        if self.plant == "kinematic":
            return "on", "forces need a plant with masses, 'rigid' or 'flexible'; the plant is 'kinematic'"
        if given.on == ORBITER and self.orbiter == "fixed":
            return "on", "the orbiter is fixed, and no force moves it; dynamics.orbiter = 'free' or 'held' frees it"
        if given.on not in self.movable:
            return "on", f"no body {given.on!r}: there are {', '.join(self.movable)}"
        frames = (*FRAMES, SPACE, TIP, *self.payloads)
        if given.frame not in frames:
            return "frame", f"no frame {given.frame!r}: there are {', '.join(frames)}"
        for name, values, bounds, unit in (
            ("force", given.force, Force.bounds, Force.unit),
            ("torque", given.torque, Torque.bounds, Torque.unit),
            ("at", given.at or ZERO, COORDINATE, COORDINATE.unit),
        ):
            if why := next(_implausible(values, bounds, unit), ""):
                return name, why
        return None


def _implausible(values: Vec3, bounds: Bounds, unit: str) -> Iterator[str]:
    """Yield why values are not plausible."""
    for value in values:
        if why := bounds.problem(value, unit):
            yield why


def payload_names(payloads: Sequence[str], *, own: bool) -> tuple[str, ...]:
    """Return the names of a scenario's payloads: those of the worksite, and ``payload`` if it attaches one itself."""
    return (*payloads, PART) if own else tuple(payloads)


def planned(problems: Problems, spec: ScenarioFile, disturbable: Disturbable) -> tuple[Planned, ...]:
    """Return the disturbances that a scenario plans; those that are wrong are reported and left out."""
    found = []
    for i, one in enumerate(spec.disturbance):
        given = _disturbance(one)
        if wrong := disturbable.problem(given):
            problems.add(("disturbance", i, wrong[0]), wrong[1])
        elif not any((*given.force, *given.torque)):
            problems.add(("disturbance", i), "has no force and no torque: give at least one of them")
        elif one.duration <= 0.0:
            problems.add(("disturbance", i, "duration"), f"has to be above 0, got {one.duration:g} s")
        else:
            found.append(Planned(given, float(one.begin), math.fsum((one.begin, one.duration))))
    return tuple(found)


def _disturbance(spec: DisturbanceSpec) -> Disturbance:
    at = None if spec.at is None else plain_vector(spec.at)
    return Disturbance(spec.on, plain_vector(spec.force), plain_vector(spec.torque), spec.frame, at)
