"""Who may talk to a station: its own pages alone."""

from __future__ import annotations

from urllib.parse import urlsplit

from starlette.applications import Starlette
from starlette.responses import PlainTextResponse
from starlette.types import ASGIApp, Receive, Scope, Send
from starlette.websockets import WebSocket


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


def keep_to_own(app: Starlette, host: str) -> Starlette:
    """The app, which from now on answers its own page alone; `host` is what it listens on."""
    everywhere = host in ("0.0.0.0", "::")  # the caller's wish: any name may be ours
    app.add_middleware(
        OwnOriginOnly, hosts=None if everywhere else frozenset({host.lower(), "127.0.0.1", "localhost", "::1"})
    )
    return app
