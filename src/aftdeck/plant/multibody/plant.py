"""Plant with masses: MuJoCo moves the bodies, servos and brakes drive the joints, and encoders measure them.

Source: JSC-12628, interfaces of the steering to "RMS rigid body and flexible body dynamics and RMS servo modules". In
each control period, commanded joint rates come out of steering, and measured angles and rates go into steering.
"""

from __future__ import annotations

import math
from typing import Any, Literal

import mujoco
import numpy as np

from aftdeck.arms.load import ArmModel
from aftdeck.arms.masses import servo_needed
from aftdeck.arrays import Array
from aftdeck.bodies.pose import HERE, POSE
from aftdeck.errors import SimulationError
from aftdeck.plant.linear_actuator import Travel
from aftdeck.plant.multibody.build import STEP
from aftdeck.plant.multibody.contacts import ContactPairs
from aftdeck.plant.multibody.payloads import HOLDERS, Payloads
from aftdeck.plant.multibody.servo import Servos
from aftdeck.plant.multibody.view import View
from aftdeck.plant.plant import Accuracy, Surroundings
from aftdeck.plant.spread import Spread, spread_of
from aftdeck.plant.state import Bodies, PlantState
from aftdeck.steering.mode import LawChoice

mujoco.set_mju_user_warning(lambda text: None)  # otherwise MuJoCo writes a file into the user's folder
_STATE = mujoco.mjtState.mjSTATE_INTEGRATION


class MultibodyPlant:
    """Arm of rigid or flexible bodies on a fixed or free orbiter, and the worksite's payloads.

    There is one model for each payload that the scenario attaches, and one without a payload. All have the same degrees
    of freedom. The bodies' state is in the `PlantState`; MuJoCo's data is a workspace that receives the state before
    each step, so that a copied or restored state continues exactly.
    """

    def __init__(
        self, models: list[Any], arm: ArmModel, travel: Travel, period: float, *, strict: bool = False
    ) -> None:
        """Set up the plant.

        Args:
            models: compiled models: without a payload, then with each payload.
            arm: the arm.
            travel: range and rate of the telescope.
            period: control period [s].
            strict: whether the steering's acceleration limits count from the measured rates, as published.
        """
        servo = servo_needed(arm)
        self._steps = math.ceil(period / STEP - 1e-9)
        self._views = [View(model, arm) for model in models]
        self._servos = [Servos(view, arm.joints, servo) for view in self._views]
        for view in self._views:
            view.model.opt.timestep = period / self._steps
            view.limit(arm.limits.hard)
        self._contacts = [ContactPairs(view.model, view.data) for view in self._views]
        self._payloads = [Payloads(view.model, view.data) for view in self._views]
        self._kind: Literal["rigid", "flexible"] = "flexible" if len(self._views[0].gearboxes) else "rigid"
        self._travel, self._period, self._strict = travel, period, strict

    @property
    def accuracy(self) -> Accuracy:
        """Differences that friction and the encoders' steps leave (assumed)."""
        return Accuracy(1e-3, 5e-3, 1e-3)

    @property
    def has_servos(self) -> bool:
        """True."""
        return True

    @property
    def has_contact_forces(self) -> bool:
        """True."""
        return True

    def spread(self, law: LawChoice, *, loaded: bool) -> Spread:
        """Return the greatest differences that were measured (`plant.spread`)."""
        return spread_of(self._kind, law, loaded=loaded)

    def begin(self, state: PlantState, attached: int, poses: Array, motions: Array, prong: float) -> None:
        """Place the bodies at the state's joint angles, unbent, with the joints' rates (`Plant.begin`)."""
        view = self._views[attached]
        mujoco.mj_resetData(view.model, view.data)
        view.set_joints(state.angles, state.rates, state.stand.position, prong)
        self._payloads[attached].place(poses, motions)
        state.bodies = Bodies(
            physics=np.empty(mujoco.mj_stateSize(view.model, _STATE)),
            holds=np.full(6, np.nan),
            brakes=np.full(6, np.nan),
            frames=np.empty((view.rows, POSE)),
            reference=state.rates.copy(),
            torques=np.zeros(6),
            overdriven=np.zeros(6, np.uint8),
            payloads=poses.copy(),
            motions=motions.copy(),
            held=np.zeros((len(poses), len(HOLDERS))),
            held_peaks=np.zeros((len(poses), len(HOLDERS))),
            held_for=np.zeros((len(poses), len(HOLDERS))),
        )
        state.base[:] = HERE
        self._store(attached, state)

    def move(
        self, state: PlantState, rates: Array, drive: float, around: Surroundings, *, brakes: bool, attached: int
    ) -> None:
        """Move the bodies for one control period, with the commanded rates held (`Plant.move`)."""
        bodies = state.bodies
        assert bodies is not None, "`begin` sets the bodies"
        view, servos = self._views[attached], self._servos[attached]
        model, data, stand = view.model, view.data, state.stand
        mujoco.mj_setState(model, data, bodies.physics, _STATE)
        self._payloads[attached].connect(around.holds)
        self._contacts[attached].select(around.near)
        servos.command(bodies, state.angles, rates, brakes=brakes)
        view.drive_telescope((stand.after(self._travel, drive, self._period) - stand.position) / self._period)
        view.drive_prong(around.prong, self._period)
        mujoco.mj_step(model, data, nstep=self._steps)
        if view.diverged():
            raise SimulationError(
                f"the model of the bodies diverged within the control step that ends at {data.time:g} s"
            )
        self._store(attached, state)
        servos.measure(bodies, state.angles, state.rates, brakes=brakes)
        bodies.reference[:] = state.rates if self._strict else rates
        state.commanded += rates * self._period
        height = view.height
        stand.velocity, stand.position = (height - stand.position) / self._period, height

    def _store(self, attached: int, state: PlantState) -> None:
        """Store MuJoCo's state and the poses that belong to it."""
        view, bodies = self._views[attached], state.bodies
        assert bodies is not None, "`begin` sets the bodies"
        mujoco.mj_getState(view.model, view.data, bodies.physics, _STATE)
        mujoco.mj_kinematics(view.model, view.data)  # after a step, MuJoCo's poses are those before the step
        view.write_poses(bodies.frames, state.base)
        self._payloads[attached].write(bodies)
        bodies.touches = self._contacts[attached].touches(state.base)
