"""Log line that a mechanism emits during a step; the simulation adds the time and logs it."""

from __future__ import annotations

from typing import Literal, NamedTuple


class LogLine(NamedTuple):
    """A line for the log.

    Attributes:
        kind: ``captured``, ``missed``, ``released``, ``rigid``, ``latched``, ``unlatched``, ``refused``.
        level: level of the log line.
        text: sentence for the operator.
    """

    kind: str
    level: Literal["info", "caution", "warning"]
    text: str


def rejection(text: str) -> LogLine:
    """Return the log line for a rejected command, with the reason as its text."""
    return LogLine("refused", "caution", text)
