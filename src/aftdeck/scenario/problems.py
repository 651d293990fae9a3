"""Collection of the problems in a scenario file, so that all are reported at once."""

from __future__ import annotations

from collections.abc import Sequence

from aftdeck.files import Problem, Where, sentences


class Problems:
    """Problems found so far, in the order found. The object is true if it contains a problem.

    The problems given at construction belong to fields that could not be decoded and were left out. `add` ignores a
    problem if its place equals, contains or is inside the place of such a field: the problem may be a consequence of
    the missing field.
    """

    def __init__(self, found: Sequence[Problem] = ()) -> None:
        self._found = list(found)
        self._known = [problem.where for problem in found]

    def __bool__(self) -> bool:
        return bool(self._found)

    def add(self, where: Where, what: str) -> None:
        """Add the problem `what` at the place `where` in the file."""
        if not any(_inside(where, known) or _inside(known, where) for known in self._known):
            self._found.append(Problem(where, what))

    def in_tables(self, name: str) -> list[Problem]:
        """Return the problems inside tables of this name."""
        return [problem for problem in self._found if name in problem.where]

    def sentences(self, file: str, text: str) -> list[str]:
        """Return one sentence per problem, with the number of the problem's line.

        Args:
            file: the file's name in the sentences.
            text: content of the file, in which the lines are found.
        """
        return sentences(self._found, file, text)


def _inside(place: Where, other: Where) -> bool:
    """Return whether `place` equals `other` or is inside it."""
    return place[: len(other)] == other
