"""Pages connected to one station: their session, the page in control, and the observers."""

from __future__ import annotations

import asyncio
import contextlib
import functools
import itertools
import math
from collections import deque
from collections.abc import Callable
from threading import Thread
from typing import Protocol

from aftdeck.errors import AftdeckError
from aftdeck.station.conversion.polygons_of import Shot, shot_of
from aftdeck.station.core.desk import Page
from aftdeck.station.core.roles import ANSWER_WITHIN, ControlRoles
from aftdeck.station.messages import from_page, to_page
from aftdeck.station.server.scenario_list import ScenarioList
from aftdeck.station.session.driver import Driver
from aftdeck.station.session.session import Session

GATHER_S = 0.05
"""Time for which requests for pictures are gathered [s]."""


class Connected(Protocol):
    """Interface through which `Pages` uses a page.

    Attributes:
        shows: True if the page only shows the run and cannot take control.
        may_fly: False if the page's address is for observing only.
        seq: number of the page's last message.
        answers: messages that `Pages` has queued for the page; the page's own sender task sends them.
    """

    shows: bool
    may_fly: bool
    seq: int
    answers: deque[to_page.Answers]


class Pages:
    """Pages connected to one station, with their session and their control roles.

    Attributes:
        driver: driver of the present session.
        choice: scenarios from which the operator chooses.
        windows: pages that only show the run.
        fresh: event on which the sender tasks wait; `wake` sets it and replaces it by a new event.
        polygons: for each page, the pictures in the look of 1972 that it shows.
        change: task that prepares another scenario; None before the first change.
    """

    def __init__(self, session: Session, notify: Callable[[], None], *, for_page: bool = False) -> None:
        """Prepare the pages of a session.

        Args:
            session: the session.
            notify: called in the session's thread when there is something new to send.
            for_page: whether the first run waits until the page in control has drawn it.
        """
        self.driver, self._notify = Driver(session, for_page=for_page), notify
        self._drawing: set[Connected] = set()
        self.choice = ScenarioList(session.scenario)
        self.windows: set[Connected] = set()
        self.polygons: dict[Connected, tuple[from_page.PolygonPicture, ...]] = {}
        self.fresh = asyncio.Event()
        self._gathering = False
        self.change: asyncio.Task[None] | None = None

    @property
    def session(self) -> Session:
        """The present session."""
        return self.driver.session

    @property
    def roles(self) -> ControlRoles[Page]:
        """Pages that can take control, and the page in control."""
        return self.session.desk.roles

    def start(self) -> None:
        """Start the session's run; the driver's thread calls `notify` after each step and after a failure."""
        self.driver.start(self._notify)

    def wake(self) -> None:
        """Wake the sender task of every page, because data to send has changed."""
        self.fresh.set()
        self.fresh = asyncio.Event()

    def show_polygons(self, page: Connected, pictures: tuple[from_page.PolygonPicture, ...]) -> None:
        """Draw these pictures in the look of 1972 for a page.

        A camera is drawn once for all pages, as high as the highest of its pictures. All requests within `GATHER_S`
        take effect together, because a page may ask hundreds of times a second.
        """
        self.polygons[page] = pictures
        if not self._gathering:
            self._gathering = True
            asyncio.get_running_loop().call_later(GATHER_S, self._want_polygons)

    def _want_polygons(self) -> None:
        self._gathering = False
        aspects: dict[Shot, float] = {}
        for picture in itertools.chain.from_iterable(self.polygons.values()):
            shot = shot_of(picture)
            aspects[shot] = min(picture.aspect, aspects.get(shot, math.inf))
        self.session.painter.want(aspects)
        self.wake()

    def drawn(self, page: Connected) -> None:
        """Let a run go on that waits for the first pictures of a page; later runs wait for this page, too."""
        self._drawing.add(page)
        self.driver.drawn()

    def fly(self, choice: from_page.FlyScenario, page: Connected) -> None:
        """Prepare another scenario, or the same one on another plant or with its script, and run it when it is ready.

        Until then the sticks of the present run are centred.

        Raises:
            CommandError: the scenario cannot be chosen.
        """
        self.choice.choose(choice.number, choice.plant, demo=choice.demo)
        self.session.set_unattended("another scenario")
        self.wake()
        self.change = asyncio.create_task(self._change(choice, page))

    async def _change(self, wanted: from_page.FlyScenario, page: Connected) -> None:
        """Replace the present session by a session of another scenario; after an error, keep the present session."""
        before, choice, number = self.driver, self.choice, wanted.number
        try:
            self.driver = Driver(
                await _make_in_daemon_thread(
                    lambda: before.session.another(choice.load(number, wanted.plant), shown=wanted.demo)
                ),
                for_page=self.roles.operator in self._drawing,
            )
            self.polygons.clear()  # every page asks again after its welcome
            choice.flown, choice.plant = number, self.driver.session.scenario.plant
            self.wake()
            await asyncio.to_thread(before.close)  # the old recording must be finished before the new one begins
            self.start()
        except Exception as error:  # any error must reach the page that chose the scenario
            page.answers.append(to_page.Refused(-1, f"{choice.scenarios[number].title!r} cannot be run: {error}"))
            if not isinstance(error, AftdeckError):
                raise
        finally:
            choice.coming = None
            self.wake()

    async def close(self) -> None:
        """Cancel the preparation of a scenario, and close the session."""
        if self.change is not None:
            self.change.cancel()
            await asyncio.wait([self.change])
        self.driver.close()

    def join(self, page: Connected) -> None:
        """Add a page; a page that only shows the run gets no control role."""
        if page.shows:
            self.windows.add(page)
        else:
            self.session.join(page, may_fly=page.may_fly)

    def leave(self, page: Connected, cause: str = "page gone") -> None:
        """Remove a page; if it was in control, the arm is put into its safe state (`Desk.leave`)."""
        self._drawing.discard(page)
        if page.shows:
            self.windows.remove(page)
            return
        self.session.leave(page, cause)

    def reseat(self, page: Connected, *, seated: bool) -> None:
        """Give a page a control role if `seated` is true (the page is wide enough); otherwise remove this role."""
        if seated is not page.shows:
            return  # nothing changes
        self.leave(page, "page narrow")
        page.shows = not seated
        self.join(page)
        self.wake()

    def readiness(self) -> to_page.Readiness:
        """Return the message about what is not ready yet."""
        laws = self.session.laws
        share, left_s = laws.progress or (None, None)
        return to_page.Readiness(
            waits_for=self.driver.waits_for,
            share=None if share is None else round(share, 2),
            left_s=None if left_s is None else math.ceil(left_s),
            failure=laws.failure,
        )

    def asked(self) -> None:
        """Wake the sender task of every page when a request for the sticks expires."""
        asyncio.get_running_loop().call_later(ANSWER_WITHIN, self.wake)


async def _make_in_daemon_thread(make: Callable[[], Session]) -> Session:
    """Make a session in a daemon thread, and return it.

    Compiling may take half a minute. The process can end meanwhile, because it does not wait for a daemon thread.
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

    Thread(target=run, name="scenario change", daemon=True).start()
    return await made
