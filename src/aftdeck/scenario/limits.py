"""Limits in a scenario that replace the arm's limits: joint limits, rate limits, limits of the point of resolution."""

from __future__ import annotations

from dataclasses import replace
from typing import TypeVar

import msgspec

from aftdeck.arms.geometry import frozen
from aftdeck.arms.limits import JointRates, LimitProblem, Limits, limit_problems
from aftdeck.arms.load import ArmModel, PorLimits
from aftdeck.errors import AftdeckError, ScenarioError
from aftdeck.files import Where
from aftdeck.kinematics.arm import Arm
from aftdeck.scenario.by_joint import fits
from aftdeck.scenario.model import RateLimits
from aftdeck.scenario.problems import Problems
from aftdeck.scenario.schema import LimitsOverride, PorOverride, RatesOverride
from aftdeck.scenario.sources import Sources

_T = TypeVar("_T", Limits, JointRates)


def limited_arm(problems: Problems, name: str, over: LimitsOverride, sources: Sources) -> Arm | None:
    """Load the arm, with the scenario's limits replacing the arm's limits; return None if the arm cannot be loaded.

    Args:
        problems: collects the problems found.
        name: name or path of the arm, as written in the scenario's file.
        over: the scenario's limits.
        sources: origin of the arm.
    """
    try:
        model = sources.arm(name)
    except ScenarioError as error:
        for problem in error.problems:
            problems.add(("arm",), problem)
        return None
    except AftdeckError as error:
        problems.add(("arm",), str(error))
        return None
    return Arm(_limited(problems, model, over))


def _limited(problems: Problems, model: ArmModel, over: LimitsOverride) -> ArmModel:
    where = ("limits",)
    limits = _replaced(problems, model, model.limits, over, where)
    rates = _replaced(problems, model, model.rates, over, where)
    for problem in limit_problems(model.joints, model.slides, limits, rates):
        problems.add((*where, *_place(problem)), problem.what)
    return replace(model, limits=limits, rates=rates)


def _place(problem: LimitProblem) -> Where:
    """Return the place of a problem in a table of limits."""
    return (problem.quantity,) if problem.quantity == "acceleration" else ()


def _replaced(problems: Problems, model: ArmModel, own: _T, over: RatesOverride, where: Where) -> _T:
    """Return the arm's own limits, with those in their place that the file gives and that fit the arm's joints."""
    given = {name: value for name in own._fields if (value := getattr(over, name)) is not None}
    fitting = {k: frozen(v) for k, v in given.items() if fits(problems, model, v, (*where, k))}
    return own._replace(**fitting)


def phase_limits(
    problems: Problems, model: ArmModel, mass: float, own: PorOverride, over: RatesOverride, where: Where
) -> RateLimits | None:
    """Return the limits of a phase of the script, or None if the phase gives none.

    Args:
        problems: collects the problems found.
        model: the arm with the scenario's limits.
        mass: mass of the payload that the arm carries in the phase [kg].
        own: the scenario's limits of the point of resolution.
        over: limits of the phase, which replace the scenario's limits.
        where: place of the phase's limits in the file.
    """
    if over == RatesOverride():
        return None
    rates = _replaced(problems, model, model.rates, over, where)
    for problem in limit_problems(model.joints, model.slides, model.limits, rates):
        problems.add((*where, *_place(problem)), problem.what)
    given = {name: value for name in PorOverride.__struct_fields__ if (value := getattr(over.por, name)) is not None}
    if over.por.reached_in is not None:
        own = msgspec.structs.replace(own, acceleration=None, angular_acceleration=None)
    por = msgspec.structs.replace(own, **given)
    check_por(problems, over.por, por_with(model, mass, por), (*where, "por"))
    return RateLimits(rates, por)


def por_with(arm: ArmModel, mass: float, over: PorOverride) -> PorLimits:
    """Return the limits of the point of resolution for a payload's `mass` [kg].

    If `over` contains no value for a speed or angular rate, the arm's limit applies. If it contains no value for an
    acceleration, the acceleration is the coarse speed or angular rate divided by the time `reached_in`. If it contains
    no `reached_in` either, the arm's time from rest to its coarse limit is used.
    """
    arm_limits = arm.por_limits(mass)

    def pick(given: float | None, own: float) -> float:
        return own if given is None else float(given)

    translation = (
        pick(over.translation, arm_limits.translation[0]),
        pick(over.vernier_translation, arm_limits.translation[1]),
    )
    rotation = (pick(over.rotation, arm_limits.rotation[0]), pick(over.vernier_rotation, arm_limits.rotation[1]))
    acceleration = translation[0] / pick(over.reached_in, arm_limits.translation[0] / arm_limits.acceleration)
    angular_acceleration = rotation[0] / pick(over.reached_in, arm_limits.rotation[0] / arm_limits.angular_acceleration)
    return PorLimits(
        translation,
        rotation,
        pick(over.acceleration, acceleration),
        pick(over.angular_acceleration, angular_acceleration),
    )


def check_por(problems: Problems, over: PorOverride, por: PorLimits, where: Where = ("limits", "por")) -> None:
    """Report vernier limits above the coarse limits, and an acceleration given twice."""
    for name in PorOverride.__struct_fields__:
        given = getattr(over, name)
        if given is not None and over.reached_in is not None and "acceleration" in name:
            problems.add((*where, name), "give either reached_in or accelerations, not both")
    for name, (coarse, vernier) in (("vernier_translation", por.translation), ("vernier_rotation", por.rotation)):
        if vernier > coarse:
            problems.add((*where, name), f"has to be at most the coarse limit {coarse:g}, got {vernier:g}")
