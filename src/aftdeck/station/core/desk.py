"""Desk of a session: what its pages ask for, stored from their messages until a control step takes it."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from aftdeck.errors import CommandError, InputError
from aftdeck.scenario.light import Lighting
from aftdeck.simulation.camera_drives import CameraDrive
from aftdeck.station.core.asked import Asked
from aftdeck.station.core.commands import check_camera, check_light, check_shown, check_sticks, check_switch
from aftdeck.station.core.page_inputs import PageInputs
from aftdeck.station.core.roles import ControlRoles
from aftdeck.station.messages import from_page, kinds, to_page
from aftdeck.station.messages.frame import AutopilotName
from aftdeck.station.messages.welcome import Welcome

NOT_IN_CONTROL = "this page observes; only the page in control can send commands"
"""Reason for rejecting a command of an observer or of a secondary window."""

Page = object
"""A page, as its host names it."""


class Answer(NamedTuple):
    """Answer of a session to a page."""

    page: Page
    message: to_page.Answers


class Desk:
    """What the pages of a session ask for.

    Attributes:
        roles: pages that can take control, and the page in control.
        autopilot: what flies in place of the operator; None: the operator flies.
        changes: changes in flight for the next step.
    """

    def __init__(
        self, welcome: Welcome, delay: int, lighting: Lighting, clock: Callable[[], float], roles: ControlRoles[Page]
    ) -> None:
        """Begin with centred sticks.

        Args:
            welcome: first message to a page; it names all that a command may name.
            delay: command delay [steps].
            lighting: lighting at the beginning of a run.
            clock: returns the time [s].
            roles: control roles of the pages.
        """
        self.roles = roles
        self.autopilot: AutopilotName | None = None
        self._welcome, self._clock = welcome, clock
        self._inputs = PageInputs(delay)
        self._first_lighting = self._lighting = lighting
        self._latency_ms: float | None = None
        self._monitors: tuple[kinds.Monitor, ...] = ()
        self._announced = ""
        self.changes: dict[str, str] = {}
        self._numbers: dict[Page, int] = {}

    def join(self, page: Page, *, may_fly: bool = True) -> None:
        """Add a page, which takes control if it may fly and no page is in control."""
        self.roles.join(page, may_fly=may_fly)

    def leave(self, page: Page, cause: str = "page gone") -> None:
        """Remove a page; if it was in control, put the arm into its safe state.

        Args:
            page: page that leaves.
            cause: why the page leaves; one of `unattended.CAUSES`.
        """
        was_operator = page == self.roles.operator
        self.roles.leave(page)
        self._numbers.pop(page, None)
        if was_operator:
            self.set_unattended(cause if self.roles.operator is None else f"{cause}, another flies")

    def role(self, page: Page, *, may_fly: bool) -> to_page.Role:
        """Return the message about a page's role and the page in control; `may_fly`: whether it may take control."""
        roles = self.roles
        number, operator, asking = (
            roles.number(other) if other in roles else 0 for other in (page, roles.operator, roles.asking)
        )
        return to_page.Role(
            flying=page == roles.operator,
            may_fly=may_fly,
            watchers=max(0, len(roles) - 1),
            number=number,
            flier=operator,
            asking=asking,
            name=roles.name(page),
            names=tuple(to_page.NamedPage(*named) for named in roles.named()),
        )

    def receive(self, page: Page, message: from_page.FromPage) -> tuple[Answer, ...]:
        """Take a message of a page, and return the answers to it: to this page if it is rejected, or to another."""
        if page in self.roles:
            self._numbers[page] = message.seq
        try:
            if isinstance(message, from_page.Announce):
                self.announce("operator" if page == self.roles.operator else "observer")
            elif isinstance(message, from_page.AskSticks) and page in self.roles:
                self.roles.ask(page)
            elif isinstance(message, from_page.SetName) and page in self.roles:
                self.roles.give_name(page, message.name)
            elif page != self.roles.operator:
                raise CommandError(NOT_IN_CONTROL)
            elif isinstance(message, from_page.GiveSticks | from_page.KeepSticks):
                return self._answer(page, gives=isinstance(message, from_page.GiveSticks))
            else:
                self.accept(message)
        except (CommandError, InputError) as error:
            return (Answer(page, to_page.Refused(message.seq, str(error))),)
        return ()

    def _answer(self, operator: Page, *, gives: bool) -> tuple[Answer, ...]:
        """Answer the pending request: hand over control if `gives` is true; otherwise reject the request.

        Raises:
            CommandError: no request is pending, or a stick is not centred.
        """
        asking, name = self.roles.pending_request(), self.roles.display_name(operator)
        if gives:
            self.hand_over(f"{name} gives the sticks to {self.roles.display_name(asking)}")
        self.roles.answer(gives)
        text = f"{name} keeps the sticks"
        return () if gives else (Answer(asking, to_page.Refused(self._numbers.get(asking, -1), text)),)

    def accept(self, message: from_page.FromPage) -> None:
        """Take a message of the page in control.

        Raises:
            CommandError: a deflection, a switch position, a target or a name is not possible, the sticks must be
                centred first (`PageInputs.steer`), an autopilot moves the cameras, or too many commands are waiting.
        """
        match message:
            case from_page.Sticks():
                check_sticks(message)
                self._inputs.steer(message, self._clock())
            case from_page.DriveCamera():
                check_camera(message, self._welcome)
                if self.autopilot is not None:
                    raise CommandError(
                        f"the {self.autopilot} is in control: move a stick to take over, then move the camera"
                    )
                camera = CameraDrive(message.camera, message.pan, message.tilt, message.zoom, message.slow)
                self._inputs.turn(camera, self._clock())
            case from_page.Controllers():
                self._inputs.use(message)
            case from_page.Shown():
                check_shown(message, self._welcome)
                self._latency_ms, self._monitors = message.latency_ms, message.monitors
            case from_page.SetLight():  # allowed even while an autopilot flies
                check_light(message.lighting, self._welcome)
                self._lighting = message.lighting
            case _:
                check_switch(message, self._welcome)
                self._inputs.command(message)

    def announce(self, by: str) -> None:
        """Take the announcement of a clearance problem; `by`: ``operator`` or ``observer``."""
        self._announced = by

    def set_unattended(self, cause: str = "page gone") -> None:
        """Centre the sticks and delete all waiting commands; `cause` is one of `unattended.CAUSES`."""
        self._inputs.set_unattended(cause)
        self._latency_ms, self._monitors = None, ()

    def hand_over(self, text: str) -> None:
        """Centre the sticks and delete all waiting commands, because another page takes control; log `text`.

        For one step the controls then count as unattended: RATE HOLD is cancelled and POSITION HOLD is set.

        Raises:
            CommandError: a stick is deflected.
        """
        self._inputs.hand_over(text)
        self._latency_ms, self._monitors = None, ()

    def take(self, *, rate_held: bool) -> Asked:
        """Return what is asked for in the next control step; `rate_held`: whether RATE HOLD keeps a rate."""
        taken = self._inputs.take(self._clock(), rate_held=rate_held)
        if isinstance(taken.command, from_page.Restart):
            self._lighting, self.changes = self._first_lighting, {}
        changes, self.changes = self.changes, {}
        announced, self._announced = self._announced, ""
        return Asked(taken, self._latency_ms, self._monitors, self._lighting, announced, changes)
