"""The concept arm's end effector: a fixed finger, and a prong that closes towards it (TABLE I, input 13)."""

from __future__ import annotations

from aftdeck.arms.equipment import Prong
from aftdeck.plant.slide import Slide


def prong_of(prong: Prong | None) -> Slide:
    """The prong, open: y2 of its inner face [m], + close, - open; at rest at 0 of a hand that has none."""
    if prong is None:
        return Slide(0.0, 0.0, 0.0, 0.0)
    return Slide(prong.opened, prong.opened, prong.closed, prong.rate)
