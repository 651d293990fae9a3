"""``python -m benchmarks.linear_models``: plants against their linear models, as a table in Markdown.

The Shuttle's arm is half stretched, on a fixed orbiter in empty space. Commands are a sine of the rate of shoulder
pitch; forces push the tip down for `LASTS`. *Difference* is the greatest distance between the true tips of plant and
linear model, as a share of the greatest displacement of the linear model's: first with friction and the steps of
encoders and tachometers set to zero, then as they are.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from typing import NamedTuple

import numpy as np

from aftdeck.analysis.dynamics import dynamics
from aftdeck.analysis.linear_model import LinearModel
from aftdeck.analysis.linearise import Engaged
from aftdeck.arrays import Array
from aftdeck.units import POUND
from benchmarks.plant_answers import PlantAnswers, scenario_of

POSE = np.radians([0.0, 60.0, -80.0, -20.0, 0.0, 0.0])
"""Joint angles: the arm is half stretched, and its end effector points down [rad]."""
LASTS, FREQUENCY = 20.0, 0.1
"""Time of an answer [s], and frequency of the commands [Hz]: two cycles."""


class Case(NamedTuple):
    """Row of the table: what acts on the joints, the payload [lb], and sizes of the input [deg/s or N]."""

    engaged: Engaged
    pounds: float
    sizes: tuple[float, ...]


class Size(NamedTuple):
    """Rows of the table, by plant."""

    cases: dict[str, tuple[Case, ...]]


LIGHT, HEAVY, FORCES = (0.01, 0.1, 1.0), (0.003, 0.01, 0.03), (1.0, 10.0, 50.0)
MOVING = (
    Case("servos", 0.0, LIGHT),
    Case("servos", 32_000.0, HEAVY),
    Case("hold", 0.0, FORCES),
    Case("hold", 32_000.0, FORCES),
)
BRAKED = (Case("brakes", 0.0, FORCES), Case("brakes", 32_000.0, FORCES))
"""Not on the rigid plant: the tip moves by less than 1 mm there."""
FULL = Size({"rigid": MOVING, "flexible": MOVING + BRAKED})
TINY = Size({"rigid": (Case("servos", 0.0, (0.1,)),)})


def given(model: LinearModel, engaged: Engaged, size: float) -> Array:
    """Return the inputs (k, m): a sine of shoulder pitch [deg/s], or a steady force on the tip [N]."""
    steps = round(LASTS / model.period)
    inputs = np.zeros((steps, len(model.inputs)))
    if engaged == "servos":
        phase = 2.0 * math.pi * FREQUENCY * model.period * np.arange(steps)
        inputs[:, model.inputs.index("rate.shoulder_pitch")] = math.radians(size) * np.sin(phase)
    else:
        inputs[:, model.inputs.index("force.z")] = size
    return inputs


def tips(case: Case, *, flexible: bool) -> Iterator[tuple[float, float, float]]:
    """Yield for each size the greatest displacement of the linear model's tip [m], and the differences as shares of it.

    The first difference is without friction and steps of encoders and tachometers, the second with both [1].
    """
    arm = dynamics("srms", payload=case.pounds * POUND if case.pounds else None, flexible=flexible)
    model = arm.linear(POSE, case.engaged)
    place = model.outputs.index("tip.x")
    for size in case.sizes:
        inputs = given(model, case.engaged, size)
        expected = model.response(inputs)[:, place : place + 3]
        moves, apart = float(np.linalg.norm(expected, axis=1).max()), []
        for exact in (True, False):
            scenario = scenario_of("srms", POSE, arm.payload, flexible=flexible, exact=exact)
            found = PlantAnswers(scenario).to(inputs, case.engaged)[:, place : place + 3]
            apart.append(float(np.linalg.norm(found - expected, axis=1).max()) / moves)
        yield moves, apart[0], apart[1]


def table(size: Size) -> Iterator[str]:
    """Yield the lines of the table."""
    yield "| plant | payload, lb | engaged | input | tip moves by, mm | difference without friction and steps | with |"
    yield "|---|---|---|---|---|---|---|"
    for plant, cases in size.cases.items():
        for case in cases:
            moves, without, having = zip(*tips(case, flexible=plant == "flexible"), strict=True)
            unit = "°/s" if case.engaged == "servos" else "N"
            cells = (
                plant,
                f"{case.pounds:,.0f}" if case.pounds else "none",
                case.engaged,
                f"{_row(case.sizes)} {unit}",
                _row([1e3 * one for one in moves]),
                f"{_row([100.0 * one for one in without])} %",
                f"{_row([100.0 * one for one in having])} %",
            )
            yield f"| {' | '.join(cells)} |"


def _row(values: Iterable[float]) -> str:
    return " · ".join(f"{float(f'{value:.2g}'):g}" for value in values)


if __name__ == "__main__":
    for line in table(FULL):
        print(line, flush=True)
