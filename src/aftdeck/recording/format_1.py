"""Conversion of messages of layout 1 (Aftdeck 0.1) to the plain form (`codec.plain`) of layout 2.

In layout 1, the names of a frame's fields contain units, and some fields have other names.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from msgspec.structs import replace

from aftdeck.simulation.frame import Check, Frame
from aftdeck.worksite.conditions import Units, condition_text
from aftdeck.worksite.watch.alarm import CLEAR, Level, level_of

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
_WAY_OUT = "way out: "
"""Beginning of a line with an escape direction; layout 1 lists such lines among the reasons for an inhibit."""
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
_CONDITION = {"text": "words"}
_HAND = {"spacing_m": "spacing"}
_CARGO = {"position_m": "position", "rotation": "orientation", "velocity_m_s": "velocity"}


class FramesOf1:
    """Converter of the frames of a run, in order: a frame's clearance level depends on that of the frame before."""

    def __init__(self, joints: tuple[str, ...], thresholds: Callable[[], tuple[float, float]]) -> None:
        """Prepare for the first frame of a run.

        Args:
            joints: names of the arm's joints.
            thresholds: returns the scenario's clearance thresholds for caution and warning [m]; called only for files
                without the clearance level.
        """
        self._joints, self._thresholds = joints, thresholds
        self._level: Level = CLEAR

    def frame(self, old: Plain) -> Plain:
        """Return a frame in the plain form of layout 2."""
        new = _renamed(old, _FRAME)
        position, orientation = new.pop("payload_m"), new.pop("payload_rotation")
        new["payload"] = None if position is None else {"position": position, "orientation": orientation}
        text = old["check"]
        new["check"] = {"good": text.startswith("GOOD"), "text": text} if text else None
        new["goal"] = None if old["goal"] is None else _renamed(old["goal"], _GOAL)
        views = old["views"]
        new["views"] = [
            dict(zip(("pan", "tilt", "zoom"), views[i : i + 3], strict=True)) for i in range(0, len(views), 3)
        ]
        new["work"] = work = self._work(old["work"])
        new["ways_out"] = [
            escape | {"position": _position(escape["text"], escape["stick"])} for escape in old["ways_out"]
        ]
        new["ways_out"] += [
            self._contact_escape(text.removeprefix(_WAY_OUT))
            for text in old["work"]["inhibits"]
            if text.startswith(_WAY_OUT)
        ]
        new.setdefault("times", {})
        new.setdefault("wrist_pitch", None)
        if new.get("attached") is None:  # a scenario of Aftdeck 0.1 attaches at most one payload
            new["attached"] = int(position is not None and not any(cargo["held"] for cargo in work["cargo"]))
        return new

    def _contact_escape(self, text: str) -> Plain:
        """Return the escape direction from a contact; layout 1 contains this direction only as text."""
        *_, command, direction = text.removeprefix("ORB UNL, ").split(" ")
        sign = -1 if direction.startswith("−") or direction == "shorter" else 1
        escape = {"cause": "contact", "text": text, "sign": sign, "position": "", "axis": 0}
        if command == "telescope":
            return escape | {"stick": "telescope"}
        if command in ("THC", "RHC"):
            stick = "translation" if command == "THC" else "rotation"
            axis = ("X", "Y", "Z", "roll", "pitch", "yaw").index(direction[1:]) % 3
        else:
            stick, axis = "joint", self._joints.index("_".join(text.split(" ")[1:-1]))
        return escape | {"stick": stick, "axis": axis, "position": _position(text, stick)}

    def _work(self, old: Plain) -> Plain:
        new = _renamed(old, _WORK)
        text = new.pop("pursuit")
        new["objective"] = {"action": text.split(" ")[0], "text": text} if text else None
        new["inhibits"] = [text for text in old["inhibits"] if not text.startswith(_WAY_OUT)]
        new["nearest"] = None if old["nearest"] is None else _near(old["nearest"])
        new["contacts"] = [_near(contact) for contact in old["contacts"]]
        new["conditions"] = [_renamed(condition, _CONDITION) for condition in old["conditions"]]
        new["hand"] = _renamed(old["hand"], _HAND)
        new["cargo"] = [_renamed(cargo, _CARGO) for cargo in old["cargo"]]
        if old.get("clearance_level") is None:
            near = new["nearest"]
            new["clearance_level"] = (
                CLEAR if near is None else level_of(near["clearance"], *self._thresholds(), self._level)
            )
        self._level = new["clearance_level"]
        return new


def as_layout_1(frame: Frame, units: Units) -> Frame:
    """Return a frame whose check and conditions have only the values that layout 1 records.

    The field `words` of each condition becomes the condition's text in the operator's units, as in the frames that
    `FramesOf1` returns.
    """
    check = frame.check and Check(frame.check.good, frame.check.text)
    conditions = tuple(
        replace(condition, words=condition_text(condition, units), numbers=()) for condition in frame.work.conditions
    )
    return replace(frame, check=check, work=replace(frame.work, conditions=conditions))


def inputs(old: Plain) -> Plain:
    """Return a step's inputs in the plain form of layout 2."""
    new = dict(old)
    position, rotation, joints = (new.pop(f"target_{part}", None) for part in ("position", "rotation", "joints"))
    if position is not None:
        new["target"] = {"position": position, "rotation": rotation, "joints": joints}
    return new


def _position(text: str, stick: str) -> str:
    """Return the position of the MODE rotary that the text of an escape direction names; empty if it names none."""
    if stick == "joint":
        return text.split(" ", maxsplit=1)[0]
    return "ORB UNL" if text.startswith("ORB UNL, ") else ""


def _near(old: Plain) -> Plain:
    new = _renamed(old, _NEAR)
    new["feature_a"], new["feature_b"] = new.pop("features") or ("", "")
    return new


def _renamed(old: Plain, names: dict[str, str]) -> Plain:
    return {names.get(name, name): value for name, value in old.items()}
