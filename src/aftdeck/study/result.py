"""Row of a case in the table of results."""

from __future__ import annotations

from aftdeck.operators.spec import OperatorSpec
from aftdeck.report.metrics.steps import SHARE
from aftdeck.report.table import Row, cells
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.summary import Summary
from aftdeck.study.columns import OUTCOME
from aftdeck.study.design import Case
from aftdeck.study.plan import Plan
from aftdeck.study.watch import Watch

GIVEN_UP = "given up"
"""End of a run whose operator did not complete its task."""
LONGEST_ERROR = 2000
"""Greatest length of an error in the table [characters]."""


def results(plan: Plan, scenario: Scenario, spec: OperatorSpec, watch: Watch, summary: Summary) -> Row:
    """Return the columns of a run that reached its end."""
    found = cells(watch.found())
    ended: str = summary.ended
    if spec.kind != "script":
        ended = "completed" if found[SHARE.column] in (None, 1.0) else GIVEN_UP
        if ended == GIVEN_UP and summary.time_s >= scenario.duration:
            ended = "time"
    position, angle = summary.true_position_error_m, summary.true_rotation_error_rad
    own: Row = {
        "final_error_m": summary.position_error_m if position is None else position,
        "final_angle_rad": summary.rotation_error_rad if angle is None else angle,
    }
    numbers = found | own
    rule = plan.success
    success = (
        rule.ended in (ended, "any")
        and all(_number(numbers, name) <= bound for name, bound in rule.at_most.items())
        and all(_number(numbers, name) >= bound for name, bound in rule.at_least.items())
    )
    outcome: Row = {
        "ended": ended,
        "success": success,
        "error": "",
        "state_sha256": watch.state().hex(),
    }
    return outcome | own | {name: found[name] for name in plan.metrics}


def _number(numbers: Row, name: str) -> float:
    """Return a number, or NaN, which satisfies no bound."""
    value = numbers[name]
    return float("nan") if value is None else float(value)


def row_of(plan: Plan, case: Case, found: Row) -> Row:
    """Return the row of a case in the order of the columns; what is not in `found` is empty."""
    empty: Row = {"ended": "", "success": False, "error": "", "state_sha256": ""}
    head: Row = {"index": case.index, "seed": case.seed} | dict(zip(plan.factors, case.cells, strict=True))
    return head | {name: found.get(name, empty.get(name)) for name in (*OUTCOME, *plan.metrics)}


def error_text(error: BaseException) -> str:
    """Return an error as one text: its kind and its message."""
    return f"{type(error).__name__}: {error}"[:LONGEST_ERROR]
