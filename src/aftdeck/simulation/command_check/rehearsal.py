"""Rehearsal of an automatic motion for CMD CK: the control steps of the motion, computed on a copy of the state.

The copy includes the worksite. The rehearsal therefore has the contacts and sliding payloads of the real motion.
"""

from __future__ import annotations

import numpy as np

from aftdeck.frames import Pose
from aftdeck.kinematics.solver import nearest_singularity
from aftdeck.scenario.target import Target
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.fly import fly, go
from aftdeck.simulation.frame import Cause
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.log import joint_label
from aftdeck.simulation.motion.standstill import fixed_in, latched_payload_reason
from aftdeck.simulation.operator.sequence import begin
from aftdeck.simulation.parts.checking import Tried, Way
from aftdeck.simulation.state import State
from aftdeck.steering.layout import CAUSE, LIMITING_JOINT, MOTION_ACTIVE, RATIO, REMAINING
from aftdeck.steering.limiters import BY_SINGULARITY, CAUSES
from aftdeck.units import INCH, Time
from aftdeck.worksite.watch.found import POINT_A

LONG = 3600.0
"""Time that every motion to a point may take [s]; a motion that is estimated to take longer may take twice as long."""
SLOWEST = 0.01
"""Share of the steering's speed that an estimate assumes at least [1]: near a standstill, the share says nothing."""
DAY = Time.bounds.greatest
"""Longest run [s]: no motion may take longer."""
_NO_INPUTS = Inputs()


class Rehearsal:
    """Rehearsal of one automatic motion; each call of `advance` continues it.

    Attributes:
        steps: number of steps rehearsed so far.
    """

    def __init__(self, flight: Flight, start: State, target: Target, way: Way) -> None:
        self._flight, self._way = flight, way
        self._copy = start.fork()
        panel = self._copy.panel
        if panel.mode not in flight.scenario.sequences:
            panel.mode = "OPR CMD"
        panel.law, panel.rate_hold_sticks, panel.position_hold_target = way.law, None, None
        panel.proceeding, panel.ending = False, ""
        begin(self._copy, target, way.joints)
        self._copy.worksite.watch.counts[:] = 0  # a rehearsal does not use the minimum clearance
        self._touching = frozenset(self._copy.worksite.logged_contacts)
        self._nearest, self._which, self._point = 1.0, 0, panel.point
        self._last_limit: tuple[int, int, str] = (0, -1, "")
        self._going, self._since, self._latest = panel.point, 0.0, LONG
        self.steps = 0

    def advance(self, most: int) -> Tried | None:
        """Rehearse up to `most` further steps; return the result, or None if the motion has not ended yet."""
        flight, copy, period = self._flight, self._copy, self._flight.scenario.control_period
        for _ in range(most):
            self._last_limit = int(copy.report[CAUSE]), int(copy.report[LIMITING_JOINT]), copy.worksite.halt
            copy.tick += 1
            copy.events.clear()
            log = copy.log(period)
            if self.steps == 0:  # `begin` has already set the panel for this step
                copy.measure()
                go(flight, copy, log, _NO_INPUTS)
            else:
                fly(flight, copy, log, _NO_INPUTS)
            if copy.panel.ending:
                return self._ended(self.steps * period)
            self.steps += 1
            near, which = nearest_singularity(copy.arm.model.links, copy.plant.angles)
            if near < self._nearest:
                self._nearest, self._which = near, which
            if copy.worksite.arm_fixed:  # a port or latches have fixed the payload, which also ends the motion
                return self._tried(True, "", self.steps * period, f"then {fixed_in(flight.site, copy.worksite)}", "")
            if copy.worksite.contacts.inhibit.changed and (text := self._contact(self._touching)):
                return self._tried(False, "contact", self.steps * period, text, "")
            if self.steps * period >= (latest := self._latest_end(self.steps * period)):
                text = f"target not reached within {latest:.0f} s"
                return self._tried(False, "time", self.steps * period, text, "")
        return None

    def _latest_end(self, now: float) -> float:
        """Return the time by which the motion to the present point has to end [s].

        It is an hour after the start of this motion, or twice the greatest estimate of the first half hour. An estimate
        is the steering's remaining time, longer by the share of its speed that the limits allow now.
        """
        copy = self._copy
        if copy.panel.point != self._going:
            self._going, self._since, self._latest = copy.panel.point, now, now + LONG
        if copy.command[MOTION_ACTIVE] != 0.0 and now - self._since <= 0.5 * LONG:
            left = float(copy.report[REMAINING]) / max(float(copy.report[RATIO]), SLOWEST)
            self._latest = max(self._latest, self._since + 2.0 * (now - self._since + left))
        return min(self._latest, DAY)

    def _contact(self, besides: frozenset[int] = frozenset()) -> str:
        """Return a text about a contact that inhibits the arm and is not in `besides`; "" if there is none."""
        copy, scenario = self._copy, self._flight.scenario
        worksite = copy.worksite
        for contact in worksite.contacts.standing(
            self._flight.site.layout, worksite.watch.found, scenario.arm.model.units
        ):
            if contact.inhibits and contact.group not in besides:
                point = worksite.watch.found[contact.group, POINT_A : POINT_A + 3]
                x, y, z = scenario.arm.model.mount.to("panel", Pose(point, np.eye(3))).position / INCH
                return f"{contact.a} touches {contact.b} at X {x:.0f}, Y {y:.0f}, Z {z:.0f} in"
        return ""

    def _ended(self, seconds: float) -> Tried:
        """Return the result of a motion that has ended because it reached or missed its target or was abandoned."""
        flight, copy = self._flight, self._copy
        near = ""
        if self._nearest < copy.arm.model.singular:
            near = f"passing the {copy.arm.model.singularities[self._which]} singularity at {self._nearest:.2f}"
        if copy.panel.ending == "given up":
            cause, text = self._standstill()
            return self._tried(False, cause, seconds, text, near)
        good = copy.panel.ending == "reached" or flight.scenario.strict
        text = f"final error {copy.panel.final_error}" if copy.panel.final_error else ""
        return self._tried(good, "" if good else "miss", seconds, text, near)

    def _tried(self, good: bool, cause: Cause, seconds: float, text: str, near: str) -> Tried:
        panel, point = self._copy.panel, self._point
        if not good and panel.point > point:
            text = f"after point {panel.point} of {len(self._flight.scenario.sequences[panel.mode])}: {text}"
        return Tried(self._way, good, cause, seconds, text, near)

    def _standstill(self) -> tuple[Cause, str]:
        """Return the cause of the arm's standstill, and its text."""
        flight, (cause, culprit, halt) = self._flight, self._last_limit
        if halt == "seat":
            return "seat", latched_payload_reason(flight.site, self._copy.worksite)
        if halt == "contact":
            return "contact", self._contact() or "a contact stops the arm"
        if cause == BY_SINGULARITY:
            return "limit", f"the {flight.scenario.arm.model.singularities[culprit]} singularity blocks the way"
        return "limit", f"{joint_label(flight.scenario.arm.joints[culprit])} reaches its {CAUSES[cause]}"
