"""The pair of parts that the present step of the task brings together, or takes apart.

CLEARANCE excepts such a pair while the approach goes well (`simulation.payloads.alignment`), because every capture and
berthing would raise an alarm. Its clearance is a number of its own, without an alarm.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from aftdeck.scenario.model import Scenario
from aftdeck.scenario.on_arm import arm_solids
from aftdeck.scenario.target import AtBerth, AtPayload
from aftdeck.scenario.task_step import TaskStep
from aftdeck.simulation.frame import Frame
from aftdeck.task.remaining import Aims
from aftdeck.worksite.report import Near


class TaskPairs:
    """Finder of the task's pair, for the frames of one scenario."""

    def __init__(self, scenario: Scenario) -> None:
        self._aims = Aims(scenario)
        self._arm = frozenset(solid.part for solid in arm_solids(scenario.arm.model, scenario.worksite))
        self._payloads = tuple(frozenset(solid.part for solid in payload.solids) for payload in scenario.payloads)
        self._worksite = scenario.worksite

    def nearest(self, watched: Callable[[], Sequence[Near]], frame: Frame, step: TaskStep | None) -> Near | None:
        """Return the task's pair with the smallest clearance; None if the task moves nothing to a payload or a berth.

        On the way to a payload, these are a part of the arm and a part of the payload. On the way to a berth, they are
        a part of the held payload and a part that is fixed to the berth's coordinate frame.

        Args:
            watched: returns all monitored pairs, the smallest clearance first (`Simulation.watched`); this takes up to
                4 ms, so it is only called if the task moves something.
            frame: frame of the same step.
            step: present step of the task; None if there is none.
        """
        moved, others = self._parts(frame, step)
        if not (moved and others):
            return None
        ways = ((near, (near.a, near.b), (near.b, near.a)) for near in watched())
        return next((near for near, *both in ways if any(a in moved and b in others for a, b in both)), None)

    def _parts(self, frame: Frame, step: TaskStep | None) -> tuple[frozenset[str], frozenset[str]]:
        """Return the parts that move, and the parts to which they move; empty if there are none."""
        held = self._aims.places.held(frame)
        match self._aims.target(frame, step):
            case AtPayload(payload=k) if held is None:
                return self._arm, self._payloads[k]
            case AtBerth(berth=name) if held is not None:
                carrier = self._aims.places.berths[name].frame
                fixed = (solid.part for solid in self._worksite.solids if solid.frame == carrier)
                return self._payloads[held], frozenset(fixed)
            case _:
                return frozenset(), frozenset()
