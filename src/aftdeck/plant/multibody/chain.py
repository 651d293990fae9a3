"""Chain of an arm's bodies in MuJoCo: base, joints with motors and gearboxes, booms, telescope and prong.

A body named as a frame of the arm (`ArmModel.frames`) has this frame's pose. A flexible arm has springs besides: three
hinges of the base, the gearbox behind each motor, and in each boom two pairs of hinges for bending and one for torsion.
"""

from __future__ import annotations

from typing import Any

import mujoco
import numpy as np

from aftdeck.arms.flexures import Flexure
from aftdeck.arms.load import ArmModel
from aftdeck.arms.masses import Boom, flexibility_needed, masses_of, servo_needed
from aftdeck.arms.switched import SwitchedJoint
from aftdeck.arrays import Array
from aftdeck.bodies.mass_properties import ROUNDING, MassProperties, joined

GAUSS = (0.5 * (1.0 - 1.0 / np.sqrt(3.0)), 0.5 * (1.0 + 1.0 / np.sqrt(3.0)))
"""Places of a boom's hinges, as shares of its length: with them, the two hinges bend at the tip exactly as a beam."""
DUST = MassProperties(1e-3, np.zeros(3), 1e-4 * np.eye(3))
"""Mass properties of a body between two joints: MuJoCo allows no moving body without mass."""
AXES = np.eye(3)

Body = Any
"""A body of MuJoCo's specification; the library has no types."""


def add_arm(parent: Body, model: ArmModel, *, flexible: bool) -> Body:
    """Add an arm to a body whose frame is L; return the arm's last body.

    Raises:
        ArmError: the arm's file lacks a table that this model needs.
    """
    return _Chain(model, flexible=flexible).add_to(parent)


def end_body(part: Flexure) -> tuple[str, Array]:
    """Return the name of the body that is fixed to the end of a part that bends, and the place of the end in it [m]."""
    if not part.end.any():
        return part.part, np.zeros(3)
    return f"{part.part}.{len(GAUSS)}", (1.0 - GAUSS[-1]) * part.end


class _Chain:
    """Arm that is being added to a specification."""

    def __init__(self, model: ArmModel, *, flexible: bool) -> None:
        self._model, self._servo, self._masses = model, servo_needed(model), masses_of(model)
        self._springs = flexibility_needed(model) if flexible else None
        self._bodies = dict(self._masses.bodies)
        if flexible:
            self._bodies["base"] = self._bodies.pop(model.linkage.frames[0], DUST)  # the foot turns with the base

    def add_to(self, parent: Body) -> Body:
        frames, linkage = self._model.linkage.frames, self._model.linkage
        at = self._body(parent, frames[0], np.zeros(3), moving=False)
        at = self._base(at)
        centre = np.zeros(3)
        if self._model.telescope is not None:
            height = float(linkage.links[0])
            at, centre = self._slide(at, self._model.telescope, height), np.array([0.0, 0.0, height])
        for i, frame in enumerate(frames[1:]):
            at = self._joint(at, i, frame, centre + linkage.steps[i])
            at, centre = self._along(at, frame)
        if self._model.prong is not None:
            self._slide(at, self._model.prong, 0.0)
        return at

    def _base(self, at: Body) -> Body:
        """Add the base's springs between the vehicle and the first joint."""
        if self._springs is None:
            return at
        body = self._body(at, "base", np.zeros(3))
        for axis, name, stiffness in zip(AXES, "xyz", self._springs.base, strict=True):
            self._hinge(body, f"base.{name}", axis, stiffness)
        return body

    def _slide(self, at: Body, joint: SwitchedJoint, begin: float) -> Body:
        """Add a joint that a switch drives; MuJoCo's coordinate is 0 at the joint's coordinate `begin` [m]."""
        body = self._body(at, joint.frame, begin * joint.axis)
        self._hinge(body, joint.driver, joint.axis, kind=mujoco.mjtJoint.mjJNT_SLIDE)
        return body

    def _joint(self, at: Body, i: int, frame: str, centre: Array) -> Body:
        """Add a joint: its motor and, on a flexible arm, the gearbox behind it."""
        name, axis = self._model.joints[i], self._model.linkage.axes[i]
        if self._springs is None:
            body = self._body(at, frame, centre)
            motor = self._hinge(body, f"motor.{name}", axis)
        else:
            rotor = self._body(at, f"rotor.{name}", centre)
            motor = self._hinge(rotor, f"motor.{name}", axis)
            body = self._body(rotor, frame, np.zeros(3))
            self._hinge(body, f"gearbox.{name}", axis, self._springs.gearboxes[i])
        motor.armature, motor.frictionloss = self._servo.armature[i], self._servo.friction[i]
        return body

    def _along(self, at: Body, frame: str) -> tuple[Body, Array]:
        """Add the boom that a frame carries, if there is one; return its last body, and the frame's origin in it."""
        boom = next((boom for boom in self._masses.booms if boom.frame == frame), None)
        if boom is None or self._springs is None:
            return at, np.zeros(3)
        which = self._masses.booms.index(boom)
        length = float(np.linalg.norm(boom.end))
        bending, torsion = 2.0 * self._springs.bending[which] / length, self._springs.torsion[which] / length
        along = boom.end / length
        across = np.cross(along, AXES[1])
        begin = 0.0
        for number, (place, until) in enumerate(zip(GAUSS, (GAUSS[1], 1.0), strict=True), start=1):
            properties = boom.section(place, until).moved(-place * boom.end)
            if until == 1.0:
                properties = joined([properties, boom.tip.moved((1.0 - place) * boom.end)])
            at = self._body(at, f"{boom.name}.{number}", (place - begin) * boom.end, properties)
            self._hinge(at, f"{boom.name}.{number}.pitch", AXES[1], bending)
            self._hinge(at, f"{boom.name}.{number}.yaw", across, bending)
            begin = place
        self._hinge(at, f"{boom.name}.torsion", along, torsion)
        return at, -begin * boom.end

    def _body(
        self, parent: Body, name: str, at: Array, properties: MassProperties | None = None, *, moving: bool = True
    ) -> Body:
        """Add a body with its mass properties; a body of the arm's frames has those of `ArmMasses`."""
        body = parent.add_body(name=name, pos=at)
        parts = [self._bodies[name]] if name in self._bodies else []
        parts += [self._carried(boom) for boom in self._masses.booms if boom.frame == name]
        parts += [] if properties is None else [properties]
        if parts or moving:
            set_mass(body, joined(parts) if parts else DUST)
        return body

    def _carried(self, boom: Boom) -> MassProperties:
        """Return the part of a boom that is fixed to the frame that carries the boom."""
        return boom.whole() if self._springs is None else boom.section(0.0, GAUSS[0])

    def _hinge(
        self, body: Body, name: str, axis: Array, stiffness: float = 0.0, kind: Any = mujoco.mjtJoint.mjJNT_HINGE
    ) -> Any:
        joint = body.add_joint(name=name, type=kind, axis=axis)
        if stiffness and self._springs is not None:
            joint.stiffness[0], joint.damping[0] = stiffness, self._springs.damping * stiffness
        return joint


def set_mass(body: Body, properties: MassProperties) -> None:
    """Set the mass properties of a body.

    MuJoCo rejects a flat plate whose greatest principal moment exceeds the sum of the others by rounding.
    """
    i = properties.inertia
    least, middle, greatest = np.linalg.eigvalsh(i)
    if np.triu(i, 1).any() and least + middle < greatest * (1.0 + ROUNDING):
        i = i + 2.0 * ROUNDING * greatest * np.eye(3)
    body.explicitinertial = True
    body.mass, body.ipos = properties.mass, properties.centre
    body.fullinertia = [i[0, 0], i[1, 1], i[2, 2], i[0, 1], i[0, 2], i[1, 2]]
