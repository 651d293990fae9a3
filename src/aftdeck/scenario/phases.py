"""Phases of the script; checks that a phase gives every field that its mode needs, and none that its mode forbids."""

from __future__ import annotations

from collections.abc import Sequence

from aftdeck.arms.by_joint import wrong_unit
from aftdeck.errors import InputError
from aftdeck.files import Where, place
from aftdeck.kinematics.arm import Arm
from aftdeck.scenario.attached import Grasp
from aftdeck.scenario.by_joint import fits
from aftdeck.scenario.limits import phase_limits
from aftdeck.scenario.model import PhasePlan, RateLimits, Sequences
from aftdeck.scenario.modes import Chosen, check_mode, chosen_mode
from aftdeck.scenario.places import TargetReferences, goal
from aftdeck.scenario.poses import check_angle
from aftdeck.scenario.problems import Problems
from aftdeck.scenario.schema import AngularVelocity, Phase, PorOverride, Velocity
from aftdeck.steering.mode import MODES, Mode

_USED: dict[str, set[str]] = {
    "automatic": {"law"},
    "manual": {"translation", "rotation", "velocity", "angular_velocity"},
    "single": {"joint", "drive", "joint_rate", "joint_at"},
    "test": set(),
    "master": {"master"},
}
"""Fields that are allowed only in some modes, by the kind of mode that allows them.

OPR CMD also allows `target`, and ORB LD also allows `payload_axes`.
"""


def script(
    problems: Problems,
    arm: Arm,
    phases: Sequence[Phase],
    grasp: Grasp,
    por: PorOverride,
    sequences: Sequences,
    references: TargetReferences,
) -> list[PhasePlan | None]:
    """Return the checked phases; None for each phase whose mode does not exist.

    Args:
        problems: collects the problems found.
        arm: the arm, with the scenario's limits.
        phases: the decoded phases.
        grasp: collects the payloads of the phases; it already has the payload that is attached at the start, if any.
        por: the scenario's limits of the point of resolution.
        sequences: points of AUTO 1-4.
        references: objects relative to which targets may be given.
    """
    plans: list[PhasePlan | None] = []
    for i, phase in enumerate(phases):
        where: Where = ("phase", i)
        attaches = grasp.attach(problems, phase, where)
        chosen = chosen_mode(problems, phase.mode, (*where, "mode"))
        if chosen is None:
            plans.append(None)
            continue
        check_mode(problems, chosen.position, grasp.loaded, sequences, (*where, "mode"))
        limits = phase_limits(problems, arm.model, grasp.mass, por, phase.limits, (*where, "limits"))
        plans.append(_phase_plan(problems, arm, phase, where, chosen, references, limits, attaches))
    return plans


def _phase_plan(
    problems: Problems,
    arm: Arm,
    phase: Phase,
    where: Where,
    chosen: Chosen,
    references: TargetReferences,
    limits: RateLimits | None,
    attaches: int | None,
) -> PhasePlan:
    """Return one checked phase."""
    target = None if phase.target is None else goal(problems, arm, phase.target, references, (*where, "target"))
    joint = _joint(problems, arm, phase, where)
    _check_phase(problems, arm, phase, chosen, joint, where)
    return PhasePlan(
        name=phase.name or f"{chosen.position}, {place(where)}",
        mode=chosen.position,
        rate=phase.rate,
        translation=phase.translation,
        rotation=phase.rotation,
        velocity=_three(phase.velocity),
        angular_velocity=_three(phase.angular_velocity),
        joint=joint,
        drive=phase.drive,
        joint_rate=None if phase.joint_rate is None else float(phase.joint_rate),
        joint_at=None if phase.joint_at is None else float(phase.joint_at),
        target=target,
        law=chosen.law or phase.law,
        payload_axes=chosen.payload_axes or phase.payload_axes,
        master=None if phase.master is None else tuple(float(angle) for angle in phase.master),
        effector=phase.effector,
        latch=phase.latch,
        brakes=phase.brakes,
        safing=phase.safing,
        stand_at=_stand(problems, arm, phase, where),
        orbiter=phase.orbiter,
        limits=limits,
        attaches=attaches,
        until=phase.until,
        duration=None if phase.duration is None else float(phase.duration),
    )


def _three(given: Velocity | AngularVelocity | None) -> tuple[float, float, float] | None:
    return None if given is None else (float(given[0]), float(given[1]), float(given[2]))


def _joint(problems: Problems, arm: Arm, phase: Phase, where: Where) -> int:
    """Return the index of the selected joint, from 0; also 0 if the phase selects no joint or an unknown one."""
    if phase.joint is None:
        return 0
    if phase.joint not in arm.joints:
        problems.add((*where, "joint"), f"no joint {phase.joint!r}: there are {', '.join(arm.joints)}")
        return 0
    return arm.joints.index(phase.joint)


def _stand(problems: Problems, arm: Arm, phase: Phase, where: Where) -> float | None:
    """Return the length to which the telescope moves [m], or None if the phase gives none."""
    if phase.stand_at is None:
        return None
    try:
        arm.model.at(phase.stand_at)
    except InputError as error:
        problems.add((*where, "stand_at"), str(error))
    return float(phase.stand_at)


def _check_phase(problems: Problems, arm: Arm, phase: Phase, chosen: Chosen, joint: int, where: Where) -> None:
    """Report fields that a phase's mode needs but the phase lacks, and fields that the mode does not use."""
    mode = MODES[chosen.position]
    _check_use(problems, phase, mode, where)
    if phase.law is not None and chosen.law not in (None, phase.law):
        problems.add((*where, "law"), f"mode {phase.mode} selects the steering law; leave law out")
    if phase.duration is not None and phase.duration <= 0.0:
        problems.add((*where, "duration"), f"has to be above 0, got {phase.duration:g} s")
    if mode.position == "OPR CMD" and phase.target is None:
        problems.add(where, "mode OPR CMD needs a target")
    if mode.kind in ("manual", "test") and phase.duration is None:
        problems.add(where, f"mode {mode.position} needs a duration")
    if mode.kind == "master" and phase.master is None:
        problems.add(where, f"mode {mode.position} needs the master arm's angles")
    if phase.master is not None:
        fits(problems, arm.model, phase.master, (*where, "master"))
    if (phase.until is not None or phase.stand_at is not None) and phase.duration is None:
        problems.add(where, "until and stand_at need a duration: the longest time allowed")
    if phase.until == "at rest" and mode.kind != "manual":
        problems.add(
            (*where, "until"), f"'at rest' is for a manual mode, in which the sticks move the arm; got {mode.position}"
        )
    if phase.until == "at rest" and any((*phase.translation, *phase.rotation)):
        problems.add((*where, "until"), "'at rest' cannot occur while translation or rotation commands a motion")
    if phase.brakes and mode.kind == "automatic":
        problems.add((*where, "brakes"), f"the brakes would hold the arm, and {mode.position} moves it")
    if mode.kind == "single":
        _check_single(problems, arm, phase, mode, joint, where)


def _check_use(problems: Problems, phase: Phase, mode: Mode, where: Where) -> None:
    """Report fields that the mode does not use, and inputs given both as a deflection and as a velocity or rate."""
    given = {
        "target": phase.target is not None,
        "law": phase.law is not None,
        "translation": phase.translation != (0.0, 0.0, 0.0),
        "rotation": phase.rotation != (0.0, 0.0, 0.0),
        "velocity": phase.velocity is not None,
        "angular_velocity": phase.angular_velocity is not None,
        "payload_axes": phase.payload_axes is not None,
        "joint": phase.joint is not None,
        "drive": phase.drive != 0.0,
        "joint_rate": phase.joint_rate is not None,
        "joint_at": phase.joint_at is not None,
        "master": phase.master is not None,
    }
    used = _USED[mode.kind] | ({"target"} if mode.position == "OPR CMD" else set())
    used |= {"payload_axes"} if mode.has_payload_axes else set()
    for stick, physical in (("translation", "velocity"), ("rotation", "angular_velocity"), ("drive", "joint_rate")):
        if given[stick] and given[physical]:
            problems.add((*where, physical), f"give either {stick} or {physical}, not both")
    for name, present in given.items():
        if present and name not in used:
            takes = ", ".join(sorted(used)) or "nothing"
            problems.add((*where, name), f"mode {mode.position} takes no {name}; it takes {takes}")


def _check_single(problems: Problems, arm: Arm, phase: Phase, mode: Mode, joint: int, where: Where) -> None:
    """Check a phase in SINGLE or DIRECT.

    The phase has to give a joint. It also has to give either `joint_at`, the final angle of the joint, or a duration
    with `drive` or `joint_rate`.
    """
    if phase.joint is None:
        problems.add(where, f"mode {mode.position} needs a joint")
    if phase.joint_at is None and phase.duration is None:
        problems.add(where, f"mode {mode.position} needs either joint_at, or a duration with drive or joint_rate")
    if phase.joint in arm.joints and (why := wrong_unit(phase.joint, arm.model.slides[joint], phase.joint_rate)):
        problems.add((*where, "joint_rate"), why)
    if phase.joint_at is None:
        return
    for name, given in (("drive", phase.drive != 0.0), ("joint_rate", phase.joint_rate is not None)):
        if given:
            problems.add(where, f"give either joint_at or {name}, not both")
    if phase.joint in arm.joints:
        check_angle(problems, arm, joint, phase.joint_at, (*where, "joint_at"))
