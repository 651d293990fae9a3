"""A step of the operator's task, checked and frozen."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

from aftdeck.scenario.schema import Part
from aftdeck.scenario.target import RelativeTarget, Target
from aftdeck.scenario.task_file import DeskGroup, StateSpec, StickAxis, Use


class UseInStep(NamedTuple):
    """A function of the controls that a step needs.

    Attributes:
        use: the function.
        does: its effect in this step, in one or two words.
    """

    use: Use
    does: str


class Hint(NamedTuple):
    """Text that replaces a step's text in a certain state.

    Attributes:
        when: the state.
        text: the text, with marks as in `StepSpec`.
        uses: functions that matter in this state.
    """

    when: StateSpec
    text: str
    uses: tuple[UseInStep, ...]


@dataclass(frozen=True, eq=False)
class TaskStep:
    """One step of the operator's task.

    Attributes:
        title: name of the step.
        text: instruction, with marks as in `StepSpec`.
        done: state that completes the step.
        target: pose to which the tip, or the held payload, has to move; None if the step has no such pose.
        joint: index of the joint that has to move, from 0; None if the step is not about one joint.
        joint_at: angle to which this joint has to move [rad].
        mode: position of the MODE rotary that the step needs; None if any will do.
        way: axes of the THC in the order in which the place is approached; empty if all are used at once.
        uses: functions that matter.
        groups: groups of the desk that the step needs.
        cameras: the two cameras that show the step best; empty if the scenario leaves the choice to the station.
        part: part of the problem that begins with this step; None if none does.
        hints: texts for certain states, the first that holds is shown.
    """

    title: str
    text: str
    done: StateSpec
    target: Target | RelativeTarget | None
    joint: int | None
    joint_at: float
    mode: str | None
    way: tuple[StickAxis, ...]
    uses: tuple[UseInStep, ...]
    groups: tuple[DeskGroup, ...]
    cameras: tuple[str, ...]
    part: Part | None
    hints: tuple[Hint, ...]

    @property
    def is_milestone(self) -> bool:
        """Whether the step ends with a captured payload, or with a payload that is fixed to a berth."""
        return self.done.held is True or self.done.fixed is True or self.done.berth is not None
