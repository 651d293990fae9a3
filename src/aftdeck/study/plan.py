"""What all cases of a study have in common."""

from __future__ import annotations

from typing import Any

import msgspec

from aftdeck.study.carried import Carried
from aftdeck.study.file import Study
from aftdeck.study.schema import SuccessSpec


class Plan(msgspec.Struct, frozen=True):
    """What all cases of a study have in common: plain values, which every worker gets once."""

    title: str
    carried: Carried
    factors: tuple[str, ...]
    """Columns of the factors."""
    operator: dict[str, Any]
    monitors: dict[str, Any]
    metrics: tuple[str, ...]
    success: SuccessSpec
    gauged: bool = False
    """Whether the runs have gauges."""


def plan_of(study: Study) -> Plan:
    """Return what the workers need of a study."""
    return Plan(
        study.spec.title,
        study.carried,
        tuple(factor.column for factor in study.factors),
        study.spec.operator,
        msgspec.to_builtins(study.spec.monitors),
        study.metric_columns,
        study.spec.success,
        study.gauged,
    )
