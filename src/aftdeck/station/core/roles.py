"""Control roles: the page in control of the arm, requests for control, and the names of the pages.

The first page takes control. When the page in control leaves, the remaining page that joined first takes control. The
page in control can also give the sticks to a page that asks for them. A page that may not fly never takes control.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from typing import Generic, TypeVar

from aftdeck.errors import CommandError, InputError
from aftdeck.lines import one_line

ANSWER_WITHIN = 10.0
"""Time after which a request for the sticks expires [s]."""

MAX_NAME_LENGTH = 24
"""Maximum number of characters of a person's name."""

P = TypeVar("P")


@dataclass(frozen=True)
class ControlRequest(Generic[P]):
    """Request of a page for the sticks."""

    page: P
    until: float
    """Time at which the request expires [s], on the host's clock."""


class ControlRoles(Generic[P]):
    """Pages of one station, each with a number and the name of its user; one page is in control.

    Attributes:
        operator: the page in control; None if no page is in control.
    """

    def __init__(self, clock: Callable[[], float]) -> None:
        """Begin without a page; `clock` returns the time [s]."""
        self.operator: P | None = None
        self._numbers: dict[P, int] = {}
        self._names: dict[P, str] = {}
        self._observing: set[P] = set()
        self._request: ControlRequest[P] | None = None
        self._clock = clock

    def __len__(self) -> int:
        return len(self._numbers)

    def __contains__(self, page: P) -> bool:
        return page in self._numbers

    def number(self, page: P) -> int:
        """Return the number of a page: the lowest number that was free when the page joined."""
        return self._numbers[page]

    def give_name(self, page: P, name: str) -> None:
        """Set the name of the person at a page, or remove the present name if `name` is empty.

        Raises:
            InputError: the name is too long, is not one line of visible text, or is reserved (``page 1``).
        """
        if re.fullmatch(r"page \d+", name, re.IGNORECASE):
            raise InputError(f"name {name!r} is reserved for pages without a name; choose another")
        self._names[page] = one_line("a name", name, MAX_NAME_LENGTH) if name else ""

    def name(self, page: P) -> str:
        """Return the name of the person at a page; empty if no name is set."""
        return self._names.get(page, "")

    def named(self) -> list[tuple[int, str]]:
        """Return the number and the name of each named page; append the number to a name that is not unique."""
        names = {self._numbers[page]: name for page, name in self._names.items() if name}
        while equal := {name for name, pages in Counter(names.values()).items() if pages > 1}:
            names = {number: f"{name} {number}" if name in equal else name for number, name in names.items()}
        return list(names.items())

    def display_name(self, page: P) -> str:
        """Return a page's name for use in a sentence: the name of the person at it; ``page 1`` if no name is set."""
        number = self._numbers[page]
        return dict(self.named()).get(number, f"page {number}")

    def join(self, page: P, *, may_fly: bool = True) -> None:
        """Add a page; it takes control if it may fly and no page is in control."""
        taken = set(self._numbers.values())
        self._numbers[page] = next(n for n in range(1, len(taken) + 2) if n not in taken)
        if not may_fly:
            self._observing.add(page)
        elif self.operator is None:
            self.operator = page

    def leave(self, page: P) -> None:
        """Remove a page; if it was in control, the remaining page that joined first takes control."""
        del self._numbers[page]
        self._names.pop(page, None)
        self._observing.discard(page)
        if self.asking == page:
            self._request = None
        if self.operator == page:
            self.operator = next((other for other in self._numbers if other not in self._observing), None)
            self._request = None

    @property
    def asking(self) -> P | None:
        """Page whose request for the sticks is pending; None if no request is pending."""
        if self._request is not None and self._clock() >= self._request.until:
            self._request = None
        return None if self._request is None else self._request.page

    def ask(self, page: P) -> None:
        """Request the sticks for a page.

        Raises:
            CommandError: the page may not fly or is in control already, or the request of another page is pending.
        """
        if page in self._observing:
            raise CommandError("this page's address is for observing; to fly, open the address for flying")
        if page == self.operator:
            raise CommandError("this page is in control already")
        if self.asking not in (None, page):
            raise CommandError(
                f"{self.display_name(self.pending_request())} is asking for the sticks; wait for the answer"
            )
        self._request = ControlRequest(page, self._clock() + ANSWER_WITHIN)

    def answer(self, gives: bool) -> None:
        """Answer the pending request: hand over control if `gives` is true; otherwise reject the request.

        Raises:
            CommandError: no page asks for the sticks, or the request has expired.
        """
        page, self._request = self.pending_request(), None
        if gives:
            self.operator = page

    def pending_request(self) -> P:
        """Return the page that asks for the sticks.

        Raises:
            CommandError: no page asks for the sticks, or the request has expired.
        """
        if (page := self.asking) is None:
            raise CommandError("no request for the sticks is pending: it was answered or has expired")
        return page
