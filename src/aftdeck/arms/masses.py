"""Masses of an arm by the frames that carry them: its links, and the bodies of its file that have a mass."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import NamedTuple

import numpy as np

from aftdeck.arms.body_file import BlockBody
from aftdeck.arms.dynamics import Flexibility, Servo
from aftdeck.arms.geometry import FOOT, frame_of
from aftdeck.arms.link_file import BodyLink, BoxLink
from aftdeck.arms.links import rods_of
from aftdeck.arms.load import ArmModel
from aftdeck.arms.model import ArmFile
from aftdeck.arrays import Array
from aftdeck.bodies.mass_properties import MassProperties, box, cylinder, joined
from aftdeck.errors import ArmError


class Boom(NamedTuple):
    """Boom: a uniform cylinder from the origin of the frame that carries it to the next joint.

    Attributes:
        name: name of the boom, such as ``upper_boom``.
        frame: name of the frame that carries the boom.
        end: (3,) vector from the frame's origin to the next joint [m].
        mass: mass of the cylinder [kg].
        radius: radius of the cylinder [m].
        tip: body fixed to the boom's end; its coordinates begin at the end.
    """

    name: str
    frame: str
    end: Array
    mass: float
    radius: float
    tip: MassProperties

    def section(self, begin: float, end: float) -> MassProperties:
        """Return the part of the cylinder between two shares of its length, 0 to 1."""
        return cylinder((end - begin) * self.mass, self.radius, begin * self.end, end * self.end)

    def whole(self) -> MassProperties:
        """Return the boom as a rigid body, with the body at its end."""
        return joined([self.section(0.0, 1.0), self.tip.moved(self.end)])


class ArmMasses(NamedTuple):
    """Masses of an arm.

    Attributes:
        bodies: for each frame that carries a mass besides a boom, the mass properties in that frame.
        booms: the booms, from the shoulder to the wrist; none if the arm has no booms that bend.
    """

    bodies: dict[str, MassProperties]
    booms: tuple[Boom, ...]


def masses_of(model: ArmModel) -> ArmMasses:
    """Return the masses of an arm.

    Raises:
        ArmError: a joint has no mass behind it, or a joint that a switch drives has no drive.
    """
    file, bodies, booms = model.source, dict[str, list[MassProperties]](), []
    for _, frame, link in rods_of(file):
        if link.bends:
            shares = link.shares()
            bodies[frame] = [shares.beginning]
            booms.append(Boom(link.name, frame, link.end, shares.rod, link.radius, shares.tip))
        else:
            bodies[frame] = [link.whole()]
    for given, frame in ((file.foot, FOOT), *((joint.link, frame_of(joint.name)) for joint in file.joint)):
        if isinstance(given, BodyLink):
            bodies[frame] = [MassProperties(float(given.mass), np.array(given.centre), np.diag(given.inertia))]
        elif isinstance(given, BoxLink):
            bodies[frame] = [box(given.mass, given.low, given.high)]
    for body in file.bodies:
        if isinstance(body, BlockBody) and body.mass is not None:
            bodies.setdefault(body.frame, []).append(box(body.mass, body.low, body.high))
    if lacking := [*_massless(file, bodies), *(joint.name for joint in model.switched if joint.drive is None)]:
        raise ArmError(
            f"the arm {model.name!r} cannot have a rigid or flexible plant: its file has no mass (link) or drive for "
            f"{', '.join(lacking)}"
        )
    return ArmMasses({frame: joined(parts) if parts[1:] else parts[0] for frame, parts in bodies.items()}, tuple(booms))


def _massless(file: ArmFile, bodies: Mapping[str, object]) -> Iterator[str]:
    """Yield the name of each joint without mass behind it; where the next joint has the same centre, none is needed."""
    ends = [*(joint.step for joint in file.steered[1:]), None]
    for joint, end in zip(file.steered, ends, strict=True):
        if frame_of(joint.name) not in bodies and (end is None or any(end)):
            yield joint.name
    for slide in file.switched:
        if frame_of(slide.name) not in bodies:
            yield slide.name


def check_masses(model: ArmModel, *, flexible: bool) -> None:
    """Check that an arm's file has all tables that a plant with masses needs.

    Raises:
        ArmError: a table, a mass or a drive is missing; the message names it.
    """
    servo_needed(model)
    if flexible:
        flexibility_needed(model)
    masses_of(model)


def servo_needed(model: ArmModel) -> Servo:
    """Return an arm's servos; raise an ArmError if its file has none."""
    if model.servo is None:
        raise _lacking(model, "servo")
    return model.servo


def flexibility_needed(model: ArmModel) -> Flexibility:
    """Return an arm's springs; raise an ArmError if its file has none."""
    if model.flexibility is None:
        raise _lacking(model, "flexibility")
    return model.flexibility


def _lacking(model: ArmModel, table: str) -> ArmError:
    """Return the error for an arm whose file lacks a table that a plant with masses needs."""
    plant = "flexible" if table == "flexibility" else "rigid or flexible"
    return ArmError(f"the arm {model.name!r} cannot have a {plant} plant: its file has no table [{table}]")
