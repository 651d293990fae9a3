"""Who took part in a flight, and under which condition: a study's own words, kept in the recording alone."""

from __future__ import annotations

from typing import NamedTuple

from aftdeck.lines import one_line

MOST_OF_A_PARTICIPANT = 40
"""Characters of a participant's code."""
MOST_OF_A_CONDITION = 120
"""Characters of a condition."""


class Trial(NamedTuple):
    """What a study says of a flight; an empty word says nothing. No page that flies is told of it."""

    participant: str = ""
    condition: str = ""


NO_TRIAL = Trial()


def trial(participant: str | None, condition: str | None) -> Trial:
    """A trial in these words, or in none.

    Raises:
        InputError: words that are too long, or that do not stand on one line.
    """
    return Trial(
        "" if participant is None else one_line("a participant's code", participant, MOST_OF_A_PARTICIPANT),
        "" if condition is None else one_line("a condition", condition, MOST_OF_A_CONDITION),
    )
