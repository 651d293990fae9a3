"""Check of stored results: whether a row is one of a study's cases, with values that a run can have."""

from __future__ import annotations

import math
import re
from functools import cached_property
from typing import get_args

import msgspec

from aftdeck.report.table import Row
from aftdeck.simulation.summary import Ended
from aftdeck.study.columns import NUMERIC, OUTCOME
from aftdeck.study.design import Case, cases
from aftdeck.study.file import Study
from aftdeck.study.plan import plan_of
from aftdeck.study.result import GIVEN_UP, row_of
from aftdeck.table import Cell

ENDED = (*get_args(Ended), GIVEN_UP)
"""How a run can end."""
_SHA256 = re.compile(r"[0-9a-f]{64}")


class RowCheck:
    """Check of the rows of one study."""

    def __init__(self, study: Study) -> None:
        self._study, self._plan = study, plan_of(study)

    @cached_property
    def _cases(self) -> list[Case]:
        return cases(self._study)

    def problem(self, row: Row) -> str:
        """Return what is wrong with a row, in a few words; empty if nothing is."""
        index = row.get("index")
        if type(index) is not int or not 0 <= index < len(self._cases):
            return f"index is {index!r}; the study has the cases 0 to {len(self._cases) - 1}"
        designed = row_of(self._plan, self._cases[index], row)
        if row.keys() != designed.keys():
            return f"the columns differ: {', '.join(sorted(row.keys() ^ designed.keys()))}"
        for name, value in designed.items():
            if msgspec.json.encode(row[name]) != msgspec.json.encode(value):
                return f"{name} is {row[name]!r}; this case of the design has {value!r}"
        return _outcome_problem(row) or next(
            (f"{name} is {row[name]!r}" for name in self._plan.metrics if not _is_metric(name, row[name])), ""
        )


def _outcome_problem(row: Row) -> str:
    ended, success, error, state, *errors = (row[name] for name in OUTCOME)
    if not isinstance(error, str):
        return f"error is {error!r}"
    if error:
        left = [name for name, value in row.items() if value and name in OUTCOME and name != "error"]
        return f"there is an error, but also {left[0]}" if left else ""
    if ended not in ENDED:
        return f"ended is {ended!r}; expected one of {', '.join(ENDED)}"
    if type(success) is not bool:
        return f"success is {success!r}"
    if not isinstance(state, str) or not _SHA256.fullmatch(state):
        return f"state_sha256 is {state!r}"
    wrong = [value for value in errors if not _is_metric("final_error_m", value)]
    return f"a final error is {wrong[0]!r}" if wrong else ""


def _is_metric(name: str, value: Cell) -> bool:
    """Return whether a value can be in the column of a metric."""
    if value is None:
        return True
    if name not in NUMERIC:
        return isinstance(value, str)
    return isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value)
