"""Python interface of the dynamics of an arm: equations of motion, natural modes, linear models."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Literal, get_args

import mujoco
import numpy as np
from numpy.typing import ArrayLike

from aftdeck.analysis.coordinates import check_stops, coordinates_of, finite, of_all, opened
from aftdeck.analysis.given import given_orbiter, given_payload, smooth
from aftdeck.analysis.linear_model import LinearModel
from aftdeck.analysis.linearise import Engaged, linearised
from aftdeck.analysis.modes import Modes, modes_of
from aftdeck.arrays import Array
from aftdeck.bodies.mass_properties import MassProperties
from aftdeck.errors import InputError
from aftdeck.kinematics.arm import Arm, load_arm
from aftdeck.plant.multibody.build import arm_spec, attach
from aftdeck.plant.multibody.frequencies import RIGID_MODES, stiffnesses
from aftdeck.plant.multibody.view import View
from aftdeck.scenario.schema import CONTROL_PERIOD
from aftdeck.units import Time, short


class Dynamics:
    """Equations of motion of an arm: M(q) a + b(q, v) + D v + K q = f.

    The bodies are those of the plants `rigid` and `flexible` (docs/dynamics.md); MuJoCo computes their motion. There is
    no gravity. Friction, steps of encoders and tachometers, stops and torque limits are left out. On the right are the
    forces on the coordinates: torques of the motors, behind the gear, and whatever else acts.

    A rigid arm has one coordinate for each joint. The concept arm also has the extension of its telescope, from the
    arm's `stand`, and the position of its prong. On a flexible
    arm, a joint's coordinate is the angle of its motor, behind the gear; the windup of the gearbox, which adds to it,
    and the bending of booms and base are coordinates of their own. A free orbiter has six besides: its displacement and
    its rotation vector since the start, along L's axes at the start. Its rates are the velocity of L's origin along the
    same axes, and its angular velocity along its own.

    Wherever a method takes values of all coordinates (..., n), it also takes those of the arm's joints (..., j); the
    others are then 0, so that the arm is unbent, and the prong is open. Arrays can have any number of leading
    dimensions, and are broadcast together.

    Attributes:
        arm: the arm.
        payload: mass properties of the payload in frame 7, with the tip as origin; None without one.
        orbiter: mass properties of the free orbiter in L; None if it is fixed.
        flexible: whether gearboxes, booms and base bend.
        coordinates: (n,) names of the coordinates, from base to tip. Those of motors, gearboxes and bending are angles
            [rad] and their forces torques [N m]; those of telescope and prong are lengths [m] and forces [N].
    """

    def __init__(
        self, arm: Arm, payload: MassProperties | None, orbiter: MassProperties | None, *, flexible: bool
    ) -> None:
        self.arm, self.payload, self.orbiter, self.flexible = arm, payload, orbiter, flexible
        self._smooth = smooth(arm.model)
        self._spec = arm_spec(self._smooth, flexible=flexible, orbiter=orbiter)
        if payload is not None:
            attach(self._spec, payload)
        self._model = self._spec.compile()
        self._view = View(self._model, self._smooth)
        self._model.opt.disableactuator = -1  # all servos, brakes and drives
        self.coordinates = coordinates_of(self._model)
        self._unbent = np.array([opened(arm.model) if name == "prong" else 0.0 for name in self.coordinates])
        self._of_arm = np.array([not name.startswith("orbiter.") for name in self.coordinates])

    def mass_matrix(self, positions: ArrayLike) -> Array:
        """Return the mass matrix M (..., n, n) at positions (..., n) [kg m2, kg m, kg]."""
        (q,) = self._given(positions=positions)
        found = np.empty((*q.shape, q.shape[-1]))
        for at in self._states(q):
            mujoco.mj_fullM(self._model, self._view.data, found[at])
        return found

    def bias(self, positions: ArrayLike, rates: ArrayLike) -> Array:
        """Return Coriolis and centrifugal forces b (..., n) at positions (..., n) and rates (..., n) [N m, N]."""
        q, v = self._given(positions=positions, rates=rates)
        found = np.empty(q.shape)
        for at in self._states(q, v):
            found[at] = self._view.data.qfrc_bias
        return found

    @property
    def stiffness(self) -> Array:
        """Stiffness K of the springs (n, n) [N m/rad]; a diagonal matrix, 0 for a rigid arm."""
        return np.diag(stiffnesses(self._model))

    @property
    def damping(self) -> Array:
        """Damping D of the springs (n, n) [N m s/rad]; a diagonal matrix, 0 for a rigid arm."""
        return np.diag(self._model.dof_damping)

    def inverse(self, positions: ArrayLike, rates: ArrayLike, accelerations: ArrayLike) -> Array:
        """Return the forces (..., n) on the coordinates that cause accelerations (..., n) [N m, N]."""
        q, v, a = self._given(positions=positions, rates=rates, accelerations=accelerations)
        found, data = np.empty(q.shape), self._view.data
        for at in self._states(q, v):
            data.qacc[:] = a[at]
            mujoco.mj_inverse(self._model, data)
            found[at] = data.qfrc_inverse
        return found

    def forward(self, positions: ArrayLike, rates: ArrayLike, forces: ArrayLike) -> Array:
        """Return the accelerations (..., n) that forces (..., n) on the coordinates cause [rad/s2, m/s2]."""
        q, v, f = self._given(positions=positions, rates=rates, forces=forces)
        found, data = np.empty(q.shape), self._view.data
        for at in self._states(q, v, f):
            found[at] = data.qacc
        return found

    def tip_jacobian(self, positions: ArrayLike) -> Array:
        """Return the Jacobian of the tip in space (..., 6, n): displacement [m], then rotation [rad], along L's axes.

        L is that at the start, if the orbiter is free. The transpose gives the forces on the coordinates that a force
        [N] and a moment [N m] on the tip cause.
        """
        (q,) = self._given(positions=positions)
        found = np.empty((*q.shape[:-1], 6, q.shape[-1]))
        for at in self._states(q):
            found[at] = self._jacobian()
        return found

    def modes(self, angles: ArrayLike) -> Modes:
        """Return the natural modes at unbent joint angles (j,) [rad], with the brakes on.

        Raises:
            InputError: the arm is rigid, and therefore has no modes, or the angles are not a finite number for each
                joint.
            LimitError: an angle is beyond the joint's hard stops.
        """
        if not self.flexible:
            raise InputError("a rigid arm has no natural modes: give `dynamics` the argument flexible=True")
        self._pose(angles)
        drifting = 0 if self.orbiter is None else RIGID_MODES
        return modes_of(self._view, self._model.dof_damping, self._jacobian() * self._of_arm, drifting)

    def linear(self, angles: ArrayLike, engaged: Engaged = "servos", *, period: float = 0.02) -> LinearModel:
        """Return the linear model about rest at unbent joint angles, in discrete time.

        It is that of the plant itself, with its integrator, its sampling and its commands held for a period. Inputs:

        - ``force.x`` to ``moment.z``: force [N] and moment [N m] on the tip, along the axes of L.
        - ``rate.JOINT``, not with brakes: commanded joint rate [rad/s].
        - ``hold.JOINT``, with hold: angle at which the servo holds the joint [rad].

        Outputs:

        - ``angle.JOINT``: joint angle as the encoder measures it at the joint's output [rad].
        - ``rate.JOINT``: joint rate as the tachometer measures it at the motor [rad/s].
        - ``tip.x`` to ``tip.rz``: displacement [m] and rotation [rad] of the true tip, in L.
        - ``torque.JOINT``: torque of the motor or brake at the end of the period that begins with the sample [N m].

        States: ``position.COORDINATE``, ``rate.COORDINATE`` and, with brakes, their deflections ``brake.JOINT`` [rad].

        Args:
            angles: (j,) joint angles [rad].
            engaged: ``servos``: rate servos that are commanded. ``hold``: servos that return the joints to angles, as
                those of joints that are not commanded do; with ``rate.JOINT`` besides, SINGLE and MASTER. ``brakes``.
            period: control period [s].

        Raises:
            InputError: `engaged` or the period is none of these, or the angles are not a finite number for each
                joint.
            LimitError: an angle is beyond the joint's hard stops.
        """
        if engaged not in get_args(Engaged):
            raise InputError(f"engaged: expected 'servos', 'brakes' or 'hold', got {short(engaged)}")
        time = finite(period, "period")
        if time.ndim:
            raise InputError(f"period: expected one number [s], got {short(period)}")
        if why := CONTROL_PERIOD.problem(float(time), Time.unit):
            raise InputError(f"period: {why}")
        pose = self._pose(angles)
        jacobian = self._jacobian()
        return linearised(self._spec, self._smooth, pose, jacobian, jacobian * self._of_arm, engaged, float(time))

    def _given(self, **given: ArrayLike) -> list[Array]:
        """Return the arguments of a method, broadcast together; the positions come first."""
        motors, others = self._view.motor_rates, {"positions": self._unbent}
        arrays = [of_all(values, motors, others.get(what, 0.0 * self._unbent), what) for what, values in given.items()]
        check_stops(self.arm.model, arrays[0][..., motors])
        try:
            return list(np.broadcast_arrays(*arrays))
        except ValueError:
            shapes = ", ".join(f"{what} {np.shape(values)}" for what, values in given.items())
            raise InputError(f"these arrays cannot be broadcast together: {shapes}") from None

    def _states(self, q: Array, v: Array | None = None, f: Array | None = None) -> Iterator[tuple[int, ...]]:
        """Yield the index of each row, with MuJoCo's values at its positions, rates and forces."""
        data = self._view.data
        for at in np.ndindex(q.shape[:-1]):
            data.qpos[:] = self._model.qpos0
            mujoco.mj_integratePos(self._model, data.qpos, np.ascontiguousarray(q[at]), 1.0)
            data.qvel[:] = 0.0 if v is None else v[at]
            data.qfrc_applied[:] = 0.0 if f is None else f[at]
            mujoco.mj_forward(self._model, data)
            yield at

    def _pose(self, angles: ArrayLike) -> Array:
        """Place the arm at rest, unbent, and return the joint angles (j,)."""
        given, joints = finite(angles, "joint angles"), (len(self.arm.joints),)
        if given.shape != joints:
            raise InputError(f"joint angles: expected shape {joints}, got {given.shape}")
        (q,) = self._given(positions=given)
        next(self._states(q))
        return given

    def _jacobian(self) -> Array:
        """Return the Jacobian of the tip (6, n) at MuJoCo's present pose."""
        found = np.empty((6, self._model.nv))
        site = self._model.site("tip").id
        mujoco.mj_jacSite(self._model, self._view.data, found[:3], found[3:], site)
        return found


def dynamics(
    arm: Arm | str | Path,
    *,
    payload: float | MassProperties | None = None,
    orbiter: Literal["fixed", "free"] | MassProperties = "fixed",
    flexible: bool = False,
) -> Dynamics:
    """Return the dynamics of an arm, with or without a payload at its tip.

    Args:
        arm: the arm, a built-in arm's name, or an arm file.
        payload: mass properties in frame 7, with the tip as origin; or a mass [kg], for a uniform cylinder across the
            arm, parallel to the pitch axes, with its centre at the tip and the proportions and the density of the
            Shuttle's heaviest payload, as for `aftdeck arm NAME frequencies`; None for no payload.
        orbiter: ``fixed``; ``free``, with the mass properties of the worksite that has the arm's name or else of the
            worksite ``orbiter``; or the mass properties in L of a free one.
        flexible: whether gearboxes, booms and base bend.

    Raises:
        ArmError: no built-in arm has that name, or the arm's file lacks a table that the dynamics need.
        ScenarioError: the arm file has errors.
        InputError: no payload or no orbiter has that mass, centre or inertia.
    """
    whole = arm if isinstance(arm, Arm) else load_arm(arm)
    return Dynamics(whole, given_payload(payload), given_orbiter(orbiter, whole.model), flexible=bool(flexible))
