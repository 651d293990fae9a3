"""Table of the lamps that a frame can light: the name and the condition of each lamp."""

from __future__ import annotations

from collections.abc import Callable
from itertools import chain
from typing import TYPE_CHECKING, Literal, NamedTuple

import msgspec

from aftdeck.recording.delays import Delays
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import PAST_REACH, PAST_SOFT, Frame, Level
from aftdeck.simulation.log import joint_label
from aftdeck.worksite.report import Work


class Lit(NamedTuple):
    """State of a lit lamp: its level, and the cause that the operator reads."""

    level: Level
    text: str


def _singular(scenario: Scenario, frame: Frame) -> Lit | None:
    if not frame.singular:
        return None
    near = [
        (name, d)
        for name, d in zip(scenario.arm.model.singularities, frame.singularity, strict=True)
        if name in frame.singular
    ]
    return Lit("caution", ", ".join(f"{name} {abs(d):.2f}" for name, d in near)) if near else None


def _reach_limit(scenario: Scenario, frame: Frame) -> Lit | None:
    return _joints_beyond(scenario, frame, PAST_REACH)


def _soft_stop(scenario: Scenario, frame: Frame) -> Lit | None:
    beyond, text = _joints_beyond(scenario, frame, PAST_SOFT), _limit_text(frame, "soft stop")
    return beyond or (Lit("caution", text) if text else None)


def _rate_limit(_scenario: Scenario, frame: Frame) -> Lit | None:
    text = _limit_text(frame, "joint rate")
    return Lit("info", text) if text else None


def _clearance(_scenario: Scenario, frame: Frame) -> Lit | None:
    level, near = frame.work.clearance_level, frame.work.nearest
    return None if near is None or level == "info" else Lit(level, f"{near.a} to {near.b}")


def _derigidize(_scenario: Scenario, frame: Frame) -> Lit | None:
    """Return the state of DERIGIDIZE, which is lit while the snares hold a payload that is not rigidized.

    While the snares or the carriage move, or the switch is set to open, the level is info; otherwise it is caution.
    """
    hand = frame.work.hand
    if not _held_loosely(frame.work):
        return None
    moves = hand.switch in ("open", "close") if hand.mode == "auto" else hand.rigid != "off"
    level: Level = "info" if moves or hand.switch == "open" else "caution"
    return Lit(level, "the payload is captured, not rigidized")


def _release(_scenario: Scenario, frame: Frame) -> Lit | None:
    hand = frame.work.hand
    releases = _held_loosely(frame.work) and hand.switch == "open" and hand.rigid == "off"
    return Lit("info", "the payload is being released") if releases else None


def _control_error(scenario: Scenario, frame: Frame) -> Lit | None:
    """Return the state of CONTR ERR, which is lit while a joint turns against its motor or brake."""
    joints = () if frame.dynamics is None else frame.dynamics.overdriven
    if not joints:
        return None
    what = "brake slips" if frame.brakes else "driven back"
    return Lit("caution", f"{what}: {', '.join(joint_label(scenario.arm.joints[joint]) for joint in joints)}")


LAMPS: dict[str, Callable[[Scenario, Frame], Lit | None]] = {
    "SINGULAR": _singular,
    "REACH LIM": _reach_limit,
    "SOFT STOP": _soft_stop,
    "RATE LIM": _rate_limit,
    "CLEARANCE": _clearance,
    "DERIGIDIZE": _derigidize,
    "RELEASE": _release,
    "CONTR ERR": _control_error,
}
"""Condition of each lamp that a frame can light. The page adds lamps of its own, and arranges all of them."""
TIME_LOST = "TIME LOST"
"""Lamp that is lit by lost time, from the loss to the end of the run."""
NEW_LOSS_S = 10.0
"""Simulated time after a loss for which TIME LOST is a caution [s]; after it, its level is info.

A loss before the first command is no caution.
"""

if TYPE_CHECKING:
    FlightLamp = str
else:
    FlightLamp = Literal[(*LAMPS, TIME_LOST)]  # type of all lamp names, for `station/messages/typescript.py`


class Lamp(msgspec.Struct, frozen=True, gc=False):
    """A lit lamp and its cause."""

    name: FlightLamp
    level: Level
    text: str
    """Cause, such as ``elbow 0.12`` for SINGULAR."""
    standing: bool = False
    """Whether the lamp raises no alarm: lit at this level since the first step of the run, or about the computer."""


class StandingLamps:
    """Lamps that have been lit at the same level since the first step of a run, by causes that were there from then on.

    A cause is a joint, a singularity or a pair of parts.
    """

    def __init__(self) -> None:
        self._standing: frozenset[tuple[str, Level, str]] | None = None

    def marked(self, lamps: tuple[Lamp, ...]) -> tuple[Lamp, ...]:
        """Return the lamps of the next step, with `Lamp.standing`; call this once for each step, from the first."""
        if self._standing is not None and not self._standing:
            return lamps
        causes = [frozenset((lamp.name, lamp.level, cause) for cause in _causes(lamp)) for lamp in lamps]
        lit = frozenset(chain.from_iterable(causes))
        self._standing = lit if self._standing is None else self._standing & lit
        return tuple(
            msgspec.structs.replace(lamp, standing=True) if own <= self._standing else lamp
            for lamp, own in zip(lamps, causes, strict=True)
        )


def _causes(lamp: Lamp) -> list[str]:
    """Return the causes in a lamp's text, without their numbers."""
    return [cause.rstrip("0123456789. ") for cause in lamp.text.split(", ")]


def lit_lamps(scenario: Scenario, frame: Frame, delays: Delays | None = None) -> tuple[Lamp, ...]:
    """Return the lit lamps, each with its cause.

    Args:
        scenario: the scenario of the run.
        frame: the frame.
        delays: delays of the steps up to this frame; None if they are not known.
    """
    lit = [Lamp(name, *state) for name, holds in LAMPS.items() if (state := holds(scenario, frame)) is not None]
    if delays is not None and delays.lost_s:
        recent = delays.lost_at_s is not None and frame.time_s - delays.lost_at_s < NEW_LOSS_S
        level: Level = "caution" if recent else "info"
        lit.append(Lamp(TIME_LOST, level, delays.text(), standing=True))
    return tuple(lit)


def _joints_beyond(scenario: Scenario, frame: Frame, zone: int) -> Lit | None:
    """Return a caution that names the joints in a zone or beyond it; None if no joint is there."""
    if max(frame.zones) < zone:
        return None
    beyond = [joint_label(name) for name, z in zip(scenario.arm.joints, frame.zones, strict=True) if z >= zone]
    return Lit("caution", ", ".join(beyond)) if beyond else None


def _limit_text(frame: Frame, kind: str) -> str:
    """Return the text of the first limit of this kind that was active in the step; "" if none was."""
    return next((limit.text for limit in frame.limits if limit.kind == kind), "") if frame.limits else ""


def _held_loosely(work: Work) -> bool:
    """Return whether the snares hold a payload that is not rigidized."""
    return work.hand.carriage is not None and "RIGID" not in work.hand.flags and any(c.held for c in work.cargo)
