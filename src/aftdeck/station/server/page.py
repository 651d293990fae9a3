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
from aftdeck.station.session.recent import Mark
from aftdeck.station.session.session import Phase

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


class Page:
    """One connected page, from hello to goodbye.

    Attributes:
        answers: messages that `Pages` queues for it; its own sender sends them, so that no page waits for another.
    """

    def __init__(self, pages: Pages, socket: WebSocket) -> None:
        self.pages, self.socket = pages, socket
        self.welcomed, self.shows, self.strips = pages.session, False, False
        self.seq = -1
        self.wrong = 0
        self.answers: deque[to_page.Refused] = deque()

    async def serve(self) -> None:
        """Do the handshake, then receive and send until one side disconnects."""
        if not await self._handshake():
            return
        self.pages.come(self)
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

    async def _handshake(self) -> bool:
        try:
            text = await asyncio.wait_for(self.socket.receive_text(), HELLO_WITHIN)
            hello = _hello.decode(text)
        except TimeoutError:
            return await self._goodbye(f"no hello came within {HELLO_WITHIN:g} s")
        except (msgspec.MsgspecError, KeyError, RecursionError) as error:
            return await self._goodbye(f"the first message must be a hello with the protocol's number: {error}")
        if hello.protocol != kinds.PROTOCOL:
            return await self._goodbye(
                f"this page speaks protocol {hello.protocol}, the station {kinds.PROTOCOL}: reload the page"
            )
        if len(self.pages.seats) + len(self.pages.windows) >= MOST_PAGES:
            return await self._goodbye(f"{MOST_PAGES} pages are connected already")
        self.welcomed, self.shows, self.strips = self.pages.session, hello.shows, hello.strips
        await self._send(self.welcomed.welcome)
        return True

    async def _goodbye(self, text: str) -> bool:
        await self._send(to_page.Refused(-1, text))
        await self.socket.close(1008, text.encode()[:LONGEST_REASON].decode(errors="ignore"))
        return False

    async def _send(self, message: to_page.FromServer) -> None:
        await self.socket.send_text(_encoder.encode(message).decode())

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
        await self._goodbye(f"{MOST_WRONG} messages were refused; the connection is closed")

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
        if self.pages.seats.flier is not self:
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
        told: Mark | None = None
        while self.pages.session.phase is not Phase.CLOSED:
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
            if news := session.log_since(lines):
                lines += len(news)
                await self._send(to_page.Events(news))
            recent = session.recent.news(told) if self.strips else None
            if recent:
                message, told = recent
                await self._send(message)
            if (frame := session.newest) is not sent and (recent or not self.strips):
                sent = frame
                await self.socket.send_text(frame.decode())
            if session.phase is Phase.FAILED:
                await self._goodbye(session.failure)
                return
            await fresh.wait()
