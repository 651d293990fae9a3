"""Answers of a scenario's own plant to the inputs of its linear model, without the steering."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from aftdeck.analysis.given import without_friction
from aftdeck.analysis.linearise import Engaged
from aftdeck.arrays import Array
from aftdeck.bodies.mass_properties import MassProperties
from aftdeck.bodies.pose import pose_of
from aftdeck.kinematics.arm import Arm
from aftdeck.plant.plant import Push, Surroundings
from aftdeck.scenario.load import parse_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.run import Simulation

COMMANDED = 1e-12
"""Rate that is added to commands, because a joint with a rate of 0 is not commanded [rad/s]."""


def scenario_of(
    arm: str,
    angles: Array,
    payload: MassProperties | None,
    *,
    flexible: bool,
    orbiter: str = "fixed",
    period: float = 0.02,
    exact: bool = True,
) -> Scenario:
    """Return a scenario in empty space.

    Args:
        arm: name of the arm.
        angles: (6,) joint angles at the start [rad].
        payload: payload, with its principal axes along those of frame 7.
        flexible: whether the plant is flexible.
        orbiter: ``fixed`` or ``free``.
        period: control period [s].
        exact: whether friction and the steps of encoders and tachometers are set to zero.
    """
    carried = ""
    if payload is not None:
        centre, moments = payload.centre.tolist(), np.diag(payload.inertia).tolist()
        carried = f"[payload]\nmass = {payload.mass!r}\nposition = {centre}\ninertia = {moments}\n"
    text = (
        f"title = 'small inputs'\narm = '{arm}'\nworksite = 'space'\n"
        f"plant = '{'flexible' if flexible else 'rigid'}'\ncontrol_period = {period!r}\nduration = '600 s'\n"
        f"dynamics = {{ orbiter = '{orbiter}' }}\n[initial]\njoints = {angles.tolist()}\n{carried}"
    )
    given = parse_scenario(text, "small", "small.toml", Path())
    return replace(given, arm=Arm(without_friction(given.arm.model))) if exact else given


class PlantAnswers:
    """Plant of a scenario at its start, and what it answers in each control period."""

    def __init__(self, scenario: Scenario) -> None:
        self._sim = Simulation(scenario)
        self._plant = self._sim._flight.plant
        self._attached = self._sim._state.script.attached
        self._frame = scenario.arm.model.frames.index(scenario.arm.model.linkage.frames[-1])
        self._to_tip = np.array([float(scenario.arm.model.links[4]), 0.0, 0.0])
        self._rest = self._sim._state.plant.angles.copy()
        self._tip = self._pose()

    def to(self, inputs: Array, engaged: Engaged, *, follow: bool = False) -> Array:
        """Return the outputs (k, 24) of a linear model for its inputs (k, m).

        Args:
            inputs: force and moment on the tip; commanded rates; angles to hold, as differences from the start.
            engaged: what acts on the joints.
            follow: whether the plant itself moves the angles to hold, at the commanded rates.
        """
        state, found = self._sim._state.plant, []
        bodies = state.bodies
        assert bodies is not None
        braked, held = engaged == "brakes", engaged == "hold"
        prong = self._sim._state.worksite.prong.position
        bodies.holds[:] = self._rest if held else np.nan
        for row in inputs:
            place, turn = self._pose()
            angles = state.angles - self._rest
            moved = turn @ self._tip[1].T
            rotated = 0.5 * np.array([moved[2, 1] - moved[1, 2], moved[0, 2] - moved[2, 0], moved[1, 0] - moved[0, 1]])
            measured = [angles, state.rates.copy(), place - self._tip[0], rotated]
            base = pose_of(state.base)
            push = Push("hand", row[:3], row[3:6], base.position + base.rotation @ place)
            if held and not follow:
                bodies.holds[:] = self._rest + row[12:]
            rates = np.zeros(6) if braked else row[6:12] + (0.0 if held else COMMANDED)
            around = Surroundings(prong=prong, pushes=(push,))
            self._plant.move(state, rates, 0.0, around, brakes=braked, attached=self._attached, by_angle=held)
            found.append(np.concatenate([*measured, bodies.torques]))
        return np.array(found)

    def _pose(self) -> tuple[Array, Array]:
        """Return place and axes of the true tip in L."""
        bodies = self._sim._state.plant.bodies
        assert bodies is not None
        row = bodies.frames[self._frame].copy()
        axes = row[3:].reshape(3, 3)
        return row[:3] + axes @ self._to_tip, axes
