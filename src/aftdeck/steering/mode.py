"""Positions of the MODE rotary and MASTER, and the report's modes that each position can select."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from aftdeck.steering.layout import DIRECT_LAW, MASTER_LAW, NO_LAW

Kind = Literal["automatic", "manual", "single", "test", "master"]
LawChoice = Literal["position", "closed loop", "open loop"]
AUTOMATIC_LAWS: dict[LawChoice, int] = {"position": 1, "closed loop": 2, "open loop": 3}
"""The report's mode for each position of the switch that selects the steering law of OPR CMD and AUTO 1-4."""


@dataclass(frozen=True)
class Mode:
    """One position of the MODE rotary.

    Attributes:
        position: name as printed on the panel.
        laws: the report's mode numbers that the position can select, the default first.
        title: short description.
        kind: kind of command: a target, sticks, one joint's drive switch, the master arm, or none.
        point: point that the mode moves.
        axes: axes of the THC and the RHC. Exception: in mode 7 (ORB LD), the RHC acts about the payload's axes.
        axis_names: positive directions of the THC's three axes.
    """

    position: str
    laws: tuple[int, ...]
    title: str
    kind: Kind
    point: Literal["tip", "payload", "selected joint", "all joints", "none"]
    axes: Literal["orbiter axes", "end effector axes", "payload axes", "joint", "none"]
    axis_names: tuple[str, str, str]

    @property
    def loaded(self) -> bool:
        """Whether the mode needs a payload that is attached to the end effector."""
        return self.point == "payload"

    @property
    def prestored(self) -> bool:
        """Whether the mode moves through points that the scenario defines for the mode."""
        return self.position.startswith("AUTO")

    @property
    def by_joint(self) -> bool:
        """Whether the operator moves joints, not the point of resolution."""
        return self.kind in ("single", "master")

    @property
    def by_angle(self) -> bool:
        """Whether the mode steers the joints to angles, at which the servos then hold them: SINGLE and MASTER."""
        return self.by_joint and self.laws[0] != DIRECT_LAW

    @property
    def has_payload_axes(self) -> bool:
        """Whether a switch of the mode selects a second law, in which the RHC acts about the payload's axes."""
        return self.kind == "manual" and len(self.laws) > 1


ORB_UNL = 4
"""Number of the law of ORB UNL, for whose axes ways out are shown in modes without sticks."""
ORB_LD_TURNING = 7
"""Number of the law of ORB LD in which the RHC acts about the payload's axes, and the THC along the orbiter's."""
_ORBITER = ("+X fwd", "+Y stbd", "+Z down")
_AUTO = (2, 1, 3)

MODES: dict[str, Mode] = {
    mode.position: mode
    for mode in (
        Mode("OPR CMD", _AUTO, "to the keyed-in point", "automatic", "tip", "orbiter axes", _ORBITER),
        Mode("AUTO 1", _AUTO, "prestored points 1", "automatic", "tip", "orbiter axes", _ORBITER),
        Mode("AUTO 2", _AUTO, "prestored points 2", "automatic", "tip", "orbiter axes", _ORBITER),
        Mode("AUTO 3", _AUTO, "prestored points 3", "automatic", "tip", "orbiter axes", _ORBITER),
        Mode("AUTO 4", _AUTO, "prestored points 4", "automatic", "tip", "orbiter axes", _ORBITER),
        Mode("TEST", (int(NO_LAW),), "every lamp and segment lit", "test", "none", "none", ("", "", "")),
        Mode("ORB UNL", (ORB_UNL,), "tip along the orbiter's axes", "manual", "tip", "orbiter axes", _ORBITER),
        Mode(
            "END EFF", (5,), "tip along its own axes", "manual", "tip", "end effector axes",
            ("+X out", "+Y right", "+Z down"),
        ),
        Mode(
            "ORB LD", (ORB_UNL, ORB_LD_TURNING), "payload along the orbiter's axes", "manual", "payload",
            "orbiter axes", _ORBITER,
        ),
        Mode(
            "PL", (6,), "payload along its own axes", "manual", "payload", "payload axes",
            ("+X payload", "+Y payload", "+Z payload"),
        ),
        Mode("SINGLE", (8,), "one joint at a time", "single", "selected joint", "joint", ("+ joint", "", "")),
        Mode(
            "DIRECT", (int(DIRECT_LAW),), "one joint, no steering, no soft stops", "single", "selected joint", "joint",
            ("+ joint", "", ""),
        ),
        Mode(
            "MASTER", (int(MASTER_LAW),), "the arm follows a master arm's joints", "master", "all joints", "none",
            ("", "", ""),
        ),
    )
}  # fmt: skip
"""Every position by name, in order: the panel's left column, its right column, then MASTER (not on the panel)."""


NUMBERED = range(1, 9)
"""Numbers of JSC-12628's own modes."""


def position_of(law: int) -> tuple[str, int] | None:
    """Return the first panel position that selects a law, and the law; None if the law is not 1 to 8."""
    first = next((mode.position for mode in MODES.values() if law in mode.laws), None)
    return None if first is None or law not in NUMBERED else (first, law)
