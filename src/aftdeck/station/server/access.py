"""Access to a station: on its own machine everyone may fly; over a network, an address needs a key.

A station that listens on the loopback interface has no keys. On any other interface, the first part of a page's path is
a key: one key for flying, another for observing. Without a key, the server answers with one sentence.
"""

from __future__ import annotations

import hmac
import ipaddress
import secrets
import socket
from typing import Literal, NamedTuple

Role = Literal["fly", "watch"]

KEY_BYTES = 16
"""Length of a random key [bytes]; its text has a third more characters."""
_ANYWHERE = ("192.0.2.1", 9)
"""Address reserved for documentation (RFC 5737). Choosing a route to it shows this machine's own address."""


class Access(NamedTuple):
    """Names under which pages may address a server, and the keys that their addresses need.

    Attributes:
        names: host names and addresses, in lower case, that a request may name.
        addresses: whether a request may also name any numeric address. Only a name can lead a browser to a machine that
            the name's owner has chosen (DNS rebinding).
        keys: key of each role; empty if everyone may fly.
    """

    names: frozenset[str]
    addresses: bool = False
    keys: tuple[tuple[Role, str], ...] = ()

    def accepts(self, name: str | None) -> bool:
        """Return whether a request may name this host."""
        return name is not None and (name in self.names or (self.addresses and _is_address(name)))

    def role(self, key: str) -> Role | None:
        """Return the role of a key; None if no role has this key."""
        found = [role for role, own in self.keys if hmac.compare_digest(own.encode(), key.encode())]
        return found[0] if found else None


_LOCAL_NAMES = frozenset({"127.0.0.1", "localhost", "::1"})
LOCAL = Access(_LOCAL_NAMES)
"""Access to a server that listens on the loopback interface."""


def access_of(listener: socket.socket, host: str, names: tuple[str, ...] = (), *, fly: bool = True) -> Access:
    """Return the access to a server.

    Args:
        listener: the server's socket.
        host: address or name on which the server was asked to listen.
        names: further host names that requests may use.
        fly: whether the server has a station, and not only a recording.
    """
    address = ipaddress.ip_address(listener.getsockname()[0].partition("%")[0])
    own = _LOCAL_NAMES | {host.lower(), *(name.lower() for name in names)}
    if address.is_loopback:
        return Access(own)
    roles: tuple[Role, ...] = ("fly", "watch") if fly else ("watch",)
    return Access(
        own, addresses=address.is_unspecified, keys=tuple((role, secrets.token_urlsafe(KEY_BYTES)) for role in roles)
    )


def shown_host(listener: socket.socket, host: str, names: tuple[str, ...] = ()) -> str:
    """Return the host for the addresses that the user passes on: the first stated name, else this machine's address."""
    if names:
        return names[0]
    if not ipaddress.ip_address(listener.getsockname()[0].partition("%")[0]).is_unspecified:
        return f"[{host}]" if ":" in host else host
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        try:
            probe.connect(_ANYWHERE)  # sends nothing
            return str(probe.getsockname()[0])
        except OSError:
            return "localhost"


def _is_address(name: str) -> bool:
    try:
        ipaddress.ip_address(name)
    except ValueError:
        return False
    return True
