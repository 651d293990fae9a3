"""Linear model of an arm about a pose, from the plant's own control periods.

The plant moves for one control period from states and with inputs that differ a little from rest in the pose. Their
effects, divided by the differences, are the columns of the matrices. They contain all that the plant is: bodies,
springs, servos or brakes, MuJoCo's integrator, and the sampling of encoders and commands.
"""

from __future__ import annotations

from typing import Any, Literal

import mujoco
import numpy as np

from aftdeck.analysis.coordinates import SIX, coordinates_of, opened
from aftdeck.analysis.linear_model import LinearModel
from aftdeck.arms.geometry import frozen
from aftdeck.arms.load import ArmModel
from aftdeck.arrays import Array
from aftdeck.plant.linear_actuator import Travel
from aftdeck.plant.multibody.contacts import add_solids
from aftdeck.plant.multibody.plant import MultibodyPlant
from aftdeck.plant.multibody.view import View
from aftdeck.plant.plant import Surroundings
from aftdeck.plant.state import new_plant_state

Engaged = Literal["servos", "brakes", "hold"]
"""What acts on the joints: rate servos of joints that are commanded, brakes, or servos that hold angles."""
MOVED, PUSHED, DEFLECTED = 1e-7, 1e-2, 1e-9
"""Differences from the pose: of positions, rates and commands [rad, m, rad/s, m/s], of forces [N, N m], and of the
deflections of brakes [rad]; a brake slips at some 1e-5 rad. Rounding changes the matrices by 1e-8 (derived)."""
COMMANDED = 1e-300
"""Rate of a joint that is commanded to stand still [rad/s]: the servo of a joint with a rate of 0 holds its angle."""
LOAD = ("force.x", "force.y", "force.z", "moment.x", "moment.y", "moment.z")
"""Inputs of every model: force [N] and moment [N m] on the tip, along the axes of L."""
_STATE = int(mujoco.mjtState.mjSTATE_INTEGRATION)


def linearised(
    spec: Any, arm: ArmModel, angles: Array, jacobian: Array, in_l: Array, engaged: Engaged, period: float
) -> LinearModel:
    """Return the linear model about rest in a pose.

    Args:
        spec: MuJoCo's specification of the arm, with its payload.
        arm: the arm, without friction (`given.smooth`).
        angles: (j,) joint angles [rad].
        jacobian: (6, n) motion of the tip in space, along the axes of L.
        in_l: (6, n) motion of the tip relative to L.
        engaged: what acts on the joints.
        period: control period [s].
    """
    sampled = _Sampled(spec, arm, angles, jacobian, engaged, period)
    states, inputs = sampled.states, sampled.inputs
    slopes = np.array([sampled.slope(place) for place in range(len(states) + len(inputs))]).T
    after, torques = slopes[: len(states)], slopes[len(states) :]
    measured = np.concatenate([sampled.measured(), np.pad(in_l, ((0, 0), (0, len(states) - in_l.shape[1])))])
    return LinearModel(
        A=frozen(after[:, : len(states)]),
        B=frozen(after[:, len(states) :]),
        C=frozen(np.concatenate([measured, torques[:, : len(states)]])),
        D=frozen(np.concatenate([np.zeros((len(measured), len(inputs))), torques[:, len(states) :]])),
        states=states,
        inputs=inputs,
        outputs=(
            *(f"angle.{name}" for name in arm.joints),
            *(f"rate.{name}" for name in arm.joints),
            *(f"tip.{axis}" for axis in SIX),
            *(f"torque.{name}" for name in arm.joints),
        ),
        period=period,
    )


class _Sampled:
    """One control period of the plant, as a function of the state at its beginning and of the inputs.

    Attributes:
        states: names of the states.
        inputs: names of the inputs.
    """

    def __init__(
        self, spec: Any, arm: ArmModel, angles: Array, jacobian: Array, engaged: Engaged, period: float
    ) -> None:
        with_solids = spec.copy()
        add_solids(with_solids, [], [], {})
        model, joints = spec.compile(), arm.joints
        self._plant = MultibodyPlant(
            [(model, with_solids.compile())], arm, Travel(-np.inf, np.inf, 0.0), period
        )  # the telescope has no stops, either
        self._view, self._jacobian, self._engaged = View(model, arm), jacobian, engaged
        self._state = new_plant_state(len(joints))
        self._state.angles[:], self._state.stand.position = angles, float(arm.links[0])
        prong = opened(arm)
        self._plant.begin(self._state, 0, np.empty((0, 12)), np.empty((0, 6)), prong)
        self._view.set_joints(angles, np.zeros(len(joints)), float(arm.links[0]), prong)
        self._around = Surroundings(prong=prong)
        self._rest, self._angles = self._view.qpos.copy(), angles
        self._brakes = [int(model.actuator(f"brake.{name}").actadr[0]) for name in joints]
        names = coordinates_of(model)
        kinds = ("motor", "gearbox") if len(self._view.gearboxes) else ("motor",)
        self._turned = [[names.index(f"{kind}.{name}") for kind in kinds] for name in joints]
        self.states = (
            *(f"position.{name}" for name in names),
            *(f"rate.{name}" for name in names),
            *(f"brake.{name}" for name in joints if engaged == "brakes"),
        )
        self.inputs = (
            *LOAD,
            *(f"rate.{name}" for name in joints if engaged != "brakes"),
            *(f"hold.{name}" for name in joints if engaged == "hold"),
        )

    def slope(self, place: int) -> Array:
        """Return by how much a state or an input changes the state after the period and the torques at its end.

        Args:
            place: number of the state, or that of the input after all states.
        """
        name = (*self.states, *self.inputs)[place]
        by = PUSHED if name in LOAD else DEFLECTED if name.startswith("brake.") else MOVED
        # The friction of a brake takes a share of the motion that grows with it: two differences extrapolate it to 0.
        slope: Array = 2.0 * self._difference(place, 0.5 * by) - self._difference(place, by)
        return slope

    def _difference(self, place: int, by: float) -> Array:
        values = np.zeros(len(self.states) + len(self.inputs))
        values[place] = by
        found: Array = (self._after(values) - self._after(-values)) / (2.0 * by)
        return found

    def measured(self) -> Array:
        """Return the rows of C for encoders, at the joints' outputs, and tachometers, on the motors."""
        n, joints = self._view.model.nv, len(self._turned)
        rows = np.zeros((2 * joints, len(self.states)))
        for i, places in enumerate(self._turned):
            rows[i, places], rows[joints + i, n + places[0]] = 1.0, 1.0
        return rows

    def _after(self, values: Array) -> Array:
        """Return the state after the period, and the torques at its end, from state and inputs."""
        view, state, bodies = self._view, self._state, self._state.bodies
        assert bodies is not None, "`begin` sets the bodies"
        model, data, n = view.model, view.data, view.model.nv
        braked, x, u = self._engaged == "brakes", values[: len(self.states)], values[len(self.states) :]
        mujoco.mj_resetData(model, data)
        data.qpos[:], data.qvel[:] = self._rest, x[n : 2 * n]
        mujoco.mj_integratePos(model, data.qpos, x[:n], 1.0)
        data.qfrc_applied[:] = self._jacobian.T @ u[: len(LOAD)]
        if braked:
            data.act[self._brakes] = x[2 * n :]
        mujoco.mj_getState(model, data, bodies.physics, _STATE)
        state.angles[:] = self._angles + [x[places].sum() for places in self._turned]
        state.stand.position = view.height
        rates, bodies.holds[:] = self._commands(u[len(LOAD) :])
        by_angle = self._engaged == "hold"
        self._plant.move(state, rates, 0.0, self._around, brakes=braked, attached=0, by_angle=by_angle)
        mujoco.mj_setState(model, data, bodies.physics, _STATE)
        moved = np.empty(n)
        mujoco.mj_differentiatePos(model, moved, 1.0, self._rest, data.qpos)
        deflected = data.act[self._brakes] if braked else ()
        return np.concatenate([moved, data.qvel, deflected, bodies.torques])

    def _commands(self, inputs: Array) -> tuple[Array, Array]:
        """Return the commanded rates and the angles to which the servos turn the joints, each (j,)."""
        joints = len(self._angles)
        match self._engaged:
            case "servos":
                return inputs + COMMANDED, np.full(joints, np.nan)
            case "hold":
                return inputs[:joints], self._angles + inputs[joints:]
            case "brakes":
                return np.zeros(joints), np.full(joints, np.nan)
