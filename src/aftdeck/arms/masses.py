"""Masses of an arm, distributed over the frames that carry them by stated rules.

Family of the Shuttle's arm. `arms.links` has the rule. The foot is fixed to the vehicle; on a flexible arm, it turns
with the base.

Family of the concept arm. Upper and lower arm are uniform boxes from pin to pin. The hand is uniform in the volume of
stub, palm, fixed finger and prong. The telescope's tube is a uniform box.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from aftdeck.arms.blocks import Block, blocks_of
from aftdeck.arms.drives import SlidesFile
from aftdeck.arms.dynamics import Flexibility, Servo
from aftdeck.arms.geometry import STAND
from aftdeck.arms.links import BOOMS, links_of
from aftdeck.arms.load import ArmModel
from aftdeck.arms.model import ChainArmFile, HeadingArmFile, YawArmFile
from aftdeck.arrays import Array
from aftdeck.bodies.mass_properties import MassProperties, box, cylinder, joined
from aftdeck.errors import ArmError

HAND = ("stub", "palm", "fixed finger", "prong")
"""Parts of a concept arm whose volumes share the mass of the hand."""


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
        ArmError: the arm's file lacks the table `links` or `slides`, or a part has no mass.
    """
    file = model.source
    if isinstance(file, ChainArmFile):
        return _of_chain(model, file)
    parts = file.masses.parts.value
    if massless := [name for name in parts.__struct_fields__ if getattr(parts, name) <= 0.0]:
        raise ArmError(
            f"the arm {model.name!r} cannot have a rigid or flexible plant: masses.parts has 0 kg for "
            f"{', '.join(massless)}"
        )
    if isinstance(file, YawArmFile):
        if file.links is None:
            raise _lacking(model, "links")
        return _of_yaw_arm(model, file)
    if file.slides is None:
        raise _lacking(model, "slides")
    return _of_heading_arm(model, file, file.slides)


def check_masses(model: ArmModel, *, flexible: bool) -> None:
    """Check that an arm's file has all tables that a plant with masses needs.

    Raises:
        ArmError: a table is missing, or a part has no mass; the message names it.
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


def _of_chain(model: ArmModel, file: ChainArmFile) -> ArmMasses:
    if lacking := [joint.name for joint in file.joint if joint.link is None]:
        raise ArmError(
            f"the arm {model.name!r} cannot have a rigid or flexible plant: its file has no mass (link) for "
            f"{', '.join(lacking)}"
        )
    links = [joint.link for joint in file.joint if joint.link is not None]
    bodies = {
        frame: MassProperties(float(link.mass), np.array(link.centre), np.diag(link.inertia))
        for frame, link in zip(model.linkage.frames[1:], links, strict=True)
    }
    return ArmMasses(bodies, ())


def _of_yaw_arm(model: ArmModel, file: YawArmFile) -> ArmMasses:
    bodies, booms = {}, []
    for link, frame in zip(links_of(file), model.linkage.frames, strict=True):
        if link.name in BOOMS:
            shares = link.shares()
            bodies[frame] = shares.beginning
            booms.append(Boom(link.name, frame, link.end, shares.rod, link.radius, shares.tip))
        else:
            bodies[frame] = link.whole()
    return ArmMasses(bodies, tuple(booms))


def _of_heading_arm(model: ArmModel, file: HeadingArmFile, slides: SlidesFile) -> ArmMasses:
    m, frames, half = file.masses.parts.value, model.linkage.frames, 0.5 * file.booms.side.value
    blocks = blocks_of(file, frames)
    bodies = {
        frame: box(mass, (0.0, -half, -half), (length.value, half, half))
        for frame, mass, length in (
            (frames[2], m.upper_arm, file.geometry.upper_arm),
            (frames[3], m.lower_arm, file.geometry.lower_arm),
        )
    }
    hand = [block for block in blocks if block.part in HAND]
    density = m.hand / sum(map(_volume, hand))
    for frame in dict.fromkeys(block.frame for block in hand):
        bodies[frame] = joined([box(density * _volume(b), b.low, b.high) for b in hand if b.frame == frame])
    tube = next(block for block in blocks if block.frame == STAND)
    return ArmMasses(bodies | {STAND: box(slides.telescope_mass.value, tube.low, tube.high)}, ())


def _volume(block: Block) -> float:
    """Return the volume of a block [m3]."""
    return float(np.prod(np.subtract(block.high, block.low)))
