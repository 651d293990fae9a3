"""Definitions that the messages in both directions share. `from_page` and `to_page` define the messages.

Messages are JSON objects; their ``type`` is the tag of the struct. The page's TypeScript is generated from these types
(``make generate``). All quantities are SI and radians. The *panel* components of a position are X = -Xo, Y = Yo,
Z = -Zo; those of an attitude are pitch, yaw, roll, applied in this order. The *scene* frame has x aft, y starboard,
z up; its origin is at Xo 942, Yo 0, Zo 400 inches. Quaternions are wxyz.
"""

from __future__ import annotations

from typing import Annotated, Literal

import msgspec

PROTOCOL = 8
"""Version of this protocol; in the handshake, the server rejects a page of another version."""

MAX_MESSAGE_BYTES = 16_384
"""Longest message that the server accepts from a page [bytes].

Only a `Controllers` message can come near this length; all other messages have fewer than 600 bytes.
"""

Quat = tuple[float, float, float, float]
Rate = Literal["coarse", "vernier"]
LawChoice = Literal["position", "closed loop", "open loop"]
Level = Literal["info", "caution", "warning"]
EffectorSwitch = Literal["stop", "close", "open"]
ProblemPart = Literal["full problem", "acquisition", "extraction", "manoeuvring"]
ControllerKind = Literal["keyboard", "pad", "thc pad", "rhc pad", "thc joystick", "rhc joystick", "spacemouse", "touch"]
Binding = Annotated[str, msgspec.Meta(pattern=r"^[A-Za-z0-9+]{1,16} [A-Za-z0-9+ -]{1,16}$")]
WaitsFor = Literal["", "page", "laws"]
Offset = Annotated[float, msgspec.Meta(ge=-0.3, le=0.3)]
Seq = Annotated[int, msgspec.Meta(ge=0, le=2**53 - 1)]
"""Sequence number of a page's message: an integer that JavaScript represents exactly."""
Name = Annotated[str, msgspec.Meta(max_length=64)]
Monitor = Annotated[tuple[Name, ...], msgspec.Meta(min_length=1, max_length=2)]
"""Names of the cameras that a monitor shows: one, or two for a split monitor, the left half first."""


class WireMessage(msgspec.Struct, frozen=True, forbid_unknown_fields=True, tag_field="type"):
    """Base class of frozen, tagged messages that reject unknown fields."""
