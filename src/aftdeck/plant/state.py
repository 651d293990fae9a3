"""State of a plant: what steering measures, and the state of the bodies behind the measurements."""

from __future__ import annotations

import msgspec
import numpy as np

from aftdeck.arrays import Array, Mask
from aftdeck.bodies.pose import HERE, POSE
from aftdeck.plant.linear_actuator import Slide
from aftdeck.plant.stop import TipMotion
from aftdeck.state_part import StatePart
from aftdeck.tuples import Vec3

FOLLOWING = np.zeros((0, POSE))
"""Poses of an arm's frames that follow from the joint angles."""


class Touch(msgspec.Struct, frozen=True, array_like=True):
    """Force between two parts in contact, in one control period.

    Attributes:
        group: index of the pair of parts in the worksite's layout.
        force: mean force on the second part, in L [N]; the force on the first part is opposite. Times the period, it is
            the impulse.
        place: point at which it acts, in L [m].
        greatest: greatest size of the force in a step of MuJoCo [N].
    """

    group: int
    force: Vec3
    place: Vec3
    greatest: float


class ContactForce(msgspec.Struct, frozen=True, array_like=True):
    """Force of a contact since the parts touched.

    Attributes:
        greatest: greatest force [N].
        impulse: sum over the control periods of mean force times period [N s].
        apart_for: time since the parts touched last [s].
    """

    greatest: float = 0.0
    impulse: float = 0.0
    apart_for: float = 0.0


class Bodies(StatePart):
    """State of a plant with masses (`plant.multibody`).

    Attributes:
        physics: MuJoCo's integration state: time, positions, velocities, activations, controls and warm start.
        holds: (n,) angles to which the servos turn the joints [rad]; NaN for none. They are the angles of joints that
            are not commanded and, in modes that steer joint angles, those to which the commanded rates lead.
        frames: (f, 12) true poses of the arm's frames in L, in the order of `ArmModel.frames`.
        bends: (b, 6) bends of base and booms (`kinematics.bending`), in the order of `flexures_of`; (0, 6) if rigid.
        reference: (n,) rates from which the steering's acceleration limits count [rad/s].
        torques: (n,) torques of motors and brakes about the joints, at the end of the step [N m].
        overdriven: (n,) 1 for joints that turn against a motor or brake at its greatest torque.
        payloads: (c, 12) poses of the worksite's payloads, in the frame that is fixed in space and coincided with L at
            the start of the run.
        motions: (c, 6) their motions: angular velocity in the payload's axes [rad/s], then velocity of its centre in
            the axes of the same frame [m/s].
        held: (c, 3) forces at the payloads' centres by which end effector, orbiter and space hold them, at the end of
            the step [N].
        held_greatest: (c, 3) greatest of these forces in the control period [N]: of all steps of MuJoCo if solids are
            near each other, else at the end of the period.
        held_peaks: (c, 3) greatest forces since the end effector, the orbiter or space began to hold the payload [N].
        held_for: (c, 3) time since then [s]; infinite if it holds the payload from the start of the run.
        orbiter_velocity: (3,) velocity of the orbiter's centre of mass in space, in L's axes [m/s]; 0 if it is fixed.
        pulses: (6,) time left of the least pulses of the orbiter's jets, about and along forward, starboard and down;
            its sign is that of the torque or the force [s].
        fired: (6,) time for which these jets have fired so far [s].
        tip: motion of the tip, and its stop.
        touches: forces between parts in contact, in the last control period.
        contacts: force of each contact since the parts touched, by the index of the pair.
    """

    physics: Array
    holds: Array
    frames: Array
    bends: Array
    reference: Array
    torques: Array
    overdriven: Mask
    payloads: Array
    motions: Array
    held: Array
    held_greatest: Array
    held_peaks: Array
    held_for: Array
    orbiter_velocity: Array
    pulses: Array
    fired: Array
    tip: TipMotion = msgspec.field(default_factory=TipMotion)
    touches: tuple[Touch, ...] = ()
    contacts: dict[int, ContactForce] = msgspec.field(default_factory=dict)


class PlantState(StatePart):
    """State of a plant.

    Attributes:
        angles: (n,) joint angles, as the encoders measure them [rad].
        rates: (n,) joint rates, as the tachometers measure them [rad/s].
        commanded: (n,) angles that the joints would have without stops, from all commanded rates so far [rad].
        stand: telescope; its position is the shoulder's height above L's origin.
        base: (12,) pose of L in the frame that is fixed in space and coincided with L at the start of the run. On the
            kinematic plant, L does not turn, and the worksite counts its displacement.
        bodies: state of the bodies; None on the kinematic plant, whose bodies are where the joint angles place them.
    """

    angles: Array
    rates: Array
    commanded: Array
    stand: Slide
    base: Array
    bodies: Bodies | None = None

    @property
    def reference(self) -> Array:
        """Rates (n,) from which the steering's acceleration limits count [rad/s].

        They are the measured rates on the kinematic plant, and the commanded rates with masses: a servo turns its joint
        with a torque in proportion to the difference of the two, which an acceleration limit that counts from the
        measured rate holds below the torque that a heavy payload needs. The steering as published (`strict`) counts
        from them, too; otherwise it would not move such a payload.
        """
        return self.rates if self.bodies is None else self.bodies.reference

    @property
    def holds(self) -> Array:
        """Angles (n,) to which servos turn the joints, as `Bodies.holds`; the joint angles on the kinematic plant."""
        return self.angles if self.bodies is None else self.bodies.holds

    @property
    def frames(self) -> Array:
        """True poses of the arm's frames in L, (f, 12); `FOLLOWING` if they follow from the joint angles."""
        return FOLLOWING if self.bodies is None else self.bodies.frames


def new_plant_state(joints: int) -> PlantState:
    """Return the state of an arm with this number of joints, all at rest at zero, without bodies."""
    return PlantState(np.zeros(joints), np.zeros(joints), np.zeros(joints), Slide(0.0), np.array(HERE))
