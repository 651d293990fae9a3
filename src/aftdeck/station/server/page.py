"""One connected page: its handshake, its commands, and the messages sent to it."""

from __future__ import annotations

import asyncio
import contextlib
from collections import deque

import msgspec
from starlette.websockets import WebSocket, WebSocketDisconnect

from aftdeck.errors import CommandError, InputError
from aftdeck.station.messages import from_page, kinds, to_page
from aftdeck.station.server.pages import Pages
from aftdeck.station.session.driver import Phase
from aftdeck.station.session.recent import Mark

HELLO_WITHIN = 5.0
"""Time within which a page must send its hello [s]."""
MOST_PAGES = 32
"""Maximum number of pages connected at once."""
MOST_WRONG = 20
"""Number of consecutive rejected messages after which the connection is closed."""
LONGEST_REASON = 123
"""Longest reason in a WebSocket's close frame [bytes]; RFC 6455, 5.5."""

_AT_REST = (
    from_page.Stop
    | from_page.SetBrakes
    | from_page.SetSafing
    | from_page.HandsOff
    | from_page.Shown
    | from_page.Controllers
    | from_page.SetLight
    | from_page.GiveSticks
    | from_page.KeepSticks
    | from_page.FlyScenario
)
"""Messages accepted while another scenario is being prepared: none of them moves the arm."""

_encoder = msgspec.json.Encoder()
_hello = msgspec.json.Decoder(from_page.Hello)
_messages: msgspec.json.Decoder[from_page.FromPage] = msgspec.json.Decoder(from_page.FromPage)


async def send(socket: WebSocket, message: to_page.FromServer) -> None:
    """Send a message to a page."""
    await socket.send_text(_encoder.encode(message).decode())


async def goodbye(socket: WebSocket, text: str) -> None:
    """Send a page the reason for which its connection ends, and close the connection."""
    await send(socket, to_page.Refused(-1, text))
    await socket.close(1008, text.encode()[:LONGEST_REASON].decode(errors="ignore"))


async def greeted(socket: WebSocket) -> from_page.Hello | None:
    """Return the hello of a page that has connected; None after a goodbye to a page that does not say it right."""
    try:
        hello = _hello.decode(await asyncio.wait_for(socket.receive_text(), HELLO_WITHIN))
    except TimeoutError:
        await goodbye(socket, f"no hello came within {HELLO_WITHIN:g} s")
        return None
    except (msgspec.MsgspecError, KeyError, RecursionError) as error:
        await goodbye(socket, f"the first message must be a hello with the protocol's number: {error}")
        return None
    if hello.protocol != kinds.PROTOCOL:
        text = f"this page speaks protocol {hello.protocol}, the station {kinds.PROTOCOL}: reload the page"
        await goodbye(socket, text)
        return None
    return hello


class Page:
    """One connected page, from its welcome to goodbye.

    Attributes:
        answers: messages that `Pages` queues for it; its own sender sends them, so that no page waits for another.
    """

    def __init__(self, pages: Pages, socket: WebSocket, hello: from_page.Hello) -> None:
        self.pages, self.socket = pages, socket
        self.welcomed, self.shows, self.strips = pages.session, hello.shows, hello.strips
        self.seq = -1
        self.wrong = 0
        self.answers: deque[to_page.Refused] = deque()

    async def serve(self) -> None:
        """Welcome the page, then receive and send until one side disconnects."""
        if len(self.pages.seats) + len(self.pages.windows) >= MOST_PAGES:
            return await goodbye(self.socket, f"{MOST_PAGES} pages are connected already")
        await self._send(self.welcomed.welcome)
        self.pages.join(self)
        sender = asyncio.create_task(self._send_news())
        try:
            self.pages.wake()
            await self._receive()
        finally:
            sender.cancel()
            with contextlib.suppress(asyncio.CancelledError, WebSocketDisconnect, RuntimeError):
                await sender
            self.pages.leave(self)
            self.pages.wake()

    async def _send(self, message: to_page.FromServer) -> None:
        await send(self.socket, message)

    # --- from the page ------------------------------------------------------------------------------------

    async def _receive(self) -> None:
        while self.wrong < MOST_WRONG:
            message = await self.socket.receive()
            if message["type"] == "websocket.disconnect":
                return
            text = message.get("text")
            if text is None:
                await self.refuse(-1, "messages are JSON text; this one was binary")
                continue
            await self._take(text)
        await goodbye(self.socket, f"{MOST_WRONG} messages were refused; the connection is closed")

    async def _take(self, text: str) -> None:
        try:
            message = _messages.decode(text)
        except (msgspec.MsgspecError, RecursionError) as error:
            return await self.refuse(-1, f"message not understood: {error}")
        if message.seq <= self.seq:
            return await self.refuse(
                message.seq, f"message {message.seq} came after message {self.seq}; it was not taken"
            )
        self.seq = message.seq
        if isinstance(message, from_page.LeaveSeat | from_page.TakeSeat):
            return self.pages.reseat(self, seated=isinstance(message, from_page.TakeSeat))
        if isinstance(message, from_page.AskSticks | from_page.SetName) and not self.shows:
            try:
                if isinstance(message, from_page.AskSticks):
                    return self.pages.ask(self)
                return self.pages.name(self, message.name)
            except (CommandError, InputError) as error:
                return await self.refuse(message.seq, str(error), counts=False)
        if self.pages.seats.operator is not self:
            return await self.refuse(message.seq, "you watch; another page flies", counts=False)
        try:
            self._do(message)
        except CommandError as error:
            return await self.refuse(message.seq, str(error))
        self.wrong = 0

    def _do(self, message: from_page.FromPage) -> None:
        session = self.pages.session
        if self.pages.choice.coming is not None and not isinstance(message, _AT_REST):
            if isinstance(message, from_page.Sticks | from_page.DriveCamera):
                return  # sent before the page learned that a scenario was chosen
            raise CommandError("another scenario is made ready; the arm rests meanwhile")
        match message:
            case from_page.GiveSticks() | from_page.KeepSticks():
                self.pages.answer(isinstance(message, from_page.GiveSticks))
            case from_page.Sticks():
                session.steer(message)
            case from_page.Shown():
                session.shown(message)
            case from_page.Controllers():
                session.controllers_in_use(message)
            case from_page.DriveCamera():
                session.turn(message)
            case from_page.SetLight():
                session.light(message)
            case from_page.FlyScenario():
                self.pages.fly(message.number, self)
            case _:
                session.command(message)

    async def refuse(self, seq: int, text: str, *, counts: bool = True) -> None:
        """Report a rejected message to the page; `counts` is False if the message does not count for `MOST_WRONG`."""
        self.wrong += counts
        await self._send(to_page.Refused(seq, text))

    # --- to the page --------------------------------------------------------------------------------------

    async def _send_news(self) -> None:
        """Send scenarios, role, log and newest frame whenever they change, and skip older frames.

        A window that draws strips gets only the frames that come with a new sample.
        """
        session = self.welcomed
        scenarios, role, lines, sent = None, None, 0, b""
        mark: Mark | None = None
        while self.pages.driver.phase is not Phase.CLOSED:
            fresh = self.pages.fresh  # read before the news, so that no later change is missed
            if session is not self.pages.session:
                session, lines, sent = self.pages.session, 0, b""
                await self._send(session.welcome)
            while self.answers:
                await self._send(self.answers.popleft())
            if (choice := self.pages.choice.message()) != scenarios:
                scenarios = choice
                await self._send(choice)
            now = self.pages.role(self)
            if now != role:
                role = now
                await self._send(now)
            if news := session.log.since(lines):
                lines += len(news)
                await self._send(to_page.Events(news))
            recent = session.recent.news(mark) if self.strips else None
            if recent:
                message, mark = recent
                await self._send(message)
            if (frame := session.newest) is not sent and (recent or not self.strips):
                sent = frame
                await self.socket.send_text(frame.decode())
            if (driver := self.pages.driver).phase is Phase.FAILED:
                await goodbye(self.socket, driver.failure)
                return
            await fresh.wait()
