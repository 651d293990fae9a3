"""Access control of a station: rejection of requests from other sites' pages."""

from __future__ import annotations

from urllib.parse import urlsplit

from starlette.applications import Starlette
from starlette.responses import PlainTextResponse
from starlette.types import ASGIApp, Receive, Scope, Send
from starlette.websockets import WebSocket


class OwnOriginOnly:
    """Middleware that rejects requests from other sites' pages, and requests with a foreign host name."""

    def __init__(self, app: ASGIApp, hosts: frozenset[str] | None) -> None:
        self._app, self._hosts = app, hosts

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass on a request, or reject it if it comes from another site's page or has a foreign host name."""
        if scope["type"] not in ("http", "websocket") or self._own(scope):
            await self._app(scope, receive, send)
        elif scope["type"] == "websocket":
            await WebSocket(scope, receive, send).close(1008)
        else:
            await PlainTextResponse("only this station's own pages may send requests\n", 403)(scope, receive, send)

    def _own(self, scope: Scope) -> bool:
        headers = {name: value.decode("latin-1") for name, value in scope["headers"]}
        host = headers.get(b"host", "")
        if self._hosts is not None and _host_name(f"//{host}") not in self._hosts:
            return False
        origin = headers.get(b"origin")
        return origin is None or origin in (f"http://{host}", f"https://{host}")


def _host_name(url: str) -> str | None:
    """Return the host of a URL in lower case; None if the URL has no valid host."""
    try:
        return urlsplit(url).hostname
    except ValueError:
        return None


def keep_to_own(app: Starlette, host: str) -> Starlette:
    """Add `OwnOriginOnly` to the app, and return the app; `host` is the address on which the app listens."""
    everywhere = host in ("0.0.0.0", "::")  # all interfaces: any host name may belong to this machine
    app.add_middleware(
        OwnOriginOnly, hosts=None if everywhere else frozenset({host.lower(), "127.0.0.1", "localhost", "::1"})
    )
    return app
