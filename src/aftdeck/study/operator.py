"""Operator of a run: the scenario's script, or a synthetic pilot, for the scenario's duration at most."""

from __future__ import annotations

import importlib
from collections.abc import Callable
from typing import Any

from aftdeck.errors import InputError
from aftdeck.operators.spec import OperatorSpec
from aftdeck.scenario.model import Scenario
from aftdeck.schema_check import convert
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation

Operator = Callable[[Simulation], Inputs | None]
_PILOT = "aftdeck.operators.pilot"


def operator_of(table: dict[str, Any]) -> OperatorSpec:
    """Return the parameters of an operator from a table that has been checked."""
    return convert(table, OperatorSpec)


def inputs_of(scenario: Scenario, spec: OperatorSpec, seed: int) -> Operator | None:
    """Return the function that supplies the inputs of a run; None if the scenario's script does.

    Raises:
        InputError: there is no pilot, or it cannot fly the scenario.
    """
    if spec.kind == "script":
        return None
    try:
        pilot = importlib.import_module(_PILOT).pilot
    except ModuleNotFoundError as error:
        if error.name != _PILOT:
            raise
        raise InputError(f"operator.kind: {spec.kind!r} needs the module {_PILOT}, which this version lacks") from None
    inputs: Operator = pilot(scenario, spec, seed)
    ticks = scenario.ticks

    def until_the_end(sim: Simulation) -> Inputs | None:
        nonlocal ticks
        ticks -= 1
        return inputs(sim) if ticks >= 0 else None

    return until_the_end
