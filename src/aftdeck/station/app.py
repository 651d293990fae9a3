"""The station's server: the page's files, and one WebSocket per page."""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import AsyncIterator
from pathlib import Path
from urllib.parse import urlsplit

import msgspec
from starlette.applications import Starlette
from starlette.requests import Request
from starlette.responses import PlainTextResponse, Response
from starlette.routing import BaseRoute, Mount, Route, WebSocketRoute
from starlette.staticfiles import StaticFiles
from starlette.types import ASGIApp, Receive, Scope, Send
from starlette.websockets import WebSocket, WebSocketDisconnect

from aftdeck.errors import CommandError
from aftdeck.station import protocol as wire
from aftdeck.station.session import Phase, Session

STATIC = Path(__file__).parent / "static"
HELLO_WITHIN = 5.0
"""How long a page may take to say hello [s]."""
MOST_PAGES = 32
"""Pages connected at once."""
MOST_WRONG = 20
"""Messages refused one after the other after which a connection is closed."""
LONGEST_REASON = 123
"""Longest reason in a WebSocket's close frame [bytes]; RFC 6455, 5.5."""

_encoder = msgspec.json.Encoder()
_hello = msgspec.json.Decoder(wire.Hello)
_messages: msgspec.json.Decoder[wire.FromPage] = msgspec.json.Decoder(wire.FromPage)


class Pages:
    """The pages connected to one session: who flies, and waking their senders."""

    def __init__(self, session: Session) -> None:
        self.session = session
        self.pages: list[Page] = []
        self.fresh = asyncio.Event()

    def wake(self) -> None:
        """Tell every sender that there is something new."""
        self.fresh.set()
        self.fresh = asyncio.Event()

    @property
    def flier(self) -> Page | None:
        """The page that flies: the one longest here."""
        return self.pages[0] if self.pages else None

    def leave(self, page: Page) -> None:
        """Take a page off; the sticks go to zero if it flew."""
        if page is self.flier:
            self.session.let_go()
        self.pages.remove(page)


class Page:
    """One connected page, from hello to goodbye."""

    def __init__(self, pages: Pages, socket: WebSocket) -> None:
        self.pages, self.socket = pages, socket
        self.seq = -1
        self.wrong = 0

    async def serve(self) -> None:
        """Handshake, then receive and send until one side goes."""
        if not await self._handshake():
            return
        self.pages.pages.append(self)
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
        if hello.protocol != wire.PROTOCOL:
            return await self._goodbye(
                f"this page speaks protocol {hello.protocol}, the station {wire.PROTOCOL}: reload the page"
            )
        if len(self.pages.pages) >= MOST_PAGES:
            return await self._goodbye(f"{MOST_PAGES} pages are connected already")
        await self._send(self.pages.session.welcome)
        return True

    async def _goodbye(self, text: str) -> bool:
        await self._send(wire.Refused(-1, text))
        await self.socket.close(1008, text.encode()[:LONGEST_REASON].decode(errors="ignore"))
        return False

    async def _send(self, message: wire.FromServer) -> None:
        await self.socket.send_text(_encoder.encode(message).decode())

    # --- from the page ------------------------------------------------------------------------------------

    async def _receive(self) -> None:
        while self.wrong < MOST_WRONG:
            message = await self.socket.receive()
            if message["type"] == "websocket.disconnect":
                return
            text = message.get("text")
            if text is None:
                await self._refuse(-1, "messages are JSON text; this one was binary")
                continue
            await self._take(text)
        await self._goodbye(f"{MOST_WRONG} messages were refused; the connection is closed")

    async def _take(self, text: str) -> None:
        try:
            message = _messages.decode(text)
        except (msgspec.MsgspecError, RecursionError) as error:
            return await self._refuse(-1, f"message not understood: {error}")
        if message.seq <= self.seq:
            return await self._refuse(
                message.seq, f"message {message.seq} came after message {self.seq}; it was not taken"
            )
        self.seq = message.seq
        if self.pages.flier is not self:
            return await self._refuse(message.seq, "you watch; another page flies", counts=False)
        try:
            if isinstance(message, wire.Sticks):
                self.pages.session.steer(message)
            elif isinstance(message, wire.Shown):
                self.pages.session.shown(message)
            elif isinstance(message, wire.Controllers):
                self.pages.session.controllers_in_use(message)
            elif isinstance(message, wire.DriveCamera):
                self.pages.session.turn(message)
            elif isinstance(message, wire.SetLight):
                self.pages.session.light(message)
            else:
                self.pages.session.command(message)
        except CommandError as error:
            return await self._refuse(message.seq, str(error))
        self.wrong = 0

    async def _refuse(self, seq: int, text: str, *, counts: bool = True) -> None:
        self.wrong += counts
        await self._send(wire.Refused(seq, text))

    # --- to the page --------------------------------------------------------------------------------------

    async def _send_news(self) -> None:
        """Send role, log and newest frame whenever they change; frames that came meanwhile are skipped."""
        session = self.pages.session
        role, lines, sent = None, 0, b""
        while session.phase is not Phase.CLOSED:
            fresh = self.pages.fresh  # taken before looking, so that nothing new is missed
            now = wire.Role(self.pages.flier is self, len(self.pages.pages) - 1)
            if now != role:
                role = now
                await self._send(now)
            if news := session.log_since(lines):
                lines += len(news)
                await self._send(wire.Events(tuple(wire.Event(e.time_s, e.kind, e.level, e.text) for e in news)))
            if (frame := session.newest) is not sent:
                sent = frame
                await self.socket.send_text(frame.decode())
            if session.phase is Phase.FAILED:
                await self._goodbye(session.failure)
                return
            await fresh.wait()


class OwnOriginOnly:
    """Refuses requests that another site's page makes, and host names that are not this machine's."""

    def __init__(self, app: ASGIApp, hosts: frozenset[str] | None) -> None:
        self._app, self._hosts = app, hosts

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass on what comes from this station's own page."""
        if scope["type"] not in ("http", "websocket") or self._own(scope):
            await self._app(scope, receive, send)
        elif scope["type"] == "websocket":
            await WebSocket(scope, receive, send).close(1008)
        else:
            await PlainTextResponse("only this station's own page may talk to it\n", 403)(scope, receive, send)

    def _own(self, scope: Scope) -> bool:
        headers = {name: value.decode("latin-1") for name, value in scope["headers"]}
        host = headers.get(b"host", "")
        if self._hosts is not None and _host_name(f"//{host}") not in self._hosts:
            return False
        origin = headers.get(b"origin")
        return origin is None or origin in (f"http://{host}", f"https://{host}")


def _host_name(url: str) -> str | None:
    """The host in a URL, in lower case; None where there is none."""
    try:
        return urlsplit(url).hostname
    except ValueError:
        return None


def make_app(session: Session, host: str = "127.0.0.1") -> Starlette:
    """The server of a session; it starts to fly with the server and stops with it."""
    pages: Pages | None = None

    @contextlib.asynccontextmanager
    async def lifespan(_: Starlette) -> AsyncIterator[None]:
        nonlocal pages
        pages = Pages(session)
        loop = asyncio.get_running_loop()
        here = pages

        def told() -> None:
            with contextlib.suppress(RuntimeError):  # the loop is closing
                loop.call_soon_threadsafe(here.wake)

        session.start(told)
        try:
            yield
        finally:
            session.close()

    async def talk(socket: WebSocket) -> None:
        assert pages is not None, "the lifespan makes it before the first connection"
        await socket.accept()
        with contextlib.suppress(WebSocketDisconnect):
            await Page(pages, socket).serve()

    async def health(_: Request) -> Response:
        return PlainTextResponse(f"{session.phase.value}\n")

    routes: list[BaseRoute] = [WebSocketRoute("/ws", talk), Route("/health", health)]
    if (STATIC / "index.html").is_file():
        routes.append(Mount("/", StaticFiles(directory=STATIC, html=True)))
    return keep_to_own(Starlette(routes=routes, lifespan=lifespan), host)


def keep_to_own(app: Starlette, host: str) -> Starlette:
    """The app, which from now on answers its own page alone; `host` is what it listens on."""
    everywhere = host in ("0.0.0.0", "::")  # the caller's wish: any name may be ours
    app.add_middleware(
        OwnOriginOnly, hosts=None if everywhere else frozenset({host.lower(), "127.0.0.1", "localhost", "::1"})
    )
    return app
