"""Worst cases of a study, and the paths of their recordings."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path

from aftdeck.report.table import Row
from aftdeck.study.file import Study

RECORDINGS = "recordings"
"""Folder of the recordings."""


def worst(study: Study, rows: Sequence[Row]) -> list[int]:
    """Return the indices of the worst cases that reached an end, the worst first.

    Unsuccessful cases come first, then those with the worst value of the first response. A case without a value is
    worse than all with one. Cases with an error are left out: they are listed with their errors.
    """
    sign = -1.0 if study.spec.report.worst == "greatest" else 1.0

    def badness(row: Row) -> tuple[bool, float, int]:
        value = next((row[response] for response in study.responses), None)
        return bool(row["success"]), -math.inf if value is None else sign * float(value), int(str(row["index"]))

    ended = sorted((row for row in rows if not row["error"]), key=badness)
    return [int(str(row["index"])) for row in ended[: study.spec.report.recordings]]


def recording_of(folder: Path, index: int) -> Path:
    """Return the path of a case's recording in the folder of a study."""
    return folder / RECORDINGS / f"case-{index:06d}.mcap"
