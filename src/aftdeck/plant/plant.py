"""Interface of a plant: the model that turns commanded rates into motion."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal, NamedTuple, Protocol

import numpy as np

from aftdeck.arrays import Array, Indices
from aftdeck.plant.readings import Readings
from aftdeck.plant.spread import Spread
from aftdeck.plant.state import PlantState
from aftdeck.steering.mode import LawChoice

NO_COMMAND = np.full(3, np.nan)
"""Value of `Surroundings.velocity` without a command."""
LEAST_PULSE = 0.08
"""Least time for which a jet is on when the orbiter translates [s]; the Shuttle's jets have it (firm)."""
MOST_PAIRS = 128
"""Greatest number of pairs of solids that can be near each other at the same time, on a plant with contact forces."""
NOTHING_NEAR: Indices = np.empty((0, 3), dtype=np.int64)
"""Value of `Surroundings.near` if no solids are near each other."""


class Accuracy(NamedTuple):
    """Differences within which a plant can bring joints and telescope to a given position.

    Attributes:
        angle: difference of a joint's angle [rad].
        rate: rate at which a joint counts as at rest [rad/s].
        length: difference of the telescope's length [m].
    """

    angle: float
    rate: float
    length: float


class Hold(NamedTuple):
    """Connection of a payload of the worksite to the arm, to the orbiter or to space, in one control period.

    Attributes:
        payload: index of the payload.
        by: what holds the payload: the last joint's frame, the orbiter, or space.
        pose: (12,) pose in which the payload is held: in the last joint's frame, in L, or in the frame that is fixed in
            space and coincided with L at the start of the run.
        closed: 1 if the payload is held in `pose`. A smaller value is the position of the snare ring while it closes
            about the pin: the snares then only damp the motion of payload and end effector relative to each other.
        give: time constant with which a displaced payload returns to `pose`, without overshoot [s].
    """

    payload: int
    by: Literal["hand", "orbiter", "space"]
    pose: Array
    closed: float = 1.0
    give: float = 0.1


Pushed = int | Literal["hand", "attached", "orbiter"]
"""A body that can be pushed: index of a payload of the worksite, the last joint's body, the payload that the scenario
itself attaches, or the orbiter."""


class Push(NamedTuple):
    """Force and torque on a body in one control period, in the frame that is fixed in space and was L at the start.

    Attributes:
        on: the body.
        force: (3,) force [N].
        torque: (3,) torque in addition to that of the force [N m].
        place: (3,) point at which the force acts when the period begins [m].
    """

    on: Pushed
    force: Array
    torque: Array
    place: Array


class Surroundings(NamedTuple):
    """What acts on the bodies besides servos and brakes, in one control period.

    Attributes:
        holds: all connections of the worksite's payloads.
        near: (p, 3) pairs of solids that can touch: the pair of parts and the two solids, as in the worksite's layout.
        prong: position of the prong, for an arm that has one [m].
        velocity: (3,) commanded velocity of the orbiter in space, along forward, starboard and down [m/s]; NaN for an
            axis that is not commanded.
        pushes: disturbances, and torques of payloads with attitude control.
    """

    holds: Sequence[Hold] = ()
    near: Indices = NOTHING_NEAR
    prong: float = 0.0
    velocity: Array = NO_COMMAND
    pushes: Sequence[Push] = ()


class Plant(Protocol):
    """Model of the arm between steering and worksite (JSC-12628: integration driver with body and servo models).

    A plant holds constants of the run, and the readings of its last step. What else changes is in the `PlantState` that
    its methods receive.
    """

    @property
    def readings(self) -> Readings | None:
        """Readings of the last step; None without gauges and before the first step."""

    @property
    def accuracy(self) -> Accuracy:
        """Differences within which the plant can bring joints and telescope to a given position."""

    @property
    def has_servos(self) -> bool:
        """Whether servos turn the joints.

        The arm then needs time to come to rest, and the servos hold the joints while no rate is commanded.
        """

    @property
    def has_contact_forces(self) -> bool:
        """Whether parts in contact push each other apart, so that a contact need not inhibit the arm's motion."""

    def spread(self, law: LawChoice, *, loaded: bool) -> Spread:
        """Return by how much an automatic motion differs from its rehearsal on the kinematic plant."""

    def begin(self, state: PlantState, attached: int, poses: Array, motions: Array, prong: float) -> None:
        """Set up the bodies for the joint angles, joint rates and telescope of `state`.

        Args:
            state: state with angles, rates and the telescope's position; its bodies are set.
            attached: number, from 1, of the payload that the arm carries; 0 for none.
            poses: (c, 12) poses of the worksite's payloads in L.
            motions: (c, 6) motions of the worksite's payloads, as `Bodies.motions`.
            prong: position of the prong, for an arm that has one [m].
        """

    def move(
        self,
        state: PlantState,
        rates: Array,
        drive: float,
        around: Surroundings,
        *,
        brakes: bool,
        attached: int,
        by_angle: bool,
    ) -> None:
        """Move arm and telescope for one control period, and measure the joints.

        Args:
            state: changed in place.
            rates: (n,) commanded joint rates [rad/s].
            drive: drive of the telescope, -1 to +1; + lengthens it.
            around: what acts on the bodies besides servos and brakes.
            brakes: whether the brakes of all joints are on.
            attached: number, from 1, of the payload that the arm carries; 0 for none.
            by_angle: whether servos also turn the joints to the angles to which the commanded rates lead.

        Raises:
            SimulationError: the model diverged.
        """
