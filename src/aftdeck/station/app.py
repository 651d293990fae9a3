"""The station's server: the page's files, and one WebSocket per page."""

from __future__ import annotations

import asyncio
import contextlib
import functools
from collections import deque
from collections.abc import AsyncIterator, Callable
from pathlib import Path
from threading import Thread
from urllib.parse import urlsplit

import msgspec
from starlette.applications import Starlette
from starlette.requests import Request
from starlette.responses import PlainTextResponse, Response
from starlette.routing import BaseRoute, Mount, Route, WebSocketRoute
from starlette.staticfiles import StaticFiles
from starlette.types import ASGIApp, Receive, Scope, Send
from starlette.websockets import WebSocket, WebSocketDisconnect

from aftdeck.errors import AftdeckError, CommandError, InputError
from aftdeck.station import protocol as wire
from aftdeck.station.choice import Choice
from aftdeck.station.recent import Mark
from aftdeck.station.seats import ANSWER_WITHIN, Seats
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

_AT_REST = (
    wire.Stop
    | wire.SetBrakes
    | wire.SetSafing
    | wire.HandsOff
    | wire.Shown
    | wire.Controllers
    | wire.SetLight
    | wire.GiveSticks
    | wire.KeepSticks
    | wire.FlyScenario
)
"""What is looked at while another scenario is made ready: nothing that moves the arm."""

_encoder = msgspec.json.Encoder()
_hello = msgspec.json.Decoder(wire.Hello)
_messages: msgspec.json.Decoder[wire.FromPage] = msgspec.json.Decoder(wire.FromPage)


class Pages:
    """The pages connected to one station: what is flown, who flies, and waking their senders."""

    def __init__(self, session: Session, told: Callable[[], None]) -> None:
        self.session, self._told = session, told
        self.choice = Choice(session.scenario)
        self.seats: Seats[Page] = Seats()
        self.windows: set[Page] = set()
        self.fresh = asyncio.Event()
        self.change: asyncio.Task[None] | None = None

    def wake(self) -> None:
        """Tell every sender that there is something new."""
        self.fresh.set()
        self.fresh = asyncio.Event()

    def fly(self, number: int, asking: Page) -> None:
        """Make another scenario ready and then fly it; the arm comes to rest meanwhile.

        Raises:
            CommandError: it cannot be chosen.
        """
        self.choice.choose(number)
        self.session.let_go("another scenario")
        self.wake()
        self.change = asyncio.create_task(self._change(number, asking))

    async def _change(self, number: int, asking: Page) -> None:
        """Leave the present session for another; where that cannot be made, the present one goes on."""
        before, choice = self.session, self.choice
        try:
            self.session = await _abandonable(lambda: before.another(choice.load(number)))
            choice.flown = number
            self.wake()
            await asyncio.to_thread(before.close)  # its recording is finished before the next begins
            self.session.start(self._told)
        except Exception as error:  # whoever asked must hear of it, whatever it was
            asking.answers.append(wire.Refused(-1, f"{choice.scenarios[number].title!r} cannot be flown: {error}"))
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

    def come(self, page: Page) -> None:
        """Take a page on: with hands it has a seat, one that only shows has none."""
        if page.shows:
            self.windows.add(page)
        else:
            self.seats.come(page)

    def leave(self, page: Page, cause: str = "page gone") -> None:
        """Take a page off, for one of `unattended.CAUSES`; the sticks go to zero if it flew."""
        if page.shows:
            self.windows.remove(page)
            return
        flew = page is self.seats.flier
        self.seats.leave(page)
        if flew:
            self.session.let_go(cause if self.seats.flier is None else f"{cause}, another flies")

    def reseat(self, page: Page, *, seated: bool) -> None:
        """A page has become wide enough to have hands, or too narrow for it."""
        if seated is not page.shows:
            return  # it is so already
        self.leave(page, "page narrow")
        page.shows = not seated
        self.come(page)
        self.wake()

    def role(self, page: Page) -> wire.Role:
        """What a page is told of who flies."""
        seats = self.seats
        number, flier, asking = (
            0 if one is None or one.shows else seats.number(one) for one in (page, seats.flier, seats.asking)
        )
        return wire.Role(
            flying=page is seats.flier,
            watchers=max(0, len(seats) - 1),
            number=number,
            flier=flier,
            asking=asking,
            name=seats.name(page),
            names=tuple(wire.NamedPage(*named) for named in seats.named()),
        )

    def name(self, page: Page, name: str) -> None:
        """Somebody says who he is.

        Raises:
            InputError: what can be no name.
        """
        self.seats.give_name(page, name)
        self.wake()

    def ask(self, page: Page) -> None:
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
            asked.answers.append(wire.Refused(asked.seq, f"{flier} keeps the sticks"))
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


class Page:
    """One connected page, from hello to goodbye.

    Attributes:
        answers: what others have it told; its own sender sends them, so that nobody waits for its connection.
    """

    def __init__(self, pages: Pages, socket: WebSocket) -> None:
        self.pages, self.socket = pages, socket
        self.welcomed, self.shows, self.strips = pages.session, False, False
        self.seq = -1
        self.wrong = 0
        self.answers: deque[wire.Refused] = deque()

    async def serve(self) -> None:
        """Handshake, then receive and send until one side goes."""
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
        if hello.protocol != wire.PROTOCOL:
            return await self._goodbye(
                f"this page speaks protocol {hello.protocol}, the station {wire.PROTOCOL}: reload the page"
            )
        if len(self.pages.seats) + len(self.pages.windows) >= MOST_PAGES:
            return await self._goodbye(f"{MOST_PAGES} pages are connected already")
        self.welcomed, self.shows, self.strips = self.pages.session, hello.shows, hello.strips
        await self._send(self.welcomed.welcome)
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
        if isinstance(message, wire.LeaveSeat | wire.TakeSeat):
            return self.pages.reseat(self, seated=isinstance(message, wire.TakeSeat))
        if isinstance(message, wire.AskSticks | wire.SetName) and not self.shows:
            try:
                if isinstance(message, wire.AskSticks):
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

    def _do(self, message: wire.FromPage) -> None:
        session = self.pages.session
        if self.pages.choice.coming is not None and not isinstance(message, _AT_REST):
            if isinstance(message, wire.Sticks | wire.DriveCamera):
                return  # on their way when the scenario was chosen
            raise CommandError("another scenario is made ready; the arm rests meanwhile")
        match message:
            case wire.GiveSticks() | wire.KeepSticks():
                self.pages.answer(isinstance(message, wire.GiveSticks))
            case wire.Sticks():
                session.steer(message)
            case wire.Shown():
                session.shown(message)
            case wire.Controllers():
                session.controllers_in_use(message)
            case wire.DriveCamera():
                session.turn(message)
            case wire.SetLight():
                session.light(message)
            case wire.FlyScenario():
                self.pages.fly(message.number, self)
            case _:
                session.command(message)

    async def refuse(self, seq: int, text: str, *, counts: bool = True) -> None:
        """Tell the page what was not taken; `counts`: among those after which the connection is closed."""
        self.wrong += counts
        await self._send(wire.Refused(seq, text))

    # --- to the page --------------------------------------------------------------------------------------

    async def _send_news(self) -> None:
        """Send scenarios, role, log and newest frame whenever they change; frames that came meanwhile are skipped.

        A window that draws strips gets a frame with every sample, and no others.
        """
        session = self.welcomed
        scenarios, role, lines, sent = None, None, 0, b""
        told: Mark | None = None
        while self.pages.session.phase is not Phase.CLOSED:
            fresh = self.pages.fresh  # taken before looking, so that nothing new is missed
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
                await self._send(wire.Events(tuple(wire.Event(e.time_s, e.kind, e.level, e.text) for e in news)))
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
    """The server that begins with this session: it starts to fly with the server and stops with it."""
    pages: Pages | None = None

    @contextlib.asynccontextmanager
    async def lifespan(_: Starlette) -> AsyncIterator[None]:
        nonlocal pages
        loop = asyncio.get_running_loop()

        def told() -> None:
            with contextlib.suppress(RuntimeError):  # the loop is closing
                loop.call_soon_threadsafe(here.wake)

        here = pages = Pages(session, told)
        session.start(told)
        try:
            yield
        finally:
            await here.close()

    async def talk(socket: WebSocket) -> None:
        assert pages is not None, "the lifespan makes it before the first connection"
        await socket.accept()
        with contextlib.suppress(WebSocketDisconnect):
            await Page(pages, socket).serve()

    async def health(_: Request) -> Response:
        return PlainTextResponse(f"{(pages.session if pages else session).phase.value}\n")

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
