"""All pages connected to one station: their session, the page in control, and the observers."""

from __future__ import annotations

import asyncio
import contextlib
import functools
from collections import deque
from collections.abc import Callable
from threading import Thread
from typing import Protocol

from aftdeck.errors import AftdeckError
from aftdeck.station.messages import to_page
from aftdeck.station.server.control_roles import ANSWER_WITHIN, ControlRoles
from aftdeck.station.server.scenario_list import ScenarioList
from aftdeck.station.session.driver import Driver
from aftdeck.station.session.session import Session


class Connected(Protocol):
    """Part of a page that `Pages` and the other pages use.

    Attributes:
        shows: True if the page only shows the run and cannot take control.
        seq: number of its last message.
        answers: messages that `Pages` queues for it; its own sender sends them, so that no page waits for another.
    """

    shows: bool
    seq: int
    answers: deque[to_page.Refused]


class Pages:
    """Pages connected to one station, with their session and their control roles."""

    def __init__(self, session: Session, notify: Callable[[], None]) -> None:
        self.driver, self._notify = Driver(session), notify
        self.choice = ScenarioList(session.scenario)
        self.seats: ControlRoles[Connected] = ControlRoles()
        self.windows: set[Connected] = set()
        self.fresh = asyncio.Event()
        self.change: asyncio.Task[None] | None = None

    @property
    def session(self) -> Session:
        """The present session."""
        return self.driver.session

    def start(self) -> None:
        """Start the session's run; its thread calls `notify` after each step and after a failure."""
        self.driver.start(self._notify)

    def wake(self) -> None:
        """Wake the sender of every page, because there is something new to send."""
        self.fresh.set()
        self.fresh = asyncio.Event()

    def fly(self, number: int, asking: Connected) -> None:
        """Prepare another scenario and then run it; the arm comes to rest meanwhile.

        Raises:
            CommandError: the scenario cannot be chosen.
        """
        self.choice.choose(number)
        self.session.let_go("another scenario")
        self.wake()
        self.change = asyncio.create_task(self._change(number, asking))

    async def _change(self, number: int, asking: Connected) -> None:
        """Replace the present session by one of another scenario; if that cannot be made, the present one continues."""
        before, choice = self.driver, self.choice
        try:
            self.driver = Driver(await _abandonable(lambda: before.session.another(choice.load(number))))
            choice.flown = number
            self.wake()
            await asyncio.to_thread(before.close)  # its recording must be finished before the next one begins
            self.start()
        except Exception as error:  # any error must reach the page that asked
            asking.answers.append(to_page.Refused(-1, f"{choice.scenarios[number].title!r} cannot be flown: {error}"))
            if not isinstance(error, AftdeckError):
                raise
        finally:
            choice.coming = None
            self.wake()

    async def close(self) -> None:
        """Cancel the preparation of a scenario and close the session, because the server stops."""
        if self.change is not None:
            self.change.cancel()
            await asyncio.wait([self.change])
        self.driver.close()

    def join(self, page: Connected) -> None:
        """Add a page; a page that only shows the run gets no seat."""
        if page.shows:
            self.windows.add(page)
        else:
            self.seats.join(page)

    def leave(self, page: Connected, cause: str = "page gone") -> None:
        """Remove a page, for one of `unattended.CAUSES`; if it was in control, the sticks go to zero."""
        if page.shows:
            self.windows.remove(page)
            return
        flew = page is self.seats.operator
        self.seats.leave(page)
        if flew:
            self.session.let_go(cause if self.seats.operator is None else f"{cause}, another flies")

    def reseat(self, page: Connected, *, seated: bool) -> None:
        """Give a seat to a page that has become wide enough to take control, or take it from a too narrow one."""
        if seated is not page.shows:
            return  # nothing changes
        self.leave(page, "page narrow")
        page.shows = not seated
        self.join(page)
        self.wake()

    def role(self, page: Connected) -> to_page.Role:
        """Return the message that tells a page its role, and which page is in control."""
        roles = self.seats
        number, flier, asking = (
            0 if one is None or one.shows else roles.number(one) for one in (page, roles.operator, roles.asking)
        )
        return to_page.Role(
            flying=page is roles.operator,
            watchers=max(0, len(roles) - 1),
            number=number,
            flier=flier,
            asking=asking,
            name=roles.name(page),
            names=tuple(to_page.NamedPage(*named) for named in roles.named()),
        )

    def name(self, page: Connected, name: str) -> None:
        """Set the name of the person at a page.

        Raises:
            InputError: the name is not valid.
        """
        self.seats.give_name(page, name)
        self.wake()

    def ask(self, page: Connected) -> None:
        """Request control for a page; when the time to answer is over, all pages are informed.

        Raises:
            CommandError: the page is in control already, or another page is asking.
        """
        self.seats.ask(page)
        self.wake()
        asyncio.get_running_loop().call_later(ANSWER_WITHIN, self.wake)

    def answer(self, gives: bool) -> None:
        """Give the sticks to the page that asks for control, or keep them, as the page in control decided.

        Raises:
            CommandError: no page asks for control, or a stick is not centred.
        """
        seats = self.seats
        asked = seats.pending_request()
        assert seats.operator is not None, "it is the page that flies that answers"
        flier = seats.display_name(seats.operator)
        if gives:
            self.session.hand_over(f"{flier} gives the sticks to {seats.display_name(asked)}")
        else:
            asked.answers.append(to_page.Refused(asked.seq, f"{flier} keeps the sticks"))
        seats.answer(gives)
        self.wake()


async def _abandonable(make: Callable[[], Session]) -> Session:
    """Make a session in a daemon thread and return it.

    The end of the process does not wait for that thread: compiling may take half a minute.
    """
    loop = asyncio.get_running_loop()
    made: asyncio.Future[Session] = loop.create_future()

    def run() -> None:
        try:
            deliver = functools.partial(made.set_result, make())
        except Exception as error:
            deliver = functools.partial(made.set_exception, error)
        with contextlib.suppress(RuntimeError):  # the loop is closed
            loop.call_soon_threadsafe(lambda: None if made.done() else deliver())

    Thread(target=run, name="making ready", daemon=True).start()
    return await made
