"""RATE HOLD, which keeps the stick command, and POSITION HOLD, which keeps the pose while the sticks are centred."""

from __future__ import annotations

import numpy as np

from aftdeck.plant.plant import Plant
from aftdeck.scenario.target import target_at
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.log import Log
from aftdeck.simulation.state import Panel, State
from aftdeck.steering.layout import LAW, MOTION_ACTIVE, STICKS, TARGET, TWIST
from aftdeck.steering.mode import AUTOMATIC_LAWS, MODES

AT_REST = 1e-3
"""Tip speed [m/s] and angular rate [rad/s] below which POSITION HOLD stores the present pose as its target."""


def effective_sticks(panel: Panel, log: Log, inputs: Inputs) -> tuple[float, ...]:
    """Update RATE HOLD, and return the stick command that acts (rotation, then translation)."""
    sticks = (*inputs.rotation, *inputs.translation)
    if inputs.rate_hold:
        if MODES[panel.mode].kind != "manual":
            log.reject(f"RATE HOLD refused: it works in the manual modes, not in {panel.mode}")
        elif panel.rate_hold_sticks is not None:
            panel.rate_hold_sticks = None
            log.add("rate hold", "info", "RATE HOLD off")
        elif any(sticks):
            panel.rate_hold_sticks = sticks
            log.add("rate hold", "info", "RATE HOLD: the present rates are kept; press again to cancel")
        else:
            log.reject("RATE HOLD refused: the sticks are at rest, there is no rate to keep")
    return sticks if panel.rate_hold_sticks is None else panel.rate_hold_sticks


def hold_position(plant: Plant, state: State) -> None:
    """Apply POSITION HOLD (POHS): in a manual mode with centred sticks, command mode 2 to keep the pose.

    The pose is stored when the arm has come to rest. If the plant has servos, no mode is needed: they hold the joints'
    angles.
    """
    panel = state.panel
    off = not panel.position_hold or MODES[panel.mode].kind != "manual"
    if off or state.command[STICKS : STICKS + 6].any():
        panel.position_hold_target = None
        return
    if panel.position_hold_target is None and np.abs(state.steering[TWIST : TWIST + 6]).max() < AT_REST:
        tip = state.arm.forward(state.plant.angles)
        panel.position_hold_target = target_at(tip)
        state.command[TARGET : TARGET + 3] = tip.position
        state.command[TARGET + 3 : TARGET + 12] = tip.rotation.ravel()
    if panel.position_hold_target is not None and not plant.has_servos:
        state.command[LAW], state.command[MOTION_ACTIVE] = AUTOMATIC_LAWS["closed loop"], 1.0
