"""Masses of an arm, distributed over the frames that carry them by stated rules.

Family of the Shuttle's arm. The yaw housing is a sphere at the first joint and fixed to the vehicle. The shoulder is a
sphere midway between yaw and pitch joint. Booms are uniform cylinders between the centres of their joints. Half of the
elbow is fixed to the upper boom's end and half to the lower boom's beginning, both as spheres at the joint. Half of the
wrist pitch housing is a sphere at the lower boom's end. Each link behind wrist pitch, wrist yaw and wrist roll has half
of the housing at its beginning and half of the next one; the last link has the whole end effector. Its mass is midway
along the link, with the inertia that the file gives.

Family of the concept arm. Upper and lower arm are uniform boxes from pin to pin. The hand is uniform in the volume of
stub, palm, fixed finger and prong. The telescope's tube is a uniform box.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from aftdeck.arms.blocks import Block, blocks_of
from aftdeck.arms.drives import HousingsFile, SlidesFile
from aftdeck.arms.dynamics import Flexibility, Servo
from aftdeck.arms.geometry import STAND
from aftdeck.arms.load import ArmModel
from aftdeck.arms.model import HeadingArmFile, YawArmFile
from aftdeck.arrays import Array
from aftdeck.bodies.mass_properties import MassProperties, box, cylinder, joined, sphere
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
        ArmError: the arm's file lacks the table `housings` or `slides`, or a part has no mass.
    """
    file = model.source
    parts = file.masses.parts.value
    if massless := [name for name in parts.__struct_fields__ if getattr(parts, name) <= 0.0]:
        raise ArmError(
            f"the arm {model.name!r} cannot have a rigid or flexible plant: masses.parts has 0 kg for "
            f"{', '.join(massless)}"
        )
    if isinstance(file, YawArmFile):
        if file.housings is None:
            raise _lacking(model, "housings")
        return _of_yaw_arm(model, file, file.housings)
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


def _of_yaw_arm(model: ArmModel, file: YawArmFile, housings: HousingsFile) -> ArmMasses:
    m, radius = file.masses.parts.value, float(housings.radius.value)
    frames, steps = model.linkage.frames, model.linkage.steps
    half_elbow = sphere(0.5 * m.elbow, radius)
    half_wrist = sphere(0.5 * m.wrist_pitch, radius)
    to_yaw, to_tip = float(steps[4][0]), float(file.geometry.wrist_yaw_to_tip.value)
    to_roll = float(housings.wrist_yaw_to_roll.value)
    links = (
        (0.5 * m.wrist_pitch + 0.5 * m.wrist_yaw, 0.5 * to_yaw),
        (0.5 * m.wrist_yaw + 0.5 * m.wrist_roll, 0.5 * to_roll),
        (0.5 * m.wrist_roll + m.end_effector, 0.5 * (to_roll + to_tip)),
    )
    bodies = {
        frames[0]: sphere(m.yaw_housing, radius),
        frames[1]: sphere(m.shoulder, radius, 0.5 * steps[1]),
        frames[3]: half_elbow,
    }
    for frame, (mass, ahead), (along, across) in zip(frames[4:], links, housings.wrist_inertia.value, strict=True):
        bodies[frame] = MassProperties(mass, np.array([ahead, 0.0, 0.0]), np.diag([along, across, across]))
    boom_radius = float(housings.boom_radius.value)
    return ArmMasses(
        bodies,
        (
            Boom("upper_boom", frames[2], steps[2], m.upper_boom, boom_radius, half_elbow),
            Boom("lower_boom", frames[3], steps[3], m.lower_boom, boom_radius, half_wrist),
        ),
    )


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
