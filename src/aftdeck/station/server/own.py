"""Requests that a server answers: those of its own pages, under its own names, and with a key if it needs one."""

from __future__ import annotations

from urllib.parse import urlsplit

from starlette.applications import Starlette
from starlette.datastructures import Headers
from starlette.responses import PlainTextResponse, RedirectResponse, Response
from starlette.types import ASGIApp, Receive, Scope, Send
from starlette.websockets import WebSocket

from aftdeck.station.server.access import Access
from aftdeck.station.server.policy import Policy

MAY_FLY = "aftdeck.may_fly"
"""Key of a scope: whether the request's address allows flying."""
OWN_SITES = ("same-origin", "none")
"""Values of Sec-Fetch-Site (W3C, Fetch Metadata Request Headers) of the station's own pages, and of a typed address.

Servers on other ports of the same machine are ``same-site``.
"""
FOREIGN = "only this station's own pages may send requests\n"
NO_KEY = (
    "This address has no key. Ask the person who started the station for the whole address; one address is for flying, "
    "another for observing.\n"
)


class OwnPagesOnly:
    """Middleware that rejects requests of other sites' pages, under foreign names, or without a key."""

    def __init__(self, app: ASGIApp, access: Access) -> None:
        self._app, self._access = app, access

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass a request on without the key in its path, or reject it."""
        if scope["type"] not in ("http", "websocket"):
            return await self._app(scope, receive, send)
        if not self._own(scope):
            return await _reject(PlainTextResponse(FOREIGN, 403), scope, receive, send)
        if not self._access.keys:
            return await self._app({**scope, MAY_FLY: True}, receive, send)
        key, slash, _ = scope["path"].removeprefix("/").partition("/")
        role = self._access.role(key)
        if role is None:
            return await _reject(PlainTextResponse(NO_KEY, 403), scope, receive, send)
        if not slash:
            return await _reject(RedirectResponse(f"{key}/"), scope, receive, send)
        inner = {**scope, "root_path": f"{scope.get('root_path', '')}/{key}", MAY_FLY: role == "fly"}
        return await self._app(inner, receive, send)

    def _own(self, scope: Scope) -> bool:
        headers = Headers(scope=scope)
        host = headers.get("host", "")
        origin = headers.get("origin")
        own_origin = origin is None or origin in (f"http://{host}", f"https://{host}")
        return own_origin and not _sent_elsewhere(headers) and self._access.accepts(_host_name(f"//{host}"))


def _sent_elsewhere(headers: Headers) -> bool:
    """Return whether a browser says that another site's page sends this request, and not to open the station.

    A browser sends no Origin with a request for a picture or a script. A link of another page may open the station in a
    whole tab: such a request reads nothing, and the other page cannot repeat it unseen.
    """
    opens = headers.get("sec-fetch-mode") == "navigate" and headers.get("sec-fetch-dest", "document") == "document"
    return headers.get("sec-fetch-site", "none") not in OWN_SITES and not opens


async def _reject(response: Response, scope: Scope, receive: Receive, send: Send) -> None:
    if scope["type"] == "websocket":
        await WebSocket(scope, receive, send).close(1008)
    else:
        await response(scope, receive, send)


def _host_name(url: str) -> str | None:
    """Return the host of a URL in lower case; None if the URL has no valid host."""
    try:
        return urlsplit(url).hostname
    except ValueError:
        return None


def keep_to_own(app: Starlette, access: Access) -> Starlette:
    """Add `OwnPagesOnly` and `Policy` to the app, and return the app."""
    app.add_middleware(OwnPagesOnly, access=access)
    app.add_middleware(Policy)  # outermost, so that rejections have its headers, too
    return app
