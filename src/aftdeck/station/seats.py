"""Who flies: the page that came first, the next one when it leaves, and whoever it gives the sticks to; their names."""

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
"""The page that flies gives the sticks within this time of being asked, or keeps them [s]."""

MOST_OF_A_NAME = 24
"""Characters of a person's name."""

P = TypeVar("P")


@dataclass(frozen=True)
class Asked(Generic[P]):
    """A page wants the sticks."""

    page: P
    until: float
    """[s], as `time.monotonic`."""


class Seats(Generic[P]):
    """The pages of one flight, each with its number and the name of who sits there; one of them flies.

    Attributes:
        flier: the page that flies; None: there is none.
    """

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self.flier: P | None = None
        self._numbers: dict[P, int] = {}
        self._names: dict[P, str] = {}
        self._asked: Asked[P] | None = None
        self._clock = clock

    def __len__(self) -> int:
        return len(self._numbers)

    def number(self, page: P) -> int:
        """What a page is called without a name: the lowest number that was free when it came."""
        return self._numbers[page]

    def give_name(self, page: P, name: str) -> None:
        """Who sits at a page; empty: nobody in particular.

        Raises:
            InputError: too long, not to be read on one line, or what a page without a name is called.
        """
        if re.fullmatch(r"page \d+", name, re.IGNORECASE):
            raise InputError(f"{name!r} is what a page without a name is called")
        self._names[page] = one_line("a name", name, MOST_OF_A_NAME) if name else ""

    def name(self, page: P) -> str:
        """The name that was given at a page; empty: none."""
        return self._names.get(page, "")

    def named(self) -> list[tuple[int, str]]:
        """Numbers and names of the pages that have one; of two alike each has its number behind it."""
        given = [(self._numbers[page], name) for page, name in self._names.items() if name]
        shown = {number: name for number, name in given}
        while alike := {name for name, pages in Counter(shown.values()).items() if pages > 1}:
            shown = {number: f"{name} {number}" if name in alike else name for number, name in shown.items()}
        return list(shown.items())

    def called(self, page: P) -> str:
        """What a page is called in a sentence."""
        number = self._numbers[page]
        return dict(self.named()).get(number, f"page {number}")

    def come(self, page: P) -> None:
        """Take a seat; whoever finds none that flies, flies."""
        taken = set(self._numbers.values())
        self._numbers[page] = next(n for n in range(1, len(taken) + 2) if n not in taken)
        if self.flier is None:
            self.flier = page

    def leave(self, page: P) -> None:
        """Leave the seat; the sticks go to the page longest here."""
        del self._numbers[page]
        self._names.pop(page, None)
        if self.asking == page:
            self._asked = None
        if self.flier == page:
            self.flier = next(iter(self._numbers), None)
            self._asked = None

    @property
    def asking(self) -> P | None:
        """The page that wants the sticks, until it is answered or `ANSWER_WITHIN` is over."""
        if self._asked is not None and self._clock() >= self._asked.until:
            self._asked = None
        return None if self._asked is None else self._asked.page

    def ask(self, page: P) -> None:
        """Ask for the sticks.

        Raises:
            CommandError: it has them, or another page is asking.
        """
        if page == self.flier:
            raise CommandError("you fly: there is nobody to ask for the sticks")
        if self.asking not in (None, page):
            raise CommandError(f"{self.called(self.who_asks())} has asked for the sticks already")
        self._asked = Asked(page, self._clock() + ANSWER_WITHIN)

    def answer(self, gives: bool) -> None:
        """Give the sticks to the page that asks, or keep them.

        Raises:
            CommandError: nobody asks.
        """
        page, self._asked = self.who_asks(), None
        if gives:
            self.flier = page

    def who_asks(self) -> P:
        """The page that asks.

        Raises:
            CommandError: nobody asks.
        """
        if (page := self.asking) is None:
            raise CommandError("nobody asks for the sticks, or no longer")
        return page
