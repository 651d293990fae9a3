"""Ways to a target; CMD CK chooses one of them.

A way is one possible motion: either a straight line (modes 2 and 3), or a joint motion (mode 1) to one of the sets of
joint angles that put the tip at the target (RMANGS's branches).
"""

from __future__ import annotations

import numpy as np

from aftdeck.arms.by_joint import shown
from aftdeck.arrays import Array
from aftdeck.errors import UnreachableError
from aftdeck.kinematics.arm import Arm
from aftdeck.matrices import distance
from aftdeck.scenario.model import Scenario
from aftdeck.scenario.target import Target
from aftdeck.simulation.inputs import AGREED
from aftdeck.simulation.log import joint_label
from aftdeck.simulation.parts.checking import Way
from aftdeck.simulation.state import State
from aftdeck.steering.layout import RATE
from aftdeck.steering.mode import AUTOMATIC_LAWS, LawChoice

ROUNDING = 1e-9
"""Greatest angle past a soft stop that counts as a rounding error of a solution [rad]."""


def ways(scenario: Scenario, state: State, target: Target, law: LawChoice) -> tuple[Way, ...]:
    """Return the ways to a target with a steering law, sorted by the lower bound of their duration.

    Raises:
        UnreachableError, SingularityError: no joint angles put the tip at the target, or (with the position law) all
            such angles are outside the soft stops.
    """
    if law != "position":
        final_angles(state, target)
        return (Way(law, None, 0.0, ""),)
    arm, now = state.arm, state.plant.angles
    given = _given(arm, target)
    found = [given] if given is not None else _branches(scenario, arm, now, target)
    rules = state.carried.rules["OPR CMD", state.panel.rate, AUTOMATIC_LAWS["position"]]
    result = []
    for angles in found:
        least = float((np.abs(angles - now) / rules[RATE : RATE + len(now)]).max())
        result.append(Way("position", tuple(angles.tolist()), least, _name(arm, now, angles)))
    return tuple(sorted(result, key=lambda way: way.least))


def final_angles(state: State, target: Target) -> Array:
    """Return the joint angles at the target.

    The result is the target's own joint angles if they put the tip at the target. If they do not, because they belong
    to another length of the telescope, the result is the solution nearest to them. If the target has no joint angles,
    the result is the solution nearest to the present angles.

    Raises:
        UnreachableError, SingularityError: no joint angles put the tip at the target.
    """
    given = _given(state.arm, target)
    if given is not None:
        return given
    near = state.plant.angles if target.joints is None else np.array(target.joints)
    nearest: Array = state.arm.inverse(target.pose, near=near)[0]
    return nearest


def _given(arm: Arm, target: Target) -> Array | None:
    """Return the target's own joint angles if they exist and put the tip at the target; else None."""
    if target.joints is None:
        return None
    angles = np.array(target.joints)
    return angles if distance(arm.forward(angles).position.tolist(), target.position) <= AGREED else None


def _branches(scenario: Scenario, arm: Arm, now: Array, target: Target) -> list[Array]:
    """Return all solutions for the joint angles that are inside the soft stops.

    Under `strict`, return only RMANGS's own solution, without a test of the soft stops. If no solution is inside the
    soft stops, return all solutions under `as_flown`; without `as_flown`, raise UnreachableError.
    `now` (n,) are the present angles [rad].
    """
    near = now if target.joints is None else np.array(target.joints)
    if scenario.strict:
        return [arm.rmangs(target.pose)]
    solutions = arm.inverse(target.pose, near=near)
    low, high = scenario.arm.limits.soft.T
    beyond = np.maximum(low - solutions, solutions - high)
    inside = [angles for angles, most in zip(solutions, beyond.max(axis=1), strict=True) if most <= ROUNDING]
    if not inside and not scenario.as_flown:
        row = int(beyond.max(axis=1).argmin())
        joint = int(beyond[row].argmax())
        slides = arm.model.slides[joint]
        raise UnreachableError(
            f"every solution lies outside the soft stops; the nearest needs {joint_label(arm.joints[joint])} at "
            f"{shown(solutions[row, joint], slides, '.2f')}, {shown(beyond[row, joint], slides, '.2f')} outside",
            float(beyond[row, joint]),
            arm.joints[joint],
        )
    return inside or list(solutions)


def _name(arm: Arm, now: Array, angles: Array) -> str:
    """Return a text that names the parts of the arm that are flipped at `angles` (n,) relative to `now` (n,)."""
    before, after = (arm.singularities(q) for q in (now, angles))
    turned = [
        name for name, a, b in zip(arm.model.singularities, before, after, strict=True) if float(a) * float(b) < 0.0
    ]
    return f"{' and '.join(turned)} flipped" if turned else "present configuration"
