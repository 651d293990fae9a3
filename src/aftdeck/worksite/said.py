"""What a mechanism has to say of a step; the simulation stamps it with the time and logs it."""

from __future__ import annotations

from typing import Literal, NamedTuple


class Said(NamedTuple):
    """A line for the log.

    Attributes:
        kind: ``captured``, ``missed``, ``released``, ``rigid``, ``latched``, ``unlatched``, ``refused``.
        level: as the log has them.
        text: a sentence for people.
    """

    kind: str
    level: Literal["info", "caution", "warning"]
    text: str


def refused(text: str) -> Said:
    """A command that was not taken, and why."""
    return Said("refused", "caution", text)
