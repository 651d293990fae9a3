"""Inputs of the page in control, stored from their arrival until a control step uses them.

This is a state machine without a clock, a thread or a simulation: the caller passes the time.
"""

from __future__ import annotations

from collections import deque
from typing import Literal, NamedTuple

import msgspec

from aftdeck.errors import CommandError
from aftdeck.simulation.camera_drives import CameraDrive
from aftdeck.station.core.commands import travel
from aftdeck.station.messages import from_page

LOST = 2.0
"""Longest pause between messages after which deflected sticks act at once [s]. After a longer pause, the operator must
first centre the sticks."""
SILENCE = 0.5
"""If no message arrives for this time [s], sticks and camera switches are centred."""
MAX_WAITING = 32
"""Maximum number of waiting commands; each control step executes one."""
NO_CONTROLLERS = from_page.Controllers(0, ())
CENTRED = from_page.Sticks(-1, (0.0, 0.0, 0.0), (0.0, 0.0, 0.0), 0.0)
STILL = CameraDrive("")
"""Camera command that moves no camera."""


class Taken(NamedTuple):
    """Inputs for one control step.

    Attributes:
        sticks: stick deflections.
        camera: command for the drives of a camera; `STILL` if no camera is moved.
        command: switch command; None if no command was waiting.
        cause: one of `unattended.CAUSES` if the controls have become unattended; else empty.
        handed_over: text for the log if another page takes control; else empty.
        controllers: devices that move the sticks.
        delayed: queue of sequence numbers, oldest first: one for each step of the command delay. They belong to stick
            messages that do not act yet.
    """

    sticks: from_page.Sticks
    camera: CameraDrive
    command: from_page.FromPage | None
    cause: str
    handed_over: str
    controllers: from_page.Controllers
    delayed: deque[int]

    def flown(self) -> int:
        """Add the sequence number of `sticks` to the delay queue; remove and return the queue's oldest number.

        The returned number belongs to the stick message that acts in this step. It is -1 if no message acts.
        """
        self.delayed.append(self.sticks.seq)
        return self.delayed.popleft()


class PageInputs:
    """Sticks, camera switches and waiting commands of the page in control."""

    def __init__(self, delay: int) -> None:
        """Begin with centred sticks.

        Args:
            delay: command delay [steps].
        """
        self._delay = delay
        self._commands: deque[from_page.FromPage] = deque()
        self._heard = self._camera_heard = 0.0
        self._cause = self._handed_over = ""
        self._clear()

    def _clear(self) -> None:
        self._sticks, self._camera, self._controllers = CENTRED, STILL, NO_CONTROLLERS
        self._commands.clear()
        self._zeroed = False
        self._lost: Literal["", "not reported", "reported"] = ""
        self._empty_delay()

    def _empty_delay(self) -> None:
        """Set all delayed sequence numbers to -1: a run begins, or the next page starts its own numbers."""
        self._delayed = deque([-1] * self._delay)

    def steer(self, sticks: from_page.Sticks, now: float) -> None:
        """Set the stick deflections, received at the time `now` [s].

        If `take` has centred the sticks in a pause between messages, and the pause was longer than `LOST`, deflected
        sticks act again only after the operator has centred them.

        Raises:
            CommandError: a stick is deflected in the first message after such a pause. Further messages do not raise
                the error again.
        """
        if self._zeroed and now - self._heard > LOST:
            self._lost = "not reported"
        self._heard, self._zeroed = now, False
        if not self._lost or not any(travel(sticks)):
            self._sticks, self._lost = sticks, ""
            return
        self._sticks = msgspec.structs.replace(CENTRED, seq=sticks.seq)
        if self._lost == "not reported":
            self._lost = "reported"
            raise CommandError(f"no sticks were received for {LOST:g} s: centre the sticks first")

    def turn(self, camera: CameraDrive, now: float) -> None:
        """Set the switches that drive a camera, received at the time `now` [s]."""
        self._camera, self._camera_heard = camera, now

    def use(self, controllers: from_page.Controllers) -> None:
        """Set the devices that move the sticks."""
        self._controllers = controllers

    def command(self, message: from_page.FromPage) -> None:
        """Queue a switch command; STOP first centres the sticks and deletes all waiting commands.

        Therefore STOP is never rejected and never delayed by other commands.

        Raises:
            CommandError: too many commands are waiting.
        """
        if isinstance(message, from_page.Stop):
            self._commands.clear()
            self._sticks, self._camera = msgspec.structs.replace(CENTRED, seq=self._sticks.seq), STILL
        if len(self._commands) >= MAX_WAITING:
            raise CommandError(f"command rejected: {MAX_WAITING} commands are waiting already")
        self._commands.append(message)

    def set_unattended(self, cause: str) -> None:
        """Centre the sticks and delete all waiting commands; `cause` is one of `unattended.CAUSES`."""
        self._clear()
        self._cause = cause

    def hand_over(self, text: str) -> None:
        """Centre the sticks and delete all waiting commands, because another page takes control; log `text`.

        Raises:
            CommandError: a stick is deflected.
        """
        if any(travel(self._sticks)):
            raise CommandError("centre the sticks first: deflected sticks cannot be given to another page")
        self.set_unattended("handed over")
        self._handed_over = text

    def take(self, now: float, *, rate_held: bool) -> Taken:
        """Return the inputs of a control step at the time `now` [s].

        Args:
            now: time [s], on the clock of `steer` and `turn`.
            rate_held: whether RATE HOLD keeps a rate. If so, the page must send messages even with centred sticks.
        """
        if now - self._heard > SILENCE and (rate_held or any(travel(self._sticks))):
            self._zeroed = True
            self._sticks = msgspec.structs.replace(CENTRED, seq=self._sticks.seq)
            self._cause = self._cause or "sticks silent"
        camera = self._camera if now - self._camera_heard <= SILENCE else STILL
        command = self._commands.popleft() if self._commands else None
        if isinstance(command, from_page.Restart):
            self._empty_delay()
        taken = Taken(self._sticks, camera, command, self._cause, self._handed_over, self._controllers, self._delayed)
        self._cause = self._handed_over = ""
        return taken
