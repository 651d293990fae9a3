"""Columns of the table of results."""

from __future__ import annotations

from aftdeck.report.catalogue import METRICS

BEFORE = ("index", "seed")
"""Columns before those of the factors."""
OUTCOME = ("ended", "success", "error", "state_sha256", "final_error_m", "final_angle_rad")
"""Columns between those of the factors and those of the metrics."""
FIXED_COLUMNS = (*BEFORE, *OUTCOME)

ABOUT = {
    "index": "number of the case, from 0",
    "seed": "seed of the run",
    "ended": "completed, time, fault, given up (an operator that did not complete its task), or empty after an error",
    "success": "whether the run satisfies the study's rule of success; an error is no success",
    "error": "reason why there is no result; empty if there is one",
    "final_error_m": "distance of the true tip from its target at the end [m]; empty without a target",
    "final_angle_rad": "angle of the true tip from its target at the end [rad]; empty without a target",
    "state_sha256": "SHA-256 of the exact state after the last step: equal for equal runs",
}
"""Description of each fixed column."""
NUMERIC = (
    "final_error_m",
    "final_angle_rad",
    *(metric.column for metric in METRICS if not metric.is_text),
)
"""Columns of results with numbers."""
