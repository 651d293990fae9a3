"""Ring-down of the braked arm in time: frequency and damping that its masses, springs and friction predict."""

from __future__ import annotations

import itertools
import math
from dataclasses import replace
from typing import NamedTuple

import mujoco
import numpy as np
import pytest

from aftdeck.arms.load import ArmModel, load_model
from aftdeck.arrays import Array
from aftdeck.bodies.mass_properties import MassProperties
from aftdeck.plant.multibody.build import SERVOS
from aftdeck.plant.multibody.view import View
from aftdeck.plant.usual_payload import HEAVIEST, usual_payload
from aftdeck.units import POUND
from benchmarks.ring_down import PITCH, Ring, braked, loss, predicted, stiffness

STRAIGHT = np.zeros(6)
BENT = np.radians([20.0, 60.0, -90.0, 30.0, 20.0, 10.0])
SAMPLE = 0.02


class Measured(NamedTuple):
    """Free vibration as measured: its frequency [Hz], its damping ratio [1] and the amplitude between [m]."""

    frequency: float
    damping: float
    amplitude: float


@pytest.fixture(scope="module")
def srms() -> ArmModel:
    return load_model("srms")


def ring_down(view: View, ring: Ring, cycles: int = 3) -> Measured:
    """Displace the braked arm in the shape of a mode, let it go, and measure the tip along the mode's direction."""
    model, data = view.model, view.data
    model.opt.disableactuator = 1 << SERVOS
    site = model.site("tip").id
    rest = data.site_xpos[site].copy()
    data.qpos[:] += ring.shape
    along: list[float] = []
    for _ in range(round((cycles + 0.5) / ring.frequency / SAMPLE)):
        mujoco.mj_step(model, data, nstep=round(SAMPLE / model.opt.timestep))
        mujoco.mj_kinematics(model, data)
        along.append(float((data.site_xpos[site] - rest) @ ring.along))
    assert not any(warning.number for warning in data.warning)
    tip = np.array(along)
    ups = np.flatnonzero((tip[:-1] < 0.0) & (tip[1:] >= 0.0))
    times = [k - tip[k] / (tip[k + 1] - tip[k]) for k in ups]
    peaks = [0.5 * float(np.ptp(tip[a:b])) for a, b in itertools.pairwise(ups)]
    between = math.sqrt(peaks[0] * peaks[-1])
    damping = math.log(peaks[0] / peaks[-1]) / (2.0 * math.pi * (len(peaks) - 1))
    return Measured(1.0 / (SAMPLE * float(np.diff(times).mean())), damping, between)


def payload_of(pounds: float) -> MassProperties | None:
    return usual_payload(pounds * POUND, PITCH) if pounds else None


@pytest.mark.slow
@pytest.mark.parametrize("amplitude", [0.1, 0.03, 0.01])
@pytest.mark.parametrize(
    ("angles", "pounds", "number"),
    [(STRAIGHT, 0.0, 0), (STRAIGHT, 0.0, 1), (BENT, 0.0, 0), (STRAIGHT, 32_000.0, 0), (STRAIGHT, HEAVIEST / POUND, 0)],
)
def test_braked_arm_rings_as_predicted(
    srms: ArmModel, angles: Array, pounds: float, number: int, amplitude: float
) -> None:
    view = braked(srms, angles, payload_of(pounds))
    found = ring_down(view, predicted(view, srms, number, amplitude))
    expected = predicted(braked(srms, angles, payload_of(pounds)), srms, number, found.amplitude)
    assert found.frequency == pytest.approx(expected.frequency, rel=0.01)
    assert found.damping == pytest.approx(expected.damping, rel=0.2)


@pytest.mark.parametrize("pounds", [0.0, 32_000.0])
def test_arm_without_friction_rings_at_its_eigenfrequency(srms: ArmModel, pounds: float) -> None:
    springs = srms.flexibility
    assert springs is not None
    smooth = replace(srms, flexibility=springs._replace(friction=np.full(6, 1e-9)))
    view = braked(smooth, STRAIGHT, payload_of(pounds))
    ring = predicted(view, smooth, 0, 0.05)
    found = ring_down(view, ring)
    assert found.frequency == pytest.approx(ring.frequency, rel=0.005)
    assert found.damping == pytest.approx(ring.damping, rel=0.2)


def test_loss_and_stiffness_of_friction_have_their_limits() -> None:
    torque, reach = np.array([40.0]), np.array([1e-4])
    assert loss(torque, reach, 1e4 * reach) == pytest.approx(
        4.0 * torque * 1e4 * reach, rel=1e-3
    )  # Coulomb's rectangle
    assert loss(torque, reach, 1e-3 * reach) == pytest.approx(0.0, abs=1e-11)
    assert stiffness(torque, reach, 1e-3 * reach) == pytest.approx(torque / reach, rel=1e-2)  # a spring
    assert stiffness(torque, reach, 1e4 * reach) == pytest.approx(0.0, abs=1e-3 * float(torque[0] / reach[0]))
