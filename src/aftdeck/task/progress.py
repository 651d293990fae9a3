"""Progress through the steps of the operator's task; each frame of the run updates it."""

from __future__ import annotations

from aftdeck.scenario.model import Scenario
from aftdeck.scenario.task_file import StateSpec
from aftdeck.scenario.task_step import TaskStep
from aftdeck.simulation.frame import Frame
from aftdeck.task.reached import Since, reached
from aftdeck.task.remaining import Aims, Remaining


class Progress:
    """Progress of one run through the steps of its scenario.

    Attributes:
        steps: all steps.
        first: index of the step at which the run began: 0, or the first step of the part that was re-initialised.
        at: index of the present step; the number of steps when all are complete.
        done_s: for each step, the simulated time at which it was completed [s]; None if it is open or was skipped.
        places: poses of the scenario's payloads and berths, and of the tip.
        slides: for each joint, whether it slides.
    """

    def __init__(self, scenario: Scenario) -> None:
        self.steps: tuple[TaskStep, ...] = scenario.steps
        self.first, self.at = 0, 0
        self.done_s: list[float | None] = [None] * len(self.steps)
        self._period_s = scenario.control_period
        self._aims = Aims(scenario)
        self.places, self.slides = self._aims.places, self._aims.slides
        self._begin: Since | None = None
        self._frame: Frame | None = None
        self._before: Frame | None = None  # the frame before, if it was seen in the same step of the task
        self._known: tuple[tuple[Frame, int, Remaining | None], ...] = ()
        self._held = False  # the end effector held a payload in the last frame
        self._looked = False
        self._again = False  # the present step was entered by `back`, and its state has held since then
        self._open = False  # the next milestone has been seen not to hold since the present step began

    @property
    def present(self) -> TaskStep | None:
        """The present step; None if all are past or the scenario has none."""
        return self.steps[self.at] if self.at < len(self.steps) else None

    @property
    def skipped(self) -> tuple[int, ...]:
        """Indices of the steps of the run that were skipped and not completed."""
        return tuple(i for i in range(self.first, self.at) if self.done_s[i] is None)

    def see(self, frame: Frame) -> tuple[int, ...]:
        """Update the progress by the next frame; return the indices of the steps that this frame completes.

        After a re-initialisation, the task begins again with the step of the same part, or with the first step.
        If the payload that earlier steps have captured is lost, the task returns to the step of its capture.
        """
        for event in frame.events:
            if event.kind == "initialise":
                self._begin_part(event.text)
        if self._begin is None:
            self._begin = Since(frame.position, frame.orientation)
        done = self._completed(frame)
        for i in done:
            self.done_s[i] = frame.time_s
        held = self.places.held(frame) is not None
        if done:
            self._enter(done[-1] + 1)
        elif self._held and not held:
            self._return_to_capture()
        self._held = held
        self._before, self._frame = (None if done else self._frame), frame
        return done

    def hint(self) -> int:
        """Return the index of the present step's hint whose state holds in the newest frame; -1 if none does."""
        frame = self._frame
        if frame is None or self.present is None:
            return -1
        hints = enumerate(self.present.hints)
        return next((i for i, hint in hints if self._reached(frame, self.at, hint.when)), -1)

    def remaining(self) -> Remaining | None:
        """Return the remaining motion in the newest frame; None if there is no place to move to."""
        return None if self._frame is None else self._left(self._frame)

    def closing(self) -> float | None:
        """Return the speed towards the place [m/s]; None in the first step of a motion."""
        if self._before is None or (now := self.remaining()) is None or now.motion is None:
            return None
        before = self._left(self._before)
        return None if before is None or before.to != now.to else (before.distance - now.distance) / self._period_s

    def _left(self, frame: Frame) -> Remaining | None:
        """Return the remaining motion in one of the two newest frames; each is computed once."""
        for seen, at, left in self._known:
            if seen is frame and at == self.at:
                return left
        left = self._aims.remaining(frame, self.present)
        self._known = ((frame, self.at, left), *self._known[:1])
        return left

    def look(self) -> None:
        """Note that the operator has put another camera on a monitor."""
        self._looked = True

    def skip(self) -> None:
        """Go to the next step without completing the present one."""
        if self.present is not None:
            self._enter(self.at + 1)

    def back(self) -> None:
        """Go to the previous step. If its state holds already, this state has to end before it completes the step."""
        self._enter(max(self.first, self.at - 1))
        self._again = True

    def _begin_part(self, text: str) -> None:
        """Begin again; `text` is the log line of the re-initialisation, which ends with the name of the part."""
        self.done_s = [None] * len(self.steps)
        self.first = next((i for i, step in enumerate(self.steps) if step.part and text.endswith(step.part)), 0)
        self._enter(self.first)

    def _return_to_capture(self) -> None:
        """Return to the step in which the present payload was captured, if there is one."""
        capture = None
        for i in range(self.at - 1, -1, -1):
            if self.steps[i].done.held is False:
                break
            if self.steps[i].done.held:
                capture = i
        if capture is not None:
            self.first = min(self.first, capture)
            self.done_s[capture:] = [None] * (len(self.steps) - capture)
            self._enter(capture)

    def _enter(self, at: int) -> None:
        self.at, self._begin, self._before = at, None, None
        self._looked = self._again = self._open = False

    def _completed(self, frame: Frame) -> tuple[int, ...]:
        """Return the steps that a frame completes: the present one, or all up to the next milestone.

        While a contact inhibits the arm, only milestones are completed.
        """
        if self.present is None:
            return ()
        if not self._reached(frame, self.at, self.present.done):
            self._again = False
        elif not self._again and (self.present.is_milestone or not frame.work.arm_inhibit):
            return (self.at,)
        later = range(self.at + 1, len(self.steps))
        milestone = next((i for i in later if self.steps[i].is_milestone), None)
        if milestone is None:
            return ()
        if not self._reached(frame, milestone, self.steps[milestone].done):
            self._open = True
        elif self._open:
            return tuple(range(self.at, milestone + 1))
        return ()

    def _reached(self, frame: Frame, at: int, wanted: StateSpec) -> bool:
        since = (self._begin or Since(frame.position, frame.orientation))._replace(looked=self._looked)
        return reached(self._aims, self.steps[at], wanted, frame, since)
