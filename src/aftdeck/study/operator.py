"""Operator of a run: the scenario's script, or a synthetic pilot, for the scenario's duration at most."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from aftdeck.operators.pilot import Pilot, pilot
from aftdeck.operators.spec import OperatorSpec
from aftdeck.scenario.model import Scenario
from aftdeck.schema_check import convert
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation

Operator = Callable[[Simulation], Inputs | None]


def operator_of(table: dict[str, Any]) -> OperatorSpec:
    """Return the parameters of an operator from a table that has been checked."""
    return convert(table, OperatorSpec)


def pilot_of(scenario: Scenario, spec: OperatorSpec, seed: int) -> Pilot | None:
    """Return the pilot of a run; None if the scenario's script supplies the inputs.

    Raises:
        InputError: a pilot cannot fly the scenario.
    """
    return None if spec.kind == "script" else pilot(scenario, spec, seed)


def until_the_end(flown: Pilot, ticks: int) -> Operator:
    """Return the inputs of a pilot, for a number of control steps at most."""
    left = iter(range(ticks))
    return lambda sim: None if next(left, None) is None else flown(sim)
