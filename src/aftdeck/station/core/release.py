"""RELEASE: confirmation of a release after which the payload would float, where the operator's task wants none.

Every key, button and device sends RELEASE as one command, so the session asks for all of them. Scripts and programs
command the simulation itself, which does not ask.
"""

from __future__ import annotations

import math

from aftdeck.scenario.task_step import TaskStep
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.payloads.latch_command import CONFIRM
from aftdeck.station.messages import from_page
from aftdeck.worksite.conditions import all_ready


class ReleaseQuestion:
    """The last RELEASE of a run that was not confirmed."""

    def __init__(self) -> None:
        self._asked_s = -math.inf

    def question(self, command: from_page.FromPage | None, frame: Frame | None, step: TaskStep | None) -> str:
        """Return the request to confirm a command; empty if the command may be executed.

        The first RELEASE of a payload that nothing but the end effector holds only asks; a second RELEASE within
        `CONFIRM` is executed. Exceptions: the present step of the task is this release, it has started already, or a
        berth fixes the payload as soon as it is released.

        Args:
            command: command for the next step; None if there is none.
            frame: newest frame; None before the first step.
            step: present step of the task; None if there is none.
        """
        if not isinstance(command, from_page.SetEffector) or command.switch != "open" or frame is None:
            return ""
        held = next((payload for payload in frame.work.cargo if payload.held and payload.seat == ""), None)
        if held is None or frame.work.hand.switch == "open" or _is_inserted(frame) or (step and _is_release(step)):
            return ""
        asked_s, self._asked_s = self._asked_s, frame.time_s
        if frame.time_s - asked_s <= CONFIRM:
            self._asked_s = -math.inf
            return ""
        return f"RELEASE again within {CONFIRM:g} s to confirm: nothing but the end effector holds {held.name}"


def _is_inserted(frame: Frame) -> bool:
    """Return whether the payload is where a berth fixes it upon its release, as in the concept's bay."""
    objective = frame.work.objective
    return objective is not None and objective.action == "insert" and all_ready(frame.work.conditions)


def _is_release(step: TaskStep) -> bool:
    """Return whether a step ends with a payload that floats, or with an open end effector."""
    done = step.done
    floats = done.held is False and done.fixed is not True and done.berth is None
    return floats or done.switch == "open" or done.flag == "OPEN"
