"""The concept arm's end effector: a fixed finger, and a prong that closes towards it (TABLE I, input 13)."""

from __future__ import annotations

from aftdeck.arms.model import HeadingArmFile
from aftdeck.plant.slide import Slide


def prong_of(file: HeadingArmFile) -> Slide:
    """The prong, open: y2 of its inner face [m], + close, - open."""
    effector = file.effector
    opened, closed = float(effector.prong_open.value), float(effector.prong_closed.value)
    return Slide(opened, opened, closed, float(effector.prong_rate.value))
