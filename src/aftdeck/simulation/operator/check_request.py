"""Request of CMD CK, and the values on which its verdict depends."""

from __future__ import annotations

from hashlib import sha256

from aftdeck.scenario.target import Target
from aftdeck.simulation.parts.checking import Checking, Premises
from aftdeck.simulation.state import State


def begin_check(state: State, target: Target) -> None:
    """Request CMD CK of a target; `command_check.cmd_ck` computes the verdict in the next steps."""
    state.panel.check, state.panel.sequence = None, "checking"
    state.checking = Checking(target)


def premises(state: State, target: Target) -> Premises:
    """Return the present values on which the verdict for this target depends."""
    panel, worksite, script = state.panel, state.worksite, state.script
    return Premises(
        target,
        panel.law,
        panel.rate,
        worksite.held,
        script.limits,
        script.attached,
        panel.brakes or panel.safing,
        tuple(state.plant.angles.tolist()),
        tuple(worksite.orbiter_velocity.tolist()),
        sha256(worksite.frames.data).digest(),
    )
