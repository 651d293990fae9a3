"""Options and checks that the commands ``render`` and ``planes`` share."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from aftdeck.errors import InputError

if TYPE_CHECKING:
    from aftdeck.scenario.light import LightCondition
    from aftdeck.scenario.model import Scenario

Run = Annotated[
    str,
    typer.Argument(
        metavar="SCENARIO|RECORDING|WORDS",
        help="A scenario, whose script is run; a recording (.mcap); or the 1972 report's frame words (.jsonl).",
    ),
]
WordsOf = Annotated[
    str | None,
    typer.Option("--words-of", metavar="SCENARIO", help="Scenario of the frame words; default: concept-1972."),
]
SIZE = (800, 600)
"""Default size of a picture [pixels]."""


def not_negative(option: str, value: float | None) -> None:
    """Raise `InputError` if the value of an option, in seconds, is negative or not finite."""
    if value is not None and not 0.0 <= value < float("inf"):
        raise InputError(f"{option}: got {value:g}, expected seconds, at least 0")


def light_of(scenario: Scenario, name: str | None) -> LightCondition:
    """Return the light condition of a name; None: that of the scenario. Raise `InputError` if there is none."""
    from aftdeck.scenario.light import condition_named

    return condition_named(scenario.lighting.condition if name is None else name)
