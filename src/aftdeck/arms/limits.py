"""Joint limits and rate limits of an arm as arrays, and checks that these limits agree with each other."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

from aftdeck.arms.by_joint import scale
from aftdeck.arms.geometry import frozen
from aftdeck.arms.model import ArmFile
from aftdeck.arrays import Array


class Limits(NamedTuple):
    """Joint limits in panel angles, each (n, 2) [rad]: least and greatest.

    Attributes:
        hard: mechanical stops.
        soft: soft stops; beyond them, computed modes and MASTER move no joint further outwards.
        reach: limits at which the REACH LIM lamp lights; they do not stop a joint.
    """

    hard: Array
    soft: Array
    reach: Array


class JointRates(NamedTuple):
    """Joint rate limits and the greatest joint accelerations.

    Attributes:
        servo: (n,) greatest rates of the servos [rad/s]; RATLMT uses them in modes 2 to 7.
        coarse: (n,) limits for the rate setting coarse, in modes 1 and 8, DIRECT and MASTER [rad/s].
        vernier: (n,) limits for the rate setting vernier, in the same modes as `coarse` [rad/s].
        acceleration: (n,) greatest joint accelerations, applied in modes 1 to 7 [rad/s2].
    """

    servo: Array
    coarse: Array
    vernier: Array
    acceleration: Array


class LimitProblem(NamedTuple):
    """Inconsistent limits of a joint.

    Attributes:
        joint: number of the joint.
        quantity: ``hard``, ``servo`` or ``acceleration``.
        what: the message.
    """

    joint: int
    quantity: str
    what: str


def limits_of(file: ArmFile) -> Limits:
    """Return the joint limits of a file's arm."""
    return Limits(*(frozen([getattr(joint, name) for joint in file.steered]) for name in Limits._fields))


def rates_of(file: ArmFile) -> JointRates:
    """Return the rate limits of a file's arm."""
    return JointRates(*(frozen([getattr(joint, name) for joint in file.steered]) for name in JointRates._fields))


def limit_problems(
    joints: Sequence[str], slides: Sequence[bool], limits: Limits, rates: JointRates
) -> list[LimitProblem]:
    """Return a problem for each joint with inconsistent limits or rates; `slides`: whether each joint slides."""
    found = []
    for i, joint in enumerate(joints):
        (factor, unit), (_, si) = scale(slides[i]), scale(slides[i], degrees=False)
        chain = [*(s[i, 0] for s in limits), *(s[i, 1] for s in reversed(limits))]
        if not all(a <= b for a, b in pairwise(chain)) or chain[2] == chain[3]:
            ranges = "; ".join(
                f"{name} {low:g} to {high:g} {unit}"
                for name, (low, high) in zip(Limits._fields, (s[i] * factor for s in limits), strict=True)
            )
            what = (
                f"{joint}: reach limits have to be inside the soft stops, and soft stops inside the hard stops; "
                f"got {ranges}"
            )
            found.append(LimitProblem(i, "hard", what))
        vernier, coarse, servo = rates.vernier[i], rates.coarse[i], rates.servo[i]
        if not 0.0 < vernier <= coarse <= servo:
            what = f"{joint}: expected 0 < vernier <= coarse <= servo, got {vernier:g}, {coarse:g}, {servo:g} {si}/s"
            found.append(LimitProblem(i, "servo", what))
        if not rates.acceleration[i] > 0.0:
            what = f"{joint}: expected an acceleration above 0, got {rates.acceleration[i]:g} {si}/s2"
            found.append(LimitProblem(i, "acceleration", what))
    return found
