"""Participant and condition of a run in a study: texts that recordings and the list of recordings store."""

from __future__ import annotations

from typing import NamedTuple

from aftdeck.lines import one_line

MAX_PARTICIPANT_LENGTH = 40
"""Maximum length of a participant's code [characters]."""
MAX_CONDITION_LENGTH = 120
"""Maximum length of a condition [characters]."""


class Trial(NamedTuple):
    """Participant and condition of a run in a study; empty if not given. No page of a live station receives them."""

    participant: str = ""
    condition: str = ""


NO_TRIAL = Trial()


def trial(participant: str | None, condition: str | None) -> Trial:
    """Return a trial with these texts; None becomes an empty text.

    Raises:
        InputError: a text is empty or too long, is not one printable line, or begins or ends with a space.
    """
    return Trial(
        "" if participant is None else one_line("a participant's code", participant, MAX_PARTICIPANT_LENGTH),
        "" if condition is None else one_line("a condition", condition, MAX_CONDITION_LENGTH),
    )
