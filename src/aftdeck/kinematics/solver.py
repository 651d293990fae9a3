"""The five questions that steering asks about an arm: posture, tip, twist of rates, rates of a twist, nearness.

An arm's array says which solver answers: one of the two closed forms (`linkage`, `jacobian`, `rates`, `singular`), or
the general one (`chain`). All three have the same answers; the closed forms are faster, and their singularities have
names: shoulder, elbow, wrist. Those of any other chain are one: the loss of its rank.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from aftdeck.arms.geometry import GENERAL
from aftdeck.arrays import Array
from aftdeck.kinematics import singular
from aftdeck.kinematics.chain import answers
from aftdeck.kinematics.chain.answers import NEAR, TIP, answer, tip_of_row
from aftdeck.kinematics.jacobian import Rates, Twist, erates, jacobi, of_array
from aftdeck.kinematics.linkage import WRIST, Sines, Tip, sines, tip
from aftdeck.kinematics.rates import rmsrat
from aftdeck.kinematics.singular import distances
from aftdeck.law import law


class Posture(NamedTuple):
    """Posture of an arm.

    Attributes:
        sines: sines and cosines of a closed form's angles; zeros with the general solver.
        found: (ANSWERS,) posture of the general solver (`chain.answers`); (0,) with a closed form.
    """

    sines: Sines
    found: Array


@law
def posture(arm: Array, q: Rates) -> Posture:
    """Return the posture at coordinates `q` of the joints [rad or m]."""
    if arm[WRIST] != GENERAL:
        return Posture(sines(arm, q.r1, q.r2, q.r3, q.r4, q.r5, q.r6), np.empty(0))
    none = Sines(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    return Posture(none, answer(arm, q))


@law
def number_of_singularities(arm: Array) -> int:
    """Return the number of singularities that the solver tells apart."""
    return 3 if arm[WRIST] != GENERAL else 1


@law
def tip_of(arm: Array, p: Posture) -> Tip:
    """Return the tip's position [m] and axes in L."""
    return tip(arm, p.sines) if arm[WRIST] != GENERAL else tip_of_row(p.found[TIP:])


@law
def tip_at(arm: Array, q: Rates) -> Tip:
    """Return the tip's position [m] and axes in L at coordinates `q`, without the rest of the posture."""
    if arm[WRIST] != GENERAL:
        return tip(arm, sines(arm, q.r1, q.r2, q.r3, q.r4, q.r5, q.r6))
    return answers.tip_at(arm, q)


@law
def twist_of(arm: Array, p: Posture, rates: Rates) -> Twist:
    """Return the tip's twist in L at rates of the joints [rad/s or m/s]."""
    if arm[WRIST] != GENERAL:
        return erates(p.sines, jacobi(arm, p.sines), rates)
    return answers.twist_of_rates(arm, p.found, rates)


@law
def rates_of(arm: Array, p: Posture, twist: Twist, floor: float) -> Rates:
    """Return the rates of the joints [rad/s or m/s] for a twist of the tip in L.

    Nearer to a singularity than `floor` [1], the rates grow no more. A chain that cannot make the twist follows the
    part that it can.
    """
    if arm[WRIST] != GENERAL:
        return rmsrat(arm, p.sines, twist, floor)
    return answers.rates_of_twist(arm, p.found, twist, floor)


@law
def distance(arm: Array, p: Posture, which: int) -> float:
    """Return the signed distance from a singularity, in [-1, 1]."""
    return distances(arm, p.sines)[which] if arm[WRIST] != GENERAL else float(p.found[NEAR])


@law
def closing(arm: Array, p: Posture, rates: Rates, which: int) -> tuple[float, float]:
    """Return the signed distance from a singularity, and the rate at which its magnitude falls [1/s]."""
    if arm[WRIST] != GENERAL:
        return singular.closing(arm, p.sines, rates, which)
    return float(p.found[NEAR]), -answers.change_of_distance(arm, p.found, rates)


@law
def nearest_singularity(arm: Array, angles: Array) -> tuple[float, int]:
    """Return the least distance from a singularity at angles (n,) [rad], and the number of that singularity."""
    p, least, which = posture(arm, of_array(angles)), 2.0, 0
    for k in range(number_of_singularities(arm)):
        here = abs(distance(arm, p, k))
        if here < least:
            least, which = here, k
    return least, which
