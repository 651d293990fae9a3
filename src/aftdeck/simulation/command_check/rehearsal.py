"""Rehearsal of an automatic motion for CMD CK: the control steps of the motion, computed on a copy of the state.

The copy includes the worksite. The rehearsal therefore has the contacts and sliding payloads of the real motion.
"""

from __future__ import annotations

import numpy as np

from aftdeck.frames import Pose
from aftdeck.kinematics.solver import nearest_singularity
from aftdeck.scenario.target import Target
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.fly import complete, fly, go
from aftdeck.simulation.frame import Cause
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.log import joint_label
from aftdeck.simulation.motion.standstill import fixed_in, latched_payload_reason
from aftdeck.simulation.operator.sequence import begin, fly_by
from aftdeck.simulation.parts.checking import Tried, Way
from aftdeck.simulation.period.period import ATTACHED
from aftdeck.simulation.period.quick import give, take
from aftdeck.simulation.period.rehearse import (
    LATEST,
    NEAREST,
    PASSES,
    PASSES_TURN,
    REACHED,
    SINCE,
    STEPS,
    VALUES,
    WHICH,
    estimate,
    rehearsed,
)
from aftdeck.simulation.state import State
from aftdeck.steering.layout import CAUSE, LIMITING_JOINT, MOTION_ACTIVE
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
_COMMANDED = 2
"""Number of steps after which the panel's command stays as it is until the motion ends."""


class Rehearsal:
    """Rehearsal of one automatic motion; each call of `advance` continues it."""

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
        self._going = self._point = panel.point
        self._last_limit: tuple[int, int, str] = (0, -1, "")
        self._values = np.zeros(VALUES)
        self._values[NEAREST], self._values[LATEST] = 1.0, LONG

    @property
    def steps(self) -> int:
        """Number of steps rehearsed so far."""
        return int(self._values[STEPS])

    def advance(self, most: int) -> Tried | None:
        """Rehearse up to `most` further steps; return the result, or None if the motion has not ended yet."""
        end = self.steps + most
        while self.steps < end:
            before = self.steps
            if before >= _COMMANDED:
                self._make_steps(end - before)
            if self.steps == before:
                self._make_step()
            if (result := self._result()) is not None:
                return result
        return None

    def _make_steps(self, most: int) -> None:
        """Rehearse up to `most` steps in compiled code, until one needs more than that or may end the motion."""
        flight, copy, values, before = self._flight, self._copy, self._values, self.steps
        values[PASSES], values[PASSES_TURN] = fly_by(flight.scenario, copy.panel)
        give(flight, copy, _NO_INPUTS)
        rehearsed(
            copy.row.arrays(flight.packed),
            *copy.both_rules(),
            copy.arm.model.links,
            values,
            most,
            0.5 * LONG,
            SLOWEST,
            DAY,
        )
        if self.steps == before:
            return
        copy.tick += 1
        copy.events.clear()
        copy.panel.blocked, reached = 0, int(values[REACHED])
        take(flight, copy, reached)
        complete(flight, copy, copy.log(flight.scenario.control_period), _NO_INPUTS, reached, observes=False)
        if reached < ATTACHED:
            self._note_singularity()

    def _make_step(self) -> None:
        """Rehearse one step."""
        flight, copy = self._flight, self._copy
        self._last_limit = int(copy.report[CAUSE]), int(copy.report[LIMITING_JOINT]), copy.worksite.halt
        copy.tick += 1
        copy.events.clear()
        log = copy.log(flight.scenario.control_period)
        if self.steps == 0:  # `begin` has already set the panel for this step
            go(flight, copy, log, _NO_INPUTS, observes=False)
        else:
            fly(flight, copy, log, _NO_INPUTS)
        if not copy.panel.ending:
            self._values[STEPS] += 1.0
            self._note_singularity()

    def _note_singularity(self) -> None:
        """Note the singularity that is nearest so far."""
        near, which = nearest_singularity(self._copy.arm.model.links, self._copy.plant.angles)
        if near < self._values[NEAREST]:
            self._values[NEAREST], self._values[WHICH] = near, which

    def _result(self) -> Tried | None:
        """Return the result after a step; None if the motion has not ended yet."""
        copy, seconds = self._copy, self.steps * self._flight.scenario.control_period
        if copy.panel.ending:
            return self._ended(seconds)
        if copy.worksite.arm_fixed:  # a port or latches have fixed the payload, which also ends the motion
            return self._tried(True, "", seconds, f"then {fixed_in(self._flight.site, copy.worksite)}", "")
        if copy.worksite.contacts.inhibit.changed and (text := self._contact(self._touching)):
            return self._tried(False, "contact", seconds, text, "")
        if seconds >= (latest := self._latest_end(seconds)):
            return self._tried(False, "time", seconds, f"target not reached within {latest:.0f} s", "")
        return None

    def _latest_end(self, now: float) -> float:
        """Return the time by which the motion to the present point has to end [s].

        It is an hour after the start of this motion, or twice the greatest estimate of the first half hour. An estimate
        is the steering's remaining time, longer by the share of its speed that the limits allow now.
        """
        copy, values = self._copy, self._values
        if copy.panel.point != self._going:
            self._going, values[SINCE], values[LATEST] = copy.panel.point, now, now + LONG
        if copy.command[MOTION_ACTIVE] != 0.0:
            estimate(copy.report, values, now, 0.5 * LONG, SLOWEST)
        return min(float(values[LATEST]), DAY)

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
        nearest, which = float(self._values[NEAREST]), int(self._values[WHICH])
        if nearest < copy.arm.model.singular:
            near = f"passing the {copy.arm.model.singularities[which]} singularity at {nearest:.2f}"
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
