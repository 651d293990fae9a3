"""Conversion of messages of layout 1, of Aftdeck 0.1, to the plain form of layout 2.

In layout 1 the names of a frame's fields contain units, and some fields have other names.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from msgspec.structs import replace

from aftdeck.recording.records import FrameRecord
from aftdeck.simulation.frame import Check
from aftdeck.worksite.alarm import CLEAR, Level, level_of

Plain = dict[str, Any]

_FRAME = {
    "angles_rad": "angles",
    "rates_rad_s": "rates",
    "angles_commanded_rad": "angles_commanded",
    "rates_commanded_rad_s": "rates_commanded",
    "rate_limits_rad_s": "rate_limits",
    "tip_m": "position",
    "tip_rotation": "orientation",
    "point_m": "resolution",
}
_GOAL = {"position_m": "position", "distance_m": "distance", "angle_rad": "angle"}
_WORK = {
    "stand_m": "stand",
    "orbiter_m": "orbiter",
    "orbiter_m_s": "orbiter_velocity",
    "master_rad": "master",
}
_NEAR = {
    "clearance_m": "clearance",
    "closing_m_s": "closing",
    "point_m": "point_a",
    "other_m": "point_b",
    "distance_m": "distance",
}
_HAND = {"spacing_m": "spacing"}
_CARGO = {"position_m": "position", "rotation": "orientation", "velocity_m_s": "velocity"}


class FramesOf1:
    """Converter of a run's frames, in order: a frame's clearance level depends on the level before."""

    def __init__(self, thresholds: Callable[[], tuple[float, float]]) -> None:
        """Convert frames; `thresholds` returns the scenario's clearances for caution and warning [m].

        It is called only for early files, which do not record the clearance level.
        """
        self._thresholds = thresholds
        self._level: Level = CLEAR

    def frame(self, old: Plain) -> Plain:
        """Return a frame in the plain form of layout 2."""
        new = _renamed(old, _FRAME)
        place, attitude = new.pop("payload_m"), new.pop("payload_rotation")
        new["payload"] = None if place is None else {"position": place, "orientation": attitude}
        text = old["check"]
        new["check"] = {"good": text.startswith("GOOD"), "text": text} if text else None
        new["goal"] = None if old["goal"] is None else _renamed(old["goal"], _GOAL)
        views = old["views"]
        new["views"] = [
            dict(zip(("pan", "tilt", "zoom"), views[i : i + 3], strict=True)) for i in range(0, len(views), 3)
        ]
        new["work"] = work = self._work(old["work"])
        new.setdefault("times", {})
        new.setdefault("wrist_pitch", None)
        if new.get("attached") is None:  # scenarios had at most one payload of their own then
            new["attached"] = int(place is not None and not any(one["held"] for one in work["cargo"]))
        return new

    def _work(self, old: Plain) -> Plain:
        new = _renamed(old, _WORK)
        new["nearest"] = None if old["nearest"] is None else _near(old["nearest"])
        new["contacts"] = [_near(one) for one in old["contacts"]]
        new["hand"] = _renamed(old["hand"], _HAND)
        new["cargo"] = [_renamed(one, _CARGO) for one in old["cargo"]]
        if old.get("clearance_level") is None:
            near = new["nearest"]
            new["clearance_level"] = (
                CLEAR if near is None else level_of(near["clearance"], *self._thresholds(), self._level)
            )
        self._level = new["clearance_level"]
        return new


def as_told(frame: FrameRecord) -> FrameRecord:
    """Return a frame without the values that layout 1 does not record: its check's seconds, cause and joints."""
    check = frame.check and Check(frame.check.good, frame.check.text)
    return replace(frame, check=check)


def inputs(old: Plain) -> Plain:
    """Return a step's inputs in the plain form of layout 2."""
    new = dict(old)
    place, rotation, joints = (new.pop(f"target_{part}", None) for part in ("position", "rotation", "joints"))
    if place is not None:
        new["target"] = {"position": place, "rotation": rotation, "joints": joints}
    return new


def _near(old: Plain) -> Plain:
    new = _renamed(old, _NEAR)
    new["feature_a"], new["feature_b"] = new.pop("features") or ("", "")
    return new


def _renamed(old: Plain, names: dict[str, str]) -> Plain:
    return {names.get(name, name): value for name, value in old.items()}
