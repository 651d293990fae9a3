"""Readings of a frame as single numbers, for policies and datasets."""

from __future__ import annotations

from aftdeck.simulation.frame import Frame
from aftdeck.units import FOOT

_SWITCH = {"stop": 0.0, "close": 1.0, "open": -1.0}


def effector_switch(frame: Frame) -> float:
    """Return the position of the end effector switch: 1 close, 0 stop, -1 open."""
    return _SWITCH[frame.work.hand.switch]


def clearance_share(frame: Frame) -> float:
    """Return the minimum clearance c as c / (c + 1 ft), 0 in contact; 1 if no pair is monitored."""
    if frame.work.nearest is None:
        return 1.0
    distance = max(frame.work.nearest.clearance, 0.0)
    return distance / (distance + FOOT)


def conditions_share(frame: Frame) -> float:
    """Return the share of the present conditions that hold; 0 if there are none."""
    found = frame.work.conditions
    return sum(condition.holds for condition in found) / len(found) if found else 0.0


def detrimental(frame: Frame) -> bool:
    """Return whether a detrimental contact exists."""
    return any(not contact.essential for contact in frame.work.contacts)
