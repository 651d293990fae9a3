"""State of a plant: what steering measures, and the state of the bodies behind the measurements."""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array, Mask
from aftdeck.bodies.pose import HERE, POSE
from aftdeck.plant.linear_actuator import Slide
from aftdeck.state_part import StatePart

FOLLOWING = np.zeros((0, POSE))
"""Poses of an arm's frames that follow from the joint angles."""


class Bodies(StatePart):
    """State of a plant with masses (`plant.multibody`).

    Attributes:
        physics: MuJoCo's integration state: time, positions, velocities, activations, controls and warm start.
        holds: (6,) angles that the servos hold while their joints are not commanded [rad]; NaN for a commanded joint.
        brakes: (6,) angles at which the brakes hold the joints [rad]; NaN while the brakes are off.
        frames: (n, 12) true poses of the arm's frames in L, in the order of `ArmModel.frames`.
        reference: (6,) rates from which the steering's acceleration limits count [rad/s].
        torques: (6,) torques of motors and brakes about the joints, at the end of the step [N m].
        overdriven: (6,) 1 for joints that turn against a motor or brake at its greatest torque.
        payloads: (c, 12) poses of the worksite's payloads, in the frame that is fixed in space and coincided with L at
            the start of the run.
        motions: (c, 6) their motions: angular velocity in the payload's axes [rad/s], then velocity of its centre in
            the axes of the same frame [m/s].
        held: (c, 3) forces at the payloads' centres by which end effector, orbiter and space hold them, at the end of
            the step [N].
    """

    physics: Array
    holds: Array
    brakes: Array
    frames: Array
    reference: Array
    torques: Array
    overdriven: Mask
    payloads: Array
    motions: Array
    held: Array


class PlantState(StatePart):
    """State of a plant.

    Attributes:
        angles: (6,) joint angles, as the encoders measure them [rad].
        rates: (6,) joint rates, as the tachometers measure them [rad/s].
        commanded: (6,) angles that the joints would have without stops, from all commanded rates so far [rad].
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
        """Rates (6,) from which the steering's acceleration limits count [rad/s].

        They are the measured rates on the kinematic plant, and under `strict`. Otherwise they are the commanded rates:
        a servo turns its joint with a torque in proportion to the difference of the two, which an acceleration limit
        that counts from the measured rate holds below the torque that a heavy payload needs.
        """
        return self.rates if self.bodies is None else self.bodies.reference

    @property
    def frames(self) -> Array:
        """True poses of the arm's frames in L, (n, 12); `FOLLOWING` if they follow from the joint angles."""
        return FOLLOWING if self.bodies is None else self.bodies.frames


def new_plant_state() -> PlantState:
    """Return a state with all joints at rest at zero, without bodies."""
    return PlantState(np.zeros(6), np.zeros(6), np.zeros(6), Slide(0.0), np.array(HERE))
