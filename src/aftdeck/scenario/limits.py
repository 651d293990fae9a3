"""The arm with the scenario's limits in place of its own: joints, rates and the point of resolution."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from aftdeck.arms.geometry import frozen
from aftdeck.arms.limits import Array, JointRates, Limits, limit_problems
from aftdeck.arms.load import ArmModel, PorLimits
from aftdeck.errors import AftdeckError, ScenarioError
from aftdeck.kinematics.arm import Arm, load_arm
from aftdeck.scenario.problems import Problems
from aftdeck.scenario.schema import LimitsOverride, PorOverride


def limited_arm(problems: Problems, name_or_path: str, over: LimitsOverride, folder: Path) -> Arm | None:
    """The arm of a built-in name or of a file, sought from `folder`, with the scenario's limits; None: no such arm."""
    if name_or_path.endswith(".toml") and not Path(name_or_path).is_absolute():
        name_or_path = str(folder / name_or_path)
    try:
        arm = load_arm(name_or_path)
    except ScenarioError as error:
        for problem in error.problems:
            problems.wrong(("arm",), problem)
        return None
    except AftdeckError as error:
        problems.wrong(("arm",), str(error))
        return None
    return Arm(_limited(problems, arm.model, over))


def _limited(problems: Problems, model: ArmModel, over: LimitsOverride) -> ArmModel:
    def pick(name: str, own: Array) -> Array:
        given = getattr(over, name)
        return own if given is None else frozen(given)

    limits = Limits(**{name: pick(name, own) for name, own in model.limits._asdict().items()})
    rates = JointRates(**{name: pick(name, own) for name, own in model.rates._asdict().items()})
    for problem in limit_problems(model.joints, limits, rates):
        problems.wrong(("limits",), problem)
    return replace(model, limits=limits, rates=rates)


def por_with(arm: ArmModel, mass: float, over: PorOverride) -> PorLimits:
    """The arm's limits of the point of resolution with a payload [kg], the scenario's in their place."""
    own = arm.por_limits(mass)

    def pick(given: float | None, own: float) -> float:
        return own if given is None else float(given)

    return PorLimits(
        (pick(over.translation, own.translation[0]), pick(over.vernier_translation, own.translation[1])),
        (pick(over.rotation, own.rotation[0]), pick(over.vernier_rotation, own.rotation[1])),
        pick(over.reached_in, own.reached_in),
    )


def check_por(problems: Problems, por: PorLimits) -> None:
    """Note limits that are none."""
    for name, value in zip(
        PorOverride.__struct_fields__, (*por.translation, *por.rotation, por.reached_in), strict=True
    ):
        if value <= 0.0:
            problems.wrong(("limits", "por", name), f"is above 0, got {value:g}")
    for name, (coarse, vernier) in (("vernier_translation", por.translation), ("vernier_rotation", por.rotation)):
        if vernier > coarse > 0.0:
            problems.wrong(("limits", "por", name), f"is at most the coarse limit {coarse:g}, got {vernier:g}")
