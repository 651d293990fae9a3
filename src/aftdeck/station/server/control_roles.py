"""Control roles: which page is in control of the arm, requests for control, and the names of the pages.

The first page takes control. When it leaves, the page connected longest takes control. The page in control can also
give the sticks to a page that asks for them.
"""

from __future__ import annotations

import re
import time
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from typing import Generic, TypeVar

from aftdeck.errors import CommandError, InputError
from aftdeck.lines import one_line

ANSWER_WITHIN = 10.0
"""Time within which the page in control gives the sticks or keeps them, after a request [s]."""

MOST_OF_A_NAME = 24
"""Maximum number of characters of a person's name."""

P = TypeVar("P")


@dataclass(frozen=True)
class ControlRequest(Generic[P]):
    """Request of a page for the sticks."""

    page: P
    until: float
    """Time at which the request expires [s], on the clock of `time.monotonic`."""


class ControlRoles(Generic[P]):
    """Pages of one station, each with its number and the name of its user; one of them is in control.

    Attributes:
        operator: the page in control; None if there is none.
    """

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self.operator: P | None = None
        self._numbers: dict[P, int] = {}
        self._names: dict[P, str] = {}
        self._asked: ControlRequest[P] | None = None
        self._clock = clock

    def __len__(self) -> int:
        return len(self._numbers)

    def number(self, page: P) -> int:
        """Return the number of a page: the lowest number that was free when it came."""
        return self._numbers[page]

    def give_name(self, page: P, name: str) -> None:
        """Set the name of the person at a page; an empty name removes it.

        Raises:
            InputError: the name is too long, is not one line of visible text, or is reserved (``page 1``).
        """
        if re.fullmatch(r"page \d+", name, re.IGNORECASE):
            raise InputError(f"{name!r} is what a page without a name is called")
        self._names[page] = one_line("a name", name, MOST_OF_A_NAME) if name else ""

    def name(self, page: P) -> str:
        """Return the name that was given at a page; empty if none was given."""
        return self._names.get(page, "")

    def named(self) -> list[tuple[int, str]]:
        """Return numbers and names of the pages that have a name; the page's number is appended to equal names."""
        given = [(self._numbers[page], name) for page, name in self._names.items() if name]
        shown = {number: name for number, name in given}
        while alike := {name for name, pages in Counter(shown.values()).items() if pages > 1}:
            shown = {number: f"{name} {number}" if name in alike else name for number, name in shown.items()}
        return list(shown.items())

    def display_name(self, page: P) -> str:
        """Return the name of a page for use in a sentence; ``page 1`` for a page without a name."""
        number = self._numbers[page]
        return dict(self.named()).get(number, f"page {number}")

    def join(self, page: P) -> None:
        """Add a page; it takes control if no page is in control."""
        taken = set(self._numbers.values())
        self._numbers[page] = next(n for n in range(1, len(taken) + 2) if n not in taken)
        if self.operator is None:
            self.operator = page

    def leave(self, page: P) -> None:
        """Remove a page; if it was in control, the page that has been here longest takes control."""
        del self._numbers[page]
        self._names.pop(page, None)
        if self.asking == page:
            self._asked = None
        if self.operator == page:
            self.operator = next(iter(self._numbers), None)
            self._asked = None

    @property
    def asking(self) -> P | None:
        """Page that asks for the sticks, until it is answered or `ANSWER_WITHIN` is over; None if no page asks."""
        if self._asked is not None and self._clock() >= self._asked.until:
            self._asked = None
        return None if self._asked is None else self._asked.page

    def ask(self, page: P) -> None:
        """Request the sticks for a page.

        Raises:
            CommandError: the page has the sticks already, or another page is asking.
        """
        if page == self.operator:
            raise CommandError("you fly: there is nobody to ask for the sticks")
        if self.asking not in (None, page):
            raise CommandError(f"{self.display_name(self.pending_request())} has asked for the sticks already")
        self._asked = ControlRequest(page, self._clock() + ANSWER_WITHIN)

    def answer(self, gives: bool) -> None:
        """Give the sticks to the page that asks, or keep them.

        Raises:
            CommandError: no page asks for the sticks, or the request has expired.
        """
        page, self._asked = self.pending_request(), None
        if gives:
            self.operator = page

    def pending_request(self) -> P:
        """Return the page that asks for the sticks.

        Raises:
            CommandError: no page asks for the sticks, or the request has expired.
        """
        if (page := self.asking) is None:
            raise CommandError("nobody asks for the sticks, or no longer")
        return page
