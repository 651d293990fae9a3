"""Gathering what is wrong with a scenario file, so that all of it is told at once."""

from __future__ import annotations

from collections.abc import Sequence

from aftdeck.files import Problem, Where, sentences


class Problems:
    """What has been found wrong so far, in the order found; true where there is anything.

    A place in which something was wrong already is not complained of again, nor what stands around it: the rest
    of it may only look wrong for want of what had to be left out.
    """

    def __init__(self, found: Sequence[Problem] = ()) -> None:
        self._found = list(found)
        self._known = [problem.where for problem in found]

    def __bool__(self) -> bool:
        return bool(self._found)

    def wrong(self, where: Where, what: str) -> None:
        """Note that `what` is wrong at the place `where` in the file."""
        if not any(_inside(where, known) or _inside(known, where) for known in self._known):
            self._found.append(Problem(where, what))

    def sentences(self, file: str, text: str) -> list[str]:
        """A sentence for each, with its line in `text`; `file` stands for the file."""
        return sentences(self._found, file, text)


def _inside(place: Where, other: Where) -> bool:
    """Whether a place is another or within it."""
    return place[: len(other)] == other
