"""Chains for tests: those of the built-in arms, and random ones."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from scipy.spatial.transform import Rotation

import aftdeck
from aftdeck.arms.chain import AXIS, JOINT, PLACE, SLIDES
from aftdeck.arrays import Array
from aftdeck.bodies.pose import HERE, POSE
from aftdeck.kinematics.chain.posture import place_joints, write_jacobian


class Chain(NamedTuple):
    """A chain, and its tip's pose in the last joint's frame."""

    joints: Array
    hand: Array

    @property
    def number(self) -> int:
        return len(self.joints)

    @property
    def scale(self) -> float:
        """Characteristic length [m]: the sum of the distances between joints, and to the tip."""
        return float(np.linalg.norm(self.joints[:, :3], axis=1).sum() + np.linalg.norm(self.hand[:3]))


class Posture(NamedTuple):
    """Poses of joints and tip, and the Jacobian."""

    joints: Array
    tip: Array
    jacobian: Array


def posture(chain: Chain, q: Array) -> Posture:
    joints, tip, matrix = np.empty((chain.number, POSE)), np.empty(POSE), np.empty((6, chain.number))
    place_joints(chain.joints, chain.hand, q, joints, tip)
    write_jacobian(chain.joints, joints, tip, matrix)
    return Posture(joints, tip, matrix)


def chain_of(arm: aftdeck.Arm) -> Chain:
    """Return the chain of an arm of one of the two families."""
    linkage = arm.model.linkage
    joints = np.zeros((6, JOINT))
    joints[:, PLACE : PLACE + POSE] = HERE
    joints[:, :3] = linkage.steps
    joints[:, AXIS : AXIS + 3] = linkage.axes
    hand = np.array(HERE)
    hand[:3] = linkage.tip
    return Chain(joints, hand)


def random_chain(rng: np.random.Generator, count: int, slides: int = 0) -> Chain:
    """Return a chain with random places and axes, of which `slides` joints slide."""
    joints = np.zeros((count, JOINT))
    for row in joints:
        row[:3] = rng.uniform(-1.5, 1.5, 3)
        row[3:12] = Rotation.random(random_state=rng).as_matrix().ravel()
        row[AXIS : AXIS + 3] = Rotation.random(random_state=rng).as_matrix()[0]
    joints[rng.permutation(count)[:slides], SLIDES] = 1.0
    hand = np.concatenate([rng.uniform(-1.0, 1.0, 3), Rotation.random(random_state=rng).as_matrix().ravel()])
    return Chain(joints, hand)


def random_coordinates(rng: np.random.Generator, chain: Chain) -> Array:
    return np.where(
        chain.joints[:, SLIDES] != 0.0, rng.uniform(-1.0, 1.0, chain.number), rng.uniform(-3.0, 3.0, chain.number)
    )
