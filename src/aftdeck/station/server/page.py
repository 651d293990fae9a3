"""Connection of one page: its handshake, its commands, and the messages sent to it."""

from __future__ import annotations

import asyncio
import contextlib
from collections import deque

import msgspec
from starlette.websockets import WebSocket, WebSocketDisconnect, WebSocketState

from aftdeck.errors import CommandError
from aftdeck.station.conversion.polygons_of import shot_of
from aftdeck.station.core.commands import check_polygons
from aftdeck.station.core.core import OF_CONSOLE
from aftdeck.station.core.news import News
from aftdeck.station.messages import from_page, kinds, to_page
from aftdeck.station.server import guard
from aftdeck.station.server.allowance import Allowance
from aftdeck.station.server.pages import Pages
from aftdeck.station.server.terse_log import log
from aftdeck.station.session.driver import Phase

HELLO_WITHIN = 5.0
"""Time within which a page must send `Hello` [s]."""
MAX_PAGES = 32
"""Maximum number of pages connected at the same time."""
TOO_MANY_PAGES = f"{MAX_PAGES} pages are connected, which is the maximum"
"""Reason for closing the connection of a new page while `MAX_PAGES` pages are connected."""
MAX_REJECTIONS = 20
"""Number of consecutive rejected messages after which the connection is closed."""
REJECTIONS_PER_SECOND, REJECTIONS_AT_ONCE = 10.0, 100.0
"""Rejected messages per second over a long time, and at once, beyond which the connection is closed.

A page that loses control may have sent the sticks of a second before it learns so.
"""
ROLES_PER_SECOND, ROLES_AT_ONCE = 1.0, 20.0
"""Messages about roles and names per second over a long time, and at once: each is reported to all pages."""
MAX_REASON_LENGTH = 123
"""Longest reason in a WebSocket's close frame [bytes]; RFC 6455, 5.5."""

_ACCEPTED_DURING_CHANGE = (
    from_page.Stop
    | from_page.SetBrakes
    | from_page.SetSafing
    | from_page.HandsOff
    | from_page.Drawn
    | from_page.Shown
    | from_page.Controllers
    | from_page.SetLight
    | from_page.GiveSticks
    | from_page.KeepSticks
    | from_page.FlyScenario
)
"""Messages accepted during a change of the scenario: none of them moves the arm."""

_ABOUT_ROLES = from_page.AskSticks | from_page.SetName | from_page.LeaveSeat | from_page.TakeSeat
_ABOUT_CONTROL = from_page.AskSticks | from_page.SetName | from_page.GiveSticks | from_page.KeepSticks
_OF_EVERY_PAGE = from_page.AskSticks | from_page.SetName | from_page.Announce
"""Messages whose rejection does not count towards `MAX_REJECTIONS`."""
TOO_OFTEN = f"at most {ROLES_PER_SECOND:g} request for the sticks or new name a second is allowed; wait a moment"
"""Reason for rejecting a message about roles."""

LINES_PER_SECOND, LINES_AT_ONCE = 10.0, 40
"""Rate of the lines that a page may type on the console or have completed [1/s], and their number at once."""
TOO_MANY_LINES = f"at most {LINES_PER_SECOND:g} lines a second can be typed; wait a moment"
"""Reason for rejecting a line of the console."""

_encoder = msgspec.json.Encoder()
_hello = msgspec.json.Decoder(from_page.Hello)
_messages: msgspec.json.Decoder[from_page.FromPage] = msgspec.json.Decoder(from_page.FromPage)


async def send(socket: WebSocket, message: to_page.FromServer) -> None:
    """Send a message to a page.

    Raises:
        WebSocketDisconnect: the connection is closed.
    """
    await send_text(socket, _encoder.encode(message))


async def send_text(socket: WebSocket, encoded: bytes) -> None:
    """Send an encoded message to a page.

    Raises:
        WebSocketDisconnect: the connection is closed.
    """
    if socket.application_state is WebSocketState.DISCONNECTED:
        raise WebSocketDisconnect(1006)
    await socket.send_text(encoded.decode())


async def goodbye(socket: WebSocket, text: str) -> None:
    """Send a page the reason for closing its connection, and close it."""
    await send(socket, to_page.Refused(-1, text))
    await socket.close(1008, text.encode()[:MAX_REASON_LENGTH].decode(errors="ignore"))


async def receive_hello(socket: WebSocket) -> from_page.Hello | None:
    """Return the first message of a page; if it is not a valid `Hello`, close the connection and return None."""
    try:
        hello = _hello.decode(await asyncio.wait_for(socket.receive_text(), HELLO_WITHIN))
    except TimeoutError:
        await goodbye(socket, f"no hello message was received within {HELLO_WITHIN:g} s")
        return None
    except (msgspec.MsgspecError, KeyError, RecursionError) as error:
        await goodbye(socket, f"the first message must be a hello message with the protocol version: {error}")
        return None
    if hello.protocol != kinds.PROTOCOL:
        text = f"this page uses protocol {hello.protocol}, the station {kinds.PROTOCOL}: reload the page"
        await goodbye(socket, text)
        return None
    return hello


class Page:
    """Connected page, from its welcome to the end of its connection.

    Attributes:
        answers: messages that `Pages` has queued for this page; the sender task of this page sends them.
        why_closed: why the server closes the connection, after `guard.PENALTY`; empty while it does not.
    """

    def __init__(self, pages: Pages, socket: WebSocket, hello: from_page.Hello, *, may_fly: bool) -> None:
        self.pages, self.socket, self.may_fly = pages, socket, may_fly
        self.shows, self.strips = hello.shows, hello.strips
        self.seq = -1
        self.rejections = 0
        self.why_closed = ""
        self.answers: deque[to_page.Answers] = deque()
        self._may_be_rejected = Allowance(REJECTIONS_PER_SECOND, REJECTIONS_AT_ONCE)
        self._may_type = Allowance(LINES_PER_SECOND, LINES_AT_ONCE)
        self._may_change_roles = Allowance(ROLES_PER_SECOND, ROLES_AT_ONCE)

    async def serve(self) -> None:
        """Send the welcome, then receive and send messages until one side disconnects."""
        if len(self.pages.roles) + len(self.pages.windows) >= MAX_PAGES:
            return await goodbye(self.socket, TOO_MANY_PAGES)
        self.pages.join(self)
        sender = asyncio.create_task(self._send_changes())
        try:
            self.pages.wake()
            await self._receive()
        finally:
            sender.cancel()
            with contextlib.suppress(asyncio.CancelledError, WebSocketDisconnect, RuntimeError):
                await sender
            self.pages.leave(self)
            self.pages.show_polygons(self, ())
            del self.pages.polygons[self]
        if self.why_closed:
            log.warning("a page is not read for %g s: %s", guard.PENALTY, self.why_closed)
            await asyncio.sleep(guard.PENALTY)
            await goodbye(self.socket, f"{self.why_closed}: the connection is closed")

    async def _send(self, message: to_page.FromServer) -> None:
        await send(self.socket, message)

    # --- from the page ------------------------------------------------------------------------------------

    async def _receive(self) -> None:
        while not self.why_closed:
            message = await self.socket.receive()
            if message["type"] == "websocket.disconnect":
                return
            text = message.get("text")
            if text is None:
                await self.reject(-1, "got a binary message; messages must be JSON text")
                continue
            await self._handle(text)
            await asyncio.sleep(0)  # other pages come between two messages of this page

    async def _handle(self, text: str) -> None:
        try:
            message = _messages.decode(text)
        except (msgspec.MsgspecError, RecursionError) as error:
            return await self.reject(-1, f"invalid message: {error}")
        if message.seq <= self.seq:
            return await self.reject(
                message.seq, f"message {message.seq} rejected: its number must be greater than {self.seq}"
            )
        self.seq = message.seq
        if isinstance(message, _ABOUT_ROLES) and not self._may_change_roles.take():
            if isinstance(message, from_page.LeaveSeat | from_page.TakeSeat):
                self.why_closed = "the page has left and taken its seat too often"  # it says at its next start which
                return None
            return await self.reject(message.seq, TOO_OFTEN, counts=False)
        if isinstance(message, from_page.LeaveSeat | from_page.TakeSeat):
            return self.pages.reseat(self, seated=isinstance(message, from_page.TakeSeat))
        if isinstance(message, from_page.ShowPolygons):
            return await self._show_polygons(message)
        if isinstance(message, OF_CONSOLE):
            if not self._may_type.take():
                return await self.reject(message.seq, TOO_MANY_LINES, counts=False)
            for _, answer in await asyncio.to_thread(self.pages.session.receive, self, message):
                await self._send(answer)
            return None
        await self._give(message)

    async def _give(self, message: from_page.FromPage) -> None:
        """Give a message to the session, and its answers to the pages."""
        commands = self.pages.roles.operator is self and not isinstance(message, _OF_EVERY_PAGE)
        try:
            answers = () if commands and self._is_own(message) else self.pages.session.receive(self, message)
        except CommandError as error:
            return await self.reject(message.seq, str(error))
        if isinstance(message, _ABOUT_CONTROL):
            self.pages.wake()
        if isinstance(message, from_page.AskSticks) and not answers:
            self.pages.asked()
        for page, answer in answers:
            if page is self and isinstance(answer, to_page.Refused):
                await self.reject(answer.seq, answer.text, counts=commands)
            elif isinstance(page, Page):
                page.answers.append(answer)
        if commands and not answers:
            self.rejections = 0

    async def _show_polygons(self, message: from_page.ShowPolygons) -> None:
        try:
            check_polygons(message, self.pages.session.welcome)
        except CommandError as error:
            return await self.reject(message.seq, str(error))
        self.pages.show_polygons(self, message.pictures)

    def _is_own(self, message: from_page.FromPage) -> bool:
        """Do a command that concerns the server only, and return True; return False for any other command.

        Raises:
            CommandError: another scenario is being prepared, or the scenario cannot be chosen.
        """
        if self.pages.choice.coming is not None and not isinstance(message, _ACCEPTED_DURING_CHANGE):
            if isinstance(message, from_page.Sticks | from_page.DriveCamera):
                return True  # sent before the page learned that a scenario was chosen
            raise CommandError("another scenario is being prepared; until it runs, no command can move the arm")
        if isinstance(message, from_page.Drawn):
            self.pages.drawn(self)
        elif isinstance(message, from_page.FlyScenario):
            self.pages.fly(message, self)
        else:
            return False
        return True

    async def reject(self, seq: int, text: str, *, counts: bool = True) -> None:
        """Report a rejected message to the page; `counts`: whether the rejection counts towards `MAX_REJECTIONS`."""
        self.rejections += counts
        if self.rejections >= MAX_REJECTIONS:
            self.why_closed = f"{MAX_REJECTIONS} consecutive messages were rejected"
        elif not self._may_be_rejected.take():
            self.why_closed = f"more than {REJECTIONS_PER_SECOND:g} messages a second were rejected"
        await self._send(to_page.Refused(seq, text))

    # --- to the page --------------------------------------------------------------------------------------

    async def _send_changes(self) -> None:
        """Send everything that is new whenever something changes; skip older frames (`News`)."""
        scenarios, readiness = None, None
        news = News(self, may_fly=self.may_fly, strips=self.strips)
        polygons: dict[str, bytes] = {}
        while self.pages.driver.phase is not Phase.CLOSED:
            fresh = self.pages.fresh  # get the event before the data, so that no later change is missed
            session = self.pages.session
            for message in news.welcome(session):
                await send_text(self.socket, message)
            while self.answers:
                await self._send(self.answers.popleft())
            if (choice := self.pages.choice.message()) != scenarios:
                scenarios = choice
                await self._send(choice)
            for message in news.role(session):
                await send_text(self.socket, message)
            if (state := self.pages.readiness()) != readiness:
                readiness = state
                await self._send(state)
            for shot in {shot_of(picture) for picture in self.pages.polygons.get(self, ())}:
                picture = session.painter.drawn.get(shot)
                if picture is not None and picture is not polygons.get(shot.camera):
                    polygons[shot.camera] = picture
                    await send_text(self.socket, picture)
            for message in news.run(session):
                await send_text(self.socket, message)
            if (driver := self.pages.driver).phase is Phase.FAILED:
                await goodbye(self.socket, driver.failure)
                return
            await fresh.wait()
