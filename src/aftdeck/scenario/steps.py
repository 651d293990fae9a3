"""Checks of the steps of the operator's task, and their conversion."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import cast, get_args

import msgspec

from aftdeck.files import Where
from aftdeck.kinematics.arm import Arm
from aftdeck.scenario.all_cameras import present_cameras
from aftdeck.scenario.modes import chosen_mode
from aftdeck.scenario.places import TargetReferences, goal
from aftdeck.scenario.poses import check_angle
from aftdeck.scenario.problems import Problems
from aftdeck.scenario.schema import StepSpec
from aftdeck.scenario.task_file import StateSpec, Use
from aftdeck.scenario.task_step import Hint, TaskStep, UseInStep
from aftdeck.schema_check import convert, split
from aftdeck.steering.mode import MODES
from aftdeck.units import Length

USES: tuple[str, ...] = get_args(Use)
"""All functions that a step can name."""
WANTING = "wanting"
"""Mark that stands for the first condition that fails."""
_EITHER = re.compile(r"[^{}|*]+\|[^{}|*]+")
"""Mark with words for a keyboard, and words for a device with sticks: ``{keys|sticks}``."""
_MARK = re.compile(r"\{([^{}]*)\}")


def task_steps(problems: Problems, arm: Arm, specs: Sequence[StepSpec], references: TargetReferences) -> list[TaskStep]:
    """Return the steps of the task, with their lengths in SI units in the texts.

    Args:
        problems: collects the problems found.
        arm: the arm, with the scenario's limits.
        specs: the decoded steps.
        references: objects relative to which targets may be given.
    """
    return [_step(problems, arm, spec, references, ("step", i)) for i, spec in enumerate(specs)]


def _step(problems: Problems, arm: Arm, spec: StepSpec, references: TargetReferences, where: Where) -> TaskStep:
    uses = _uses(problems, spec.uses, (*where, "uses"))
    hints = []
    for i, hint in enumerate(spec.hint):
        at = (*where, "hint", i)
        _check_state(problems, arm, spec, hint.when, references, (*at, "when"))
        own = uses if hint.uses is None else _uses(problems, hint.uses, (*at, "uses"))
        hints.append(Hint(hint.when, _marked(problems, hint.text, (*at, "text")), own))
    _check_state(problems, arm, spec, spec.done, references, (*where, "done"))
    joint = _joint(problems, arm, spec, where)
    mode = None if spec.mode is None else chosen_mode(problems, spec.mode, (*where, "mode"))
    return TaskStep(
        title=spec.title,
        text=_marked(problems, spec.text, (*where, "text")),
        done=spec.done,
        target=None if spec.target is None else goal(problems, arm, spec.target, references, (*where, "target")),
        joint=joint,
        joint_at=float(spec.joint_at or 0.0),
        mode=None if mode is None else mode.position,
        way=spec.way,
        uses=uses,
        groups=spec.groups,
        cameras=_cameras(problems, arm, spec, references, (*where, "cameras")),
        part=spec.part,
        hints=tuple(hints),
    )


def _check_state(
    problems: Problems, arm: Arm, spec: StepSpec, state: StateSpec, references: TargetReferences, where: Where
) -> None:
    """Check that a state gives a field, and that the things it names exist."""
    if state == StateSpec():
        problems.add(where, f"give at least one of {', '.join(StateSpec.__struct_fields__)}")
    if state.mode is not None and state.mode not in MODES:
        problems.add((*where, "mode"), f"no mode {state.mode!r}: modes are {', '.join(MODES)}")
    if state.above is not None and (spec.target is None or (spec.target.cargo, spec.target.seat) == (None, None)):
        problems.add((*where, "above"), "needs a target with `cargo` or `seat` in this step")
    if spec.joint is not None:
        slides = spec.joint in arm.joints and arm.model.slides[arm.joints.index(spec.joint)]
        own, others = ("within", "within_angle") if slides else ("within_angle", "within")
        if (getattr(state, others), state.above) != (None, None):
            problems.add(where, f"a step with a joint that {'slides' if slides else 'turns'} has only {own}")
    if references.worksite is None or state.berth is None:
        return
    berths = [berth.name for berth in references.worksite.berths]
    if state.berth not in berths:
        problems.add((*where, "berth"), f"no berth {state.berth!r}: berths are {', '.join(berths) or 'none'}")


def _joint(problems: Problems, arm: Arm, spec: StepSpec, where: Where) -> int | None:
    """Return the index of the step's joint; None if it has none or names one that does not exist."""
    if (spec.joint is None) != (spec.joint_at is None):
        problems.add(where, "give both joint and joint_at, or neither")
    if spec.joint is None or spec.joint_at is None:
        return None
    if spec.target is not None:
        problems.add((*where, "joint"), "give either a target or a joint, not both")
    if spec.joint not in arm.joints:
        problems.add((*where, "joint"), f"no joint {spec.joint!r}: joints are {', '.join(arm.joints)}")
        return None
    joint = arm.joints.index(spec.joint)
    check_angle(problems, arm, joint, spec.joint_at, (*where, "joint_at"))
    return joint


def _uses(problems: Problems, texts: Sequence[str], where: Where) -> tuple[UseInStep, ...]:
    """Return the functions of texts such as ``"-X: back"``."""
    uses = []
    for i, text in enumerate(texts):
        use, colon, does = text.partition(":")
        if not colon or not does.strip():
            problems.add((*where, i), f"expected a function and its effect, such as '-X: back', got {text!r}")
        elif _is_use(problems, use, (*where, i)):
            uses.append(UseInStep(cast("Use", use), does.strip()))
    return tuple(uses)


def _is_use(problems: Problems, use: str, where: Where) -> bool:
    if use in USES:
        return True
    problems.add(where, f"no function {use!r}: functions are {', '.join(USES)}")
    return False


def _marked(problems: Problems, text: str, where: Where) -> str:
    """Return a text whose marks are checked; lengths in it become metres."""

    def mark(match: re.Match[str]) -> str:
        inside = match[1]
        if inside == WANTING or inside in USES or _EITHER.fullmatch(inside):
            return match[0]
        if not inside[:1].isdigit():
            functions = ", ".join(USES)
            what = (
                f"no mark {match[0]!r}: allowed are a length such as {{2 in}}, {{{WANTING}}}, words for a keyboard and "
                f"for sticks such as {{keys|sticks}}, or one of {functions}"
            )
            problems.add(where, what)
            return match[0]
        try:
            return f"{{{convert(inside, Length):.9g} m}}"
        except msgspec.ValidationError as error:
            problems.add(where, f"the mark {match[0]!r}: {split(str(error))[0]}")
            return match[0]

    if text.count("*") % 2:
        problems.add(where, "has an odd number of *: a text on the desk stands between two *")
    return _MARK.sub(mark, text)


def _cameras(
    problems: Problems, arm: Arm, spec: StepSpec, references: TargetReferences, where: Where
) -> tuple[str, ...]:
    if spec.cameras is None or references.worksite is None:
        return ()
    names = [camera.name for camera in present_cameras(arm.model, references.worksite, references.payloads)]
    for i, name in enumerate(spec.cameras):
        if name not in names:
            problems.add((*where, i), f"no camera {name!r}: cameras are {', '.join(names)}")
    return spec.cameras
