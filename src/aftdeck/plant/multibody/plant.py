"""Plant with masses: MuJoCo moves the bodies, servos and brakes drive the joints, and encoders measure them.

Source: JSC-12628, interfaces of the steering to "RMS rigid body and flexible body dynamics and RMS servo modules". In
each control period, commanded joint rates come out of steering, and measured angles and rates go into steering.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import partial
from typing import Any, Literal, NamedTuple

import mujoco
import numpy as np

from aftdeck.arms.load import ArmModel
from aftdeck.arms.masses import servo_needed
from aftdeck.arrays import Array
from aftdeck.bodies.pose import HERE, POSE
from aftdeck.errors import SimulationError
from aftdeck.kinematics.bending import BEND
from aftdeck.plant.linear_actuator import Travel
from aftdeck.plant.multibody.build import STEP
from aftdeck.plant.multibody.contacts import ContactPairs
from aftdeck.plant.multibody.gauges import Gauges
from aftdeck.plant.multibody.jets import Jets, Thrusters
from aftdeck.plant.multibody.payloads import HOLDERS, Payloads
from aftdeck.plant.multibody.pushes import Pushes
from aftdeck.plant.multibody.servo import Servos
from aftdeck.plant.multibody.view import View
from aftdeck.plant.plant import Accuracy, Surroundings
from aftdeck.plant.readings import Readings
from aftdeck.plant.spread import Spread, spread_of
from aftdeck.plant.state import Bodies, PlantState
from aftdeck.steering.mode import LawChoice

mujoco.set_mju_user_warning(lambda text: None)  # otherwise MuJoCo writes a file into the user's folder
_STATE = int(mujoco.mjtState.mjSTATE_INTEGRATION)


class _Model(NamedTuple):
    """One model with its workspace, and the parts of the plant that use it.

    Attributes:
        view: model and workspace.
        servos: servos and brakes.
        payloads: payloads of the worksite.
        contacts: solids that can touch; None if the model has none.
        jets: the orbiter's jets; None if it is fixed.
        pushes: disturbances, and jets of payloads.
        gauges: gauges; None without them.
    """

    view: View
    servos: Servos
    payloads: Payloads
    contacts: ContactPairs | None
    jets: Jets | None
    pushes: Pushes
    gauges: Gauges | None


class MultibodyPlant:
    """Arm of rigid or flexible bodies on a fixed or free orbiter, and the worksite's payloads.

    There are two models for each payload that the scenario attaches, and two without a payload: one without solids,
    which is faster and used while no solids are near each other, and one with them. All have the same degrees of
    freedom. The bodies' state is in the `PlantState`; MuJoCo's data is a workspace that receives the state before
    each step, so that a copied or restored state continues exactly. Gauges only read: they do not change the motion.

    Attributes:
        readings: readings of the last step; None without gauges.
    """

    def __init__(
        self,
        models: Sequence[tuple[Any, Any]],
        arm: ArmModel,
        travel: Travel,
        period: float,
        *,
        thrusters: Thrusters | None = None,
        gauged: bool = False,
    ) -> None:
        """Set up the plant.

        Args:
            models: compiled models, each without and with solids: first without a payload, then with each payload.
            arm: the arm.
            travel: range and rate of the telescope.
            period: control period [s].
            thrusters: the orbiter's jets; None if it is fixed.
            gauged: whether the plant has gauges, which take time in each step.
        """
        self.readings: Readings | None = None
        self._made_of = models, arm, travel, period
        self._thrusters, self._gauged = thrusters, gauged
        self._steps = math.ceil(period / STEP - 1e-9)
        self._travel, self._period = travel, period
        self._apart = [self._model(one, arm, solids=False) for one, _ in models]
        self._near = [self._model(one, arm, solids=True) for _, one in models]
        self._kind: Literal["rigid", "flexible"] = "flexible" if len(self._apart[0].view.gearboxes) else "rigid"

    def _model(self, model: Any, arm: ArmModel, *, solids: bool) -> _Model:
        """Return a compiled model with its workspace."""
        view = View(model, arm)
        view.limit(arm.limits.hard)
        if not solids:
            model.opt.disableflags |= int(mujoco.mjtDisableBit.mjDSBL_CONTACT)
        contacts = ContactPairs(model, view.data) if solids else None
        jets = None if self._thrusters is None else Jets(model, view.data, self._thrusters)
        servos = Servos(view, arm.joints, servo_needed(arm), self._period, self._steps)
        gauges = Gauges(view, arm) if self._gauged else None
        pushes = Pushes(model, view.data, arm.linkage.frames[-1])
        return _Model(view, servos, Payloads(model, view.data), contacts, jets, pushes, gauges)

    def __reduce__(self) -> tuple[Callable[[], MultibodyPlant], tuple[()]]:
        """Return how a copy is made: from the compiled models, because MuJoCo's workspaces cannot be copied."""
        return partial(MultibodyPlant, *self._made_of, thrusters=self._thrusters, gauged=self._gauged), ()

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
        one, joints = self._apart[attached], len(state.angles)
        view = one.view
        mujoco.mj_resetData(view.model, view.data)
        view.set_joints(state.angles, state.rates, state.stand.position, prong)
        one.servos.begin()
        one.payloads.place(poses, motions)
        state.bodies = Bodies(
            physics=np.empty(mujoco.mj_stateSize(view.model, _STATE)),
            holds=np.full(joints, np.nan),
            frames=np.empty((view.rows, POSE)),
            bends=np.zeros((view.flexures, BEND)),
            reference=state.rates.copy(),
            torques=np.zeros(joints),
            overdriven=np.zeros(joints, np.uint8),
            payloads=poses.copy(),
            motions=motions.copy(),
            held=np.zeros((len(poses), len(HOLDERS))),
            held_greatest=np.zeros((len(poses), len(HOLDERS))),
            held_peaks=np.zeros((len(poses), len(HOLDERS))),
            held_for=np.zeros((len(poses), len(HOLDERS))),
            orbiter_velocity=np.zeros(3),
            pulses=np.zeros(6),
            fired=np.zeros(6),
        )
        state.base[:] = HERE
        _store(one, state)

    def move(
        self,
        state: PlantState,
        rates: Array,
        drive: float,
        around: Surroundings,
        *,
        brakes: bool,
        attached: int,
        by_angle: bool,
    ) -> None:
        """Move the bodies for one control period, with the commanded rates held (`Plant.move`)."""
        bodies = state.bodies
        assert bodies is not None, "`begin` sets the bodies"
        one, self.readings = (self._near if len(around.near) else self._apart)[attached], None
        view, servos = one.view, one.servos
        model, data, stand = view.model, view.data, state.stand
        mujoco.mj_setState(model, data, bodies.physics, _STATE)
        one.payloads.connect(around.holds)
        if one.jets is not None:
            one.jets.fire(state.base, bodies, around.velocity, self._period)
        if around.pushes:
            one.pushes.begin(around.pushes)
        if one.contacts is not None:
            one.contacts.select(around.near)
        steps = servos.command(bodies, state.angles, rates, brakes=brakes, by_angle=by_angle)
        if view.has_telescope:
            view.drive_telescope((stand.after(self._travel, drive, self._period) - stand.position) / self._period)
        view.drive_prong(around.prong, self._period)
        model.opt.timestep = self._period / steps
        _advance(one, steps)
        if view.diverged():
            raise SimulationError(
                f"the model of the bodies diverged within the control step that ends at {data.time:g} s"
            )
        if around.pushes:
            one.pushes.end(around.pushes)
        _store(one, state)
        bodies.touches = () if one.contacts is None else one.contacts.touches(state.base, steps)
        if one.gauges is not None:
            self.readings = one.gauges.read()
        servos.measure(state, bodies, rates, brakes=brakes, by_angle=by_angle)
        height = view.height
        stand.velocity, stand.position = (height - stand.position) / self._period, height


def _advance(one: _Model, steps: int) -> None:
    """Make steps of MuJoCo, and add up the forces of holders and contacts over them."""
    model, data, contacts, gauges = one.view.model, one.view.data, one.contacts, one.gauges
    if gauges is not None:
        gauges.clear()
    if contacts is None and gauges is None:
        mujoco.mj_step(model, data, nstep=steps)
    else:
        for _ in range(steps):
            if gauges is None:
                mujoco.mj_step(model, data)
            else:
                gauges.step()
            if contacts is not None:
                one.payloads.add()
                contacts.add()
    if contacts is None:
        one.payloads.add()


def _store(one: _Model, state: PlantState) -> None:
    """Store MuJoCo's state and the poses that belong to it."""
    view, bodies = one.view, state.bodies
    assert bodies is not None, "`begin` sets the bodies"
    mujoco.mj_getState(view.model, view.data, bodies.physics, _STATE)
    mujoco.mj_kinematics(view.model, view.data)  # after a step, MuJoCo's poses are those before the step
    view.write_poses(bodies.frames, bodies.bends, state.base)
    one.payloads.write(bodies)
    if one.jets is not None:
        one.jets.write(state.base, bodies)
