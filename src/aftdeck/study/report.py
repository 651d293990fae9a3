"""Report page of a study."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from aftdeck.study.case import Outcome
from aftdeck.study.file import Study


def write_report(study: Study, outcomes: Sequence[Outcome], folder: Path) -> None:
    """Write the report page of a study."""
