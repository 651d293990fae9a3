"""``python -m benchmarks.ring_down``: swing of the straight, braked arm in its first mode, as a table in Markdown.

Frequency and damping at an amplitude follow from the masses, the springs, and the friction in gearboxes and brakes.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from typing import Any, NamedTuple

import mujoco
import numpy as np
import scipy.linalg

from aftdeck.arms.load import ArmModel, load_model
from aftdeck.arms.masses import flexibility_needed, servo_needed
from aftdeck.arrays import Array
from aftdeck.bodies.mass_properties import MassProperties
from aftdeck.plant.multibody.build import BRAKE_STIFFNESS, arm_spec, attach
from aftdeck.plant.multibody.frequencies import matrices
from aftdeck.plant.multibody.view import View
from aftdeck.plant.usual_payload import usual_payload
from aftdeck.simulation.motion.tip_rest import AT_REST
from aftdeck.units import POUND

PITCH = 1
"""Long axis of the payload: parallel to the pitch axis."""
AMPLITUDES = (0.1, 0.03, 0.01)
"""Amplitudes of the tip in the table [m]."""
PULSE = 0.05
"""Amplitude from which the time of rest counts [m]: 4 in peak to peak, the published limit of jets against the arm."""


class Size(NamedTuple):
    """Rows of the table: payloads [lb], and multiples of the friction in the arm's file."""

    loads: tuple[int, ...]
    multiples: tuple[float, ...]


FULL, TINY = Size((0, 31_000), (0.0, 0.25, 0.5, 1.0, 2.0, 4.0)), Size((0,), (1.0,))


class Ring(NamedTuple):
    """Free vibration in one mode at one amplitude.

    Attributes:
        frequency: its frequency [Hz].
        damping: its damping ratio [1].
        shape: (nv,) displacements of all joints, motors at rest, at the amplitude [rad].
        along: (3,) direction in which the tip moves.
    """

    frequency: float
    damping: float
    shape: Array
    along: Array


def braked(arm: ArmModel, angles: Array, payload: MassProperties | None = None) -> View:
    """Return the flexible model of an arm on a fixed base."""
    spec = arm_spec(arm, flexible=True, orbiter=None)
    if payload is not None:
        attach(spec, payload)
    view = View(spec.compile(), arm)
    view.set_joints(angles, np.zeros(6), float(arm.links[0]))
    mujoco.mj_forward(view.model, view.data)
    return view


def loss(torque: Array, reach: Array, windup: Array) -> Array:
    """Return the energy that Dahl's friction takes in one cycle of an amplitude [J].

    In each half cycle, the torque approaches `torque` exponentially; the integral over the closed loop is exact.

    Args:
        torque: greatest torque [N m].
        reach: displacement in which the friction would reach it with its first stiffness [rad].
        windup: amplitude [rad].
    """
    found: Array = 4.0 * torque * (windup - reach * np.tanh(windup / reach))
    return found


def stiffness(torque: Array, reach: Array, windup: Array) -> Array:
    """Return the stiffness of the same loop: its first harmonic in phase with the displacement [N m/rad]."""
    phase = (np.arange(400) + 0.5) * np.pi / 400
    turned = np.maximum(windup, 1e-12)[:, None] * (1.0 - np.cos(phase))
    left = np.exp(-turned / reach[:, None]) * (1.0 + np.tanh(windup / reach))[:, None]
    found: Array = -2.0 * torque / np.maximum(windup, 1e-12) * ((1.0 - left) * np.cos(phase)).mean(axis=1)
    return found


def predicted(view: View, arm: ArmModel, number: int, amplitude: float) -> Ring:
    """Return the free vibration in mode `number`, from 0, with an amplitude of the tip [m].

    It is the mode of the springs and of the friction's equivalent stiffness at the amplitudes of the gearboxes. Its
    damping is the energy lost in a cycle, divided by 4 pi times the energy of the vibration.
    """
    springs, model = flexibility_needed(arm), view.model
    mass, linear = matrices(view)
    free = np.setdiff1d(np.arange(model.nv), view.motor_rates)
    gears = np.searchsorted(free, [dof_of(model, f"gearbox.{name}") for name in arm.joints])
    jacobian = np.zeros((3, model.nv))
    mujoco.mj_jacSite(model, view.data, jacobian, None, model.site("tip").id)
    torque, reach = springs.friction, springs.friction / springs.gearboxes
    windup, added = np.zeros(6), np.zeros(len(free))
    for _ in range(50):
        squares, modes = scipy.linalg.eigh(linear + np.diag(added), mass)
        shape = modes[:, number] * amplitude / np.linalg.norm(jacobian[:, free] @ modes[:, number])
        windup = 0.5 * (windup + np.abs(shape[gears]))
        added[gears] = stiffness(torque, reach, windup)
    omega = float(np.sqrt(squares[number]))
    energy = 0.5 * omega**2 * float(shape @ mass @ shape)
    viscous = np.pi * omega * springs.damping * float(shape @ (linear + np.diag(added)) @ shape)
    whole = np.zeros(model.nv)
    whole[free] = shape
    along = jacobian @ whole
    holding = servo_needed(arm).holding_torque  # a brake deflects, too, by the torque of its gearbox
    braking = loss(holding, holding / BRAKE_STIFFNESS, (springs.gearboxes + added[gears]) * windup / BRAKE_STIFFNESS)
    damping = (float(loss(torque, reach, windup).sum() + braking.sum()) + viscous) / (4.0 * np.pi * energy)
    return Ring(omega / (2.0 * np.pi), damping, whole, along / np.linalg.norm(along))


def dof_of(model: Any, joint: str) -> int:
    """Return the place of a joint in MuJoCo's velocities."""
    return int(model.joint(joint).dofadr[0])


def time_to_rest(view: View, arm: ArmModel, number: int, amplitude: float) -> float:
    """Return the time in which a swing with an amplitude of the tip [m] comes to rest [s]."""
    seconds, smaller = 0.0, 0.9
    while 2.0 * amplitude > AT_REST:
        ring = predicted(view, arm, number, amplitude)
        seconds -= math.log(smaller) / (2.0 * math.pi * ring.frequency * ring.damping)
        amplitude *= smaller
    return seconds


def table(size: Size) -> Iterator[str]:
    """Yield the lines of the table."""
    at = [f"at {1e3 * amplitude:.0f} mm" for amplitude in AMPLITUDES]
    yield f"| payload, lb | friction | {' | '.join(at)} | at rest from {1e3 * PULSE:.0f} mm after, s |"
    yield f"|---|---{'|---' * len(at)}|---|"
    model = load_model("srms")
    springs = flexibility_needed(model)
    for pounds in size.loads:
        for multiple in size.multiples:
            friction = np.maximum(multiple * springs.friction, 1e-9)
            arm = replace(model, flexibility=springs._replace(friction=friction))
            view = braked(arm, np.zeros(6), usual_payload(pounds * POUND, PITCH) if pounds else None)
            rings = [predicted(view, arm, 0, amplitude) for amplitude in AMPLITUDES]
            cells = [f"{ring.frequency:.3g} Hz, {100.0 * ring.damping:.2g} %" for ring in rings]
            seconds = time_to_rest(view, arm, 0, PULSE)
            carried, rested = f"{pounds:,}" if pounds else "none", f"{float(f'{seconds:.2g}'):,.0f}"
            yield f"| {carried} | × {multiple:g} | {' | '.join(cells)} | {rested} |"


if __name__ == "__main__":
    for line in table(FULL):
        print(line, flush=True)
