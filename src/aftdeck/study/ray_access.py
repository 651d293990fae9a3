"""Access to a Ray cluster: whether it answers at an address, and whether it asks for a token.

Ray sends a token only if RAY_AUTH_MODE is ``token`` (Ray 2.60, ``ray/_private/authentication``). With that variable
unset, ``ray start --head`` asks for a token if one is at hand, but a program that connects to an address sends none.
Therefore the cluster is asked first, with one call of its own protocol (gRPC), and RAY_AUTH_MODE is set where the
cluster needs it. Authentication is never switched off. A variable that the user has set keeps its value.

With TLS (RAY_USE_TLS) nothing is asked, and Ray's own settings hold.
"""

from __future__ import annotations

import os
import re
from pathlib import Path
from typing import Any, NamedTuple

from aftdeck.errors import InputError
from aftdeck.extra import needed

MODE, TOKEN, TOKEN_PATH = "RAY_AUTH_MODE", "RAY_AUTH_TOKEN", "RAY_AUTH_TOKEN_PATH"
TOKEN_FILE = Path(".ray", "auth_token")
"""File of a user's token, in the home folder."""
CLIENT = "ray://"
"""Beginning of the address of a cluster to which this machine does not belong."""
ADDRESS = re.compile(r"(ray://)?[^/]+:\d+")
WAIT_S = 15.0
"""Longest time until a cluster has answered [s]."""
HEAD_CALL = ("/ray.rpc.NodeInfoGcsService/CheckAlive", b"")
"""Call that the head of a cluster answers, and its argument: no nodes are asked for."""
CLIENT_CALL = ("/ray.rpc.RayletDriver/ClusterInfo", b"\x08\x06")
"""Call that the server of ``ray://`` addresses answers, and its argument: type PING (ray_client.proto)."""


class Token(NamedTuple):
    """A token, and where it was found."""

    value: str
    source: str


def token_at_hand() -> Token | None:
    """Return the token that Ray would send, or None if there is none; the order of the places is Ray's.

    Raises:
        InputError: the file that RAY_AUTH_TOKEN_PATH names cannot be read, or is empty.
    """
    if value := os.environ.get(TOKEN, "").strip():
        return Token(value, TOKEN)
    if named := os.environ.get(TOKEN_PATH, ""):
        if value := _text(Path(named)):
            return Token(value, f"{TOKEN_PATH} ({named})")
        raise InputError(f"{TOKEN_PATH} is {named!r}, which is not a file with a token")
    try:
        path = Path.home() / TOKEN_FILE
    except RuntimeError:  # this user has no home folder
        return None
    value = _text(path)
    return Token(value, str(path)) if value else None


def mode_for(address: str) -> str | None:
    """Return the value that RAY_AUTH_MODE needs for a cluster; None: it needs none, or the user has set it.

    Args:
        address: ``HOST:PORT`` of the head, or ``ray://HOST:PORT``.

    Raises:
        InputError: the address is none, nothing answers at it, or the cluster asks for a token that is not at hand.
    """
    if not ADDRESS.fullmatch(address):
        raise InputError(f"--ray: got {address!r}, expected auto, local, HOST:PORT or {CLIENT}HOST:PORT")
    if os.environ.get("RAY_USE_TLS", "0").lower() in ("1", "true"):
        return None
    mode = os.environ.get(MODE)
    if not _asks_for_a_token(address, None):
        if mode is not None and mode.lower() == "token":
            raise InputError(f"--ray {address}: this cluster has no authentication, but {MODE} is {mode!r}; unset it")
        return None
    if mode is not None and mode.lower() != "token":
        raise InputError(f"--ray {address}: this cluster asks for a token, but {MODE} is {mode!r}; unset it")
    token = token_at_hand()
    if token is None:
        raise InputError(
            f"--ray {address}: this cluster asks for a token, and none is at hand; copy ~/{TOKEN_FILE} of the "
            f"cluster's first machine to the same place here, or set {TOKEN}"
        )
    if _asks_for_a_token(address, token.value):
        raise InputError(
            f"--ray {address}: this cluster does not accept the token in {token.source}; replace it by the one in "
            f"~/{TOKEN_FILE} of the cluster's first machine"
        )
    return "token" if mode is None else None


def _asks_for_a_token(address: str, token: str | None) -> bool:
    """Return whether a cluster rejects a call because of its token.

    Raises:
        InputError: what answers is not Ray, or nothing answers.
    """
    grpc: Any = needed("grpc", "ray")
    method, argument = CLIENT_CALL if address.startswith(CLIENT) else HEAD_CALL
    target, codes = address.removeprefix(CLIENT), grpc.StatusCode
    with grpc.insecure_channel(target, options=(("grpc.enable_http_proxy", 0),)) as channel:
        given = () if token is None else (("authorization", f"Bearer {token}"),)
        try:
            channel.unary_unary(method)(argument, timeout=WAIT_S, metadata=given)
        except grpc.RpcError as error:
            code = error.code()
        else:
            return False
    if code is codes.UNAUTHENTICATED:
        return True
    if code in (codes.UNAVAILABLE, codes.DEADLINE_EXCEEDED):
        raise InputError(f"--ray {address}: no Ray cluster answers at this address")
    raise InputError(
        f"--ray {address}: what answers at this address is no Ray cluster ({code.name}); HOST:PORT has the port of "
        "`ray start --head --port=PORT`, ray://HOST:PORT that of --ray-client-server-port, 10001 by default"
    )


def _text(path: Path) -> str:
    """Return the text of a file without the space around it; "" if the file cannot be read."""
    try:
        return path.read_text(encoding="utf-8-sig").strip()
    except (OSError, UnicodeDecodeError):
        return ""
