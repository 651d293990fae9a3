"""Modes in a scenario, given by panel position or by the report's number; checks of what a mode needs.

Some modes need a payload, others need the points of a sequence.
"""

from __future__ import annotations

from dataclasses import dataclass

from aftdeck.files import Where
from aftdeck.scenario.model import Sequences
from aftdeck.scenario.problems import Problems
from aftdeck.steering.mode import AUTOMATIC_LAWS, MODES, LawChoice, position_of

MIXED = 7
"""Number of the report's mode that ORB LD uses when it rotates in payload axes."""
_LAWS: dict[int, LawChoice] = {number: law for law, number in AUTOMATIC_LAWS.items()}


@dataclass(frozen=True)
class Chosen:
    """A mode, with the switch settings that its number determines.

    The number is one of the report's numbers 1 to 8. A mode that is given by panel position determines no settings.

    Attributes:
        position: position of the MODE rotary.
        law: steering law, one of the report's modes 1 to 3; None if the number does not determine it.
        payload_axes: whether ORB LD rotates in payload axes; None if the number does not determine it.
    """

    position: str
    law: LawChoice | None = None
    payload_axes: bool | None = None


def chosen_mode(problems: Problems, given: int | str, where: Where) -> Chosen | None:
    """Return the mode of a panel position or of one of the report's numbers 1 to 8; None if no such mode exists."""
    if isinstance(given, str) and given in MODES:
        return Chosen(MODES[given].position)
    if isinstance(given, int) and (found := position_of(given)):
        position, number = found
        return Chosen(position, _LAWS.get(number), True if number == MIXED else None)
    problems.add(where, f"no mode {given!r}: modes are 1 to 8, or a position of the panel: {', '.join(MODES)}")
    return None


def check_mode(problems: Problems, position: str, loads: bool, sequences: Sequences, where: Where) -> None:
    """Report a mode that needs a payload or a sequence that the scenario does not have."""
    if MODES[position].loaded and not loads:
        problems.add(
            where, f"{position} moves a payload, and the scenario has none: add a [payload] table or a [[cargo]]"
        )
    if MODES[position].prestored and position not in sequences:
        problems.add(where, f"{position} has no points: add a [[sequence]] with slot = {position[-1]}")
