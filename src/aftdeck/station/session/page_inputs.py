"""Inputs of the page in control, from their messages until a control step takes them.

This is a state machine without a clock, a thread or a simulation: each call passes the time.
"""

from __future__ import annotations

from collections import deque
from typing import Literal, NamedTuple

import msgspec

from aftdeck.errors import CommandError
from aftdeck.simulation.camera_drives import CameraDrive
from aftdeck.station.messages import from_page
from aftdeck.station.session.commands import travel

LOST = 2.0
"""Silence after which deflected sticks must be centred before they act again [s]."""
SILENCE = 0.5
"""Silence after which sticks and camera switches go to zero [s]."""
MOST_WAITING = 32
"""Maximum number of waiting commands; each step takes one."""
NO_CONTROLLERS = from_page.Controllers(0, ())
HANDS_OFF = from_page.Sticks(-1, (0.0, 0.0, 0.0), (0.0, 0.0, 0.0), 0.0)
STILL = CameraDrive("")
"""Camera command that moves no camera."""


class Taken(NamedTuple):
    """Inputs that one control step takes.

    Attributes:
        sticks: stick deflections.
        camera: command of a camera's drives; `STILL` if there is none.
        command: switch command; None if none was waiting.
        left: one of `unattended.CAUSES` if the controls have become unattended; else empty.
        handed_over: text for the log if another page takes control; else empty.
        controllers: controllers that move the sticks.
        under_way: numbers of the sticks in the command delay, oldest first; as long as the delay is [steps].
    """

    sticks: from_page.Sticks
    camera: CameraDrive
    command: from_page.FromPage | None
    left: str
    handed_over: str
    controllers: from_page.Controllers
    under_way: deque[int]

    def flown(self) -> int:
        """Put the sticks' number into the command delay, and return the number that leaves it; -1 is no page's."""
        self.under_way.append(self.sticks.seq)
        return self.under_way.popleft()


class PageInputs:
    """Sticks, camera switches and waiting commands of the page in control."""

    def __init__(self, delay: int) -> None:
        """Start with centred sticks.

        Args:
            delay: command delay [steps].
        """
        self._delay = delay
        self._commands: deque[from_page.FromPage] = deque()
        self._heard = self._camera_heard = 0.0
        self._left = self._handed_over = ""
        self._clear()

    def _clear(self) -> None:
        self._sticks, self._camera, self._controllers = HANDS_OFF, STILL, NO_CONTROLLERS
        self._commands.clear()
        self._zeroed = False
        self._lost: Literal["", "not reported", "reported"] = ""
        self._empty_delay()

    def _empty_delay(self) -> None:
        """Start a new command delay, for a run or for a page with stick numbers of its own."""
        self._under_way = deque([-1] * self._delay)

    def steer(self, sticks: from_page.Sticks, now: float) -> None:
        """Set the stick deflections, received at the time `now` [s].

        Deflected sticks that were silent for longer than `LOST` act again only after they have been centred.

        Raises:
            CommandError: a stick is still deflected after such a silence (raised once).
        """
        if self._zeroed and now - self._heard > LOST:
            self._lost = "not reported"
        self._heard, self._zeroed = now, False
        if not self._lost or not any(travel(sticks)):
            self._sticks, self._lost = sticks, ""
            return
        self._sticks = msgspec.structs.replace(HANDS_OFF, seq=sticks.seq)
        if self._lost == "not reported":
            self._lost = "reported"
            raise CommandError("the sticks were silent: let go of them first")

    def turn(self, camera: CameraDrive, now: float) -> None:
        """Set the switches that drive a camera, received at the time `now` [s]."""
        self._camera, self._camera_heard = camera, now

    def use(self, controllers: from_page.Controllers) -> None:
        """Set the controllers that move the sticks."""
        self._controllers = controllers

    def command(self, message: from_page.FromPage) -> None:
        """Queue a switch command. STOP deletes all waiting ones, so that STOP is never rejected and never late.

        Raises:
            CommandError: too many commands are waiting.
        """
        if isinstance(message, from_page.Stop):
            self._commands.clear()
            self._sticks, self._camera = msgspec.structs.replace(HANDS_OFF, seq=self._sticks.seq), STILL
        if len(self._commands) >= MOST_WAITING:
            raise CommandError(f"{MOST_WAITING} commands are waiting already; this one was not taken")
        self._commands.append(message)

    def let_go(self, cause: str) -> None:
        """Set the sticks to zero and delete all commands: the controls are unattended, with a cause of `CAUSES`."""
        self._clear()
        self._left = cause

    def hand_over(self, text: str) -> None:
        """Set the sticks to zero and delete all commands, because another page takes control; log `text`.

        Raises:
            CommandError: a stick is deflected.
        """
        if any(travel(self._sticks)):
            raise CommandError("let go of the sticks first: they are given at rest")
        self.let_go("handed over")
        self._handed_over = text

    def take(self, now: float, *, rate_held: bool) -> Taken:
        """Return the inputs of a control step at the time `now` [s].

        Args:
            now: time [s], on the clock of `steer` and `turn`.
            rate_held: whether RATE HOLD keeps a rate, so that the page must not be silent although its sticks are
                centred.
        """
        if now - self._heard > SILENCE and (rate_held or any(travel(self._sticks))):
            self._zeroed = True
            self._sticks = msgspec.structs.replace(HANDS_OFF, seq=self._sticks.seq)
            self._left = self._left or "sticks silent"
        camera = self._camera if now - self._camera_heard <= SILENCE else STILL
        command = self._commands.popleft() if self._commands else None
        if isinstance(command, from_page.Restart):
            self._empty_delay()
        taken = Taken(self._sticks, camera, command, self._left, self._handed_over, self._controllers, self._under_way)
        self._left = self._handed_over = ""
        return taken
