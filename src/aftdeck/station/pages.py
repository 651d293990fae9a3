"""All pages connected to one station: what is flown, who flies, who watches."""

from __future__ import annotations

import asyncio
import contextlib
import functools
from collections import deque
from collections.abc import Callable
from threading import Thread
from typing import Protocol

from aftdeck.errors import AftdeckError
from aftdeck.station import to_page
from aftdeck.station.choice import Choice
from aftdeck.station.seats import ANSWER_WITHIN, Seats
from aftdeck.station.session import Session


class Connected(Protocol):
    """A page, as far as the others are concerned.

    Attributes:
        shows: it is nobody's hands.
        seq: number of its last message.
        answers: what others have it told; its own sender sends them, so that nobody waits for its connection.
    """

    shows: bool
    seq: int
    answers: deque[to_page.Refused]


class Pages:
    """The pages connected to one station: what is flown, who flies, and waking their senders."""

    def __init__(self, session: Session, told: Callable[[], None]) -> None:
        self.session, self._told = session, told
        self.choice = Choice(session.scenario)
        self.seats: Seats[Connected] = Seats()
        self.windows: set[Connected] = set()
        self.fresh = asyncio.Event()
        self.change: asyncio.Task[None] | None = None

    def wake(self) -> None:
        """Tell every sender that there is something new."""
        self.fresh.set()
        self.fresh = asyncio.Event()

    def fly(self, number: int, asking: Connected) -> None:
        """Make another scenario ready and then fly it; the arm comes to rest meanwhile.

        Raises:
            CommandError: it cannot be chosen.
        """
        self.choice.choose(number)
        self.session.let_go("another scenario")
        self.wake()
        self.change = asyncio.create_task(self._change(number, asking))

    async def _change(self, number: int, asking: Connected) -> None:
        """Leave the present session for another; where that cannot be made, the present one goes on."""
        before, choice = self.session, self.choice
        try:
            self.session = await _abandonable(lambda: before.another(choice.load(number)))
            choice.flown = number
            self.wake()
            await asyncio.to_thread(before.close)  # its recording is finished before the next begins
            self.session.start(self._told)
        except Exception as error:  # whoever asked must hear of it, whatever it was
            asking.answers.append(to_page.Refused(-1, f"{choice.scenarios[number].title!r} cannot be flown: {error}"))
            if not isinstance(error, AftdeckError):
                raise
        finally:
            choice.coming = None
            self.wake()

    async def close(self) -> None:
        """The server ends: nothing more is made ready, and the flight stops."""
        if self.change is not None:
            self.change.cancel()
            await asyncio.wait([self.change])
        self.session.close()

    def come(self, page: Connected) -> None:
        """Take a page on: with hands it has a seat, one that only shows has none."""
        if page.shows:
            self.windows.add(page)
        else:
            self.seats.come(page)

    def leave(self, page: Connected, cause: str = "page gone") -> None:
        """Take a page off, for one of `unattended.CAUSES`; the sticks go to zero if it flew."""
        if page.shows:
            self.windows.remove(page)
            return
        flew = page is self.seats.flier
        self.seats.leave(page)
        if flew:
            self.session.let_go(cause if self.seats.flier is None else f"{cause}, another flies")

    def reseat(self, page: Connected, *, seated: bool) -> None:
        """A page has become wide enough to have hands, or too narrow for it."""
        if seated is not page.shows:
            return  # it is so already
        self.leave(page, "page narrow")
        page.shows = not seated
        self.come(page)
        self.wake()

    def role(self, page: Connected) -> to_page.Role:
        """What a page is told of who flies."""
        seats = self.seats
        number, flier, asking = (
            0 if one is None or one.shows else seats.number(one) for one in (page, seats.flier, seats.asking)
        )
        return to_page.Role(
            flying=page is seats.flier,
            watchers=max(0, len(seats) - 1),
            number=number,
            flier=flier,
            asking=asking,
            name=seats.name(page),
            names=tuple(to_page.NamedPage(*named) for named in seats.named()),
        )

    def name(self, page: Connected, name: str) -> None:
        """Somebody says who he is.

        Raises:
            InputError: what can be no name.
        """
        self.seats.give_name(page, name)
        self.wake()

    def ask(self, page: Connected) -> None:
        """A page asks for the sticks; when the time to answer is over, all are told.

        Raises:
            CommandError: it flies, or another asks.
        """
        self.seats.ask(page)
        self.wake()
        asyncio.get_running_loop().call_later(ANSWER_WITHIN, self.wake)

    def answer(self, gives: bool) -> None:
        """The page that flies gives the sticks, or keeps them.

        Raises:
            CommandError: nobody asks, or a stick is not at rest.
        """
        seats = self.seats
        asked = seats.who_asks()
        assert seats.flier is not None, "it is the page that flies that answers"
        flier = seats.called(seats.flier)
        if gives:
            self.session.hand_over(f"{flier} gives the sticks to {seats.called(asked)}")
        else:
            asked.answers.append(to_page.Refused(asked.seq, f"{flier} keeps the sticks"))
        seats.answer(gives)
        self.wake()


async def _abandonable(make: Callable[[], Session]) -> Session:
    """What a thread makes that the end of the process need not wait for: compiling may take half a minute."""
    loop = asyncio.get_running_loop()
    made: asyncio.Future[Session] = loop.create_future()

    def run() -> None:
        try:
            told = functools.partial(made.set_result, make())
        except Exception as error:
            told = functools.partial(made.set_exception, error)
        with contextlib.suppress(RuntimeError):  # the loop is closed
            loop.call_soon_threadsafe(lambda: None if made.done() else told())

    Thread(target=run, name="making ready", daemon=True).start()
    return await made
